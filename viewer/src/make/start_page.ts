// The page in which stores are made: describe one, compare what comes of it with several seeds, keep one.
import { storeLink } from "../replay/addresses";
import { element } from "../ui/dom";
import type { Speech } from "../ui/speech";
import type { Status } from "../ui/status";
import { Theme } from "../ui/theme";
import { makeLink, type MakePlace } from "./addresses";
import { AskForm } from "./ask_form";
import { storesOf } from "../store/client";
import type { StoreLine } from "../store/contract";
import type { Ask, MakeOptions, Tries } from "./contract";
import { MakeClient } from "./make_client";
import { say, type MakeKey } from "./strings";
import { TryCard } from "./try_card";

const pollMilliseconds = 300;

export class StartPage {
  readonly page = element("main", { class: "make" });
  private readonly client: MakeClient;
  private readonly form: AskForm;
  private readonly cards = element("section", { class: "tries", attributes: { "aria-live": "polite" } });
  private readonly news = element("div", { class: "news" });
  private byRow: TryCard[] = [];
  private batch = 0;
  private last: Tries | undefined;
  private polling = false;

  constructor(
    private readonly place: MakePlace,
    private readonly speech: Speech,
    private readonly status: Status,
    options: MakeOptions,
    stores: readonly StoreLine[],
  ) {
    this.client = new MakeClient(place.token);
    this.form = new AskForm(speech, options, (ask) => this.begin(ask), (error) => status.textOf(error));
    const theme = new Theme(() => undefined);
    const tools = [this.tool("theme", () => theme.toggle()), this.tool("language", () => speech.toggle())];
    const title = element("h1");
    const note = element("p", { class: "muted" });
    this.page.append(element("header", {}, element("nav", { class: "links" }, ...tools), title, note), ...this.openedStores(stores), this.form.root, this.news, this.cards);
    const from = stores.find(({ store }) => store === place.from);
    if (from) this.form.start(from.prompt, from.seed);
    speech.bind(() => {
      title.textContent = this.say("title");
      note.textContent = this.say("keptIn", { folder: options.folder });
      if (this.last) this.show(this.last, true);
    });
  }

  // A page that is loaded anew shows what was asked for before.
  async resume(): Promise<void> {
    const tries = await this.client.tries();
    if (tries.batch > 0) this.follow(tries);
  }

  private say(key: MakeKey, values?: Readonly<Record<string, string | number>>): string {
    return say(this.speech.language, key, values);
  }

  private tool(key: "theme" | "language", press: () => void): HTMLElement {
    const button = element("button", { attributes: { type: "button" }, on: { click: press } });
    this.speech.bind(() => (button.textContent = this.speech.say(key)));
    return button;
  }

  private openedStores(stores: readonly StoreLine[]): HTMLElement[] {
    if (stores.length === 0) return [];
    const title = element("h2");
    const list = element("ul");
    this.speech.bind(() => {
      title.textContent = this.say("opened");
      list.replaceChildren(
        ...stores.map(({ store, name, folder, prompt, products }) => {
          const open = element("a", { text: `${name} (${folder})`, attributes: { href: storeLink({ store, token: this.place.token }) } });
          const again = prompt ? element("a", { class: "again", text: this.say("changeWords"), attributes: { href: makeLink(this.place.token, store) } }) : undefined;
          return element("li", {}, open, element("span", { class: "muted", text: this.say("products", { count: this.speech.number(products) }) }), again);
        }),
      );
    });
    return [element("section", { class: "opened panel" }, title, list)];
  }

  private async begin(ask: Ask): Promise<void> {
    this.follow(await this.client.begin(ask));
    this.cards.scrollIntoView({ block: "nearest" });
  }

  private follow(tries: Tries): void {
    this.show(tries);
    if (tries.working && !this.polling) void this.poll();
  }

  private async poll(): Promise<void> {
    this.polling = true;
    try {
      for (let working = true; working; ) {
        await new Promise((done) => setTimeout(done, pollMilliseconds));
        const tries = await this.client.tries();
        this.show(tries);
        ({ working } = tries);
      }
    } catch (error) {
      this.status.say(this.status.textOf(error));
      this.form.busy(false);
    }
    this.polling = false;
  }

  private show(tries: Tries, again = false): void {
    this.last = tries;
    if (tries.batch !== this.batch) {
      this.batch = tries.batch;
      this.byRow = tries.tries.map(() => this.card());
      this.cards.replaceChildren(...this.byRow.map(({ root }) => root));
    }
    this.form.busy(tries.working);
    this.news.replaceChildren(
      ...(tries.error ? [element("p", { class: "failed", text: tries.error.message, attributes: { role: "alert" } })] : []),
      ...tries.warnings.map((text) => element("p", { class: "muted", text })),
    );
    this.cards.hidden = tries.error !== undefined;
    tries.tries.forEach((each, row) => this.byRow[row]?.show(each, again));
  }

  private card(): TryCard {
    const { batch } = this;
    return new TryCard(this.speech, {
      keep: async (seed, name) => {
        const { store } = await this.client.keep(batch, seed, name);
        location.assign(storeLink({ store, token: this.place.token }));
      },
      textOf: (error) => this.status.textOf(error),
      pictureAddress: (seed) => this.client.pictureAddress(batch, seed),
    });
  }
}

export async function startMaking(place: MakePlace, speech: Speech, status: Status): Promise<void> {
  const client = new MakeClient(place.token);
  const [options, stores] = await Promise.all([client.options(), storesOf(place.token)]);
  document.body.classList.add("listing");
  const start = new StartPage(place, speech, status, options, stores);
  document.body.append(start.page);
  speech.bind(() => (document.title = `${say(speech.language, "title")} · MarketGen`));
  await start.resume();
}
