import { expect, test } from "vitest";
import type { GoodsTable } from "../src/stage/goods_table";
import { heatOf, ramp, rampColor } from "../src/stage/heat";
import type { Sku } from "../src/store/contract";

const skus = [1, 2, 3].map((price) => ({ price, size_m: [0.1, 0.1, 0.2] }) as unknown as Sku);
const table = { count: 3, sku: Uint16Array.from([2, 0, 1]), position: Float32Array.from([0, 0, 1, 0, 0, 0.5, 0, 0, 0]) } as unknown as GoodsTable;

test("colours go from the smallest figure to the largest", () => {
  const price = heatOf("price", table, skus);
  expect([price.low, price.high]).toEqual([1, 3]);
  expect([...price.colors]).toEqual([...ramp[4], ...ramp[0], ...ramp[2]]);
  const height = heatOf("height", table, skus);
  expect(height.low).toBeCloseTo(0.1);
  expect([...height.colors.subarray(6)]).toEqual([...ramp[0]]);
});

test("each colour is lighter than the one before, and none is beyond the ends", () => {
  const light = Array.from({ length: 21 }, (_, i) => rampColor(i / 20)).map(([r, g, b]) => 0.2126 * (r / 255) ** 2.2 + 0.7152 * (g / 255) ** 2.2 + 0.0722 * (b / 255) ** 2.2);
  for (let i = 1; i < light.length; i++) expect(light[i]).toBeGreaterThan(light[i - 1]!);
  expect(rampColor(-1)).toEqual([...ramp[0]]);
  expect(rampColor(2)).toEqual([...ramp[4]]);
});

test("a product without the figure is grey, and no end of the scale", () => {
  const studied = skus.map((sku, i) => ({ ...sku, pick_rate: [0.25, -1, 0.75][i]!, mass_kg: i }));
  const rate = heatOf("pickRate", table, studied);
  expect([rate.low, rate.high]).toEqual([0.25, 0.75]);
  expect([...rate.colors]).toEqual([...ramp[4], ...ramp[0], 128, 128, 128]);
  expect(heatOf("mass", table, studied).high).toBe(2);
});

test("where all cost the same, one colour is enough", () => {
  const same = heatOf("price", table, skus.map((sku) => ({ ...sku, price: 2 })));
  expect([...same.colors.subarray(0, 3)]).toEqual([...ramp[2]]);
});
