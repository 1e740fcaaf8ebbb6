// Chooses the episode that is driven: one of the server's file, or one that is drawn for the store.
import { storeLink } from "../replay/addresses";
import { element, words } from "../ui/dom";
import type { Speech } from "../ui/speech";
import type { DrivePlace } from "./addresses";
import type { DriveAsk, DriveStatus } from "./contract";
import { driveTexts, say, type DriveKey } from "./strings";

export class ChooseCard {
  readonly page = element("main", { class: "drive-choose" });
  private readonly form = element("form", { class: "panel", on: { submit: (event) => this.submit(event) } });
  private readonly news = element("p", { class: "muted", attributes: { role: "status" } });
  private readonly track = element("select", { on: { change: () => this.fillTools() } });
  private readonly tools = element("select");
  private readonly offer = element("select");
  private readonly seed = element("input", { attributes: { type: "number", min: "0", max: "4294967295", value: "1", required: "" } });
  private readonly go = element("button", { class: "main", attributes: { type: "submit" } });

  constructor(
    private readonly speech: Speech,
    place: DrivePlace,
    private readonly status: DriveStatus,
    private readonly begin: (ask: DriveAsk) => void,
    tools: readonly HTMLElement[],
  ) {
    const home = element("a", { attributes: { href: storeLink(place) } });
    const [title, hint] = [element("h1"), element("p", { class: "muted" })];
    const labels = [this.labelled("episode", this.offer), this.labelled("track", this.track), this.labelled("tools", this.tools), this.labelled("seed", this.seed)];
    const shown = status.offers.length > 0 ? labels.slice(0, 1) : labels.slice(1);
    this.form.append(...shown, this.go, this.news);
    this.page.append(element("nav", { class: "links" }, home, ...tools), title, hint, this.form);
    speech.bind(() => {
      title.textContent = this.say("chooseTitle");
      hint.textContent = this.say("chooseHint", { folder: status.logs });
      home.textContent = this.say("toStore");
      this.go.textContent = this.say("start");
      this.fill();
    });
  }

  // What came of it so far; `busy`: it goes on.
  tell(text: string, busy: boolean): void {
    this.news.textContent = text;
    this.go.disabled = busy;
  }

  say(key: DriveKey, values?: Readonly<Record<string, string | number>>): string {
    return say(this.speech.language, key, values);
  }

  private labelled(key: DriveKey, input: HTMLElement): HTMLElement {
    const text = element("span");
    this.speech.bind(() => (text.textContent = this.say(key)));
    return element("label", {}, text, input);
  }

  private fill(): void {
    const put = (select: HTMLSelectElement, entries: readonly (readonly [string, string])[]): void => {
      const before = select.value;
      select.replaceChildren(...entries.map(([value, text]) => element("option", { text, attributes: { value } })));
      if (before) select.value = before;
    };
    put(this.track, this.status.tracks.map(({ track }) => [track, track in driveTexts.en ? this.say(track as DriveKey) : words(track)]));
    put(this.offer, this.status.offers.map(({ id, instruction }) => [id, `${id}: ${instruction}`]));
    this.fillTools();
  }

  private fillTools(): void {
    const tools = this.status.tracks.find(({ track }) => track === this.track.value)?.tools ?? [];
    this.tools.replaceChildren(...tools.map((name) => element("option", { text: words(name), attributes: { value: name } })));
    this.tools.parentElement!.hidden = tools.length < 2;
  }

  private submit(event: Event): void {
    event.preventDefault();
    const drawn = { track: this.track.value, episode: "", tools: this.tools.value, seed: Number(this.seed.value) };
    this.begin(this.status.offers.length > 0 ? { track: "", episode: this.offer.value, tools: "", seed: 0 } : drawn);
  }
}
