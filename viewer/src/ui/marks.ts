// Words that stand at points of the store: names of zones, widths of aisles, broken rules, lengths of the tape. Those nearer win where two would overlap.
import type { Vec3 } from "../camera/vector";
import { element } from "./dom";

export interface Mark {
  readonly text: string;
  readonly at: Vec3;
  readonly kind: "zone" | "aisle" | "violation" | "tape";
}

export class Marks {
  readonly layer = element("div", { class: "marks", attributes: { "aria-hidden": "true" } });
  private readonly shown: { mark: Mark; node: HTMLElement }[] = [];
  private readonly slots = new Map<string, readonly Mark[]>();

  set(slot: string, marks: readonly Mark[]): void {
    this.slots.set(slot, marks);
    this.layer.replaceChildren();
    this.shown.length = 0;
    for (const mark of [...this.slots.values()].flat()) {
      const node = element("span", { class: mark.kind, text: mark.text });
      this.layer.append(node);
      this.shown.push({ mark, node });
    }
  }

  place(project: (point: Vec3) => { x: number; y: number } | undefined, eye: Vec3): void {
    if (this.shown.length === 0) return;
    const taken: { x: number; y: number; width: number }[] = [];
    const away = (mark: Mark): number => Math.hypot(mark.at[0] - eye[0], mark.at[1] - eye[1], mark.at[2] - eye[2]);
    for (const { mark, node } of [...this.shown].sort((a, b) => away(a.mark) - away(b.mark))) {
      const at = project(mark.at);
      const width = mark.text.length * 9 + 16;
      const free = at && !taken.some((other) => Math.abs(other.y - at.y) < 24 && Math.abs(other.x - at.x) < (other.width + width) / 2);
      node.hidden = !free;
      if (!at || !free) continue;
      taken.push({ ...at, width });
      node.style.transform = `translate(${at.x.toFixed(1)}px, ${at.y.toFixed(1)}px) translate(-50%, -50%)`;
    }
  }
}
