// What an episode was, how it ended and what happened in it.
import { element } from "../ui/dom";
import type { Replay } from "./contract";
import { listed, weightOf } from "./marks";
import { timeText, type ReplayWords } from "./words";

export interface InfoActions {
  seek(step: number): void;
}

const shownEvents = 150;

export class InfoPanel {
  readonly panel = element("section", { class: "replay-info panel" });
  private goals: readonly HTMLElement[] = [];

  constructor(
    private readonly words: ReplayWords,
    private readonly actions: InfoActions,
    private readonly replay: Replay,
    private readonly links: () => readonly HTMLElement[],
    private readonly tellsTask: boolean,
  ) {
    words.speech.bind(() => this.draw());
  }

  // Goals that lie in place at that time.
  show(seconds: number): void {
    this.replay.goals.forEach(({ count, reached, since_s }, i) => {
      const state = reached < count ? "missed" : since_s >= 0 && since_s <= seconds ? "met" : "open";
      if (this.goals[i]) this.goals[i]!.dataset["state"] = state;
    });
  }

  private draw(): void {
    const { words, replay } = this;
    const { result, run } = replay;
    this.goals = replay.goals.map((goal) => element("li", {}, element("span", { class: "name", text: words.nameOfGoal(goal) }), element("span", { class: "muted", text: words.goal(goal) })));
    const ledger = element("dl", {}, ...words.effects(replay.side_effects).flatMap(([name, value]) => [element("dt", { text: name }), element("dd", { text: value })]));
    this.panel.setAttribute("aria-label", words.say("episode"));
    this.panel.replaceChildren(
      ...(this.links().length > 0 ? [element("nav", { class: "links" }, ...this.links())] : []),
      ...(this.tellsTask ? [element("h1", { text: replay.instruction })] : []),
      element("p", { class: "muted", text: `${result.id} · ${run.policy} · ${run.realism}` }),
      element("p", { class: result.strict ? "outcome solved" : "outcome failed", text: `${words.outcome(result)} · ${result.hits}/${result.asked}` }),
      ...(result.detail ? [element("p", { class: "muted", text: result.detail })] : []),
      element("h2", { text: words.say("goals") }),
      element("ul", { class: "goals" }, ...this.goals),
      element("details", {}, element("summary", { text: words.say("events") }), this.events()),
      element("details", {}, element("summary", { text: words.say("ledger") }), ledger),
    );
  }

  private events(): HTMLElement {
    const { words, replay } = this;
    const all = listed(replay.events);
    if (all.length === 0) return element("p", { class: "muted", text: words.say("noEvents") });
    const rows = all.slice(0, shownEvents).map((event) =>
      element("li", {}, element("button", { attributes: { type: "button" }, class: weightOf(event), on: { click: () => this.actions.seek(event.step) } }, element("span", { class: "when", text: timeText(event.step * replay.step_s) }), element("span", { text: words.event(event, replay) }))),
    );
    if (all.length > shownEvents) rows.push(element("li", { class: "muted", text: words.say("moreEvents", { count: words.speech.number(all.length - shownEvents) }) }));
    return element("ol", { class: "happened" }, ...rows);
  }
}
