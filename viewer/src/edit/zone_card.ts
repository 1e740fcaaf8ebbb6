// What can be changed of a zone: kind of its fixtures, levels, how full they are, and its place.
import { element, words } from "../ui/dom";
import type { Speech } from "../ui/speech";
import type { EditZone, Patch } from "./contract";

export class ZoneCard {
  readonly root = element("div", { class: "zone-card" });

  constructor(
    private readonly speech: Speech,
    private readonly change: (patches: readonly Patch[]) => void,
  ) {}

  show(zone: EditZone | undefined, zones: readonly EditZone[], kinds: readonly string[]): void {
    const { speech } = this;
    if (!zone) return this.root.replaceChildren(element("p", { class: "muted", text: speech.say("editPickZone") }));
    const figures = speech.say("editZoneFigures", { fixtures: speech.number(zone.fixtures), products: speech.number(zone.products) });
    const focused = (document.activeElement as HTMLElement | null)?.dataset["field"];
    this.root.replaceChildren(
      element("h3", { text: nameOf(zone) }),
      element("p", { class: "muted", text: figures }),
      this.field("kind", speech.say("editKind"), this.kinds(zone, kinds)),
      this.field("levels", speech.say("editLevels"), this.levels(zone)),
      this.field("fill", speech.say("editFill"), this.fill(zone)),
      this.field("swap", speech.say("editSwap"), this.swap(zone, zones)),
    );
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

  private fill(zone: EditZone): HTMLElement {
    const input = element("input", { attributes: { type: "number", min: "0", max: "100", step: "5", value: String(Math.round(zone.fill * 100)) } });
    input.addEventListener("change", () => {
      if (input.validity.valid && input.value !== "") this.change([{ set_stock: { zone: zone.id, fill: Number(input.value) / 100 } }]);
      else input.reportValidity();
    });
    return input;
  }

  private swap(zone: EditZone, zones: readonly EditZone[]): HTMLElement {
    const others = zones.filter(({ id }) => id !== zone.id).map((other) => [other.id, nameOf(other)] as const);
    return this.choice([["", this.speech.say("editSwapNone")], ...others], "", (b) => b && this.change([{ swap_leaves: { a: zone.id, b } }]));
  }
}

function nameOf(zone: EditZone): string {
  return zone.label || words(zone.id);
}
