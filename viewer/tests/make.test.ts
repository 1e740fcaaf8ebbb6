import { expect, test } from "vitest";
import { makeLink, readMakePlace } from "../src/make/addresses";
import { readDropped, usesOf } from "../src/make/dropped";
import { makeTexts } from "../src/make/strings";
import { hardRules } from "../src/make/try_card";
import { readReplayPlace } from "../src/replay/addresses";
import type { MadeStore } from "../src/make/contract";

test("links are read as what they were made of", () => {
  expect(readMakePlace(makeLink("a secret & more", 3))).toEqual({ token: "a secret & more", from: 3 });
  expect(readMakePlace(makeLink(null))).toEqual({ token: null, from: undefined });
  expect(readMakePlace("?make&from=-1")).toEqual({ token: null, from: undefined });
  expect(readMakePlace("?store=1")).toBeUndefined();
  expect(readReplayPlace(makeLink(null, 1))).toBeUndefined();
});

test("every text is there in both languages, with the same gaps", () => {
  const gaps = (text: string): string[] => [...text.matchAll(/\{(\w+)\}/g)].map(([, name]) => name!).sort();
  expect(Object.keys(makeTexts.zh).sort()).toEqual(Object.keys(makeTexts.en).sort());
  for (const key of Object.keys(makeTexts.en) as (keyof typeof makeTexts.en)[]) {
    expect(makeTexts.zh[key], key).not.toBe("");
    expect(gaps(makeTexts.zh[key]), key).toEqual(gaps(makeTexts.en[key]));
  }
});

test("a file's ending says what it can be for", () => {
  expect(usesOf("Plan.SVG")).toEqual(["floor_plan"]);
  expect(usesOf("plan.dxf")).toEqual(["floor_plan"]);
  expect(usesOf("shop.v2.JPEG")).toEqual(["image", "floor_plan"]);
  expect(usesOf("plan.pdf")).toEqual([]);
  expect(usesOf("own.CSV")).toEqual(["catalog"]);
  expect(usesOf("own.json")).toEqual(["catalog"]);
  expect(usesOf("png")).toEqual(["image", "floor_plan"]); // the server says what is wrong with it
});

test("the bytes of a file arrive as they are, however many", async () => {
  const bytes = Uint8Array.from({ length: 100_003 }, (_, i) => (i * 7) % 256);
  const { name, base64 } = await readDropped(new File([bytes], "plan.png"));
  expect(name).toBe("plan.png");
  expect(Uint8Array.from(atob(base64), (c) => c.charCodeAt(0))).toEqual(bytes);
});

test("hard rules are counted apart from others", () => {
  const rule = (severity: string): object => ({ code: "X", severity, where: "", message: "" });
  expect(hardRules({ report: { rules: [rule("hard"), rule("soft"), rule("hard")] } } as unknown as MadeStore)).toBe(2);
});
