import { expect, test } from "vitest";
import type { Cut, EditLine } from "../src/edit/contract";
import { lineOf, ratioAt } from "../src/edit/cuts";
import { editedGoods, editedGoodsLight, editedRoom, none, rowsBefore } from "../src/edit/delta";
import { NearLight, wayOf } from "../src/edit/light";
import { pinsOf, rounded, shifted, unpinned } from "../src/edit/runs";
import { lineText } from "../src/edit/steps";
import { byShelf, swapOf, type RunBlock } from "../src/edit/block_swap";
import { EditClient } from "../src/edit/client";
import { MemorySections } from "../src/store/packed";
import type { Speech } from "../src/ui/speech";
import { filled, texts } from "../src/text/strings";

const opened = {
  count: 3,
  position: Float32Array.from([0, 0, 0, 1, 0, 0, 2, 0, 0]),
  rotation: new Int16Array(12),
  sku: Uint16Array.from([0, 1, 1]),
  fixture: Uint16Array.from([0, 0, 1]),
  shelf: Uint16Array.from([0, 1, 2]),
  facing: Uint32Array.from([0, 1, none]),
  tint: new Uint8Array(9).fill(200),
};

function edit(runs: number[], fresh: number): MemorySections {
  return new MemorySections({
    runs: Uint32Array.from(runs),
    facing_rows: Uint32Array.from([5, 6]),
    shelf_rows: Uint32Array.from([10, 11, 12]),
    fixture_rows: Uint16Array.from([3, 65535]),
    goods_position: new Float32Array(fresh * 3).fill(9),
    goods_rotation: new Int16Array(fresh * 4),
    goods_sku: new Uint16Array(fresh).fill(7),
    goods_fixture: new Uint16Array(fresh).fill(4),
    goods_shelf: new Uint16Array(fresh).fill(20),
    goods_facing: new Uint32Array(fresh).fill(30),
    goods_tint: new Uint8Array(fresh * 3).fill(100),
  });
}

test("goods of an edit are rows of the opened store under new numbers, and rows that are new", () => {
  const { goods, from } = editedGoods(opened, edit([1, 1, none, 2, 0, 1], 2));
  expect([...from]).toEqual([1, none, none, 0]);
  expect([...goods.f32("position", 3)]).toEqual([1, 0, 0, 9, 9, 9, 9, 9, 9, 0, 0, 0]);
  expect([...goods.u16("sku", 1)]).toEqual([1, 7, 7, 0]);
  expect([...goods.u16("fixture", 1)]).toEqual([3, 4, 4, 3]);
  expect([...goods.u16("shelf", 1)]).toEqual([11, 20, 20, 10]);
  expect([...goods.u32("facing", 1)]).toEqual([6, 30, 30, 5]);
  expect([...opened.shelf]).toEqual([0, 1, 2]); // the opened store stays as it is
});

test("an edit that names rows beyond the opened store is refused", () => {
  expect(() => editedGoods(opened, edit([2, 2], 0))).toThrow(/rows that the store does not have/);
});

test("what stays keeps its light, what is new has that of its place", () => {
  const light = new Uint8Array(3 * 18).map((_, i) => 10 * (1 + Math.floor(i / 18)));
  const near = new NearLight(1, 18);
  for (let row = 0; row < 3; row++) near.add(row, 0, 0, 0, light, row * 18);
  const out = editedGoodsLight(light, near, Float32Array.from([1, 0, 0, 2.1, 0.1, 0, 60, 60, 0]), Uint32Array.from([1, none, none]));
  expect([out[0], out[18], out[36]]).toEqual([20, 30, 20]); // far off: the mean of all
});

test("light does not mix surfaces that look other ways", () => {
  const near = new NearLight(6, 3);
  near.add(0, 0, 0, wayOf(0, 0, 127), Uint8Array.from([100, 100, 100]), 0);
  near.add(0, 0, 0, wayOf(0, -127, 0), Uint8Array.from([20, 20, 20]), 0);
  const out = new Uint8Array(3);
  near.read(0.6, 0, 0, wayOf(0, -120, 10), out, 0);
  expect([...out]).toEqual([20, 20, 20]);
});

