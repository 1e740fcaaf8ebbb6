// Starts the page in which a robot is driven: the choice of an episode, or the one that is open.
import { loadGoods, loadRest } from "../loader";
import { Player } from "../replay/player";
import { ReplayWords } from "../replay/words";
import { storeLink } from "../replay/addresses";
import { Stage } from "../stage/stage";
import { element } from "../ui/dom";
import type { Speech } from "../ui/speech";
import type { Status } from "../ui/status";
import { Theme } from "../ui/theme";
import { driveLink, type DrivePlace } from "./addresses";
import { ChooseCard } from "./choose_card";
import type { DriveAsk, DriveEpisode, DriveMoment, DriveStatus } from "./contract";
import { DriveApp } from "./drive_app";
import { DriveClient, DriveSocket } from "./drive_client";
import { Live } from "./live";
import { say } from "./strings";
import type { Packed } from "../store/packed";

const pollMilliseconds = 300;

// What tests and measurements read; nothing in the page depends on it.
interface Watched {
  drive?: { stage?: Stage; app?: DriveApp; socket?: DriveSocket; times: Record<string, number> };
}

// The link of a store's page to the drive.
export function offerDriving(place: Pick<DrivePlace, "store" | "token">, speech: Speech, into: Element | null): void {
  const link = element("a", { class: "to-drive", attributes: { href: driveLink(place) } });
  speech.bind(() => (link.textContent = say(speech.language, "drive")));
  into?.append(link);
}

export async function startDriving(place: DrivePlace, speech: Speech, status: Status): Promise<void> {
  const client = new DriveClient(place.store, place.token);
  const now = await client.status();
  if (now.phase === "driving" && !place.chooses) return showDrive(client, place, speech, status, now);
  return choose(client, place, speech, status, now);
}

async function choose(client: DriveClient, place: DrivePlace, speech: Speech, status: Status, now: DriveStatus): Promise<void> {
  const theme = new Theme(() => undefined);
  const tool = (key: "theme" | "language", press: () => void): HTMLElement => {
    const button = element("button", { attributes: { type: "button" }, on: { click: press } });
    speech.bind(() => (button.textContent = speech.say(key)));
    return button;
  };
  const tools = [tool("theme", () => theme.toggle()), tool("language", () => speech.toggle())];
  if (now.phase === "driving") tools.unshift(element("a", { text: say(speech.language, "lookOn"), attributes: { href: driveLink(place) } }));
  const begin = async (ask: DriveAsk): Promise<void> => {
    try {
      await client.begin(ask);
      await wait();
    } catch (error) {
      card.tell(status.textOf(error), false);
    }
  };
  const wait = async (): Promise<void> => {
    card.tell(card.say("opening"), true);
    for (;;) {
      const { phase, error } = await client.status();
      if (phase === "driving") return location.replace(driveLink(place));
      if (phase !== "opening") return card.tell(error ? card.say("failed", { message: error }) : "", false);
      await new Promise((done) => setTimeout(done, pollMilliseconds));
    }
  };
  const card = new ChooseCard(speech, place, now, (ask) => void begin(ask), tools);
  document.body.classList.add("listing");
  document.body.append(card.page);
  speech.bind(() => (document.title = `${card.say("drive")} · MarketGen`));
  if (now.phase === "opening") await wait();
  else if (now.phase === "failed") card.tell(card.say("failed", { message: now.error }), false);
  else if (now.taken) card.tell(card.say("takenChoose"), false);
}

async function showDrive(client: DriveClient, place: DrivePlace, speech: Speech, status: Status, now: DriveStatus): Promise<void> {
  const stage = Stage.create();
  if (!stage) return status.stop(new Error(speech.say("noWebgl")));
  const { canvas } = stage;
  document.body.prepend(canvas);
  const times: Record<string, number> = {};
  const watched = ((window as Watched).drive = { stage, times } as NonNullable<Watched["drive"]>);
  status.work(0.05, speech.say("loading"));
  const episode = now.episode!;
  const words = new ReplayWords(speech);
  const live = new Live();
  const stood = client.ofPlace(episode.place);
  const [summary, robot] = await Promise.all([stood.summary(), client.packed<unknown>("/robot.bin")]);
  const player = Player.live<DriveEpisode>(robot, stage, episode, live.bodies, live.things);
  const links = (): HTMLElement[] => [
    element("a", { text: say(speech.language, "toStore"), attributes: { href: storeLink(place) } }),
    ...(now.watched ? [] : [element("a", { text: say(speech.language, "another"), attributes: { href: driveLink(place, true) } })]),
  ];
  const app = (watched.app = new DriveApp(stage, summary, episode, player, live, words, status, client, () => socket, links, now.watched ? "program" : "person"));
  const cast = new GrowingCast(client, stage, player, episode);
  const socket: DriveSocket = (watched.socket = new DriveSocket(client, {
    moment: (message: Packed<DriveMoment>) => {
      if (message.head.generation !== now.generation) return location.reload();
      app.moment(message);
      cast.grow(message.head.things).catch((error: unknown) => status.say(status.textOf(error)));
    },
    note: (note) => app.note(note),
    closed: () => app.closed(),
  }));
  new ResizeObserver(() => stage.resize()).observe(canvas);
  stage.resize();
  canvas.focus({ preventScroll: true });
  const loop = (at: number): void => {
    app.frame(at);
    requestAnimationFrame(loop);
  };
  requestAnimationFrame(loop);
  const watch = { step: (share: number | undefined) => status.work(share, speech.say("loading")), shown: (what: string) => (times[what] = performance.now()) };
  const goods = await loadGoods(stood, stage, summary, watch, Player.movedRows([episode]));
  await Promise.all([loadRest(stood, stage, goods, summary, watch), cast.grow(episode.things.length)]);
  stage.complete();
  times["complete"] = performance.now();
}

// Things that are drawn as they move: what is pushed for the first time is added.
class GrowingCast {
  private shown = 0;
  private growing = false;

  constructor(
    private readonly client: DriveClient,
    private readonly stage: Stage,
    private readonly player: Player<DriveEpisode>,
    private readonly episode: DriveEpisode,
  ) {}

  // Until there are so many.
  async grow(count: number): Promise<void> {
    if (this.growing || count <= this.shown || !this.stage.goods) return;
    this.growing = true;
    try {
      const known = count <= this.episode.things.length ? this.episode : (await this.client.status()).episode;
      const things = known?.things.slice(this.shown) ?? [];
      const meshes = things.map(({ mesh }) => mesh).filter((mesh) => mesh >= 0);
      const first = Math.min(...meshes);
      if (meshes.length > 0) await this.player.addGoods(this.client.shapes(first, Math.max(...meshes) + 1), things, this.shown, first);
      for (const { kind, number } of things) if (kind === "product") this.stage.goods.leaveOut(number);
      this.shown += things.length;
    } finally {
      this.growing = false;
    }
  }
}
