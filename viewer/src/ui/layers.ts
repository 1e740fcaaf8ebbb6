// The panel of what is laid over the store.
import { heatNames, rampColor, type Heat, type HeatName } from "../stage/heat";
import { layerNames, type LayerName } from "../state/layers";
import type { TextKey } from "../text/strings";
import { element } from "./dom";
import type { Speech } from "./speech";

export interface LayerActions {
  toggle(layer: LayerName): void;
  heat(name: HeatName | undefined): void;
  close(): void;
}

export class LayersPanel {
  readonly panel = element("section", { class: "layers panel", id: "layers" });
  private readonly boxes = new Map<LayerName, HTMLInputElement>();
  private readonly messages = element("ul", { class: "messages" });

  private readonly texts: (() => void)[] = [];
  private readonly choice = element("select", {});
  private readonly legend = element("div", { class: "legend" });

  constructor(
    private readonly speech: Speech,
    actions: LayerActions,
    private violations: readonly string[],
  ) {
    const heading = element("h2", {});
    const entries = layerNames.map((name) => {
      const box = element("input", { attributes: { type: "checkbox" }, on: { change: () => actions.toggle(name) } });
      const text = element("span", {});
      this.boxes.set(name, box);
      this.texts.push(() => (text.textContent = countedText(speech, name, this.violations.length)));
      return element("label", {}, box, text);
    });
    this.setViolations(violations);
    this.panel.append(heading, ...entries, this.messages, this.heatChoice(actions), this.legend);
    this.panel.addEventListener("keydown", (event) => event.key === "Escape" && actions.close());
    this.panel.hidden = true;
    speech.bind(() => {
      for (const say of this.texts) say();
      heading.textContent = speech.say("layers");
      this.panel.setAttribute("aria-label", speech.say("layers"));
    });
  }

  setViolations(violations: readonly string[]): void {
    this.violations = violations;
    this.messages.replaceChildren(...violations.map((message) => element("li", { text: message })));
    for (const say of this.texts) say();
  }

  get isOpen(): boolean {
    return !this.panel.hidden;
  }

  open(open: boolean): void {
    this.panel.hidden = !open;
    if (open) this.boxes.get("zones")?.focus();
  }

  private heatChoice(actions: LayerActions): HTMLElement {
    const text = element("span", {});
    this.choice.addEventListener("change", () => actions.heat(heatNames.find((name) => name === this.choice.value)));
    this.speech.bind(() => {
      text.textContent = this.speech.say("heat");
      const chosen = this.choice.value;
      const option = (value: string, key: TextKey): HTMLElement => element("option", { text: this.speech.say(key), attributes: { value } });
      this.choice.replaceChildren(option("", "heatNone"), ...heatNames.map((name) => option(name, heatKeys[name])));
      this.choice.value = chosen;
    });
    return element("label", {}, text, this.choice);
  }

  showHeat(name: HeatName | undefined, heat: Heat | undefined): void {
    this.choice.value = name ?? "";
    this.legend.hidden = !heat;
    if (!name || !heat) return;
    const bar = element("div", { class: "bar" });
    bar.style.background = `linear-gradient(to right, ${[0, 0.25, 0.5, 0.75, 1].map((share) => `rgb(${rampColor(share).join(" ")})`).join(", ")})`;
    const text = (value: number): string => figureText(this.speech, name, value, heat.currency);
    this.legend.replaceChildren(bar, element("span", { text: `≤ ${text(heat.low)}` }), element("span", { text: `≥ ${text(heat.high)}` }));
  }

  show(layers: ReadonlySet<LayerName>): void {
    for (const [name, box] of this.boxes) box.checked = layers.has(name);
    this.messages.hidden = !layers.has("violations");
  }
}

const heatKeys = { price: "price", height: "heightAbove", mass: "mass", pickRate: "pickRate" } as const;

function figureText(speech: Speech, name: HeatName, value: number, currency: string): string {
  switch (name) {
    case "price":
      return speech.money(value, currency);
    case "height":
      return speech.say("metres", { value: speech.number(value, 2) });
    case "mass":
      return `${speech.number(value, 2)} kg`;
    case "pickRate":
      return `${speech.number(100 * value)} %`;
  }
}

function countedText(speech: Speech, name: LayerName, violations: number): string {
  const key: TextKey = name;
  return name === "violations" ? `${speech.say(key)} (${speech.number(violations)})` : speech.say(key);
}
