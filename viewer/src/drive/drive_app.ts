// The page of a drive: keys and a gamepad move the robot, the server's messages move the picture.
import { Navigator, topFov } from "../camera/navigator";
import { lookingAt, type Pose } from "../camera/pose";
import { roomOf } from "../camera/store_room";
import { RoomLight } from "../replay/actor_light";
import { CameraPanel } from "../replay/camera_panel";
import { Player } from "../replay/player";
import { counterView, RobotEye, type RobotView } from "../replay/robot_eye";
import type { ReplayWords } from "../replay/words";
import type { Packed } from "../store/packed";
import type { Summary } from "../store/contract";
import { screensOf, Sight } from "../stage/sight";
import type { Stage } from "../stage/stage";
import { element, reduced } from "../ui/dom";
import { Hands } from "../ui/hands";
import type { Status } from "../ui/status";
import { Theme } from "../ui/theme";
import { Controls, drivingKeys, moves, type Pad } from "./controls";
import type { DriveEpisode, DriveMoment, DriveNote, Verb } from "./contract";
import { DriveHelp } from "./drive_help";
import { DrivePanel, type Acting, type Seat } from "./drive_panel";
import type { DriveClient, DriveSocket } from "./drive_client";
import type { Live } from "./live";
import { say, type DriveKey } from "./strings";
import { together, TouchPad } from "./touch";

const usualFov = 55;
const relitAtOnce = 8;
const standsAfter = 500; // milliseconds without a message
const commandEvery = 50; // milliseconds: a control step
const still = { forward: 0, right: 0, up: 0, turn: 0, tilt: 0, fast: false } as const;
// Behind, beside, before the robot, by keys 1 to 3; 4 is from above.
const drivingViews: readonly RobotView[] = [
  { from: [-2.2, 0, 2.3], at: [0.7, 0, 0.8] },
  { from: [0.5, 2.3, 1.7], at: [0.4, 0, 0.8] },
  { from: [2.6, -0.8, 1.9], at: [0.2, 0, 0.9] },
];
const counterViews: readonly RobotView[] = [
  { from: [-0.75, 0.55, 1.0], at: [0.5, 0, 0.1] },
  { from: [0.45, 1.5, 0.8], at: [0.45, 0, 0.1] },
  counterView,
];

export class DriveApp {
  readonly navigator: Navigator;
  readonly camera: CameraPanel;
  readonly controls: Controls;
  last: DriveMoment | undefined;
  seat: Seat = { drives: false, taken: false };
  savedFile = "";
  private readonly panel: DrivePanel;
  private readonly help: DriveHelp;
  readonly touch: TouchPad;
  private readonly hands: Hands;
  private readonly eye: RobotEye;
  private readonly views: readonly RobotView[];
  private light: RoomLight | undefined; // once the room has come
  private lastFrame = 0;
  private shownPose: Pose | undefined;
  private messages = 0;
  private heard = 0; // the last one
  private begun = false;
  private moved = false; // by the command before

  constructor(
    private readonly stage: Stage,
    summary: Summary,
    episode: DriveEpisode,
    readonly player: Player<DriveEpisode>,
    private readonly live: Live,
    private readonly words: ReplayWords,
    private readonly status: Status,
    client: DriveClient,
    private readonly socket: () => DriveSocket,
    links: () => readonly HTMLElement[],
    acting: Acting,
  ) {
    stage.ceilingHeight = summary.ceiling_m;
    stage.sight = new Sight(screensOf(summary.fixtures));
    stage.setLens(usualFov);
    this.navigator = new Navigator(roomOf(summary), "orbit", lookingAt([0, 0, 2], [1, 1, 1]), 2);
    this.views = episode.has_base ? drivingViews : counterViews;
    this.eye = new RobotEye(this.navigator, this.views[0]!, 1, true);
    this.controls = new Controls(episode);
    const { speech } = words;
    const theme = new Theme((background) => stage.setBackground(background));
    this.help = new DriveHelp(speech);
    const tools = { theme: () => theme.toggle(), language: () => speech.toggle(), help: () => this.help.open() };
    const tool = (key: keyof typeof tools): HTMLElement => element("button", { text: speech.say(key), attributes: { type: "button" }, on: { click: tools[key] } });
    this.panel = new DrivePanel(words, episode, this.controls, (verb) => this.press(verb), () => [...links(), tool("theme"), tool("language"), tool("help")], acting);
    this.touch = new TouchPad(speech, { lifts: episode.joints.some(({ dimension }) => dimension === "m"), arms: episode.arms.length });
    this.camera = new CameraPanel(words, client, episode.step_s, episode.cameras, () => this.toggleCamera());
    this.hands = this.makeHands();
    document.body.append(this.panel.panel, this.camera.panel, this.touch.panel, this.help.dialog);
    speech.bind(() => {
      stage.canvas.setAttribute("aria-label", this.say("view3d"));
      document.title = `${this.say("drive")} · ${episode.id} · MarketGen`;
      this.tell();
    });
    setInterval(() => this.command(), commandEvery);
  }

