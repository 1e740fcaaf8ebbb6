// Under the front view of shelves while the store is edited: two blocks change places, by dragging one onto the other or by the fields.
import { element } from "../ui/dom";
import type { Speech } from "../ui/speech";
import { byShelf, swapOf, type RunBlock } from "./block_swap";
import type { Patch } from "./contract";
import { clickMoves, follow } from "./shapes";

export interface SwapActions {
  // While a block is carried or one is chosen for it, and when that is given up (undefined).
  preview(patches: readonly Patch[] | undefined): void;
  change(patches: readonly Patch[]): void;
  nameOf(sku: string): string;
}

export class SwapBar {
  readonly root = element("div", { class: "swap-bar" });
  private readonly told = element("p", { attributes: { role: "status" } });
  private readonly form = element("form", {});
  private blocks: readonly RunBlock[] = [];
  private chosen: number | undefined; // its facing
  private other: number | undefined;
  private facings: number | undefined;

  constructor(
    private readonly speech: Speech,
    private readonly actions: SwapActions,
  ) {
    this.root.append(this.told, this.form);
    this.root.addEventListener("keydown", (event) => {
      if (event.key !== "Escape" && !event.ctrlKey && !event.metaKey) event.stopPropagation(); // the store is not walked through from here
    });
    this.form.addEventListener("submit", (event) => {
      event.preventDefault();
      const [a, b] = [this.of(this.chosen), this.of(this.other)];
      if (a && b && this.form.reportValidity()) this.swap(a, b, this.facings);
    });
  }

  // What stands on the side of the line that is looked at.
  show(blocks: readonly RunBlock[]): void {
    this.blocks = blocks;
    this.choose(this.chosen);
  }

  // What would come, or has come, of what was asked; the empty text: what one can do here.
  tell(text: string, isFault: boolean): void {
    this.told.className = isFault ? "fault-text" : "muted";
    this.told.setAttribute("role", isFault ? "alert" : "status");
    this.told.textContent = text || this.speech.say("swapHint");
  }

  choose(facing: number | undefined): void {
    const focused = (document.activeElement as HTMLElement | null)?.dataset["field"];
    this.chosen = this.of(facing)?.facing;
    this.other = this.facings = undefined;
    this.draw();
    if (focused) this.form.querySelector<HTMLElement>(`[data-field="${focused}"]`)?.focus();
  }

  // The block is carried over the wall of blocks.
  lift(event: PointerEvent, facing: number): void {
    const from = this.of(facing);
    const button = event.currentTarget as HTMLElement;
    if (!from || event.button !== 0 || event.pointerType === "touch") return; // a finger moves the view, and has the fields
    button.focus({ preventScroll: true });
    const start = [event.clientX, event.clientY] as const;
    let over: RunBlock | undefined;
    let carried = false;
    const mark = (target: RunBlock | undefined): void => {
      for (const found of button.parentElement!.children) found.classList.toggle("target", target !== undefined && Number((found as HTMLElement).dataset["facing"]) === target.facing);
    };
    follow(
      event,
      (moved) => {
        const by = [moved.clientX - start[0], moved.clientY - start[1]] as const;
        carried ||= Math.hypot(...by) >= clickMoves;
        if (!carried) return;
        button.classList.add("carried");
        button.style.translate = `${by[0]}px ${by[1]}px`;
        const now = this.under(moved, button);
        if (now === over) return;
        over = now;
        mark(over);
        this.actions.preview(over && [swapOf(from, over)]);
      },
      (last) => {
        button.classList.remove("carried");
        button.style.translate = "";
        mark(undefined);
        if (!carried) return;
        if (last && over) this.swap(from, over);
        else this.actions.preview(undefined);
      },
    );
  }

  private swap(a: RunBlock, b: RunBlock, facings?: number): void {
    this.chosen = b.facing; // where it stands then
    this.actions.change([swapOf(a, b, facings)]);
  }

  private of(facing: number | undefined): RunBlock | undefined {
    return facing === undefined ? undefined : this.blocks.find((block) => block.facing === facing);
  }

  private under(at: PointerEvent, button: HTMLElement): RunBlock | undefined {
    const found = document.elementsFromPoint(at.clientX, at.clientY).find((element) => element instanceof HTMLElement && element.dataset["facing"] !== undefined && element.parentElement === button.parentElement);
    return found && found !== button ? this.of(Number((found as HTMLElement).dataset["facing"])) : undefined;
  }

  private draw(): void {
    const block = this.of(this.chosen);
    this.form.hidden = block === undefined;
    if (!block) return;
    const { speech } = this;
    const go = element("button", { class: "act", text: speech.say("swapDo"), attributes: { type: "submit" } });
    go.disabled = true;
    const facings = element("input", { attributes: { type: "number", min: "1", max: "200", step: "1", placeholder: String(block.facings) } });
    const other = this.others(block);
    const look = (): void => {
      this.facings = facings.value === "" ? undefined : Number(facings.value);
      this.other = other.value === "" ? undefined : Number(other.value);
      const to = this.of(this.other);
      go.disabled = to === undefined;
      this.actions.preview(to && facings.validity.valid ? [swapOf(block, to, this.facings)] : undefined);
    };
    for (const field of [facings, other]) field.addEventListener("change", look);
    facings.dataset["field"] = "swap-facings";
    other.dataset["field"] = "swap-with";
    go.dataset["field"] = "swap-do";
    this.form.replaceChildren(
      element("strong", { text: this.nameOf(block) }),
      element("label", {}, element("span", { text: speech.say("facings") }), facings),
      element("label", {}, element("span", { text: speech.say("editSwap") }), other),
      go,
    );
  }

  private others(block: RunBlock): HTMLSelectElement {
    const select = element("select", {}, element("option", { text: this.speech.say("editSwapNone"), attributes: { value: "" } }));
    for (const [shelf, blocks] of byShelf(this.blocks)) {
      const options = blocks.filter((other) => other !== block).map((other) => element("option", { text: this.nameOf(other), attributes: { value: String(other.facing) } }));
      if (options.length > 0) select.append(element("optgroup", { attributes: { label: shelf } }, ...options));
    }
    return select;
  }

  private nameOf(block: RunBlock): string {
    const name = `${this.actions.nameOf(block.sku)} × ${block.facings}`;
    return block.products > 0 ? name : this.speech.say("swapSoldOut", { name });
  }
}
