// Play, speed and the line of time with its marks.
import { element } from "../ui/dom";
import { speeds, type Clock } from "./clock";
import type { Replay } from "./contract";
import { lanes, marksOf, type Lane } from "./marks";
import type { ReplayKey } from "./strings";
import { timeText, type ReplayWords } from "./words";

export interface BarActions {
  toggle(): void;
  nudge(by: 1 | -1): void;
  event(by: 1 | -1): void;
  seek(step: number): void;
  speed(to: number): void;
  follow(): void;
  camera(): void;
}

const points = 600; // of the line of time
const laneHeight = 5;
const thinnest = 1.5;
const svg = "http://www.w3.org/2000/svg";
const laneTexts: Record<Lane, ReplayKey> = { goal: "goalLane", held: "heldLane", contact: "contactLane", harm: "harmLane" };

// 16 x 16, filled.
const pictures = {
  play: "M4 2.500v11l9-5.500z",
  pause: "M4 2.500h3v11H4zM9 2.500h3v11H9z",
  stepBack: "M11.500 3v10L5 8zM3.500 3H5v10H3.500z",
  stepAhead: "M4.500 3v10L11 8zM11 3h1.500v10H11z",
  eventBack: "M8 3v10L2 8zM14 3v10L8 8z",
  eventAhead: "M8 3v10l6-5zM2 3v10l6-5z",
  camera: "M2 4.500h2.500l1-1.500h5l1 1.500H14V13H2zM8 6a2.500 2.500 0 1 0 0 5 2.500 2.500 0 0 0 0-5",
  follow: "M8 1.500l1.500 3h-3zM8 14.500l1.500-3h-3zM1.500 8l3-1.500v3zM14.500 8l-3-1.500v3zM8 6a2 2 0 1 1 0 4 2 2 0 0 1 0-4",
} as const;

function picture(name: keyof typeof pictures): SVGSVGElement {
  const made = document.createElementNS(svg, "svg");
  for (const [key, value] of [["viewBox", "0 0 16 16"], ["class", "icon solid"], ["aria-hidden", "true"]] as const) made.setAttribute(key, value);
  const path = document.createElementNS(svg, "path");
  path.setAttribute("d", pictures[name]);
  made.append(path);
  return made;
}

export class PlayerBar {
  readonly bar: HTMLElement;
  private readonly line: HTMLInputElement;
  private readonly now = element("output", { class: "now", attributes: { "aria-live": "off" } });
  private readonly play: HTMLButtonElement;
  private readonly followButton: HTMLButtonElement;
  private readonly cameraButton: HTMLButtonElement;
  private readonly speed: HTMLSelectElement;

  constructor(
    private readonly words: ReplayWords,
    actions: BarActions,
    private readonly clock: Clock,
    episodes: readonly Pick<Replay, "events" | "run" | "goals" | "step_s">[],
  ) {
    this.line = element("input", { attributes: { type: "range", min: "0", max: String(clock.steps - 1), step: "1", value: "0" }, on: { input: () => actions.seek(Number(this.line.value)) } });
    this.play = this.button("play", "play", "Space", () => actions.toggle());
    this.followButton = this.button("follow", "follow", "F", () => actions.follow());
    this.cameraButton = this.button("camera", "camera", "C", () => actions.camera());
    this.speed = element("select", { on: { change: () => actions.speed(Number(this.speed.value)) } }, ...speeds.map((speed) => element("option", { text: `${speed}×`, attributes: { value: String(speed) } })));
    words.speech.bind(() => {
      this.line.setAttribute("aria-label", words.say("timeline"));
      this.speed.setAttribute("aria-label", words.say("speed"));
      this.speed.title = words.say("speed");
    });
    const buttons = element(
      "div",
      { class: "group" },
      this.button("eventBack", "eventBack", "B", () => actions.event(-1)),
      this.button("stepBack", "stepBack", ",", () => actions.nudge(-1)),
      this.play,
      this.button("stepAhead", "stepAhead", ".", () => actions.nudge(1)),
      this.button("eventAhead", "eventAhead", "N", () => actions.event(1)),
    );
    const line = element("div", { class: "line" }, this.line);
    for (const episode of episodes) {
      if (episodes.length > 1) line.append(element("p", { class: "whose muted", text: episode.run.policy }));
      line.append(drawn(episode, clock.steps));
    }
    this.bar = element("div", { class: "player panel" }, element("div", { class: "controls" }, buttons, this.speed, this.followButton, this.cameraButton, this.now), line, this.legend());
  }

  show(following: boolean, camera: boolean): void {
    const { clock, words } = this;
    const text = words.say("timeOf", { now: timeText(clock.seconds), end: timeText(clock.end) });
    this.now.textContent = text;
    this.line.value = String(Math.round(clock.step));
    this.line.setAttribute("aria-valuetext", text);
    this.speed.value = String(clock.speed);
    this.followButton.setAttribute("aria-pressed", String(following));
    this.cameraButton.setAttribute("aria-pressed", String(camera));
    const wanted = clock.playing ? "pause" : "play";
    if (this.play.dataset["shows"] === wanted && this.play.title.startsWith(words.say(wanted))) return;
    this.play.dataset["shows"] = wanted;
    this.play.replaceChildren(picture(wanted));
    this.label(this.play, wanted, "Space");
  }

  private legend(): HTMLElement {
    const legend = element("div", { class: "legend-of-time muted", attributes: { "aria-hidden": "true" } });
    this.words.speech.bind(() => legend.replaceChildren(...lanes.map((lane) => element("span", { class: `lane ${lane}`, text: this.words.say(laneTexts[lane]) }))));
    return legend;
  }

  private button(name: keyof typeof pictures, key: ReplayKey, keyName: string, press: () => void): HTMLButtonElement {
    const made = element("button", { class: "tool", attributes: { type: "button" }, on: { click: press } });
    made.append(picture(name));
    this.words.speech.bind(() => this.label(made, key, keyName));
    return made;
  }

  private label(button: HTMLButtonElement, key: ReplayKey, keyName: string): void {
    const text = this.words.say(key);
    button.setAttribute("aria-label", text);
    button.title = `${text} (${keyName})`;
  }
}

function drawn({ events, goals, step_s }: Pick<Replay, "events" | "goals" | "step_s">, steps: number): SVGSVGElement {
  const made = document.createElementNS(svg, "svg");
  const high = lanes.length * (laneHeight + 1);
  for (const [key, value] of [["viewBox", `0 0 ${points} ${high}`], ["preserveAspectRatio", "none"], ["class", "marks-of-time"], ["aria-hidden", "true"]] as const) made.setAttribute(key, value);
  for (const { lane, weight, from, to } of marksOf(events, steps, points, goals.flatMap(({ since_s }) => (since_s >= 0 ? [since_s / step_s] : [])))) {
    const bar = document.createElementNS(svg, "rect");
    const at = { x: Math.min(from * points, points - thinnest), y: lanes.indexOf(lane) * (laneHeight + 1), width: Math.max((to - from) * points, thinnest), height: laneHeight };
    for (const [key, value] of Object.entries(at)) bar.setAttribute(key, String(value));
    bar.setAttribute("class", `${lane} ${weight}`);
    made.append(bar);
  }
  return made;
}
