// The panel at the upper left: whose store it is, and the search in it.
import { ServerError } from "../store/client";
import type { Hit, Summary } from "../store/contract";
import { element, icon } from "./dom";
import type { Speech } from "./speech";

export interface SearchActions {
  ask(query: string, signal: AbortSignal): Promise<readonly Hit[]>;
  found(hits: readonly Hit[], query: string): void; // [] when the search is cleared
  choose(hit: Hit): void;
  failed(error: unknown): void;
}

const pause = 180; // milliseconds of no typing before the server is asked
export const shownHits = 12;

export class SearchPanel {
  readonly panel: HTMLElement;
  private readonly input: HTMLInputElement;
  private readonly clearButton: HTMLButtonElement;
  readonly showCounts: () => void; // anew, after the summary has changed
  private readonly note: HTMLElement;
  private readonly list: HTMLElement;
  private hits: readonly Hit[] = [];
  private active = -1;
  private timer = 0;
  private asking: AbortController | undefined;

  constructor(
    private readonly speech: Speech,
    private readonly actions: SearchActions,
    summary: Summary,
  ) {
    const name = element("h1", { text: summary.name });
    const counts = element("p", { class: "muted" });
    this.input = element("input", {
      attributes: { type: "search", role: "combobox", autocomplete: "off", spellcheck: "false", maxlength: "200", "aria-expanded": "false", "aria-controls": "hits" },
    });
    this.clearButton = element("button", { class: "clear", attributes: { type: "button" }, on: { click: () => this.clear() } }, icon("close"));
    this.note = element("p", { class: "note muted", attributes: { role: "status" } });
    this.list = element("ul", { id: "hits", class: "hits", attributes: { role: "listbox" } });
    const field = element("div", { class: "field" }, icon("search"), this.input, this.clearButton);
    this.panel = element("section", { class: "search panel" }, element("header", {}, name, counts), field, this.note, this.list);
    this.clearButton.hidden = this.note.hidden = this.list.hidden = true;
    this.listen();
    this.showCounts = () => {
      const { products, skus, fixtures } = summary.counts;
      counts.textContent = speech.say("counts", {
        products: speech.number(products),
        skus: speech.number(skus),
        fixtures: speech.number(fixtures),
      });
    };
    speech.bind(() => {
      this.showCounts();
      this.input.placeholder = speech.say("search");
      this.input.setAttribute("aria-label", `${speech.say("search")}: ${speech.say("searchHint")}`);
      this.clearButton.setAttribute("aria-label", speech.say("clear"));
      this.list.setAttribute("aria-label", speech.say("search"));
      this.show();
    });
  }

  get query(): string {
    return this.input.value.trim();
  }

  focus(): void {
    this.input.focus();
    this.input.select();
  }

  clear(): void {
    this.input.value = "";
    void this.search();
  }

  async start(query: string): Promise<void> {
    this.input.value = query;
    await this.search();
  }

  private listen(): void {
    this.input.addEventListener("input", () => {
      clearTimeout(this.timer);
      this.timer = window.setTimeout(() => void this.search(), pause);
    });
    this.input.addEventListener("keydown", (event) => this.key(event));
  }

  private key(event: KeyboardEvent): void {
    if (event.key === "ArrowDown" || event.key === "ArrowUp") {
      const count = Math.min(this.hits.length, shownHits);
      if (count === 0) return;
      this.active = (this.active + (event.key === "ArrowDown" ? 1 : count - 1) + (this.active < 0 && event.key === "ArrowUp" ? 1 : 0)) % count;
      this.showActive();
      event.preventDefault();
    } else if (event.key === "Enter") {
      const hit = this.hits[Math.max(this.active, 0)];
      if (hit) this.actions.choose(hit);
    } else if (event.key === "Escape") {
      if (this.input.value) this.clear();
      else this.input.blur();
      event.stopPropagation();
    }
  }

  private async search(): Promise<void> {
    this.asking?.abort();
    const query = this.query;
    this.clearButton.hidden = query === "";
    if (query === "") return this.answer([], "");
    const asking = (this.asking = new AbortController());
    try {
      const hits = await this.actions.ask(query, asking.signal);
      if (!asking.signal.aborted) this.answer(hits, query);
    } catch (error) {
      if (asking.signal.aborted) return;
      this.answer([], query);
      this.actions.failed(error instanceof ServerError ? error : new Error(String(error)));
    }
  }

  private answer(hits: readonly Hit[], query: string): void {
    this.hits = hits;
    this.active = -1;
    this.show();
    this.actions.found(hits, query);
  }

  private show(): void {
    const query = this.query;
    const { speech, hits } = this;
    this.note.hidden = query === "";
    this.note.textContent = hits.length > 0 ? speech.say("results", { count: speech.number(hits.length) }) : speech.say("noResults", { query });
    this.list.replaceChildren(...hits.slice(0, shownHits).map((hit, i) => this.row(hit, i)));
    this.list.hidden = hits.length === 0;
    this.input.setAttribute("aria-expanded", String(hits.length > 0));
    if (hits.length > shownHits) {
      this.list.append(element("li", { class: "muted rest", text: speech.say("moreResults", { count: speech.number(hits.length - shownHits) }) }));
    }
  }

  private row(hit: Hit, i: number): HTMLElement {
    const { speech } = this;
    const row = element(
      "li",
      { id: `hit-${i}`, attributes: { role: "option", "aria-selected": "false" } },
      element("span", { class: "name", text: hit.name }),
      element("span", { class: "price", text: speech.money(hit.price, hit.currency) }),
      element("span", { class: "muted", text: speech.say("pieces", { count: speech.number(hit.products.length) }) }),
    );
    row.addEventListener("click", () => {
      this.active = i;
      this.showActive();
      this.actions.choose(hit);
    });
    return row;
  }

  private showActive(): void {
    [...this.list.children].forEach((row, i) => {
      row.setAttribute("aria-selected", String(i === this.active));
      if (i === this.active) row.scrollIntoView({ block: "nearest" });
    });
    this.input.setAttribute("aria-activedescendant", `hit-${this.active}`);
  }
}
