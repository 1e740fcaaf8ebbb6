import { expect, test } from "vitest";
import type { ReplayEvent } from "../src/replay/contract";
import { listed, marksOf, nextFrom, weightOf } from "../src/replay/marks";

const event = (kind: ReplayEvent["kind"], step: number, last_step = step, force_n = 0): ReplayEvent => ({ kind, step, last_step, target: "nothing", number: 0, sku: "", force_n });

test("contacts weigh what the ledger says of their force", () => {
  expect([9.9, 10, 10.1, 50, 50.1].map((force) => weightOf(event("contact", 0, 0, force)))).toEqual(["light", "light", "firm", "firm", "hard"]);
  expect([weightOf(event("held", 0)), weightOf(event("dropped", 0))]).toEqual(["plain", "hard"]);
});

test("marks lie where and as long as what happened, the heaviest of a place on top", () => {
  const events = [event("held", 20, 50), event("contact", 0, 100, 5), event("contact", 50, 60, 80), event("toppled", 100)];
  const marks = marksOf(events, 101, 100);
  expect(marks.find(({ lane }) => lane === "held")).toEqual({ lane: "held", weight: "plain", from: 0.2, to: 0.51 });
  const contacts = marks.filter(({ lane }) => lane === "contact");
  expect(contacts.map(({ weight, from, to }) => [weight, from, to])).toEqual([["light", 0, 0.5], ["light", 0.61, 1], ["hard", 0.5, 0.61]]);
  expect(marks.find(({ lane }) => lane === "harm")).toMatchObject({ from: 0.99, to: 1 });
});

test("goals are marked where they came to lie, those of the judgement's wait at the end", () => {
  const marks = marksOf([], 101, 100, [25, 130]);
  expect(marks.map(({ lane, from, to }) => [lane, from, to])).toEqual([["goal", 0.25, 0.25], ["goal", 1, 1]]);
});

test("thousands of contacts are no more marks than there are points", () => {
  const events = Array.from({ length: 5000 }, (_, i) => event("contact", i, i, i % 60));
  expect(marksOf(events, 5000, 50).length).toBeLessThanOrEqual(50);
});

test("one goes from event to event, past light contacts", () => {
  const events = [event("contact", 5, 9, 3), event("held", 10, 30), event("contact", 20, 22, 30), event("dropped", 40)];
  expect(listed(events).map(({ step }) => step)).toEqual([10, 20, 40]);
  expect(nextFrom(events, 0, 1)?.step).toBe(10);
  expect(nextFrom(events, 10, 1)?.step).toBe(20);
  expect(nextFrom(events, 20, -1)?.step).toBe(10);
  expect([nextFrom(events, 40, 1), nextFrom(events, 10, -1)]).toEqual([undefined, undefined]);
});
