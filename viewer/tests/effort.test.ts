import { expect, test } from "vitest";
import { Pace } from "../src/stage/effort";

const after = (pace: Pace, milliseconds: number, pictures: number): Pace => {
  for (let i = 0; i < pictures; i++) pace.took(milliseconds);
  return pace;
};

test("a machine that is too slow draws less of everything, down to the least", () => {
  const pace = new Pace(true);
  const first = pace.moving;
  const least = after(pace, 400, 20).moving;
  expect(least.pixels).toBeLessThanOrEqual(first.pixels);
  expect(least.fineWithin).toBeLessThan(first.fineWithin);
  expect(least.plainFrom).toBeLessThan(first.plainFrom);
  expect(least.meshes).toBe(0);
  expect(after(pace, 400, 20).moving).toEqual(least);
});

test("a machine that is fast enough comes to all that there is", () => {
  const pace = after(new Pace(true), 10, 500);
  expect(pace.moving).toMatchObject({ pixels: 1, meshes: 60_000 });
  expect(after(new Pace(false), 5, 500).moving.meshes).toBe(1_500_000);
});

test("with a GPU a slow picture keeps all its pixels", () => {
  expect(after(new Pace(false), 100, 50).moving).toMatchObject({ pixels: 1, meshes: 12_000 });
});

test("what stands still is fine however slow the machine", () => {
  const slow = after(new Pace(true), 900, 50);
  expect(slow.resting).toMatchObject({ pixels: 1, meshes: 110_000 });
});
