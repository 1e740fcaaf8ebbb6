// The list of keys.
import type { TextKey } from "../text/strings";
import { element } from "./dom";
import type { Speech } from "./speech";

const rows: readonly (readonly [string | TextKey, TextKey])[] = [
  ["mouseDrag", "mouseLook"],
  ["mousePan", "mousePanHint"],
  ["mouseWheel", "mouseWheelHint"],
  ["W A S D", "keysMove"],
  ["← ↑ → ↓", "keysTurn"],
  ["Q E", "keysUp"],
  ["Shift", "keysFast"],
  ["1 2 3 4", "keysModes"],
  ["/", "keysSearch"],
  ["Enter", "keysPick"],
  ["M", "keysMeasure"],
  ["Z", "keysZones"],
  ["L", "layers"],
  ["R", "keysEdit"],
  ["Ctrl Z, Ctrl ⇧ Z", "keysUndo"],
  ["P", "keysPicture"],
  ["Esc", "keysClose"],
];

export class Help {
  readonly dialog = element("dialog", { class: "help panel" });

  constructor(private readonly speech: Speech) {
    speech.bind(() => this.draw());
    this.dialog.addEventListener("click", (event) => {
      if (event.target === this.dialog) this.dialog.close();
    });
  }

  open(): void {
    this.dialog.showModal();
  }

  private draw(): void {
    const { speech } = this;
    const list = element("dl", {});
    for (const [key, text] of rows) {
      const name = key.startsWith("mouse") ? speech.say(key as TextKey) : key;
      list.append(element("dt", {}, element("kbd", { text: name })), element("dd", { text: speech.say(text) }));
    }
    const close = element("button", { text: speech.say("close"), attributes: { type: "button" }, on: { click: () => this.dialog.close() } });
    this.dialog.replaceChildren(element("h2", { text: speech.say("help") }), list, close);
  }
}
