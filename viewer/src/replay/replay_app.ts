// The page of a recorded episode: the robot and the goods move as they did.
import { topFov, Navigator } from "../camera/navigator";
import { modes, type Mode } from "../camera/modes";
import { lookingAt, type Pose } from "../camera/pose";
import { roomOf } from "../camera/store_room";
import type { Summary } from "../store/contract";
import { screensOf, Sight } from "../stage/sight";
import type { Stage } from "../stage/stage";
import { element, reduced } from "../ui/dom";
import { Hands } from "../ui/hands";
import type { Status } from "../ui/status";
import { Theme } from "../ui/theme";
import { RoomLight } from "./actor_light";
import { CameraPanel } from "./camera_panel";
import { Clock } from "./clock";
import type { Replay } from "./contract";
import { InfoPanel } from "./info_panel";
import { nextFrom } from "./marks";
import { Player } from "./player";
import { PlayerBar } from "./player_bar";
import type { ReplayClient } from "./replay_client";
import { ReplayHelp } from "./replay_help";
import { aisleView, counterView, RobotEye } from "./robot_eye";
import type { ReplayWords } from "./words";

const longestFrame = 2; // seconds: after a longer pause (a tab in the background) a replay goes on from where it was
const usualFov = 55;
const barEvery = 100; // milliseconds between two times that the bar tells while playing
const relitAtOnce = 8;

const halfAway = 1.35; // times as far off where each has but half of the picture

export class ReplayApp {
  readonly navigator: Navigator;
  readonly clock: Clock;
  waiting = false;
  private readonly bar: PlayerBar;
  private readonly infos: readonly InfoPanel[];
  readonly camera: CameraPanel;
  private readonly help: ReplayHelp;
  private readonly hands: Hands;
  private light: RoomLight | undefined; // once the room has come
  private lastFrame = 0;
  private lastTold = 0;
  private shownPose: Pose | undefined;
  private shownStep = -1;
  private readonly eye: RobotEye;

  constructor(
    private readonly stage: Stage,
    summary: Summary,
    replay: Replay,
    readonly players: readonly Player[],
    private readonly words: ReplayWords,
    private readonly status: Status,
    pictures: ReplayClient,
    links: () => readonly HTMLElement[],
  ) {
    stage.ceilingHeight = summary.ceiling_m;
    stage.sight = new Sight(screensOf(summary.fixtures));
    stage.setLens(usualFov);
    const steps = Math.max(...players.map((player) => player.replay.steps));
    this.clock = new Clock(steps, replay.step_s);
    const [left, right] = players;
    if (left && right) stage.halves = (half) => [left, right].forEach((player, i) => player.reveal(i === half));
    this.navigator = new Navigator(roomOf(summary), "orbit", lookingAt([0, 0, 2], [1, 1, 1]), 2);
    this.eye = new RobotEye(this.navigator, replay.place < 0 ? aisleView : counterView, players.length > 1 ? halfAway : 1);
    const theme = new Theme((background) => stage.setBackground(background));
    const { speech } = words;
    const seek = (step: number): void => this.seek(step);
    const actions = { toggle: () => this.toggle(), nudge: (by: 1 | -1) => this.nudge(by), event: (by: 1 | -1) => this.toEvent(by), seek, speed: (to: number) => this.setSpeed(to), follow: () => this.toggleFollow(), camera: () => this.toggleCamera() };
    this.bar = new PlayerBar(words, actions, this.clock, players.map((player) => player.replay));
    this.help = new ReplayHelp(words);
    const tools = { theme: () => theme.toggle(), language: () => speech.toggle(), help: () => this.help.open() };
    const tool = (key: "theme" | "language" | "help"): HTMLElement => element("button", { text: speech.say(key), attributes: { type: "button" }, on: { click: tools[key] } });
    this.infos = players.map((player, i) => new InfoPanel(words, { seek }, player.replay, () => (i === 0 ? [...links(), tool("theme"), tool("language"), tool("help")] : []), i === 0));
    this.infos[1]?.panel.classList.add("right");
    document.body.classList.toggle("side-by-side", players.length > 1);
    this.camera = new CameraPanel(words, pictures, replay.step_s, replay.cameras, () => this.toggleCamera());
    this.hands = this.makeHands();
    document.body.append(...this.infos.map(({ panel }) => panel), this.camera.panel, this.bar.bar, this.help.dialog);
    speech.bind(() => {
      stage.canvas.setAttribute("aria-label", words.say("view3d"));
      document.title = `${replay.result.id} · ${replay.run.policy} · MarketGen`;
      this.tell();
    });
  }

