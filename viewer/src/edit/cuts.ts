// A cut of the floor as a line that can be dragged.
import type { Cut } from "./contract";

export const leastRatio = 0.08;
export const mostRatio = 0.92;

export interface Line {
  readonly x1: number;
  readonly y1: number;
  readonly x2: number;
  readonly y2: number;
}

// The middle of what lies between the two halves, in millimetres.
export function lineOf({ split, gap_mm, rect_mm: [west, south, east, north] }: Cut, ratio: number): Line {
  if (split === "y") {
    const y = south + ratio * (north - south - gap_mm) + gap_mm / 2;
    return { x1: west, y1: y, x2: east, y2: y };
  }
  const x = west + ratio * (east - west - gap_mm) + gap_mm / 2;
  return { x1: x, y1: south, x2: x, y2: north };
}

// The share that puts the line through a place.
export function ratioAt({ split, gap_mm, rect_mm: [west, south, east, north] }: Cut, x: number, y: number): number {
  const [low, high, at] = split === "y" ? [south, north, y] : [west, east, x];
  return limited((at - low - gap_mm / 2) / Math.max(high - low - gap_mm, 1));
}

export function limited(ratio: number): number {
  return Math.round(Math.min(Math.max(ratio, leastRatio), mostRatio) * 1e4) / 1e4;
}