test("a shape stands at each of its places, turned", () => {
  const near = new NearLight(6, 3);
  for (let way = 0; way < 6; way++) near.add(0, 0, 0, way, Uint8Array.from([50, 60, 70]), 0);
  const room = editedRoom(
    new MemorySections({
      position: Float32Array.from([1, 0, 0, 1, 0, 1, 2, 0, 0]),
      normal: Int8Array.from([0, -127, 0, 0, 0, -127, 0, 0, 0, -127, 0, 0]),
      color: new Uint8Array(12).fill(255),
      light: Uint8Array.from([0, 0, 0, 0, 200, 200, 200, 0, 0, 0, 0, 0]),
      finish: new Uint8Array(12),
      index: Uint32Array.from([0, 1, 2, 0, 2, 1]),
      shapes: Uint32Array.from([0, 3, 0, 3, 3]),
      places: Uint32Array.from([0, 8, 0, 9]),
      place_at: Float32Array.from([0, 0, 0, 10, 0, 0]),
      place_turns: Uint8Array.from([0, 1]),
    }),
    near,
  )!;
  expect([...room.f32("position", 3).subarray(9, 12)]).toEqual([10, 1, 0]);
  expect([...room.i8("normal", 4).subarray(12, 14)]).toEqual([127, 0]);
  expect([...room.u16("owner", 2).subarray(0, 2), ...room.u16("owner", 2).subarray(6, 8)]).toEqual([8, 65535, 9, 65535]);
  expect([...room.u8("light", 4).subarray(0, 3), room.u8("light", 4)[4]]).toEqual([50, 60, 70, 200]); // lamps have their own
  expect([...room.u32("index", 1)]).toEqual([0, 1, 2, 3, 4, 5, 0, 2, 1, 3, 5, 4]);
  expect(room.head.batches.map(({ layer, first_index, index_count }) => [layer, first_index, index_count])).toEqual([
    ["solid", 0, 6],
    ["glass", 6, 6],
  ]);
});

test("rows that were shown before are those of the same row of the opened store", () => {
  const from = Uint32Array.from([1, none, 0]);
  expect([...rowsBefore(from, undefined, 3)]).toEqual([1, none, 0]);
  expect([...rowsBefore(from, Uint32Array.from([none, 2, 1]), 3)]).toEqual([2, none, none]);
});

const run = { id: "dairy/run-1", zone: "dairy", fixture: "dairy/run-1/module-1", at_mm: [3000, 4000], rect_mm: [2500, 3500, 6000, 4500], pinned: true } as const;

test("a run that is carried is pinned where it is put down, and set free again", () => {
  expect(rounded({ x: 123, y: -6 })).toEqual({ x: 120, y: -10 });
  expect(shifted(run.rect_mm, { x: 120, y: -10 })).toEqual([2620, 3490, 6120, 4490]);
  expect(pinsOf(run, { x: 120, y: 0 })).toEqual([{ set_override: { fixture: run.fixture, field: "x_mm", value: "3120" } }]);
  expect(pinsOf(run, { x: 0, y: 0 })).toEqual([]);
  const places = [
    { fixture: run.fixture, field: "y_mm", value: "1" },
    { fixture: "snacks/run-1/module-1", field: "x_mm", value: "2" },
  ];
  expect(unpinned({ places, runs: [run] }, "dairy")).toEqual([{ set_override: { fixture: run.fixture, field: "y_mm" } }]);
});

const cut: Cut = { node: "back", split: "x", ratio: 0.5, gap_mm: 2000, rect_mm: [1000, 0, 13000, 8000] };

