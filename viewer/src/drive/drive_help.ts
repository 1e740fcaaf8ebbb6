// The keys of a drive.
import { element } from "../ui/dom";
import type { Speech } from "../ui/speech";
import { say, type DriveKey } from "./strings";

const rows: readonly (readonly [string, DriveKey])[] = [
  ["W A S D, ← ↑ → ↓", "keysDrive"],
  ["I K, J L", "keysArm"],
  ["U O", "keysArmUp"],
  ["Shift", "keysTwist"],
  ["Space", "keysGrip"],
  ["X", "keysOther"],
  ["B", "keysAxes"],
  ["Q", "keysFine"],
  ["R F", "keysLift"],
  ["[ ] - =", "keysHead"],
  ["P", "keysPause"],
  ["End", "keysDone"],
  ["Home", "keysReset"],
  ["V", "keysSave"],
  ["1 2 3 4", "keysViews"],
  ["Z", "keysFollow"],
  ["C", "keysCamera"],
];

export class DriveHelp {
  readonly dialog = element("dialog", { class: "help panel" });

  constructor(private readonly speech: Speech) {
    speech.bind(() => this.draw());
  }

  open(): void {
    this.dialog.showModal();
  }

  private draw(): void {
    const { speech } = this;
    const told = (key: DriveKey): string => say(speech.language, key);
    const own = rows.flatMap(([key, text]) => [element("dt", {}, element("kbd", { text: key })), element("dd", { text: told(text) })]);
    const close = element("button", { text: speech.say("close"), attributes: { type: "button" }, on: { click: () => this.dialog.close() } });
    this.dialog.replaceChildren(element("h2", { text: speech.say("help") }), element("dl", {}, ...own), element("p", { class: "muted", text: told("padHint") }), close);
  }
}
