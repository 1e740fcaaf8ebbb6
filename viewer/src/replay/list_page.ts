// The episodes of all evaluations of a store, to choose one from.
import { element } from "../ui/dom";
import type { StoreLine } from "../store/contract";
import type { EpisodeLine, RunEpisodes } from "./contract";
import { episodeLink, listLink, storeLink, type ReplayPlace } from "./addresses";
import { Gallery } from "./gallery";
import type { ReplayClient } from "./replay_client";
import { failureText, timeText, type ReplayWords } from "./words";

// "": all; "failed"; "solved"; or a failure's code.
export type Wanted = string;

export function isWanted(line: EpisodeLine, wanted: Wanted): boolean {
  if (wanted === "") return true;
  if (wanted === "failed") return !line.strict;
  return wanted === "solved" ? line.strict : line.failure === wanted;
}

export class ListPage {
  readonly page = element("main", { class: "replay-list" });
  private readonly rows = element("div", { class: "rows" });
  private readonly choice = element("select", { on: { change: () => this.fill() } });
  private readonly inPictures = element("input", { attributes: { type: "checkbox" }, on: { change: () => this.fill() } });
  private readonly gallery: Gallery;
  private readonly runChoice = element("select", { on: { change: () => this.fill() } });
  private readonly storeChoice = element("select", { on: { change: () => location.assign(listLink({ ...this.place, store: Number(this.storeChoice.value) })) } });

  constructor(
    private readonly words: ReplayWords,
    private readonly place: ReplayPlace,
    client: ReplayClient,
    private readonly runs: readonly RunEpisodes[],
    private readonly stores: readonly StoreLine[],
    tools: readonly HTMLElement[],
  ) {
    this.gallery = new Gallery(words, place, client);
    const pictures = element("span");
    const title = element("h1");
    const home = element("a", { attributes: { href: storeLink(place) } });
    const show = element("span");
    const run = element("span");
    const store = element("span");
    const ofStores = stores.length > 1 ? [element("label", {}, store, this.storeChoice)] : [];
    this.page.append(element("header", {}, element("nav", { class: "links" }, home, ...tools), title, element("div", { class: "choices" }, ...ofStores, element("label", {}, run, this.runChoice), element("label", {}, show, this.choice), element("label", {}, this.inPictures, pictures))), this.rows);
    words.speech.bind(() => {
      title.textContent = words.say("episodes");
      home.textContent = words.say("toStore");
      show.textContent = words.say("show");
      run.textContent = words.say("run");
      store.textContent = words.say("ofStore");
      pictures.textContent = words.say("gallery");
      this.offer();
      this.fill();
    });
  }

  static async load(client: ReplayClient): Promise<RunEpisodes[]> {
    return Promise.all((await client.runs()).map(({ run }) => client.episodes(run)));
  }

  private offer(): void {
    const { words, runs } = this;
    const codes = [...new Set(runs.flatMap(({ run }) => run.failures.map(({ code }) => code)))].filter((code) => code !== "None").sort();
    const options = [["", words.say("allEpisodes")], ["failed", words.say("allFailures")], ["solved", words.say("solvedOnes")], ...codes.map((code) => [code, code])] as const;
    const put = (select: HTMLSelectElement, entries: readonly (readonly string[])[]): void => {
      const before = select.value;
      select.replaceChildren(...entries.map(([value, text]) => element("option", { text: text!, attributes: { value: value! } })));
      if (entries.some(([value]) => value === before)) select.value = before;
    };
    put(this.choice, options);
    put(this.storeChoice, this.stores.map(({ store, name, folder, seed }) => [String(store), words.say("storeOf", { name, folder, seed })]));
    this.storeChoice.value = String(this.place.store);
    put(this.runChoice, [["", words.say("allEpisodes")], ...runs.map(({ run }) => [String(run.run), nameOfRun(run)])]);
  }

  private fill(): void {
    const { words } = this;
    const shown = this.runs.filter(({ run }) => this.runChoice.value === "" || String(run.run) === this.runChoice.value);
    const chosen = shown.flatMap(({ run, episodes }) => episodes.filter((line) => isWanted(line, this.choice.value)).map((line) => [run, line] as const));
    if (this.inPictures.checked && chosen.length > 0) {
      this.gallery.show(chosen);
      return this.rows.replaceChildren(this.gallery.grid);
    }
    const parts = shown.map((run) => this.runPart(run)).filter((part) => part !== undefined);
    const nothing = element("p", { class: "muted", text: words.say(this.runs.length === 0 ? "noRuns" : "none") });
    this.rows.replaceChildren(...(parts.length > 0 ? parts : [nothing]));
  }

  private runPart({ run, episodes }: RunEpisodes): HTMLElement | undefined {
    const { words } = this;
    const lines = episodes.filter((line) => isWanted(line, this.choice.value));
    if (lines.length === 0) return undefined;
    const head = element("tr", {}, ...(["episode", "goals", "outcome", "time", "watch"] as const).map((key) => element("th", { text: words.say(key), attributes: { scope: "col" } })));
    const table = element("table", {}, element("thead", {}, head), element("tbody", {}, ...lines.map((line) => this.row(run.run, line))));
    const { strict, clean } = run;
    return element("section", { class: "panel" }, element("h2", { text: nameOfRun(run) }), element("p", { class: "muted", text: words.say("runSummary", { strict, clean, episodes: run.episodes }) }), table);
  }

  private row(run: number, line: EpisodeLine): HTMLElement {
    const { words } = this;
    const watch = line.recorded
      ? element("a", { text: words.say("watch"), attributes: { href: episodeLink(this.place, run, line.episode), "aria-label": `${words.say("watch")}: ${line.id}` } })
      : element("span", { class: "muted", text: words.say("notRecorded"), attributes: { title: words.say("notRecordedHint") } });
    return element(
      "tr",
      {},
      element("td", { class: "id", text: line.id }),
      element("td", { text: `${line.hits}/${line.asked}` }),
      element("td", { class: line.strict ? "solved" : "failed", text: line.strict ? words.outcome(line) : line.void ? words.say("void") : failureText(line.failure), attributes: { title: line.detail } }),
      element("td", { class: "time", text: timeText(line.simulated_s) }),
      element("td", {}, watch),
    );
  }
}

export function nameOfRun({ policy, realism, folder }: { policy: string; realism: string; folder: string }): string {
  return `${policy} · ${realism} · ${folder}`;
}
