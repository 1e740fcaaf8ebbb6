import { expect, test } from "vitest";
import { eyeHeight, Navigator, type Held } from "../src/camera/navigator";
import { between, lookingAt } from "../src/camera/pose";
import { distance } from "../src/camera/vector";

const room = {
  low: [0, 0, 0] as const,
  high: [20, 12, 3] as const,
  outline: [
    [0, 0],
    [20, 0],
    [20, 12],
    [0, 12],
  ] as const,
  obstacles: [{ center: [10, 6] as const, half: [2, 0.5] as const, yaw: 0 }],
};
const nothing: Held = { forward: 0, right: 0, up: 0, turn: 0, tilt: 0, fast: false };

function orbiting(): Navigator {
  return new Navigator(room, "orbit", lookingAt([4, 2, 3], [10, 6, 1]), distance([4, 2, 3], [10, 6, 1]));
}

test("orbit keeps its target and its distance", () => {
  const navigator = orbiting();
  navigator.drag(120, -40, 720, 1, false);
  const target = navigator.target;
  [10, 6, 1].forEach((x, k) => expect(target[k]).toBeCloseTo(x, 6));
  expect(distance(navigator.pose.eye, target)).toBeCloseTo(navigator.around, 6);
});

test("zooming in orbit goes towards the target and stops before it", () => {
  const navigator = orbiting();
  for (let i = 0; i < 100; i++) navigator.zoom(1.5);
  expect(navigator.around).toBeCloseTo(0.12);
  expect(navigator.target[0]).toBeCloseTo(10, 5);
});

test("a walker goes at a walker's height and not through a shelf", () => {
  const navigator = new Navigator(room, "walk", { eye: [10, 2, eyeHeight], yaw: Math.PI / 2, pitch: 0 }, 2);
  for (let i = 0; i < 300; i++) navigator.step(1 / 30, { ...nothing, forward: 1 });
  expect(navigator.pose.eye[2]).toBe(eyeHeight);
  expect(navigator.pose.eye[1]).toBeCloseTo(5.25, 2);
  for (let i = 0; i < 60; i++) navigator.step(1 / 30, nothing);
  expect(navigator.moving).toBe(false);
});

test("entering the walk from a shelf's middle finds free floor", () => {
  const navigator = orbiting();
  navigator.enter("walk", true);
  const [x, y] = navigator.pose.eye;
  expect(Math.abs(x - 10) >= 2.25 - 1e-6 || Math.abs(y - 6) >= 0.75 - 1e-6).toBe(true);
});

test("the top view looks down on the whole room", () => {
  const navigator = orbiting();
  navigator.enter("top", true);
  expect(navigator.pose.pitch).toBeLessThan(-1.5);
  expect(navigator.pose.eye[0]).toBe(10);
  navigator.drag(50, 0, 720, 1, false);
  expect(navigator.pose.eye[0]).toBeLessThan(10);
});

test("a key held ends a flight", () => {
  const navigator = orbiting();
  navigator.goTo({ eye: [1, 1, 1], yaw: 0, pitch: 0 }, 1);
  navigator.step(0.05, nothing);
  expect(navigator.moving).toBe(true);
  navigator.step(0.05, { ...nothing, forward: 1 });
  navigator.step(2, nothing);
  expect(distance(navigator.pose.eye, [1, 1, 1])).toBeGreaterThan(1);
});

test("turns take the shorter way", () => {
  const from = { eye: [0, 0, 0] as const, yaw: 3, pitch: 0 };
  const half = between(from, { ...from, yaw: -3 }, 0.5);
  expect(Math.abs(half.yaw)).toBeCloseTo(Math.PI, 5);
});

test("who stands still has the same pose, however they move", () => {
  for (const mode of ["orbit", "walk", "fly", "top"] as const) {
    const navigator = new Navigator(room, mode, { eye: [4, 2, eyeHeight], yaw: 0.3, pitch: 0 }, 2);
    navigator.step(1 / 60, { ...nothing, forward: 1 });
    for (let i = 0; i < 100; i++) navigator.step(1 / 60, nothing);
    const { pose } = navigator;
    navigator.step(1 / 60, nothing);
    expect(navigator.pose).toBe(pose);
  }
});
