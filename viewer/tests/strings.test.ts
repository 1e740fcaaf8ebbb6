import { expect, test } from "vitest";
import { filled, languageOf, texts } from "../src/text/strings";

const names = (text: string): string[] => [...text.matchAll(/\{(\w+)\}/g)].map((match) => match[1]!).sort();

test("every text says the same things in both languages", () => {
  expect(Object.keys(texts.zh).sort()).toEqual(Object.keys(texts.en).sort());
  for (const [key, text] of Object.entries(texts.en)) {
    expect(names(texts.zh[key as keyof typeof texts.zh]), key).toEqual(names(text));
    expect(text.trim(), key).not.toBe("");
  }
});

test("texts are filled, and markup stays text", () => {
  expect(filled("Nothing matches “{query}”.", { query: "<b>" })).toBe("Nothing matches “<b>”.");
  expect(filled("{a} {b}", { a: 1 })).toBe("1 {b}");
});

test("the language follows the browser's wishes", () => {
  expect(languageOf(["fr-FR", "zh-CN", "en"])).toBe("zh");
  expect(languageOf(["fr"])).toBe("en");
});
