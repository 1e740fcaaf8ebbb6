// A picture of one of the station's cameras beside the replay, as the core's renderer takes it.
import { element, words as asWords } from "../ui/dom";
import type { Client } from "../store/client";
import { replayTexts, type ReplayKey } from "./strings";
import { timeText, type ReplayWords } from "./words";

const whilePlaying = 1000; // milliseconds between two pictures
const wide = 480; // pixels

export class CameraPanel {
  readonly panel = element("section", { class: "camera panel" });
  private readonly choice = element("select", { on: { change: () => this.again() } });
  private readonly canvas = element("canvas", { attributes: { role: "img" } });
  private readonly caption = element("p", { class: "muted", attributes: { role: "status" } });
  private wanted = -1;
  private shown: string | undefined;
  private asking = false;
  private asked = -Infinity;

  constructor(
    private readonly words: ReplayWords,
    private readonly client: Client,
    private readonly stepSeconds: number,
    cameras: readonly string[],
    close: () => void,
  ) {
    const shut = element("button", { class: "clear", text: "×", attributes: { type: "button" }, on: { click: close } });
    this.panel.append(element("header", {}, this.choice, shut), this.canvas, this.caption);
    this.panel.hidden = true;
    words.speech.bind(() => {
      const before = this.choice.value;
      this.choice.replaceChildren(...cameras.map((camera) => element("option", { text: this.nameOf(camera), attributes: { value: camera } })));
      if (before) this.choice.value = before;
      this.choice.setAttribute("aria-label", words.say("camera"));
      this.panel.setAttribute("aria-label", words.say("camera"));
      shut.setAttribute("aria-label", words.speech.say("close"));
      this.tell();
    });
  }

  get isOpen(): boolean {
    return !this.panel.hidden;
  }
  // What is shown: its camera and step; undefined: nothing yet.
  get picture(): string | undefined {
    return this.shown;
  }

  open(open: boolean): void {
    this.panel.hidden = !open;
    if (open) this.choice.focus({ preventScroll: true });
  }

  // Asks for the picture of that step, one at a time; while playing now and then.
  want(step: number, playing: boolean): void {
    this.wanted = Math.round(step);
    const due = performance.now() - this.asked > (playing ? whilePlaying : 0);
    if (this.isOpen && !this.asking && due && this.shown !== this.key()) void this.take();
  }

  private key(): string {
    return `${this.choice.value} ${this.wanted}`;
  }

  private again(): void {
    this.asked = -Infinity;
    this.want(this.wanted, false);
  }

  private async take(): Promise<void> {
    const key = this.key();
    const step = this.wanted;
    this.asking = true;
    this.asked = performance.now();
    if (this.shown === undefined) this.caption.textContent = this.words.say("cameraFirst");
    try {
      const picture = await this.client.picture(`/camera.jpg?camera=${encodeURIComponent(this.choice.value)}&step=${step}&width=${wide}`);
      Object.assign(this.canvas, { width: picture.width, height: picture.height });
      this.canvas.getContext("2d", { alpha: false })!.drawImage(picture, 0, 0);
      picture.close();
      this.shown = key;
      this.tell();
    } catch (error) {
      this.shown = key; // not asked for again until something changes
      this.caption.textContent = error instanceof Error ? error.message : String(error);
    } finally {
      this.asking = false;
    }
  }

  private tell(): void {
    if (this.shown === undefined) return;
    const [camera, step] = this.shown.split(" ");
    const text = `${this.nameOf(camera!)} · ${timeText(Number(step) * this.stepSeconds)}`;
    this.caption.textContent = text;
    this.canvas.setAttribute("aria-label", text);
  }

  private nameOf(camera: string): string {
    return camera in replayTexts.en ? this.words.say(camera as ReplayKey) : asWords(camera);
  }
}
