// A button with a list that opens above it. Works with arrows, Enter and Escape.
import { element } from "./dom";

export interface MenuEntry {
  readonly text: string;
  readonly choose: () => void;
}

export class Menu {
  readonly root: HTMLElement;
  private list: HTMLElement | undefined;

  constructor(
    private readonly button: HTMLButtonElement,
    private readonly entries: () => readonly MenuEntry[],
  ) {
    button.setAttribute("aria-haspopup", "menu");
    button.setAttribute("aria-expanded", "false");
    button.addEventListener("click", () => (this.list ? this.close() : this.open()));
    this.root = element("div", { class: "menu-root" }, button);
    this.root.addEventListener("keydown", (event) => this.step(event));
    document.addEventListener("pointerdown", (event) => {
      if (this.list && !this.root.contains(event.target as Node) && !this.list.contains(event.target as Node)) this.close();
    });
  }

  private open(): void {
    this.list = element("div", { class: "menu panel", attributes: { role: "menu" } });
    for (const entry of this.entries()) {
      const item = element("button", { text: entry.text, attributes: { type: "button", role: "menuitem", tabindex: "-1" } });
      item.addEventListener("click", () => {
        this.close();
        this.button.focus({ preventScroll: true });
        entry.choose();
      });
      this.list.append(item);
    }
    this.list.addEventListener("keydown", (event) => this.step(event));
    document.body.append(this.list);
    this.place(this.list);
    this.button.setAttribute("aria-expanded", "true");
    this.list.querySelector("button")?.focus();
  }

  // Above the button and within the page: the bar itself may scroll.
  private place(list: HTMLElement): void {
    const at = this.button.getBoundingClientRect();
    const left = Math.min(Math.max(at.left + at.width / 2 - list.offsetWidth / 2, 8), innerWidth - list.offsetWidth - 8);
    list.style.left = `${left}px`;
    list.style.bottom = `${innerHeight - at.top + 8}px`;
  }

  private close(): void {
    this.list?.remove();
    this.list = undefined;
    this.button.setAttribute("aria-expanded", "false");
  }

  private step(event: KeyboardEvent): void {
    if (!this.list) return;
    if (event.key === "Escape" || event.key === "Tab") {
      this.close();
      this.button.focus();
      if (event.key === "Escape") event.preventDefault();
      event.stopPropagation();
      return;
    }
    const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (step === undefined) return;
    const items = [...this.list.querySelectorAll("button")];
    const now = items.indexOf(document.activeElement as HTMLButtonElement);
    items[(now + step + items.length) % items.length]?.focus();
    event.preventDefault();
    event.stopPropagation();
  }
}