  // One turn of the page's loop.
  frame(now: number): void {
    const seconds = Math.min((now - this.lastFrame) / 1000, longestFrame);
    this.lastFrame = now;
    this.play(this.waiting ? 0 : seconds, now);
    this.camera.want(this.clock.step, this.clock.playing);
    if (this.shownStep >= 0) this.eye.follow(this.players[0]!);
    this.navigator.step(this.navigator.flying ? seconds : Math.min(seconds, 0.1), this.hands.held(this.navigator.mode));
    const moved = this.navigator.pose !== this.shownPose;
    if (moved) this.stage.setPose((this.shownPose = this.navigator.pose));
    if (!this.light && this.stage.room) this.light = new RoomLight(this.stage.room.corners);
    if (this.light) for (const player of this.players) player.relight(this.light, relitAtOnce);
    this.stage.frame(moved || this.clock.playing);
  }

  seek(step: number): void {
    this.clock.seek(step);
    this.tell();
  }

  private play(seconds: number, now: number): void {
    const changed = this.clock.advance(seconds);
    const { step } = this.clock;
    const waited = this.waiting;
    this.waiting = this.players.map((player) => player.show(Math.min(step, player.replay.steps - 1))).includes(false);
    if (!this.waiting) this.shownStep = step;
    else if (!waited && this.shownStep >= 0) this.status.say(this.words.say("waiting"));
    if (changed && (now - this.lastTold > barEvery || !this.clock.playing)) {
      this.lastTold = now;
      this.tell();
    }
  }

  private tell(): void {
    this.bar.show(this.eye.following, this.camera.isOpen);
    for (const info of this.infos) info.show(this.clock.seconds);
  }

  private toggle(): void {
    this.clock.toggle();
    this.tell();
  }

  private nudge(by: 1 | -1): void {
    this.clock.nudge(by);
    this.tell();
  }

  private toEvent(by: 1 | -1): void {
    const events = this.players.flatMap((player) => player.replay.events).sort((a, b) => a.step - b.step);
    const event = nextFrom(events, this.clock.step, by);
    if (event) this.seek(event.step);
  }

  private setSpeed(to: number): void {
    this.clock.speed = to;
    this.tell();
  }

  private toggleFollow(): void {
    this.eye.toggle(this.players[0]!, reduced());
    this.tell();
  }

  private toggleCamera(): void {
    this.camera.open(!this.camera.isOpen);
    if (!this.camera.isOpen) this.stage.canvas.focus({ preventScroll: true });
    this.tell();
  }

  private enter(mode: Mode): void {
    this.navigator.enter(mode, true);
    if (mode === "top") this.stage.setLens(topFov);
    else if (this.stage.camera.fov === topFov) this.stage.setLens(usualFov);
  }

  private makeHands(): Hands {
    const fov = (): number => (this.stage.camera.fov * Math.PI) / 180;
    return new Hands(this.stage.canvas, {
      drag: (dx, dy, pan) => this.navigator.drag(dx, dy, this.stage.canvas.clientHeight, fov(), pan),
      zoom: (factor) => this.navigator.zoom(factor),
      click: () => undefined,
      key: (event) => this.key(event),
      wake: () => undefined,
    });
  }

  private key(event: KeyboardEvent): boolean {
    const onButton = (event.target as HTMLElement).closest("button, a, summary, select") !== null;
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    const mode = modes[Number(key) - 1];
    const does: Partial<Record<string, () => void>> = {
      ",": () => this.nudge(-1),
      ".": () => this.nudge(1),
      b: () => this.toEvent(-1),
      n: () => this.toEvent(1),
      "[": () => (this.clock.change(-1), this.tell()),
      "]": () => (this.clock.change(1), this.tell()),
      Home: () => this.seek(0),
      End: () => this.seek(this.clock.steps - 1),
      f: () => this.toggleFollow(),
      c: () => this.toggleCamera(),
      "?": () => this.help.open(),
    };
    if (mode) this.enter(mode);
    else if (key === " " && !onButton) this.toggle();
    else if (does[key]) does[key]();
    else return false;
    return true;
  }
}
