import { expect, test } from "vitest";
import { MovingParts } from "../src/stage/moving_parts";
import type { Joint } from "../src/store/contract";

const joint = (kind: Joint["kind"], axis: Joint["axis"], upper: number, parent = -1, origin: Joint["origin_m"] = [0, 0, 0]): Joint => ({
  row: 0, fixture: 0, name: kind, kind, parent, origin_m: origin, axis, lower: 0, upper, states: [],
});
const none = 65535;
// A corner of the frame, one of a door hinged at x = 1, one of a drawer in that door.
const owner = Uint16Array.from([0, none, 0, 0, 0, 1]);
const corners = (): Float32Array => Float32Array.from([5, 5, 5, 2, 0, 0, 2, 0, 1]);
const joints = [joint("hinge", [0, 0, 1], Math.PI / 2, -1, [1, 0, 0]), joint("slide", [1, 0, 0], 0.5, 0)];

test("a door turns about its hinge and takes along what hangs in it", () => {
  const position = corners();
  const moving = new MovingParts(joints, owner, position);
  expect([...moving.move(0, Math.PI / 2)].sort()).toEqual([0, 1]);
  [5, 5, 5, 1, 1, 0, 1, 1, 1].forEach((at, i) => expect(position[i]).toBeCloseTo(at, 5));
  moving.move(1, 0.25); // along the door, that has turned
  [1, 1, 0, 1, 1.25, 1].forEach((at, i) => expect(position[i + 3]).toBeCloseTo(at, 5));
  moving.move(0, 0);
  moving.move(1, 0);
  expect(position).toEqual(corners());
});

test("nothing goes beyond its limits", () => {
  const moving = new MovingParts(joints, owner, corners());
  moving.move(1, 9);
  expect(moving.positions[1]).toBe(0.5);
  moving.move(1, -9);
  expect(moving.positions[1]).toBe(0);
});

test("wheels, belts and what has no shape are not offered", () => {
  const wheel = joint("hinge", [1, 0, 0], 4000);
  const belt = joint("belt", [1, 0, 0], 0.25);
  const door = joint("hinge", [0, 0, 1], 1.5);
  const moving = new MovingParts([wheel, belt, door, door], Uint16Array.from([0, 0, 0, 1, 0, 2]), new Float32Array(9));
  expect([0, 1, 2, 3].map((row) => moving.canMove(row))).toEqual([false, false, true, false]);
});
