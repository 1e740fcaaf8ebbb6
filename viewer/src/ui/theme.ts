// Light or dark: what the system says until the reader chooses.
import { keep, kept } from "../state/kept";

const system = matchMedia("(prefers-color-scheme: dark)");

export class Theme {
  constructor(private readonly changed: (background: string) => void) {
    const chosen = kept("theme");
    if (chosen === "light" || chosen === "dark") document.documentElement.dataset["theme"] = chosen;
    system.addEventListener("change", () => this.tell());
    this.tell();
  }

  get dark(): boolean {
    const chosen = document.documentElement.dataset["theme"];
    return chosen ? chosen === "dark" : system.matches;
  }

  toggle(): void {
    const next = this.dark ? "light" : "dark";
    document.documentElement.dataset["theme"] = next;
    keep("theme", next);
    this.tell();
  }

  private tell(): void {
    this.changed(this.dark ? "#17191c" : "#e9ebee");
  }
}
