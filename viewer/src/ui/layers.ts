// The panel of what is laid over the store.
import { layerNames, type LayerName } from "../state/layers";
import type { TextKey } from "../text/strings";
import { element } from "./dom";
import type { Speech } from "./speech";

export interface LayerActions {
  toggle(layer: LayerName): void;
  close(): void;
}

export class LayersPanel {
  readonly panel = element("section", { class: "layers panel", id: "layers" });
  private readonly boxes = new Map<LayerName, HTMLInputElement>();
  private readonly messages = element("ul", { class: "messages" });

  constructor(speech: Speech, actions: LayerActions, violations: readonly string[]) {
    const heading = element("h2", {});
    const entries = layerNames.map((name) => {
      const box = element("input", { attributes: { type: "checkbox" }, on: { change: () => actions.toggle(name) } });
      const text = element("span", {});
      this.boxes.set(name, box);
      speech.bind(() => (text.textContent = countedText(speech, name, violations.length)));
      return element("label", {}, box, text);
    });
    for (const message of violations) this.messages.append(element("li", { text: message }));
    this.panel.append(heading, ...entries, this.messages);
    this.panel.addEventListener("keydown", (event) => event.key === "Escape" && actions.close());
    this.panel.hidden = true;
    speech.bind(() => {
      heading.textContent = speech.say("layers");
      this.panel.setAttribute("aria-label", speech.say("layers"));
    });
  }

  get isOpen(): boolean {
    return !this.panel.hidden;
  }

  open(open: boolean): void {
    this.panel.hidden = !open;
    if (open) this.boxes.get("zones")?.focus();
  }

  show(layers: ReadonlySet<LayerName>): void {
    for (const [name, box] of this.boxes) box.checked = layers.has(name);
    this.messages.hidden = !layers.has("violations");
  }
}

function countedText(speech: Speech, name: LayerName, violations: number): string {
  const key: TextKey = name;
  return name === "violations" ? `${speech.say(key)} (${speech.number(violations)})` : speech.say(key);
}
