import { expect, test } from "vitest";
import { Clock } from "../src/replay/clock";

test("time runs as fast as is wished, and stops at the end", () => {
  const clock = new Clock(101, 0.05);
  expect(clock.end).toBeCloseTo(5);
  expect(clock.advance(1)).toBe(false);
  clock.toggle();
  clock.speed = 2;
  expect(clock.advance(1)).toBe(true);
  expect([clock.seconds, clock.step]).toEqual([2, expect.closeTo(40)]);
  clock.advance(10);
  expect([clock.atEnd, clock.playing, clock.step]).toEqual([true, false, 100]);
  clock.toggle();
  expect([clock.seconds, clock.playing]).toEqual([0, true]);
});

test("steps go to whole ones, and not beyond the ends", () => {
  const clock = new Clock(4, 0.05);
  clock.seek(1.4);
  clock.nudge(1);
  expect(clock.step).toBeCloseTo(2);
  clock.nudge(1);
  clock.nudge(1);
  expect(clock.step).toBe(3);
  clock.seek(1.4);
  clock.nudge(-1);
  expect(clock.step).toBeCloseTo(1);
  clock.nudge(-1);
  clock.nudge(-1);
  expect(clock.step).toBe(0);
});

test("an episode of one step does not play", () => {
  const clock = new Clock(1, 0.05);
  clock.toggle();
  expect([clock.playing, clock.step]).toEqual([false, 0]);
});

test("speeds go up and down their list", () => {
  const clock = new Clock(10, 0.05);
  const all = Array.from({ length: 5 }, () => (clock.change(1), clock.speed));
  expect(all).toEqual([2, 4, 8, 8, 8]);
  expect(Array.from({ length: 6 }, () => (clock.change(-1), clock.speed)).at(-1)).toBe(0.25);
});
