// One side of a line of fixtures, seen straight from the front: what stands in the front row, facing by facing.
import type { Fixture, Sku } from "../store/contract";
import { facingOf, fronts, rotationOf, type GoodsTable } from "./goods_table";

export const sides = ["front", "back"] as const;
export type SideName = (typeof sides)[number];

export interface Block {
  readonly product: number; // row of one of its products
  readonly facing: number; // row of the block
  readonly sku: number;
  readonly columns: number; // products beside one another
  left: number; // metres from the line's left end, and from the floor
  right: number;
  bottom: number;
  top: number;
}

export interface Elevation {
  readonly width: number; // metres
  readonly height: number;
  readonly blocks: readonly Block[]; // by level from above, then from the left
}

const sameLevel = 0.05; // metres
const noFacing = 0xffffffff;

interface Open extends Block {
  columns: number;
  readonly places: Set<number>; // centimetres along the line
}

export function elevationOf(run: string, side: SideName, fixtures: readonly Fixture[], table: GoodsTable, skus: readonly Sku[]): Elevation {
  const line = fixtures.filter((fixture) => fixture.run === run);
  const yaw = Math.round((line[0]?.yaw_deg ?? 0) / 90) + (side === "back" ? 2 : 0);
  const facing = ((yaw % 4) + 4) % 4;
  const [fx, fy] = fronts[facing]!;
  const along = (x: number, y: number): number => x * -fy + y * fx;
  const ends = line.flatMap(({ position_m: [x, y], size_m: [width] }) => [along(x, y) - width / 2, along(x, y) + width / 2]);
  const low = Math.min(...ends);
  const rows = new Set(line.map(({ row }) => row));
  const blocks = new Map<number, Open>();
  for (let row = 0; row < table.count; row++) {
    const key = table.facing[row]!;
    if (key === noFacing || table.rank[row] !== 0 || !rows.has(table.fixture[row]!) || facingOf(rotationOf(table, row)) !== facing) continue;
    const sku = table.sku[row]!;
    const [width, , height] = skus[sku]!.size_m;
    const at = along(table.position[row * 3]!, table.position[row * 3 + 1]!) - low;
    const bottom = table.position[row * 3 + 2]!;
    const block = blocks.get(key) ?? { product: row, facing: key, sku, columns: 0, places: new Set(), left: Infinity, right: -Infinity, bottom: Infinity, top: 0 };
    blocks.set(key, block);
    block.places.add(Math.round(at * 100));
    block.columns = block.places.size;
    block.left = Math.min(block.left, at - width / 2);
    block.right = Math.max(block.right, at + width / 2);
    block.bottom = Math.min(block.bottom, bottom);
    block.top = Math.max(block.top, bottom + height);
  }
  const sorted = [...blocks.values()].sort((a, b) => (Math.abs(a.bottom - b.bottom) < sameLevel ? a.left - b.left : b.bottom - a.bottom));
  return { width: Math.max(...ends) - low, height: Math.max(0, ...line.map(({ size_m }) => size_m[2])), blocks: sorted };
}
