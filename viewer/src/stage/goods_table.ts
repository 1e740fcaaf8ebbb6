// All products as flat arrays, ordered so that what is drawn together lies together: by cell (a fixture's goods that face one way)
// and in each cell by how deep they stand behind others.
import type { Summary } from "../store/contract";
import type { Sections } from "../store/packed";

export const facesAnyway = 4; // a heap: its goods face all ways
export const deepFrom = 3; // products with so many before them are hardly seen

export interface Cell {
  readonly first: number; // in `order`
  readonly deep: number; // from here on rank >= deepFrom
  readonly end: number;
  readonly facing: number; // quarter turns of the front from -Y, or facesAnyway
  readonly fixture: number;
  readonly low: [number, number, number];
  readonly high: [number, number, number];
}

export interface GoodsTable {
  readonly count: number;
  readonly position: Float32Array;
  readonly rotation: Int16Array; // x y z w, / 32767
  readonly sku: Uint16Array;
  readonly fixture: Uint16Array; // 65535: none
  readonly shelf: Uint16Array; // row; 65535: none
  readonly facing: Uint32Array; // row; 4,294,967,295: none
  readonly tint: Uint8Array; // / 200
  readonly rank: Uint8Array; // how many stand before it on its shelf
  readonly order: Uint32Array; // product rows by cell
  readonly cells: readonly Cell[];
}

export type Quaternion = readonly [number, number, number, number];

export function rotationOf(table: { rotation: Int16Array }, row: number): Quaternion {
  const r = table.rotation;
  const i = row * 4;
  return [r[i]! / 32767, r[i + 1]! / 32767, r[i + 2]! / 32767, r[i + 3]! / 32767];
}

// The quarter turn about Z nearest to where the product's front (-Y) looks.
export function facingOf([x, y, z, w]: Quaternion): number {
  const frontX = -2 * (x * y - w * z);
  const frontY = -(1 - 2 * (x * x + z * z));
  return ((Math.round(Math.atan2(frontX, -frontY) / (Math.PI / 2)) % 4) + 4) % 4;
}

// Where a front of that many quarter turns looks, and what is at its right hand... of the pack itself (+X).
export const fronts = [
  [0, -1],
  [1, 0],
  [0, 1],
  [-1, 0],
] as const;

interface Placed {
  row: number;
  width: number;
  across: number;
  depth: number;
}

function groupedBy(count: number, keyOf: (row: number) => number): Map<number, number[]> {
  const groups = new Map<number, number[]>();
  for (let row = 0; row < count; row++) {
    const key = keyOf(row);
    const group = groups.get(key);
    if (group) group.push(row);
    else groups.set(key, [row]);
  }
  return groups;
}

// Counts for each product of a shelf how many stand before it in its column.
function rankShelf(rows: readonly number[], facing: number, position: Float32Array, widthOf: (row: number) => number, rank: Uint8Array): void {
  const [fx, fy] = fronts[facing]!;
  const placed: Placed[] = rows.map((row) => {
    const x = position[row * 3]!;
    const y = position[row * 3 + 1]!;
    return { row, width: widthOf(row), across: -fy * x + fx * y, depth: -(fx * x + fy * y) };
  });
  placed.sort((a, b) => a.depth - b.depth);
  for (let i = 0; i < placed.length; i++) {
    const behind = placed[i]!;
    let before = 0;
    for (let j = i - 1; j >= 0; j--) {
      const other = placed[j]!;
      const apart = 0.35 * (behind.width + other.width);
      if (behind.depth - other.depth < 0.02 || Math.abs(behind.across - other.across) > apart) continue;
      before = Math.max(before, rank[other.row]! + 1);
    }
    rank[behind.row] = Math.min(before, 255);
  }
}

function cellOf(rows: number[], facing: number, first: number, table: Omit<GoodsTable, "cells" | "order">, reach: (row: number) => number): Cell {
  const low: [number, number, number] = [Infinity, Infinity, Infinity];
  const high: [number, number, number] = [-Infinity, -Infinity, -Infinity];
  for (const row of rows) {
    const spare = reach(row);
    for (let k = 0; k < 3; k++) {
      const at = table.position[row * 3 + k]!;
      low[k] = Math.min(low[k]!, at - (k === 2 ? 0 : spare));
      high[k] = Math.max(high[k]!, at + spare);
    }
  }
  const deep = first + rows.findIndex((row) => table.rank[row]! >= deepFrom);
  const end = first + rows.length;
  return { first, deep: deep < first ? end : deep, end, facing, fixture: table.fixture[rows[0]!]!, low, high };
}

// `without`: rows that are left out of the cells, and so are not drawn.
export function readGoods(packed: Sections, skus: Summary["skus"], without: ReadonlySet<number> = new Set()): GoodsTable {
  const position = packed.f32("position", 3);
  const count = position.length / 3;
  const base = {
    count,
    position,
    rotation: packed.i16("rotation", 4),
    sku: packed.u16("sku", 1),
    fixture: packed.u16("fixture", 1),
    shelf: packed.u16("shelf", 1),
    facing: packed.u32("facing", 1),
    tint: packed.u8("tint", 3),
    rank: new Uint8Array(count),
  };
  const { shelf } = base;
  const widths = Float64Array.from(skus, ({ size_m }) => size_m[0]);
  const reaches = Float64Array.from(skus, ({ size_m }) => Math.hypot(...size_m));
  const facing = new Uint8Array(count);
  for (let row = 0; row < count; row++) facing[row] = facingOf(rotationOf(base, row));

  for (const rows of groupedBy(count, (row) => shelf[row]!).values()) {
    const seen = [0, 0, 0, 0];
    for (const row of rows) seen[facing[row]!]!++;
    const main = seen.indexOf(Math.max(...seen));
    if (seen[main]! < rows.length * 0.8) for (const row of rows) facing[row] = facesAnyway;
    else rankShelf(rows, main, position, (row) => widths[base.sku[row]!]!, base.rank);
  }

  const order = new Uint32Array(count);
  const cells: Cell[] = [];
  let first = 0;
  for (const all of groupedBy(count, (row) => base.fixture[row]! * 8 + facing[row]!).values()) {
    const rows = all.filter((row) => !without.has(row));
    if (rows.length === 0) continue;
    rows.sort((a, b) => base.rank[a]! - base.rank[b]! || a - b);
    cells.push(cellOf(rows, facing[rows[0]!]!, first, base, (row) => reaches[base.sku[row]!]!));
    order.set(rows, first);
    first += rows.length;
  }
  return { ...base, order: order.subarray(0, first), cells };
}
