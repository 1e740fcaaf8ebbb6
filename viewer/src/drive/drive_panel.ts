// What is to be done, how it goes, and the buttons of a drive.
import { element } from "../ui/dom";
import { timeText, type ReplayWords } from "../replay/words";
import type { Controls } from "./controls";
import type { DriveEpisode, DriveMoment, Verb } from "./contract";
import { say, type DriveKey } from "./strings";

const realTime = 0.95; // of real time: what is slower is said

export interface Seat {
  readonly drives: boolean;
  readonly taken: boolean;
}

// A program acts, and the server has no driver.
export type Acting = "person" | "program";

type Button = Exclude<Verb, "move" | "take" | "go">;

export class DrivePanel {
  readonly panel = element("section", { class: "replay-info panel driving" });
  private readonly links = element("nav", { class: "links" });
  private readonly title = element("h1");
  private readonly who = element("p", { class: "muted", attributes: { role: "status" } });
  private readonly clock = element("p", { class: "clock" });
  private readonly pace = element("p", { class: "muted" });
  private readonly goals = element("ul", { class: "goals" });
  private readonly goalsTitle = element("h2");
  private readonly hand = element("dl");
  private readonly ledger = element("details", {}, element("summary"), element("dl"), element("ol", { class: "happened" }));
  private readonly verdict = element("p", { class: "outcome", attributes: { role: "status" } });
  private readonly kept = element("p", { class: "muted", attributes: { role: "status" } });
  private readonly buttons = new Map<Button | "take", HTMLButtonElement>();

  constructor(
    private readonly words: ReplayWords,
    private readonly episode: DriveEpisode,
    private readonly controls: Controls,
    press: (verb: Verb) => void,
    private readonly makeLinks: () => readonly HTMLElement[],
    private readonly acting: Acting,
  ) {
    const group = element("div", { class: "drive-buttons" });
    for (const verb of ["take", "pause", "done", "reset", "save"] as const) {
      const button = element("button", { attributes: { type: "button" }, on: { click: () => press(verb === "pause" && button.dataset["paused"] === "1" ? "go" : verb) } });
      this.buttons.set(verb, button);
      group.append(button);
    }
    this.panel.append(this.links, this.title, this.who, this.clock, this.pace, this.goalsTitle, this.goals, this.hand, group, this.verdict, this.kept, this.ledger);
    group.hidden = this.hand.hidden = acting === "program";
    words.speech.bind(() => this.draw());
  }

  say(key: DriveKey, values?: Readonly<Record<string, string | number>>): string {
    return say(this.words.speech.language, key, values);
  }

  seat({ drives, taken }: Seat): void {
    this.who.textContent = this.acting === "program" ? this.say("programActs") : this.say(drives ? "youDrive" : taken ? "otherDrives" : "nobodyDrives");
    this.buttons.get("take")!.hidden = drives || taken;
    for (const verb of ["pause", "done", "reset", "save"] as const) this.buttons.get(verb)!.disabled = !drives;
  }

  saved(file: string): void {
    this.kept.textContent = this.say("savedAs", { file });
  }
  unsaved(): void {
    this.kept.textContent = "";
  }

  show(now: DriveMoment, begun: boolean): void {
    const { words, episode } = this;
    const clock = this.say("timeOf", { now: timeText(now.time_s), end: timeText(episode.limit_s) });
    this.clock.textContent = now.verdict || !begun || now.runs || this.acting === "program" ? clock : `${clock} · ${this.say("paused")}`;
    this.pace.textContent = this.paceText(now, begun);
    [...this.goals.children].forEach((row, i) => {
      const [reached, count] = [now.reached[i] ?? 0, episode.goals[i]!.count];
      (row as HTMLElement).dataset["state"] = reached >= count ? "met" : now.verdict ? "missed" : "open";
      row.lastElementChild!.textContent = this.say("reachedOf", { reached, count });
    });
    const { arm } = this.controls;
    const rows: [string, string][] = [
      ...(episode.arms.length > 1 ? [[this.say("arm"), this.nameOfArm(arm)] as [string, string]] : []),
      [this.say("gripper"), this.say((now.openings[arm] ?? 1) > 0 ? "open" : "closed")],
      [this.say("axes"), this.say(this.controls.axes)],
      [this.say("pace"), this.say(this.controls.fine ? "fine" : "usual")],
    ];
    this.hand.replaceChildren(...described(rows));
    const [, effects, happened] = this.ledger.children;
    effects!.replaceChildren(...described(words.effects(now.side_effects)));
    happened!.replaceChildren(...[...now.events].reverse().map((event) => element("li", {}, element("span", { class: "when", text: timeText(event.step * episode.step_s) }), element("span", { text: words.event(event, episode) }))));
    this.showVerdict(now);
    const pause = this.buttons.get("pause")!;
    const paused = begun && !now.runs;
    pause.dataset["paused"] = paused ? "1" : "0";
    pause.textContent = this.say(paused ? "go" : "pause");
    pause.hidden = now.verdict !== undefined || !begun;
    this.buttons.get("done")!.hidden = now.verdict !== undefined;
  }

  private paceText({ verdict, stopped, speed, runs }: DriveMoment, begun: boolean): string {
    if (verdict) return "";
    if (this.acting === "program") return stopped ? this.say("stoppedNow") : "";
    if (!begun) return this.say("waitsForYou");
    if (stopped) return this.say("stoppedNow");
    if (!runs || speed === 0) return "";
    const share = this.say("speed", { share: this.words.speech.number(Math.min(speed, 1), 2) });
    return speed < realTime ? `${share} (${this.say("slow")})` : share;
  }

  private showVerdict({ verdict }: DriveMoment): void {
    this.verdict.hidden = !verdict;
    if (!verdict) return;
    const { success, hits, asked, failure } = verdict;
    this.verdict.textContent = success ? this.say("success") : this.say("notReached", { hits, asked, failure });
    this.verdict.className = success ? "outcome solved" : "outcome failed";
    if (!this.kept.textContent && this.acting === "person") this.kept.textContent = this.say("saveHint");
  }

  private nameOfArm(arm: number): string {
    const name = this.episode.arms[arm] ?? ""; // "left_tool_"
    const side = /^(left|right)_/.exec(name)?.[0];
    return side ? this.say(side as DriveKey) : name;
  }

  private draw(): void {
    const { words, episode } = this;
    this.links.replaceChildren(...this.makeLinks());
    this.panel.setAttribute("aria-label", words.say("episode"));
    this.title.textContent = episode.instruction;
    this.goalsTitle.textContent = words.say("goals");
    this.goals.replaceChildren(...episode.goals.map((goal) => element("li", {}, element("span", { class: "name", text: words.nameOfGoal(goal) }), element("span", { class: "muted" }))));
    this.ledger.firstElementChild!.textContent = this.say("contacts");
    for (const verb of ["done", "reset", "save"] as const) this.buttons.get(verb)!.textContent = this.say(verb);
    this.buttons.get("take")!.textContent = this.say("takeOver");
    this.buttons.get("pause")!.textContent = this.say("pause");
  }
}

function described(rows: readonly (readonly [string, string])[]): HTMLElement[] {
  return rows.flatMap(([name, value]) => [element("dt", { text: name }), element("dd", { text: value })]);
}
