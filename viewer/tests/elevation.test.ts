import { expect, test } from "vitest";
import { elevationOf } from "../src/stage/elevation";
import { readGoods } from "../src/stage/goods_table";
import type { Fixture, Sku } from "../src/store/contract";
import type { Packed } from "../src/store/packed";
import { inkOn } from "../src/ui/elevation";

const sku = { sku: "tin", size_m: [0.1, 0.1, 0.2], color: "#ffffff" } as unknown as Sku;
const none = 0xffffffff;
// A fixture 2 m wide that faces east, its left end (of who looks at it) in the south.
const fixture = { row: 0, run: "r", yaw_deg: 90, position_m: [5, 3, 0], size_m: [2, 0.5, 1.8] } as unknown as Fixture;
const quarter = Math.round(Math.SQRT1_2 * 32767);

function goods(rows: readonly (readonly [number, number, number, number])[], turns: readonly number[][]): Packed<unknown> {
  const count = rows.length;
  const sections: Record<string, unknown> = {
    position: new Float32Array(rows.flatMap(([x, y, z]) => [x, y, z])),
    rotation: new Int16Array(turns.flat()),
    sku: new Uint16Array(count),
    fixture: new Uint16Array(count),
    shelf: new Uint16Array(count),
    facing: Uint32Array.from(rows, (row) => row[3]),
    tint: new Uint8Array(count * 3).fill(200),
  };
  const get = (name: string): never => sections[name] as never;
  return { f32: get, u32: get, i16: get, u16: get, u8: get } as unknown as Packed<unknown>;
}

test("facings of the front row stand where one sees them from before the shelf", () => {
  const east = [0, 0, quarter, quarter];
  const west = [0, 0, -quarter, quarter];
  const rows = [
    [5.2, 2.5, 0.3, 1], // two beside one another
    [5.2, 2.6, 0.3, 1],
    [5.05, 2.5, 0.3, 1], // behind the first
    [5.2, 2.5, 1.2, 2], // a level above
    [5.2, 3.5, 0.3, none], // of no facing
    [4.8, 3, 0.3, 3], // on the other side
  ] as const;
  const table = readGoods(goods(rows, rows.map((row) => (row[3] === 3 ? west : east))), [sku]);
  const { width, height, blocks } = elevationOf("r", "front", [fixture], table, [sku]);
  expect([width, height]).toEqual([2, 1.8]);
  expect(blocks.map(({ product, columns }) => [product, columns])).toEqual([[3, 1], [0, 2]]);
  expect(blocks[1]).toMatchObject({ left: expect.closeTo(0.45), right: expect.closeTo(0.65), bottom: expect.closeTo(0.3), top: expect.closeTo(0.5) });
  expect(elevationOf("r", "back", [fixture], table, [sku]).blocks).toMatchObject([{ product: 5, left: expect.closeTo(0.95) }]);
  expect(elevationOf("other", "front", [fixture], table, [sku]).blocks).toEqual([]);
});

test("words are black or white by what they stand on", () => {
  expect(["#ffffff", "#ffcc00", "#000000", "#102080"].map(inkOn)).toEqual(["#000", "#000", "#fff", "#fff"]);
});
