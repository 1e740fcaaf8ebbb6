import { expect, test } from "vitest";
import { readAddress, writeAddress } from "../src/state/address";

test("what is written is read again", () => {
  const state = {
    mode: "walk",
    pose: { eye: [1.25, -3.5, 1.62], yaw: 0.75, pitch: -0.125 },
    distance: 2.5,
    product: 17,
    zones: true,
    heat: "price",
    layers: ["aisles", "violations"],
    query: "oat milk & \"燕麦\" #1",
  } as const;
  expect(readAddress(writeAddress(state))).toEqual(state);
});

test("what makes no sense is left out", () => {
  expect(readAddress("#mode=swim&eye=1,2&look=0,0&product=-4&around=-1&fixture=1e9&zones=yes&layers=zones,walls&heat=love")).toEqual({});
  expect(readAddress("#eye=1,2,NaN&look=0,0")).toEqual({});
  expect(readAddress("")).toEqual({});
});
