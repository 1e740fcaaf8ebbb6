// A figure of every product as a colour, from the smallest to the largest.
import type { Sku } from "../store/contract";
import type { GoodsTable } from "./goods_table";

export const heatNames = ["price", "height", "mass", "pickRate"] as const;
export type HeatName = (typeof heatNames)[number];

export interface Heat {
  readonly low: number; // what the first colour stands for
  readonly high: number;
  readonly colors: Uint8Array; // RGB by product row
  readonly currency: string; // of prices
}

// Dark blue to yellow over magenta and orange, ever lighter, so that it is read without telling hues apart.
export const ramp = [
  [13, 8, 135],
  [126, 3, 168],
  [204, 71, 120],
  [248, 149, 64],
  [240, 249, 33],
] as const;

const unknown = [128, 128, 128] as const; // of a product without the figure

const outliers = 0.02; // share of products at either end that take the end's colour

export function rampColor(share: number): [number, number, number] {
  const at = Math.min(Math.max(share, 0), 1) * (ramp.length - 1);
  const from = Math.min(Math.floor(at), ramp.length - 2);
  return [0, 1, 2].map((k) => Math.round(ramp[from]![k]! + (ramp[from + 1]![k]! - ramp[from]![k]!) * (at - from))) as [number, number, number];
}

const figureOf: Record<HeatName, (sku: Sku, bottom: number) => number> = {
  price: (sku) => sku.price,
  height: (sku, bottom) => bottom + sku.size_m[2] / 2,
  mass: (sku) => sku.mass_kg,
  pickRate: (sku) => (sku.pick_rate < 0 ? NaN : sku.pick_rate),
};

export function heatOf(name: HeatName, table: GoodsTable, skus: readonly Sku[]): Heat {
  const figures = Float64Array.from({ length: table.count }, (_, row) => figureOf[name](skus[table.sku[row]!]!, table.position[row * 3 + 2]!));
  const sorted = figures.filter((figure) => !Number.isNaN(figure)).sort();
  const at = (share: number): number => sorted[Math.round(share * (sorted.length - 1))] ?? 0;
  const [low, high] = [at(outliers), at(1 - outliers)];
  const colors = new Uint8Array(table.count * 3);
  const color = (figure: number): ArrayLike<number> => (Number.isNaN(figure) ? unknown : rampColor(high > low ? (figure - low) / (high - low) : 0.5));
  figures.forEach((figure, row) => colors.set(color(figure), row * 3));
  return { low, high, colors, currency: skus[0]?.currency ?? "EUR" };
}
