import type { BufferGeometry, Mesh, Texture } from "three";
import { expect, test } from "vitest";
import { Goods } from "../src/stage/goods";
import { readGoods } from "../src/stage/goods_table";
import { divideRoom, divideShapes, type RoomSource } from "../src/stage/room_parts";
import { newShared } from "../src/stage/shading";
import { nowhere } from "../src/stage/stand_ins";
import type { Sku } from "../src/store/contract";
import { MemorySections } from "../src/store/packed";

const skus = ["#ff0000", "#00ff00", "#0000ff"].map((color, i) => ({ sku: `sku-${i}`, color, size_m: [0.05 + 0.02 * i, 0.06, 0.2] }) as unknown as Sku);
const portraits = { texture: {} as Texture, cells: [3, 2] as const, cellTexels: [40, 60] as const, forms: Uint8Array.from([0, 2]) };

function tableOf(rows: readonly number[]): ReturnType<typeof readGoods> {
  const of = (size: number, value: (row: number, k: number) => number): number[] => rows.flatMap((row) => Array.from({ length: size }, (_, k) => value(row, k)));
  const sections = new MemorySections({
    position: Float32Array.from(of(3, (row, k) => (k === 0 ? row * 0.1 : k))),
    rotation: Int16Array.from(of(4, (_, k) => (k === 3 ? 32767 : 0))),
    sku: Uint16Array.from(of(1, (row) => row % 3)),
    fixture: Uint16Array.from(of(1, (row) => row % 2)),
    shelf: Uint16Array.from(of(1, (row) => row % 2)),
    facing: Uint32Array.from(of(1, (row) => row)),
    tint: Uint8Array.from(of(3, (row, k) => 180 + row + k)),
  });
  return readGoods(sections, skus);
}
const lightOf = (rows: readonly number[]): { cube: Uint8Array } => ({ cube: Uint8Array.from(rows.flatMap((row) => Array.from({ length: 18 }, (_, k) => 10 * row + k))) });
const written = (goods: Goods): Record<string, number[]> => {
  const { attributes } = (goods.standIns.group.children[0] as Mesh<BufferGeometry>).geometry;
  return Object.fromEntries(Object.entries(attributes).map(([name, { array }]) => [name, [...array]]));
};
const made = (rows: readonly number[], earlier?: { goods: Goods; rows: Uint32Array }): Goods => {
  const light = lightOf(rows);
  const goods = new Goods(tableOf(rows), skus, newShared(), () => undefined, () => undefined, earlier && { ...earlier, light });
  if (earlier) return goods;
  goods.setLight(light);
  goods.standIns.setPortraits(portraits);
  return goods;
};

test("packs that stay are as if they were written anew, beside those that are new", () => {
  const before = made([0, 1, 2, 3, 4, 5]);
  const rows = [7, 2, 3, 0, 8];
  const earlier = { goods: before, rows: Uint32Array.from([nowhere, 2, 3, 0, nowhere]) };
  expect(written(made(rows, earlier))).toEqual(written(made(rows)));
});

test("colours by a figure are not taken over as those of the packs", () => {
  const before = made([0, 1, 2]);
  before.standIns.paint(new Uint8Array(9).fill(77));
  expect(written(made([0, 1], { goods: before, rows: Uint32Array.from([0, 1]) }))).toEqual(written(made([0, 1])));
});

test("shapes are divided once, and drawn in each of their places", async () => {
  const places = 3;
  const corners = [0, 0, 0, 1, 0, 0, 0, 0, 1, 0.001, 0, 0, 0.002, 0, 0, 0, 0.001, 0];
  const each = corners.length / 3;
  const source: RoomSource = {
    position: Float32Array.from(Array.from({ length: places }, (_, i) => corners.map((value, k) => value + (k % 3 === 0 ? 4 * i : 0))).flat()),
    normal: new Int8Array(places * each * 4).fill(127),
    color: new Uint8Array(places * each * 4).fill(200),
    index: Uint32Array.from(Array.from({ length: places }, (_, i) => [0, 1, 2, 3, 4, 5].map((corner) => corner + i * each)).flat()),
    owner: Uint16Array.from(Array.from({ length: places * each }, (_, v) => [10 + Math.floor(v / each), 65535]).flat()),
  };
  const batches = [{ first: 0, count: source.index.length, surface: 0, exact: false }];
  const shaped = new Map(Array.from({ length: places }, (_, i) => [10 + i, { shape: 0, vertex: i * each }] as const));
  const plain = (parts: Awaited<ReturnType<typeof divideRoom>>): unknown => ({ ...parts, indices: parts.indices.map((level) => [...level]) });
  expect(plain(divideShapes(source, batches, shaped))).toEqual(plain(await divideRoom(source, batches)));
});
