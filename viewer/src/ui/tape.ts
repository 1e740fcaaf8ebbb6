// The measure tape: between two points that were clicked, how far they are apart.
import { distance, type Vec3 } from "../camera/vector";
import type { Stage } from "../stage/stage";
import type { Marks } from "./marks";
import type { Speech } from "./speech";

export class Tape {
  isOut = false;
  private points: readonly Vec3[] = [];

  constructor(
    private readonly stage: Stage,
    private readonly marks: Marks,
    private readonly speech: Speech,
  ) {}

  toggle(): void {
    this.isOut = !this.isOut;
    this.points = [];
    document.body.classList.toggle("measuring", this.isOut);
    this.show();
  }

  // A third point begins anew.
  add(point: Vec3): void {
    this.points = this.points.length === 2 ? [point] : [...this.points, point];
    this.show();
  }

  show(): void {
    this.stage.overlays?.showTape(this.points);
    const [a, b] = this.points;
    const text = a && b ? this.speech.say("metres", { value: this.speech.number(distance(a, b), 3) }) : "";
    this.marks.set("tape", a && b ? [{ text, at: [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2], kind: "tape" }] : []);
    this.stage.redraw();
  }
}
