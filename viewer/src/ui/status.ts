// What the page says by itself: progress, short notes, and errors with what to do.
import { ServerError, unreachable } from "../store/client";
import { PackedError } from "../store/packed";
import { element } from "./dom";
import type { Speech } from "./speech";

const noteSeconds = 4;

export class Status {
  readonly progress = element("div", { class: "progress", attributes: { role: "progressbar", "aria-valuemin": "0", "aria-valuemax": "100" } }, element("span"));
  readonly note = element("div", { class: "toast panel", attributes: { role: "status" } });
  readonly fault = element("div", { class: "fault", attributes: { role: "alert" } });
  private timer = 0;

  constructor(private readonly speech: Speech) {
    this.note.hidden = this.fault.hidden = this.progress.hidden = true;
  }

  // 0..1; undefined: nothing is under way.
  work(share: number | undefined, text = ""): void {
    this.progress.hidden = share === undefined;
    if (share === undefined) return;
    const percent = Math.round(Math.min(Math.max(share, 0.03), 1) * 100);
    (this.progress.firstElementChild as HTMLElement).style.width = `${percent}%`;
    this.progress.setAttribute("aria-valuenow", String(percent));
    this.progress.setAttribute("aria-label", text);
  }

  say(text: string): void {
    this.note.textContent = text;
    this.note.hidden = false;
    clearTimeout(this.timer);
    this.timer = window.setTimeout(() => (this.note.hidden = true), noteSeconds * 1000);
  }

  // Over the whole page, with a button that tries again.
  stop(error: unknown): void {
    const again = element("button", { text: this.speech.say("retry"), attributes: { type: "button" }, on: { click: () => location.reload() } });
    const code = error instanceof ServerError ? error.code : "";
    this.fault.replaceChildren(
      element("div", { class: "panel" }, element("h2", { text: this.speech.say("errorTitle") }), element("p", { text: this.textOf(error) }), element("p", { class: "muted code", text: code }), again),
    );
    this.fault.hidden = false;
    this.work(undefined);
    again.focus();
  }

  textOf(error: unknown): string {
    if (error instanceof PackedError) return this.speech.say("badData", { what: error.message });
    if (error instanceof ServerError) return error.code === unreachable ? this.speech.say("offline") : error.message;
    return error instanceof Error ? error.message : String(error);
  }
}
