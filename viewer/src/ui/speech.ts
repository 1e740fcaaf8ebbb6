// The page's language: what is bound to it is said anew when it changes.
import { filled, languageOf, texts, type Language, type TextKey } from "../text/strings";
import { kept, keep } from "../state/kept";

export class Speech {
  language: Language;
  private readonly bound: (() => void)[] = [];

  constructor() {
    const chosen = kept("language");
    this.language = languageOf(chosen ? [chosen] : navigator.languages);
    this.apply();
  }

  say(key: TextKey, values?: Readonly<Record<string, string | number>>): string {
    return filled(texts[this.language][key], values);
  }

  number(value: number, digits = 0): string {
    return value.toLocaleString(this.language, { minimumFractionDigits: digits, maximumFractionDigits: digits });
  }

  // `currency`: ISO 4217.
  money(value: number, currency: string): string {
    return value.toLocaleString(this.language, { style: "currency", currency, currencyDisplay: "narrowSymbol" });
  }

  nameOf({ name, name_zh }: { readonly name: string; readonly name_zh: string }): string {
    return this.language === "zh" && name_zh ? name_zh : name;
  }

  bind(say: () => void): void {
    this.bound.push(say);
    say();
  }

  toggle(): void {
    this.language = this.language === "en" ? "zh" : "en";
    keep("language", this.language);
    this.apply();
    for (const say of this.bound) say();
  }

  private apply(): void {
    document.documentElement.lang = this.language === "zh" ? "zh-Hans" : "en";
  }
}
