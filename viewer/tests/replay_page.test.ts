import { expect, test } from "vitest";
import { plainCube, RoomLight } from "../src/replay/actor_light";
import { episodeLink, listLink, readReplayPlace, storeLink } from "../src/replay/addresses";
import { isWanted } from "../src/replay/list_page";
import { replayTexts, say } from "../src/replay/strings";
import { timeText } from "../src/replay/words";
import type { EpisodeLine } from "../src/replay/contract";

test("links are read as what they were made of", () => {
  const place = { store: 2, token: "a secret & more" };
  expect(readReplayPlace(episodeLink(place, 1, 34))).toEqual({ ...place, run: 1, episode: 34, beside: undefined });
  expect(readReplayPlace(episodeLink(place, 1, 34, 2))).toEqual({ ...place, run: 1, episode: 34, beside: 2 });
  expect(readReplayPlace(listLink(place))).toEqual({ ...place, run: undefined, episode: undefined, beside: undefined });
  expect(readReplayPlace(storeLink(place))).toBeUndefined();
  expect(readReplayPlace("?replay&run=-1&episode=1e3&store=x")).toEqual({ store: 0, token: null, run: undefined, episode: undefined, beside: undefined });
});

test("every text is there in both languages, with the same gaps", () => {
  const gaps = (text: string): string[] => [...text.matchAll(/\{(\w+)\}/g)].map(([, name]) => name!).sort();
  for (const key of Object.keys(replayTexts.en) as (keyof typeof replayTexts.en)[]) {
    expect(replayTexts.zh[key], key).not.toBe("");
    expect(gaps(replayTexts.zh[key]), key).toEqual(gaps(replayTexts.en[key]));
  }
  expect(say("en", "contact", { name: "a fixture", force: 12 })).toBe("Pressed on a fixture with 12 N");
});

test("times have minutes and hundredths", () => {
  expect([0, 5.25, 59.999, 65.2].map(timeText)).toEqual(["0:00.00", "0:05.25", "1:00.00", "1:05.20"]);
});

test("episodes are chosen by how they ended", () => {
  const line = (strict: boolean, failure: string): EpisodeLine => ({ strict, failure }) as EpisodeLine;
  const lines = [line(true, "None"), line(false, "Timeout"), line(false, "None")];
  const chosen = (wanted: string): boolean[] => lines.map((each) => isWanted(each, wanted));
  expect(chosen("")).toEqual([true, true, true]);
  expect(chosen("failed")).toEqual([false, true, true]);
  expect(chosen("solved")).toEqual([true, false, false]);
  expect(chosen("Timeout")).toEqual([false, true, false]);
});

test("what moves has the light of the surfaces that are near, by the way they face", () => {
  const position = [0, 0, 0, 0.1, 0, 0, 40, 0, 0];
  const normal = [0, 0, 127, 0, 127, 0, 0, 0, 0, 0, 127, 0];
  const light = [255, 128, 0, 0, 51, 51, 51, 0, 255, 255, 255, 0];
  const cube = new RoomLight({ position, normal, light }).cubeAt([0, 0, 0.2]);
  expect([...cube.slice(12, 15)]).toEqual([1, expect.closeTo(128 / 255), 0]);
  expect([...cube.slice(0, 3)].map((x) => x.toFixed(2))).toEqual(["0.20", "0.20", "0.20"]);
  expect([...cube.slice(3, 6)]).toEqual([...plainCube.slice(3, 6)]);
});
