// The planogram of a line of fixtures as it stands: each facing a button with its name, how many stand side by side, and the price.
import { sides, type Elevation, type SideName } from "../stage/elevation";
import type { Sku } from "../store/contract";
import type { RunBlock } from "../edit/block_swap";
import { SwapBar, type SwapActions } from "../edit/swap_bar";
import { element, icon } from "./dom";
import type { Speech } from "./speech";

export interface ElevationActions {
  of(run: string, side: SideName): Elevation | undefined;
  choose(product: number): void;
  closed(): void;
  // While the store is edited.
  isEdited(): boolean;
  readonly swap: SwapActions;
  blocks(run: string): Promise<readonly RunBlock[]>;
}

// Black or white, whichever stands out more: at least 4.5 to 1 on any ground.
export function inkOn(color: string): "#000" | "#fff" {
  const word = Number.parseInt(color.slice(1), 16);
  const [r, g, b] = [16, 8, 0].map((shift) => {
    const share = ((word >> shift) & 255) / 255;
    return share <= 0.04045 ? share / 12.92 : ((share + 0.055) / 1.055) ** 2.4;
  }) as [number, number, number];
  return 0.2126 * r + 0.7152 * g + 0.0722 * b > 0.179 ? "#000" : "#fff";
}

export class ElevationPanel {
  readonly panel = element("section", { class: "elevation panel" });
  private run = "";
  private side: SideName = "front";
  private readonly swap: SwapBar;
  private blocks: readonly RunBlock[] = []; // both sides

  constructor(
    private readonly speech: Speech,
    private readonly skus: readonly Sku[],
    private readonly actions: ElevationActions,
  ) {
    this.swap = new SwapBar(speech, actions.swap);
    this.panel.hidden = true;
    this.panel.addEventListener("keydown", (event) => {
      if (event.key !== "Escape") return;
      this.close();
      event.stopPropagation();
    });
    speech.bind(() => {
      this.draw();
      this.swap.tell("", false);
      this.showBlocks();
    });
  }

  open(run: string): void {
    this.run = run;
    this.side = this.filled()[0] ?? "front";
    this.panel.hidden = false;
    this.swap.tell("", false);
    this.refresh();
    this.panel.querySelector("button")?.focus();
  }

  // The store has changed, or its edit has begun or ended.
  refresh(): void {
    if (this.panel.hidden) return;
    if (this.filled().length === 0) return this.close();
    this.draw();
    void this.askForBlocks();
  }

  // Of a preview or a change.
  tell(text: string, isFault: boolean): void {
    this.swap.tell(text, isFault);
  }

  close(): void {
    this.panel.hidden = true;
    this.actions.closed();
  }

  private async askForBlocks(): Promise<void> {
    const { run } = this;
    const blocks = this.actions.isEdited() ? await this.actions.blocks(run) : [];
    if (run !== this.run) return;
    this.blocks = blocks;
    this.showBlocks();
  }

  private showBlocks(): void {
    this.swap.show(this.blocks.filter(({ side }) => side === this.side));
  }

  private draw(): void {
    if (this.panel.hidden) return;
    const focused = (document.activeElement as HTMLElement | null)?.dataset["facing"];
    const scrolled = this.panel.querySelector(".scroll")?.scrollLeft ?? 0;
    const { speech } = this;
    const shown = this.actions.of(this.run, this.side);
    const close = element("button", { class: "tool", attributes: { type: "button", "aria-label": speech.say("close") }, on: { click: () => this.close() } }, icon("close"));
    const heading = element("h2", { text: `${speech.say("elevation")} · ${this.run}` });
    this.panel.setAttribute("aria-label", speech.say("elevation"));
    this.panel.replaceChildren(element("header", {}, heading, ...this.sideButtons(), close));
    if (!shown) return;
    const scroll = element("div", { class: "scroll" }, this.wall(shown));
    this.panel.append(scroll);
    if (this.actions.isEdited()) this.panel.append(this.swap.root);
    scroll.scrollLeft = scrolled;
    if (focused) this.panel.querySelector<HTMLElement>(`[data-facing="${focused}"]`)?.focus({ preventScroll: true });
  }

  // The sides of the line on which something stands.
  private filled(): SideName[] {
    return sides.filter((side) => (this.actions.of(this.run, side)?.blocks.length ?? 0) > 0);
  }

  private sideButtons(): HTMLElement[] {
    const filled = this.filled();
    if (filled.length < 2) return [];
    return filled.map((side) => {
      const turn = (): void => {
        this.side = side;
        this.draw();
        this.showBlocks();
      };
      const text = this.speech.say(side === "front" ? "frontSide" : "backSide");
      return element("button", { class: "side", text, attributes: { type: "button", "aria-pressed": String(side === this.side) }, on: { click: turn } });
    });
  }

  private wall({ width, height, blocks }: Elevation): HTMLElement {
    const wall = element("div", { class: "wall" });
    wall.style.aspectRatio = `${width} / ${height}`;
    const percent = (part: number, whole: number): string => `${((100 * part) / whole).toFixed(3)}%`;
    for (const block of blocks) {
      const sku = this.skus[block.sku]!;
      const name = this.speech.nameOf(sku);
      const facts = `${block.columns} × ${this.speech.money(sku.price, sku.currency)}`;
      const choose = (): void => {
        this.actions.choose(block.product);
        this.swap.choose(block.facing);
      };
      const button = element("button", { attributes: { type: "button", title: `${name}\n${sku.sku}\n${facts}`, "data-facing": String(block.facing) }, on: { click: choose } });
      if (this.actions.isEdited()) button.addEventListener("pointerdown", (event) => this.swap.lift(event, block.facing));
      button.append(element("span", { text: name }), element("span", { text: facts }));
      Object.assign(button.style, {
        left: percent(block.left, width),
        width: percent(block.right - block.left, width),
        bottom: percent(block.bottom, height),
        height: percent(block.top - block.bottom, height),
        backgroundColor: sku.color,
        color: inkOn(sku.color),
      });
      wall.append(button);
    }
    return wall;
  }
}
