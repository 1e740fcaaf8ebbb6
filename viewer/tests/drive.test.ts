import { expect, test } from "vitest";
import { readDrivePlace, driveLink } from "../src/drive/addresses";
import { Controls, drivingKeys, moves, type Pad } from "../src/drive/controls";
import { Live } from "../src/drive/live";
import { driveTexts } from "../src/drive/strings";
import { leaning, together } from "../src/drive/touch";
import { RobotEye } from "../src/replay/robot_eye";
import { Navigator } from "../src/camera/navigator";
import { lookingAt } from "../src/camera/pose";
import { MemorySections } from "../src/store/packed";

const realman = { has_base: true, arms: ["left_", "right_"], joints: [{ name: "lift", dimension: "m" }, { name: "pan", dimension: "rad" }, { name: "tilt", dimension: "rad" }] };
const panda = { has_base: false, arms: [""], joints: [] };
const held = (...codes: string[]): Set<string> => new Set(codes);
const pad = (axes: number[], pressed: number[] = []): Pad => ({ axes, buttons: Array.from({ length: 17 }, (_, i) => ({ pressed: pressed.includes(i), value: pressed.includes(i) ? 1 : 0 })) });

test("keys drive and turn a base, and both ways at once are none", () => {
  const controls = new Controls(realman);
  const { drive, turn, move } = controls.command(held("KeyW", "ArrowLeft"), undefined);
  expect(drive).toBeGreaterThan(0);
  expect(turn).toBeGreaterThan(0);
  expect(move).toEqual([0, 0, 0]);
  expect(controls.command(held("KeyW", "KeyS"), undefined).drive).toBe(0);
  expect(moves(controls.command(held(), undefined))).toBe(false);
});

test("what has no wheels is moved by the same keys", () => {
  const command = new Controls(panda).command(held("KeyW"), undefined);
  expect(command.drive).toBe(0);
  expect(command.move[0]).toBeGreaterThan(0);
});

test("every number is a share of the most, whatever is held with whatever stick", () => {
  const controls = new Controls(realman);
  const command = controls.command(drivingKeys, pad([-1, -1, -1, -1], [6, 12]));
  for (const value of [command.drive, command.turn, ...command.move, ...command.twist, ...command.joints]) expect(Math.abs(value)).toBeLessThanOrEqual(1);
});

test("Shift turns the tool instead of moving it, and slow is slower", () => {
  const controls = new Controls(realman);
  const usual = controls.command(held("KeyI"), undefined).move[0];
  const turned = controls.command(held("KeyI", "ShiftLeft"), undefined);
  expect(turned.move).toEqual([0, 0, 0]);
  expect(turned.twist[1]).toBeGreaterThan(0);
  controls.fine = true;
  expect(controls.command(held("KeyI"), undefined).move[0]).toBeLessThan(usual / 2);
});

test("the lift is the joint that is a length, the head those that are angles", () => {
  const controls = new Controls(realman);
  expect(controls.command(held("KeyR"), undefined).joints).toEqual([1, 0, 0]);
  expect(controls.command(held("KeyF", "BracketRight", "Minus"), undefined).joints).toEqual([-1, 1, -1]);
});

test("a finger's stick leans no farther than to its end, and what leans farther counts", () => {
  expect(leaning(0, 22)).toEqual([0, 0.5]);
  const [x, y] = leaning(300, -400);
  expect([x, y]).toEqual([0.6, -0.8]);
  const both = together(pad([0.5, 0, 0, 0], [12]), pad([0.2, -1, 0, 0], [0]));
  expect(both.axes.slice(0, 2)).toEqual([0.5, -1]);
  expect([0, 12, 1].map((i) => both.buttons[i]!.pressed)).toEqual([true, true, false]);
  expect(together(undefined, both)).toBe(both);
});

test("a grip is told once, to the arm that is chosen", () => {
  const controls = new Controls(realman);
  controls.otherArm();
  controls.take("close");
  expect(controls.command(held(), undefined)).toMatchObject({ arm: 1, grip: "close" });
  expect(controls.command(held(), undefined).grip).toBe("keep");
});

test("a pad's sticks rest near their middle, and its buttons count when they go down", () => {
  const controls = new Controls(realman);
  expect(moves(controls.command(held(), pad([0.05, -0.1, 0, 0])))).toBe(false);
  expect(controls.command(held(), pad([0, -1, 0, 0])).drive).toBeGreaterThan(0);
  expect(controls.presses(pad([], [0]))).toEqual(["grip"]);
  expect(controls.presses(pad([], [0]))).toEqual([]);
  expect(controls.presses(undefined)).toEqual([]);
  expect(controls.presses(pad([], [0, 9]))).toEqual(["grip", "pause"]);
});

test("bodies, things and joints are where the last message has them", () => {
  const live = new Live();
  const whole = 32767;
  const message = {
    position: Float32Array.of(1, 2, 3, 4, 5, 6),
    rotation: Int16Array.of(0, 0, 0, whole, 0, 0, whole, 0),
    joint: Uint32Array.of(9),
    joint_position: Float32Array.of(0.5),
  };
  expect(live.bodies.at(0, 0)).toBeUndefined();
  live.take(new MemorySections(message), 1, 1);
  expect(live.bodies.at(0, 0)?.position).toEqual([1, 2, 3]);
  expect(live.things.at(0, 0)).toEqual({ position: [4, 5, 6], rotation: [0, 0, 1, 0] });
  expect(Array.from(live.things.joints)).toEqual([9]);
  expect(live.things.jointAt(0, 0)).toBe(0.5);
});

test("the eye turns with the robot about it", () => {
  const room = { low: [0, 0, 0], high: [9, 9, 3], outline: [], obstacles: [] } as const;
  const navigator = new Navigator(room, "orbit", lookingAt([0, 0, 1], [1, 0, 1]), 1);
  const eye = new RobotEye(navigator, { from: [-2, 0, 1], at: [0, 0, 1] }, 1, true);
  eye.follow({ robotAt: [0, 0, 0], heading: [1, 0] });
  eye.follow({ robotAt: [0, 1, 0], heading: [0, 1] });
  const { pose } = navigator;
  expect(pose.eye[0]).toBeCloseTo(0);
  expect(pose.eye[1]).toBeCloseTo(-1);
  expect(pose.yaw).toBeCloseTo(Math.PI / 2);
});

test("addresses are read as they are written", () => {
  expect(readDrivePlace("?store=0")).toBeUndefined();
  expect(readDrivePlace(driveLink({ store: 3, token: "a b" }))).toEqual({ store: 3, token: "a b", chooses: false });
  expect(readDrivePlace(driveLink({ store: 0, token: null }, true))).toEqual({ store: 0, token: null, chooses: true });
});

test("every text says the same things in both languages", () => {
  const names = (text: string): string[] => [...text.matchAll(/\{(\w+)\}/g)].map((match) => match[1]!).sort();
  expect(Object.keys(driveTexts.zh).sort()).toEqual(Object.keys(driveTexts.en).sort());
  for (const [key, text] of Object.entries(driveTexts.en)) expect(names(driveTexts.zh[key as keyof typeof driveTexts.zh]), key).toEqual(names(text));
});
