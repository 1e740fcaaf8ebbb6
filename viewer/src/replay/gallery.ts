// Failures as pictures: how each ended, taken by the core one after another as they come into view.
import { element } from "../ui/dom";
import { episodeLink, type ReplayPlace } from "./addresses";
import type { EpisodeLine, RunLine } from "./contract";
import type { ReplayClient } from "./replay_client";
import { failureText, timeText, type ReplayWords } from "./words";

const wide = 320; // pixels

interface Waiting {
  readonly figure: Element;
  readonly take: () => Promise<void>;
}

export class Gallery {
  readonly grid = element("div", { class: "gallery" });
  private readonly queue: Waiting[] = [];
  private readonly watcher: IntersectionObserver;
  private readonly takes = new Map<Element, () => Promise<void>>();
  private taking = false;

  constructor(
    private readonly words: ReplayWords,
    private readonly place: ReplayPlace,
    private readonly client: ReplayClient,
  ) {
    this.watcher = new IntersectionObserver((entries) => this.seen(entries));
  }

  show(episodes: readonly (readonly [RunLine, EpisodeLine])[]): void {
    this.watcher.disconnect();
    this.takes.clear();
    this.queue.length = 0;
    this.grid.replaceChildren(...episodes.map(([run, line]) => this.figure(run, line)));
  }

  private figure(run: RunLine, line: EpisodeLine): HTMLElement {
    const { words } = this;
    const code = line.void ? words.say("void") : failureText(line.failure);
    const canvas = element("canvas", { attributes: { role: "img", "aria-label": words.say("endOf", { id: line.id }), width: "320", height: "240" } });
    const note = element("span", { class: "muted", text: line.recorded ? "" : words.say("notRecorded") });
    const texts = [element("strong", { class: "failed", text: code }), element("span", { text: `${line.hits}/${line.asked} · ${timeText(line.simulated_s)}` }), element("span", { class: "muted", text: `${run.policy} · ${line.id}` }), note];
    if (!line.recorded) return element("div", { class: "figure panel" }, canvas, ...texts);
    const figure = element("a", { class: "figure panel", attributes: { href: episodeLink(this.place, run.run, line.episode) } }, canvas, ...texts);
    this.takes.set(figure, () => this.take(run.run, line.episode, canvas, note));
    this.watcher.observe(figure);
    return figure;
  }

  private seen(entries: readonly IntersectionObserverEntry[]): void {
    for (const { target, isIntersecting } of entries) {
      const take = this.takes.get(target);
      if (!isIntersecting || !take) continue;
      this.watcher.unobserve(target);
      this.queue.push({ figure: target, take });
    }
    void this.work();
  }

  private async work(): Promise<void> {
    if (this.taking) return;
    this.taking = true;
    for (let next = this.queue.shift(); next; next = this.queue.shift()) if (next.figure.isConnected) await next.take();
    this.taking = false;
  }

  private async take(run: number, episode: number, canvas: HTMLCanvasElement, note: HTMLElement): Promise<void> {
    try {
      const picture = await this.client.ofEpisode(run, episode).picture(`/camera.jpg?width=${wide}`);
      canvas.getContext("2d", { alpha: false })!.drawImage(picture, 0, 0, canvas.width, canvas.height);
      picture.close();
      canvas.dataset["taken"] = "1";
    } catch (error) {
      note.textContent = error instanceof Error ? error.message : String(error);
    }
  }
}
