// A run of shelves that is carried over the plan.
import type { EditHead, Patch, Rect, Run } from "./contract";

export interface Shift {
  readonly x: number; // millimetres
  readonly y: number;
}

const grain = 10; // millimetres: what a hand means no finer
export const keyShift = 50;

export function rounded({ x, y }: Shift): Shift {
  const at = (value: number): number => Math.round(value / grain) * grain;
  return { x: at(x), y: at(y) };
}

export function shifted([west, south, east, north]: Rect, { x, y }: Shift): Rect {
  return [west + x, south + y, east + x, north + y];
}

const pin = (fixture: string, field: string, value: number): Patch => ({ set_override: { fixture, field, value: String(Math.round(value)) } });

// Pins both numbers of where the run is while it is carried.
export function heldAt({ fixture, at_mm: [x, y] }: Run, by: Shift): Patch[] {
  return [pin(fixture, "x_mm", x + by.x), pin(fixture, "y_mm", y + by.y)];
}

// Pins where the run has been put down, in the directions in which it moved.
export function pinsOf(run: Run, by: Shift): Patch[] {
  const [x, y] = heldAt(run, by);
  return [...(by.x !== 0 ? [x!] : []), ...(by.y !== 0 ? [y!] : [])];
}

// Lets the runs of a zone stand where the layout puts them.
export function unpinned({ places, runs }: Pick<EditHead, "places" | "runs">, zone: string): Patch[] {
  const own = new Set(runs.filter((run) => run.zone === zone).map(({ id }) => id));
  const runOf = (fixture: string): string => fixture.slice(0, fixture.lastIndexOf("/"));
  return places.filter(({ fixture }) => own.has(runOf(fixture))).map(({ fixture, field }) => ({ set_override: { fixture, field } }));
}
