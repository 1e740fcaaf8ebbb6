// The panel at the right: what is known of the selected product or fixture.
import type { FixtureCard, ProductCard } from "../store/contract";
import type { TextKey } from "../text/strings";
import { element, icon, words, type IconName } from "./dom";
import { jointControls, type Movable } from "./joint_controls";
import type { Speech } from "./speech";

export interface CardActions {
  close(): void;
  goTo(): void;
  showAll(): void;
  elevation(run: string): void;
  move(joint: number, to: number): void;
}

type Shown = { kind: "product"; card: ProductCard; picture: string } | { kind: "fixture"; card: FixtureCard; joints: () => readonly Movable[] };

export class CardPanel {
  readonly panel = element("aside", { class: "card panel" });
  private shown: Shown | undefined;

  constructor(
    private readonly speech: Speech,
    private readonly actions: CardActions,
  ) {
    this.panel.hidden = true;
    speech.bind(() => this.draw());
  }

  show(shown: Shown | undefined): void {
    this.shown = shown;
    this.draw();
  }

  private draw(): void {
    this.panel.hidden = this.shown === undefined;
    if (!this.shown) return;
    const kind = this.speech.say(this.shown.kind);
    this.panel.setAttribute("aria-label", kind);
    const close = element("button", { class: "tool", attributes: { type: "button", "aria-label": this.speech.say("close") }, on: { click: () => this.actions.close() } }, icon("close"));
    const head = element("header", {}, element("span", { class: "muted", text: kind }), close);
    const body = this.shown.kind === "product" ? this.product(this.shown.card, this.shown.picture) : this.fixture(this.shown.card, this.shown.joints());
    this.panel.replaceChildren(head, ...body);
  }

  private product(card: ProductCard, picture: string): HTMLElement[] {
    const { speech } = this;
    const name = speech.nameOf(card);
    const label = element("img", { class: "label", attributes: { src: picture, alt: "", decoding: "async" } });
    label.addEventListener("error", () => label.replaceWith(element("p", { class: "muted", text: speech.say("labelFailed") })));
    const title = element(
      "div",
      { class: "title" },
      element("h2", { text: name }),
      element("p", { class: "muted", text: [card.brand, card.variant].filter((part) => part).join(" · ") }),
      element("p", { class: "cost", text: speech.money(card.price, card.currency) }),
    );
    const [w, d, h] = card.size_mm;
    const facts = this.facts([
      ["net", card.net],
      ["size", `${w} × ${d} × ${h} mm`],
      ["mass", card.mass_kg < 1 ? `${speech.number(card.mass_kg * 1000)} g` : `${speech.number(card.mass_kg, 2)} kg`],
      ["friction", speech.number(card.friction, 2)],
      ["material", words(card.material)],
      ["storage", words(card.storage)],
      ["shelfLife", card.shelf_life_days > 0 ? speech.say("days", { count: speech.number(card.shelf_life_days) }) : ""],
      ["category", [card.category, card.subcategory].filter((part) => part).map(words).join(" / ")],
      ["facings", `${card.facing.facings} × ${card.facing.rows_deep} × ${card.facing.stack}`],
      ["inStore", speech.say("pieces", { count: speech.number(card.items_in_store) })],
      ["gtin", card.ean || card.plu],
      ["sku", card.sku],
      ["fixture", card.fixture.id],
      ...this.grasps(card),
    ]);
    return [label, title, this.buttons(["flyTo", "place", () => this.actions.goTo()], ["showAll", "all", () => this.actions.showAll()]), facts];
  }

  private grasps(card: ProductCard): [string, string][] {
    return card.grasps.filter(({ tries }) => tries > 0).map(({ tool, tries, held }) => [`${this.speech.say("grasp")}, ${words(tool)}`, `${held} / ${tries}`]);
  }

  private fixture(card: FixtureCard, joints: readonly Movable[]): HTMLElement[] {
    const { speech } = this;
    const metres = card.size_m.map((x) => speech.number(x, 2)).join(" × ");
    const shelves = card.shelves.map((shelf): [string, string] => [
      `${speech.say("level")} ${shelf.level + 1}${shelf.side > 0 ? ` ${speech.say("back")}` : ""}`,
      `${speech.number(shelf.height_m, 2)} m · ${speech.say("pieces", { count: speech.number(shelf.products) })}`,
    ]);
    const moving = jointControls(speech, joints, (joint, to) => this.actions.move(joint, to));
    return [
      element("div", { class: "title" }, element("h2", { text: words(card.kind) }), element("p", { class: "muted", text: card.id })),
      ...(card.run && card.levels > 0 ? [this.buttons(["elevation", "elevation", () => this.actions.elevation(card.run)])] : []),
      ...(moving ? [moving] : []),
      this.facts([
        ["zone", words(card.zone)],
        ["size", `${metres} m`],
        ["material", words(card.material)],
        ["stock", speech.say("products", { count: speech.number(card.products) })],
        ["levels", card.levels > 0 ? speech.number(card.levels) : ""],
        ...shelves,
      ]),
    ];
  }

  private facts(rows: readonly (readonly [string, string])[]): HTMLElement {
    const list = element("dl", {});
    for (const [key, value] of rows) {
      if (value === "") continue;
      const text = key in factKeys ? this.speech.say(key as TextKey) : key;
      list.append(element("dt", { text }), element("dd", { text: value }));
    }
    return list;
  }

  private buttons(...entries: readonly (readonly [TextKey, IconName, () => void])[]): HTMLElement {
    const row = element("div", { class: "buttons" });
    for (const [key, picture, press] of entries) {
      const button = element("button", { attributes: { type: "button" }, on: { click: press } }, icon(picture), element("span", { text: this.speech.say(key) }));
      row.append(button);
    }
    return row;
  }
}

const factKeys: Readonly<Partial<Record<TextKey, true>>> = {
  net: true, size: true, mass: true, friction: true, material: true, storage: true, shelfLife: true, category: true, facings: true,
  inStore: true, gtin: true, sku: true, fixture: true, zone: true, stock: true, levels: true,
};
