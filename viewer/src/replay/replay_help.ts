// The keys of a replay.
import { element } from "../ui/dom";
import type { ReplayKey } from "./strings";
import type { ReplayWords } from "./words";

const rows: readonly (readonly [string, ReplayKey])[] = [
  ["Space", "keysPlay"],
  [", .", "keysStep"],
  ["B N", "keysEvent"],
  ["[ ]", "keysSpeed"],
  ["Home End", "keysEnds"],
  ["F", "keysFollow"],
  ["C", "keysCamera"],
];

export class ReplayHelp {
  readonly dialog = element("dialog", { class: "help panel" });

  constructor(private readonly words: ReplayWords) {
    words.speech.bind(() => this.draw());
  }

  open(): void {
    this.dialog.showModal();
  }

  private draw(): void {
    const { speech } = this.words;
    const own = rows.flatMap(([key, text]) => [element("dt", {}, element("kbd", { text: key })), element("dd", { text: this.words.say(text) })]);
    const moving = (["keysMove", "keysTurn", "keysModes"] as const).flatMap((text, i) => [element("dt", {}, element("kbd", { text: ["W A S D", "← ↑ → ↓", "1 2 3 4"][i]! })), element("dd", { text: speech.say(text) })]);
    const close = element("button", { text: speech.say("close"), attributes: { type: "button" }, on: { click: () => this.dialog.close() } });
    this.dialog.replaceChildren(element("h2", { text: speech.say("help") }), element("dl", {}, ...own, ...moving), close);
  }
}