  // One turn of the page's loop.
  frame(now: number): void {
    const seconds = Math.min((now - this.lastFrame) / 1000, 0.1);
    this.lastFrame = now;
    if (this.last && this.player.show(this.messages)) this.eye.follow(this.player);
    this.camera.want(this.last?.step ?? 0, this.last?.runs ?? false);
    this.navigator.step(seconds, still);
    const moved = this.navigator.pose !== this.shownPose;
    if (moved) this.stage.setPose((this.shownPose = this.navigator.pose));
    if (!this.light && this.stage.room) this.light = new RoomLight(this.stage.room.corners);
    if (this.light) this.player.relight(this.light, relitAtOnce);
    this.stage.frame(moved || ((this.last?.runs ?? false) && now - this.heard < standsAfter));
  }

  moment(message: Packed<DriveMoment>): void {
    const { head } = message;
    this.live.take(message, head.bodies, head.things);
    if (this.last && head.step < this.last.step) this.panel.unsaved();
    this.begun = head.runs || head.step > 0;
    this.last = head;
    this.messages++;
    this.heard = performance.now();
    this.tell();
    this.stage.redraw();
  }

  note(note: DriveNote): void {
    if (note.kind === "you") this.seat = note;
    if (note.kind === "error") this.status.say(note.message);
    if (note.kind === "saved") this.panel.saved((this.savedFile = note.file));
    this.tell();
  }

  closed(): void {
    this.seat = { drives: false, taken: true };
    this.tell();
    this.status.say(this.say("gone"));
  }

  private say(key: DriveKey): string {
    return say(this.words.speech.language, key);
  }

  private tell(): void {
    this.panel.seat(this.seat);
    this.touch.panel.hidden = !this.seat.drives;
    if (this.last) this.panel.show(this.last, this.begun);
  }

  // Sent while something is held, and once when nothing is any more.
  private command(): void {
    const gamepad = navigator.getGamepads?.().find((each) => each?.mapping === "standard") as Pad | null | undefined;
    const pad = together(gamepad ?? undefined, this.touch);
    for (const press of this.controls.presses(pad)) this.padPress(press);
    const command = this.controls.command(this.hands.keysDown, pad);
    const now = moves(command);
    if (this.seat.drives && (now || this.moved)) this.socket().move(command);
    this.moved = now;
  }

  private padPress(press: "grip" | "arm" | "axes" | "pause"): void {
    if (press === "grip") this.grip();
    else if (press === "arm") this.controls.otherArm();
    else if (press === "axes") this.controls.otherAxes();
    else this.press(this.last?.runs ? "pause" : "go");
    this.tell();
  }

  private grip(): void {
    this.controls.take((this.last?.openings[this.controls.arm] ?? 1) > 0 ? "close" : "open");
  }

  private press(verb: Verb): void {
    this.socket().say(verb);
    this.stage.canvas.focus({ preventScroll: true });
  }

  private toggleCamera(): void {
    this.camera.open(!this.camera.isOpen);
    this.stage.canvas.focus({ preventScroll: true });
  }

  private view(number: number): void {
    const view = this.views[number];
    this.navigator.enter(view ? "orbit" : "top", true);
    this.stage.setLens(view ? usualFov : topFov);
    if (!view) return;
    this.eye.view = view;
    this.eye.come(this.player, reduced());
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
    if (drivingKeys.has(event.code)) return false; // they are held
    const onButton = (event.target as HTMLElement).closest("button, a, summary, select") !== null;
    const does: Partial<Record<string, () => void>> = {
      KeyX: () => this.controls.otherArm(),
      KeyB: () => this.controls.otherAxes(),
      KeyQ: () => (this.controls.fine = !this.controls.fine),
      KeyP: () => this.press(this.last?.runs ? "pause" : "go"),
      End: () => this.press("done"),
      Home: () => this.press("reset"),
      KeyV: () => this.press("save"),
      KeyZ: () => this.eye.toggle(this.player, reduced()),
      KeyC: () => this.toggleCamera(),
      ...Object.fromEntries([0, 1, 2, 3].map((i) => [`Digit${i + 1}`, () => this.view(i)])),
      ...(!onButton && { Space: () => this.grip() }),
    };
    if (event.key === "?") this.help.open();
    else if (event.repeat || !does[event.code]) return false;
    else does[event.code]!();
    this.tell();
    return true;
  }
}
