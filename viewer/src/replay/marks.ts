// What happened, as marks on a line of time.
import type { ReplayEvent } from "./contract";

export const lanes = ["goal", "held", "contact", "harm"] as const;
export type Lane = (typeof lanes)[number];
export type Weight = "plain" | "light" | "firm" | "hard";

// As the ledger has them (docs/episodes.md): below 10 N, to 50 N, above.
const firmAbove = 10;
const hardAbove = 50;

export function laneOf({ kind }: ReplayEvent): Lane {
  return kind === "held" || kind === "contact" ? kind : "harm";
}

export function weightOf(event: ReplayEvent): Weight {
  if (event.kind === "held") return "plain";
  if (event.kind !== "contact") return "hard";
  return event.force_n > hardAbove ? "hard" : event.force_n > firmAbove ? "firm" : "light";
}

export interface Mark {
  readonly lane: Lane;
  readonly weight: Weight;
  readonly from: number; // share of the whole time
  readonly to: number;
}

const order: readonly Weight[] = ["plain", "light", "firm", "hard"];

// Of a line that is so many points long: what is nearer than a point is one mark, by its heaviest. Lighter ones first. `goals`: steps
// since which one lay in place.
export function marksOf(events: readonly ReplayEvent[], steps: number, points: number, goals: readonly number[] = []): Mark[] {
  const last = Math.max(steps - 1, 1);
  const marks = goals.map((step): Mark => ({ lane: "goal", weight: "plain", from: Math.min(step / last, 1), to: Math.min(step / last, 1) }));
  for (const lane of lanes) {
    const heaviest = new Int8Array(points).fill(-1);
    for (const event of events) {
      if (laneOf(event) !== lane) continue;
      const point = (step: number): number => Math.min(Math.floor((step / last) * points), points - 1);
      for (let p = point(event.step); p <= point(event.last_step); p++) heaviest[p] = Math.max(heaviest[p]!, order.indexOf(weightOf(event)));
    }
    for (let p = 0; p < points; ) {
      let end = p + 1;
      while (end < points && heaviest[end] === heaviest[p]) end++;
      if (heaviest[p]! >= 0) marks.push({ lane, weight: order[heaviest[p]!]!, from: p / points, to: end / points });
      p = end;
    }
  }
  return marks.sort((a, b) => order.indexOf(a.weight) - order.indexOf(b.weight));
}

// Those worth a line of their own: all but light contacts.
export function listed(events: readonly ReplayEvent[]): ReplayEvent[] {
  return events.filter((event) => weightOf(event) !== "light");
}

// The first that begins after a step, or the last that begins before it.
export function nextFrom(events: readonly ReplayEvent[], step: number, by: 1 | -1): ReplayEvent | undefined {
  const sorted = listed(events);
  return by > 0 ? sorted.find((event) => event.step > step + 0.5) : sorted.findLast((event) => event.step < step - 0.5);
}
