import { expect, test } from "vitest";
import { walked, isInside, type Obstacle } from "../src/camera/floor";

const outline = [
  [0, 0],
  [10, 0],
  [10, 8],
  [0, 8],
] as const;
const shelf: Obstacle = { center: [5, 4], half: [1, 0.5], yaw: 0 };

test("a walker slides along a shelf and never stands in it", () => {
  const at = walked([5, 2, 1.6], [5.5, 3.4, 1.6], [shelf], outline);
  expect(at[0]).toBeCloseTo(5.5);
  expect(at[1]).toBeCloseTo(3.25);
});

test("a turned shelf is where it is turned to", () => {
  const turned: Obstacle = { ...shelf, yaw: Math.PI / 2 };
  expect(walked([2, 4.8, 1.6], [5, 5.2, 1.6], [turned], outline)[1]).toBeCloseTo(5.25);
  expect(walked([7, 4, 1.6], [6.2, 4, 1.6], [turned], outline)).toEqual([6.2, 4, 1.6]);
});

test("walls hold who is inside, and let who is outside walk", () => {
  expect(walked([0.5, 4, 1.6], [0.1, 4, 1.6], [], outline)[0]).toBeCloseTo(0.25);
  expect(walked([0.5, 4, 1.6], [-3, 4, 1.6], [], outline)).toEqual([0.5, 4, 1.6]);
  expect(walked([-2, 4, 1.6], [-1, 4, 1.6], [], outline)).toEqual([-1, 4, 1.6]);
});

test("between two shelves that leave no room one stays", () => {
  const left: Obstacle = { center: [4, 4], half: [0.8, 2], yaw: 0 };
  const right: Obstacle = { center: [6, 4], half: [0.8, 2], yaw: 0 };
  expect(walked([5, 1.5, 1.6], [5, 3, 1.6], [left, right], outline)).toEqual([5, 1.5, 1.6]);
});

test("inside is known for rooms that are not convex", () => {
  const corner = [[0, 0], [4, 0], [4, 2], [2, 2], [2, 4], [0, 4]] as const;
  expect(isInside(1, 3, corner)).toBe(true);
  expect(isInside(3, 3, corner)).toBe(false);
});