test("a border lies in the middle of its gap, and is where it was dragged to", () => {
  expect(lineOf(cut, 0.5)).toEqual({ x1: 7000, y1: 0, x2: 7000, y2: 8000 });
  expect(lineOf({ ...cut, split: "y" }, 0.5)).toEqual({ x1: 1000, y1: 4000, x2: 13000, y2: 4000 });
  for (const ratio of [0.1, 0.3333, 0.9]) expect(ratioAt(cut, lineOf(cut, ratio).x1, 0)).toBeCloseTo(ratio, 4);
  expect([ratioAt(cut, -5000, 0), ratioAt(cut, 99_000, 0)]).toEqual([0.08, 0.92]);
});

test("steps are read as sentences, in the words that were said where there are some", () => {
  const speech = { say: (key: keyof typeof texts.en, values = {}) => filled(texts.en[key], values), number: (value: number, digits = 0) => value.toFixed(digits) } as unknown as Speech;
  const line = (patches: object[], words = ""): EditLine => ({ words, patches, lost: [] }) as unknown as EditLine;
  expect(lineText(line([{ set_ratio: { node: "back", ratio: 0.562 } }, { swap_leaves: { a: "dairy", b: "bakery" } }]), speech)).toBe("border back at 56.2 %; dairy ⇄ bakery");
  expect(lineText(line([{ set_fixture: { zone: "drinks", levels: 6 } }]), speech)).toBe("drinks: Levels 6");
  expect(lineText(line([{ set_override: { fixture: run.fixture, field: "x_mm", value: "3120" } }, { set_override: { fixture: run.fixture, field: "y_mm" } }]), speech)).toBe(
    "dairy/run-1/module-1: X mm 3120; dairy/run-1/module-1: Y mm as usual",
  );
  expect(lineText(line([{ drop_zone: { zone: "wine" } }], "no alcohol"), speech)).toBe("no alcohol");
});

test("the server's rows of an edit are those of the page, and new SKUs are asked of the edit", () => {
  const client = new EditClient(2, null);
  expect(client.address("/products/5")).toBe("api/stores/2/products/5");
  client.setRows({ skuOfServer: Uint32Array.from([1, 3]), serverOfNew: [44], pageSkus: 3, jointOfServer: new Uint32Array(0) });
  expect(client.address("/products/5")).toBe("api/stores/2/edit/products/5");
  expect(client.address("/skus/2/label.png?px=512")).toBe("api/stores/2/skus/2/label.png?px=512");
  expect(client.address("/skus/3/label.png?px=512")).toBe("api/stores/2/edit/skus/44/label.png?px=512");
});

const block = (facing: number, shelf: number, position: number, fixture = "snacks/run-1/module-1"): RunBlock => ({ facing, fixture, side: "front", shelf, position, sku: `sku-${facing}`, facings: 2, products: 4 });

test("two blocks are named by where they stand, and by what stands there", () => {
  const [a, b] = [block(7, 2, 1), block(9, 3, 4)];
  const place = { fixture: "snacks/run-1/module-1", side: "front" };
  const to = { ...place, shelf: 3, position: 4, sku: "sku-9" };
  expect(swapOf(a, b)).toEqual({ swap_blocks: { a: { ...place, shelf: 2, position: 1, sku: "sku-7" }, b: to } });
  expect(swapOf(a, b, 3)).toEqual({ swap_blocks: { a: { ...place, shelf: 2, position: 1, sku: "sku-7", facings: 3 }, b: to } });
});

test("blocks are listed shelf by shelf, from above, modules from the left", () => {
  const blocks = [block(1, 1, 1), block(2, 3, 1, "snacks/run-1/module-10"), block(3, 3, 1, "snacks/run-1/module-2"), block(4, 3, 2, "snacks/run-1/module-2")];
  expect(byShelf(blocks).map(([name, all]) => [name, all.map(({ facing }) => facing)])).toEqual([
    ["snacks/run-1/module-2 · 3", [3, 4]],
    ["snacks/run-1/module-10 · 3", [2]],
    ["snacks/run-1/module-1 · 1", [1]],
  ]);
});
