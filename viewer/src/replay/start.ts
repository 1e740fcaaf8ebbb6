// Starts pages of replays: the list of a store's episodes, or one of them.
import { loadGoods, loadRest } from "../loader";
import { Stage } from "../stage/stage";
import { storesOf } from "../store/client";
import type { StoreLine } from "../store/contract";
import { element } from "../ui/dom";
import type { Speech } from "../ui/speech";
import type { Status } from "../ui/status";
import { Theme } from "../ui/theme";
import { episodeLink, listLink, storeLink, type ReplayPlace } from "./addresses";
import type { Replay, RunEpisodes } from "./contract";
import { ListPage, nameOfRun } from "./list_page";
import { Player } from "./player";
import { ReplayApp } from "./replay_app";
import { ReplayClient } from "./replay_client";
import { ReplayWords } from "./words";

// What tests and measurements read; nothing in the page depends on it.
interface Watched {
  replay?: { stage: Stage; app?: ReplayApp; times: Record<string, number> };
}

// The link of a store's page to its episodes, where there are some.
export async function offerEpisodes(place: Pick<ReplayPlace, "store" | "token">, speech: Speech, into: Element | null): Promise<void> {
  const runs = await new ReplayClient(place.store, place.token).runs();
  if (runs.length === 0 || !into) return;
  const words = new ReplayWords(speech);
  const link = element("a", { class: "to-episodes", attributes: { href: listLink(place) } });
  speech.bind(() => (link.textContent = words.say("episodes")));
  into.append(link);
}

export async function startReplay(place: ReplayPlace, speech: Speech, status: Status): Promise<void> {
  const client = new ReplayClient(place.store, place.token);
  const words = new ReplayWords(speech);
  if (place.run === undefined || place.episode === undefined) return showList(client, place, words);
  return showEpisode(client, place, words, status, place.run, place.episode);
}

// An evaluation may have episodes in several stores, each of which has its list.
async function storesWithRuns(token: string | null): Promise<StoreLine[]> {
  const stores = await storesOf(token);
  const runs = await Promise.all(stores.map(({ store }) => new ReplayClient(store, token).runs()));
  return stores.filter((_, i) => runs[i]!.length > 0);
}

async function showList(client: ReplayClient, place: ReplayPlace, words: ReplayWords): Promise<void> {
  const { speech } = words;
  const theme = new Theme(() => undefined);
  const tool = (key: "theme" | "language", press: () => void): HTMLElement => {
    const button = element("button", { attributes: { type: "button" }, on: { click: press } });
    speech.bind(() => (button.textContent = speech.say(key)));
    return button;
  };
  const tools = [tool("theme", () => theme.toggle()), tool("language", () => speech.toggle())];
  const [runs, stores] = await Promise.all([ListPage.load(client), storesWithRuns(place.token)]);
  document.body.classList.add("listing");
  document.body.append(new ListPage(words, place, client, runs, stores, tools).page);
  speech.bind(() => (document.title = `${words.say("episodes")} · MarketGen`));
}

interface Watching {
  readonly run: number;
  readonly episode: number;
  readonly replay: Replay;
}

// The episode, and the same one of another run where that is asked for.
async function watching(client: ReplayClient, run: number, episode: number, beside: number | undefined, others: readonly RunEpisodes[]): Promise<Watching[]> {
  const first = { run, episode, replay: await client.replay(run, episode) };
  const { id } = first.replay.result;
  const same = others.find((other) => other.run.run === beside)?.episodes.find((line) => line.id === id);
  if (beside === undefined || !same) return [first];
  return [first, { run: beside, episode: same.episode, replay: await client.replay(beside, same.episode) }];
}

// Chooses the run beside.
function besideChoice(place: ReplayPlace, words: ReplayWords, shown: readonly Watching[], others: readonly RunEpisodes[]): HTMLElement[] {
  const [first, second] = shown;
  const { id } = first!.replay.result;
  const same = others.filter(({ run, episodes }) => run.run !== first!.run && episodes.some((line) => line.id === id && line.recorded));
  if (same.length === 0) return [];
  const options = [element("option", { text: words.say("besideNone"), attributes: { value: "" } }), ...same.map(({ run }) => element("option", { text: nameOfRun(run), attributes: { value: String(run.run) } }))];
  const choice = element("select", {}, ...options);
  choice.value = second ? String(second.run) : "";
  choice.addEventListener("change", () => location.assign(episodeLink(place, first!.run, first!.episode, choice.value === "" ? undefined : Number(choice.value))));
  return [element("label", { class: "beside" }, element("span", { text: words.say("beside") }), choice)];
}

function standBeside(players: readonly Player[]): void {
  const [left, right] = players;
  if (!left || !right) return;
  for (const [own, other] of [[left, right], [right, left]] as const) {
    own.standStill(other);
    own.restingJoints = other.joints.filter((joint) => !own.joints.includes(joint));
  }
}

async function showEpisode(client: ReplayClient, place: ReplayPlace, words: ReplayWords, status: Status, run: number, episode: number): Promise<void> {
  const { speech } = words;
  const stage = Stage.create();
  if (!stage) return status.stop(new Error(speech.say("noWebgl")));
  const { canvas } = stage;
  document.body.prepend(canvas);
  const times: Record<string, number> = {};
  const watched = ((window as Watched).replay = { stage, times } as NonNullable<Watched["replay"]>);
  status.work(0.05, speech.say("loading"));
  const others = await ListPage.load(client);
  const shown = await watching(client, run, episode, place.beside, others);
  const replays = shown.map(({ replay }) => replay);
  const stood = client.ofPlace(replays[0]!.place);
  const clients = shown.map((each) => client.ofEpisode(each.run, each.episode));
  const failed = (error: unknown): void => status.say(status.textOf(error));
  const [summary, ...players] = await Promise.all([stood.summary(), ...replays.map((replay, i) => Player.create(clients[i]!, stage, replay, failed))]);
  const links = (): HTMLElement[] => [
    element("a", { text: words.say("toList"), attributes: { href: listLink(place) } }),
    element("a", { text: words.say("toStore"), attributes: { href: storeLink(place) } }),
    ...besideChoice(place, words, shown, others),
  ];
  const app = (watched.app = new ReplayApp(stage, summary, replays[0]!, players, words, status, clients[0]!, links));
  new ResizeObserver(() => stage.resize()).observe(canvas);
  stage.resize();
  const loop = (now: number): void => {
    app.frame(now);
    requestAnimationFrame(loop);
  };
  requestAnimationFrame(loop);
  const watch = { step: (share: number | undefined) => status.work(share, speech.say("loading")), shown: (what: string) => (times[what] = performance.now()) };
  const goods = await loadGoods(stood, stage, summary, watch, Player.movedRows(replays));
  await Promise.all([loadRest(stood, stage, goods, summary, watch), ...players.map((player, i) => player.addGoods(clients[i]!))]);
  standBeside(players);
  stage.complete();
  times["complete"] = performance.now();
}
