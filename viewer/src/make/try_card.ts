// One store of a brief: how far it is, its plan and picture, what became of each wish, and a button that keeps it.
import { element } from "../ui/dom";
import type { Speech } from "../ui/speech";
import type { MadeStore, Try, Wish } from "./contract";
import { planPicture } from "./plan_picture";
import { say, type MakeKey } from "./strings";

export interface CardActions {
  // Rejects with what is wrong; the folder is this one's then.
  keep(seed: number, name: string): Promise<void>;
  textOf(error: unknown): string;
  pictureAddress(seed: number): string;
}

export const hardRules = ({ report }: Pick<MadeStore, "report">): number => report.rules.filter(({ severity }) => severity === "hard").length;

export class TryCard {
  readonly root = element("article", { class: "try panel" });
  private shown: Try | undefined;
  private name: string | undefined; // as somebody typed it

  constructor(
    private readonly speech: Speech,
    private readonly actions: CardActions,
  ) {}

  // Nothing is drawn anew where nothing has changed: a picture would flicker, and a field lose what is typed.
  show(next: Try, again = false): void {
    if (!again && this.shown?.state === next.state && this.shown.seed === next.seed) return;
    this.shown = next;
    this.root.dataset["state"] = next.state;
    this.root.setAttribute("aria-busy", String(next.state === "working"));
    const head = element("header", {}, element("h2", { text: this.say("seedOf", { seed: next.seed }) }), this.stateLine(next));
    this.root.replaceChildren(head, ...(next.store ? this.storeParts(next.seed, next.store) : [element("div", { class: "made-plan empty" })]));
  }

  private say(key: MakeKey, values?: Readonly<Record<string, string | number>>): string {
    return say(this.speech.language, key, values);
  }

  private stateLine({ state, error, store }: Try): HTMLElement {
    if (store) return element("span", { class: "muted", text: store.name });
    if (state === "failed") return element("p", { class: "failed", text: `${this.say("failed")}: ${error?.message ?? ""}`, attributes: { role: "alert" } });
    return element("span", { class: "muted", text: this.say(state === "working" ? "working" : "waiting") });
  }

  private storeParts(seed: number, store: MadeStore): Node[] {
    const { speech } = this;
    const { counts, report } = store;
    const plan = planPicture(store, this.say("planOf", { name: store.name, zones: store.zones.map(({ label, id }) => label || id).join(", ") }));
    const picture = element("img", { attributes: { src: this.actions.pictureAddress(seed), alt: this.say("pictureOf", { name: store.name }), width: "480", height: "270", loading: "lazy" } });
    const percent = (share: number): string => speech.number(share * 100);
    const figures = this.say("figures", { products: speech.number(counts.products), skus: speech.number(counts.skus), fixtures: speech.number(counts.fixtures), area: speech.number(report.metrics.selling_area_m2) });
    const stocked = this.say("stocked", { share: percent(report.metrics.fill), reach: percent(report.metrics.REACH) });
    return [plan, picture, element("p", { text: figures }), element("p", { class: "muted", text: stocked }), ...this.rules(store), ...this.wishes(store), this.keeping(seed, store)];
  }

  private rules(store: MadeStore): HTMLElement[] {
    const hard = hardRules(store);
    const soft = store.report.rules.length - hard;
    const first = hard > 0 ? element("p", { class: "failed", text: this.say("hardRules", { count: hard }) }) : element("p", { class: "solved", text: this.say("rulesKept") });
    const why = element("ul", {}, ...store.report.rules.map(({ message }) => element("li", { text: message })));
    if (hard + soft === 0) return [first];
    const text = soft > 0 ? this.say("softRules", { count: soft }) : this.say("hardRules", { count: hard });
    return [first, element("details", {}, element("summary", { class: "muted", text }), why)];
  }

  private wishes({ report }: MadeStore): HTMLElement[] {
    const { requirements, unparsed, conflicts, understood } = report;
    const met = requirements.filter((wish) => wish.met).length;
    const parts = [element("h3", { text: this.say("wishes", { met, count: requirements.length }) }), element("ul", { class: "wishes" }, ...requirements.map((wish) => this.wish(wish)))];
    if (!understood) parts.push(element("p", { class: "failed", text: this.say("notUnderstood") }));
    if (understood && unparsed.length > 0) parts.push(element("p", { class: "muted", text: this.say("unparsed", { words: unparsed.map(({ text }) => `“${text}”`).join(", ") }) }));
    for (const { kept, dropped, why } of conflicts) parts.push(element("p", { class: "muted", text: this.say("givenUp", { kept, dropped, why }) }));
    return parts;
  }

  private wish({ text, met, why }: Wish): HTMLElement {
    const mark = element("span", { class: met ? "mark solved" : "mark failed", text: met ? "✓" : "✗", attributes: { role: "img", "aria-label": this.say(met ? "met" : "notMet") } });
    return element("li", {}, mark, element("span", { text }), met ? undefined : element("span", { class: "muted why", text: why }));
  }

  private keeping(seed: number, store: MadeStore): HTMLElement {
    const name = element("input", { attributes: { required: "", maxlength: "100", autocomplete: "off", spellcheck: "false" }, on: { input: () => (this.name = name.value) } });
    name.value = this.name ?? store.save_as;
    const button = element("button", { class: "main", text: this.say("keep"), attributes: { type: "submit" } });
    const fault = element("p", { class: "failed", attributes: { role: "alert" } });
    const form = element("form", { class: "keep" }, element("label", {}, element("span", { text: this.say("name") }), name), button, fault);
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      button.disabled = true;
      button.textContent = this.say("keeping");
      fault.textContent = "";
      this.actions.keep(seed, name.value).catch((error: unknown) => {
        fault.textContent = this.actions.textOf(error);
        button.disabled = false;
        button.textContent = this.say("keep");
      });
    });
    return form;
  }
}
