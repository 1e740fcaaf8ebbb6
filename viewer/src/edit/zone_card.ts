// What can be changed of a zone: kind of its fixtures, levels, aisles, how full they are and with how many facings, and its place.
import { element, words } from "../ui/dom";
import type { Speech } from "../ui/speech";
import type { EditHead, EditZone, Patch } from "./contract";
import { unpinned } from "./runs";

export class ZoneCard {
  readonly root = element("div", { class: "zone-card" });

  constructor(
    private readonly speech: Speech,
    private readonly change: (patches: readonly Patch[]) => void,
    private readonly front: (run: string) => void,
  ) {}

  show(zone: EditZone | undefined, head: EditHead): void {
    const { zones, kinds } = head;
    const { speech } = this;
    if (!zone) return this.root.replaceChildren(element("p", { class: "muted", text: speech.say("editPickZone") }));
    const figures = speech.say("editZoneFigures", { fixtures: speech.number(zone.fixtures), products: speech.number(zone.products) });
    const focused = (document.activeElement as HTMLElement | null)?.dataset["field"];
    this.root.replaceChildren(
      element("h3", { text: nameOf(zone) }),
      element("p", { class: "muted", text: figures }),
      this.field("kind", speech.say("editKind"), this.kinds(zone, kinds)),
      this.field("levels", speech.say("editLevels"), this.levels(zone)),
      this.field("aisle", speech.say("editAisle"), this.aisle(zone)),
      this.field("fill", speech.say("editFill"), this.fill(zone)),
      this.facings(zone),
      this.field("swap", speech.say("editSwap"), this.swap(zone, zones)),
    );
    const runs = head.runs.filter((run) => run.zone === zone.id).map(({ id }) => [id, id] as const);
    if (runs.length > 0) this.root.append(this.field("front", speech.say("elevation"), this.choice([["", speech.say("editSwapNone")], ...runs], "", (run) => run && this.front(run))), this.runs(zone, head));
    if (focused) this.root.querySelector<HTMLElement>(`[data-field="${focused}"]`)?.focus();
  }

  private field(name: string, text: string, control: HTMLElement): HTMLElement {
    control.dataset["field"] = name;
    return element("label", {}, element("span", { text }), control);
  }

  private choice(options: readonly (readonly [string, string])[], chosen: string, take: (value: string) => void): HTMLSelectElement {
    const select = element("select", {}, ...options.map(([value, text]) => element("option", { text, attributes: { value } })));
    select.value = chosen;
    select.addEventListener("change", () => take(select.value));
    return select;
  }

  private kinds(zone: EditZone, kinds: readonly string[]): HTMLElement {
    const all = [...new Set([zone.kind, ...kinds])];
    return this.choice(all.map((kind) => [kind, words(kind)] as const), zone.kind, (kind) => this.change([{ set_fixture: { zone: zone.id, kind } }]));
  }

  private levels(zone: EditZone): HTMLElement {
    const [least, most] = zone.level_range;
    const usual = this.speech.say("editUsual", { count: zone.usual_levels });
    const counts = Array.from({ length: Math.max(most - least + 1, 0) }, (_, i) => String(least + i));
    const options = [["", usual] as const, ...counts.map((count) => [count, count] as const)];
    return this.choice(options, zone.levels === undefined ? "" : String(zone.levels), (value) =>
      this.change([{ set_fixture: value === "" ? { zone: zone.id, usual: ["levels"] } : { zone: zone.id, levels: Number(value) } }]),
    );
  }

  // `take` is given what is typed where it is within the limits; `usual`: what nothing typed stands for.
  private number(value: string, limits: Readonly<Record<"min" | "max" | "step", number>>, take: (value: number) => void, usual?: { readonly hint: string; readonly take: () => void }): HTMLInputElement {
    const bounds = Object.entries(limits).map(([name, limit]) => [name, String(limit)]);
    const input = element("input", { attributes: { type: "number", value, ...Object.fromEntries(bounds), ...(usual ? { placeholder: usual.hint } : { required: "" }) } });
    input.addEventListener("change", () => {
      if (!input.reportValidity()) return;
      if (input.value === "") usual?.take();
      else take(Number(input.value));
    });
    return input;
  }

  private fill(zone: EditZone): HTMLElement {
    return this.number(String(Math.round(zone.fill * 100)), { min: 0, max: 100, step: 1 }, (share) => this.change([{ set_stock: { zone: zone.id, fill: share / 100 } }]));
  }

  private aisle(zone: EditZone): HTMLElement {
    const set = (values: object): void => this.change([{ set_fixture: { zone: zone.id, ...values } }]);
    const usual = { hint: this.speech.say("editAsUsual"), take: () => set({ usual: ["aisle_mm"] }) };
    return this.number(zone.aisle_mm === undefined ? "" : String(zone.aisle_mm), { min: 600, max: 8000, step: 1 }, (aisle_mm) => set({ aisle_mm }), usual);
  }

  // Fewest and most; who sets one beyond the other moves both.
  private facings(zone: EditZone): HTMLElement {
    const { speech } = this;
    const set = (facings: readonly [number, number]): void => this.change([{ set_stock: { zone: zone.id, facings } }]);
    const [fewest, most] = zone.facings;
    const limits = { min: 1, max: 40, step: 1 };
    const low = this.number(String(fewest), limits, (count) => set([count, Math.max(count, most)]));
    const high = this.number(String(most), limits, (count) => set([Math.min(fewest, count), count]));
    low.dataset["field"] = "facings";
    high.dataset["field"] = "facings-most";
    low.setAttribute("aria-label", speech.say("editFacingsFewest"));
    high.setAttribute("aria-label", speech.say("editFacingsMost"));
    return element("div", { class: "two-fields" }, element("span", { text: speech.say("editFacings") }), element("span", { class: "pair" }, low, element("span", { text: "–" }), high));
  }

  private runs(zone: EditZone, head: EditHead): HTMLElement {
    const { speech } = this;
    const made = element("p", { class: "muted runs", text: speech.say("editRuns") });
    const patches = unpinned(head, zone.id);
    if (patches.length === 0) return made;
    const free = element("button", { class: "act", text: speech.say("editRunsFree"), attributes: { type: "button" }, on: { click: () => this.change(patches) } });
    free.dataset["field"] = "free";
    return element("div", {}, made, free);
  }

  private swap(zone: EditZone, zones: readonly EditZone[]): HTMLElement {
    const others = zones.filter(({ id }) => id !== zone.id).map((other) => [other.id, nameOf(other)] as const);
    return this.choice([["", this.speech.say("editSwapNone")], ...others], "", (b) => b && this.change([{ swap_leaves: { a: zone.id, b } }]));
  }
}

function nameOf(zone: EditZone): string {
  return zone.label || words(zone.id);
}
