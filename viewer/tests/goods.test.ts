import { expect, test } from "vitest";
import { lightOn } from "../src/stage/goods_light";
import { facingOf, readGoods } from "../src/stage/goods_table";
import { enters, meets, pick, type World } from "../src/stage/pick";
import type { Packed } from "../src/store/packed";
import type { Sku } from "../src/store/contract";

const half = Math.SQRT1_2;
const can = { sku: "can", size_m: [0.08, 0.08, 0.1], color: "#ff0000" } as unknown as Sku;

function goods(places: number[][], turn = [0, 0, 0, 1], shelf = 0): Packed<unknown> {
  const count = places.length;
  const sections: Record<string, unknown> = {
    position: new Float32Array(places.flat()),
    rotation: new Int16Array(places.flatMap(() => turn.map((x) => Math.round(x * 32767)))),
    sku: new Uint16Array(count),
    fixture: new Uint16Array(count).fill(3),
    shelf: new Uint16Array(count).fill(shelf),
    facing: new Uint32Array(count),
    tint: new Uint8Array(count * 3).fill(200),
  };
  const get = (name: string): never => sections[name] as never;
  return { f32: get, u32: get, i16: get, u16: get, u8: get } as unknown as Packed<unknown>;
}

test("a front of -Y turned about Z faces round the compass", () => {
  expect(facingOf([0, 0, 0, 1])).toBe(0);
  expect(facingOf([0, 0, half, half])).toBe(1); // east
  expect(facingOf([0, 0, 1, 0])).toBe(2);
  expect(facingOf([0, 0, -half, half])).toBe(3);
});

test("goods are ordered by cell and by how deep they stand", () => {
  const places = [0.3, 0.2, 0.1, 0].flatMap((y) => [
    [0, y, 1],
    [0.1, y, 1],
  ]);
  const table = readGoods(goods(places), [can]);
  expect(table.cells).toHaveLength(1);
  expect([...table.rank]).toEqual([3, 3, 2, 2, 1, 1, 0, 0]);
  expect([...table.order.subarray(0, 2)].sort()).toEqual([6, 7]);
  expect(table.cells[0]!.deep).toBe(6);
});

test("an ambient cube lights each side by its own face", () => {
  const cube = Uint8Array.from({ length: 18 }, (_, i) => 10 * (1 + Math.floor(i / 3)));
  const out = new Uint8Array(3);
  lightOn({ cube }, 0, 0, -1, 0, out, 0);
  expect([...out]).toEqual([40, 40, 40]);
  lightOn({ cube }, 0, half, 0, half, out, 0);
  expect(out[0]).toBe(Math.floor(Math.sqrt((10 * 10 + 50 * 50) / 2)));
});

test("rays meet boxes and triangles where they are", () => {
  expect(enters([0, 0, 0], [1, 0, 0], [2, -1, -1], [3, 1, 1])).toBe(2);
  expect(enters([0, 0, 0], [-1, 0, 0], [2, -1, -1], [3, 1, 1])).toBe(Infinity);
  const triangle = new Float32Array([5, -1, -1, 5, 1, -1, 5, 0, 1]);
  expect(meets([0, 0, 0], [1, 0, 0], triangle, 0, 3, 6)).toBeCloseTo(5);
  expect(meets([0, 2, 0], [1, 0, 0], triangle, 0, 3, 6)).toBe(Infinity);
});

test("the product in front is picked, and a wall before it hides it", () => {
  const table = readGoods(goods([[0, 1, 1], [0, 2, 1]], [0, 0, 0, 1]), [can]);
  const world: World = { table, skus: [can], meshes: undefined, room: undefined, roomHidden: () => false };
  const ray = { from: [0, 0, 1.05], way: [0, 1, 0] } as const;
  expect(pick(ray, world)).toMatchObject({ product: 0, distance: expect.closeTo(0.96, 5) });
  const room = {
    position: new Float32Array([-1, 0.5, 0, 1, 0.5, 0, 0, 0.5, 3]),
    index: new Uint32Array([0, 1, 2]),
    owner: new Uint16Array([7, 65535, 7, 65535, 7, 65535]),
  };
  expect(pick(ray, { ...world, room })).toMatchObject({ fixture: 7, distance: expect.closeTo(0.5, 5) });
  expect(pick(ray, { ...world, room, roomHidden: () => true })).toMatchObject({ product: 0 });
});
