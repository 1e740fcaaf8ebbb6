import { expect, test } from "vitest";
import { BodyTracks, pieceSteps, rowAt, ThingTracks } from "../src/replay/tracks";
import type { MotionHead } from "../src/replay/contract";
import type { Packed } from "../src/store/packed";

const whole = 32767;
const half = Math.round(Math.SQRT1_2 * whole);
const packed = <Head>(sections: Record<string, unknown>): Packed<Head> => {
  const get = (name: string): never => sections[name] as never;
  return { f32: get, i16: get, u32: get } as unknown as Packed<Head>;
};

// One thing at steps 0, 10 and 11: it stands, then moves within a step each.
const things = new ThingTracks(
  packed({
    range: Uint32Array.of(0, 3, 3, 1),
    step: Uint32Array.of(0, 10, 11, 5),
    position: Float32Array.of(0, 0, 0, 1, 0, 0, 1, 2, 0, 9, 9, 9),
    rotation: Int16Array.of(0, 0, 0, whole, 0, 0, half, half, 0, 0, whole, 0, 0, 0, 0, whole),
    joint: Uint32Array.of(7),
    joint_range: Uint32Array.of(0, 2),
    joint_step: Uint32Array.of(0, 4),
    joint_position: Float32Array.of(0, 0.5),
  }),
);

test("a thing is exactly where a row has it, and stands still until the step before the next", () => {
  expect(things.count).toBe(2);
  expect(things.at(0, 0).position).toEqual([0, 0, 0]);
  expect(things.at(0, 9).position).toEqual([0, 0, 0]);
  expect(things.at(0, 9.25).position[0]).toBeCloseTo(0.25);
  expect(things.at(0, 10).position).toEqual([1, 0, 0]);
  expect(things.at(0, 10.5).position).toEqual([1, 1, 0]);
  expect(things.at(0, 400)).toEqual({ position: [1, 2, 0], rotation: [0, 0, 1, 0] });
});

test("in between a thing turns the shorter way, and stays a rotation", () => {
  const { rotation } = things.at(0, 9.5);
  expect(Math.hypot(...rotation)).toBeCloseTo(1);
  expect(2 * Math.atan2(rotation[2], rotation[3])).toBeCloseTo(Math.PI / 4, 2);
});

test("what was first seen later stood there before", () => {
  expect(things.at(1, 0).position).toEqual([9, 9, 9]);
});

test("a joint keeps its position until it moves", () => {
  expect([0, 3.9, 4, 100].map((step) => things.jointAt(0, step))).toEqual([0, 0, 0.5, 0.5]);
});

test("the row of a step is the last that is not after it", () => {
  const steps = Uint32Array.of(99, 0, 3, 8);
  expect([0, 2, 3, 7.9, 8, 50].map((step) => rowAt(steps, 1, 3, step))).toEqual([0, 0, 1, 1, 2, 2]);
  expect(rowAt(steps, 2, 2, 1)).toBe(-1);
});

test("the robot's steps come in pieces, the next one beforehand, each asked for once", async () => {
  const asked: number[] = [];
  let came = 0;
  const load = (first: number, count: number): Promise<Packed<MotionHead>> => {
    asked.push(first);
    const position = Float32Array.from({ length: count * 3 }, (_, i) => (i % 3 === 0 ? first + i / 3 : 0));
    return Promise.resolve(packed({ position, rotation: new Int16Array(count * 4).fill(0).map((_, i) => (i % 4 === 3 ? whole : 0)) }));
  };
  const tracks = new BodyTracks(1, 2.5 * pieceSteps, load, () => came++);
  expect(tracks.at(0, 0)).toBeUndefined();
  tracks.want(0);
  tracks.want(1);
  await new Promise((done) => setTimeout(done));
  expect([asked, came]).toEqual([[0, pieceSteps], 2]);
  expect(tracks.at(pieceSteps - 0.5, 0)!.position[0]).toBeCloseTo(pieceSteps - 0.5);
  expect(tracks.at(2 * pieceSteps, 0)).toBeUndefined();
  tracks.want(pieceSteps + 1);
  tracks.want(2 * pieceSteps + 1);
  expect(asked).toEqual([0, pieceSteps, 2 * pieceSteps]);
});

test("a piece that failed is said, and asked for again", async () => {
  const errors: unknown[] = [];
  let tries = 0;
  const tracks = new BodyTracks(1, 10, () => (tries++, Promise.reject(new Error("gone"))), (error) => errors.push(error));
  tracks.want(0);
  await new Promise((done) => setTimeout(done));
  tracks.want(0);
  await new Promise((done) => setTimeout(done));
  expect([tries, errors.length]).toEqual([2, 2]);
});
