// A figure of every product as a colour, from the smallest to the largest.
import type { Sku } from "../store/contract";
import type { GoodsTable } from "./goods_table";

export const heatNames = ["price", "height"] as const;
export type HeatName = (typeof heatNames)[number];

export interface Heat {
  readonly low: number; // what the first colour stands for
  readonly high: number;
  readonly colors: Uint8Array; // RGB by product row
}

// Dark blue to yellow over magenta and orange, ever lighter, so that it is read without telling hues apart.
export const ramp = [
  [13, 8, 135],
  [126, 3, 168],
  [204, 71, 120],
  [248, 149, 64],
  [240, 249, 33],
] as const;

const outliers = 0.02; // share of products at either end that take the end's colour

export function rampColor(share: number): [number, number, number] {
  const at = Math.min(Math.max(share, 0), 1) * (ramp.length - 1);
  const from = Math.min(Math.floor(at), ramp.length - 2);
  return [0, 1, 2].map((k) => Math.round(ramp[from]![k]! + (ramp[from + 1]![k]! - ramp[from]![k]!) * (at - from))) as [number, number, number];
}

export function heatOf(name: HeatName, table: GoodsTable, skus: readonly Sku[]): Heat {
  const figures = Float64Array.from({ length: table.count }, (_, row) => {
    const sku = skus[table.sku[row]!]!;
    return name === "price" ? sku.price : table.position[row * 3 + 2]! + sku.size_m[2] / 2;
  });
  const sorted = figures.toSorted();
  const at = (share: number): number => sorted[Math.round(share * (sorted.length - 1))] ?? 0;
  const [low, high] = [at(outliers), at(1 - outliers)];
  const colors = new Uint8Array(table.count * 3);
  figures.forEach((figure, row) => colors.set(rampColor(high > low ? (figure - low) / (high - low) : 0.5), row * 3));
  return { low, high, colors };
}
