import { expect, test } from "vitest";
import { Packed } from "../src/store/packed";

function container(head: object, data: Uint8Array): ArrayBuffer {
  let text = JSON.stringify(head);
  while ((8 + text.length) % 8 !== 0) text += " ";
  const bytes = new Uint8Array(8 + text.length + data.length);
  bytes.set(new TextEncoder().encode("MGV1"));
  new DataView(bytes.buffer).setUint32(4, text.length, true);
  bytes.set(new TextEncoder().encode(text), 8);
  bytes.set(data, 8 + text.length);
  return bytes.buffer;
}

const sections = { a: { type: "f32", components: 3, count: 1, offset: 0 }, b: { type: "u16", components: 1, count: 2, offset: 16 } };
const data = new Uint8Array(20);
new Float32Array(data.buffer, 0, 3).set([1, 2, 3]);
data.set([7, 0, 8, 0], 16);

test("arrays are found by name", () => {
  const packed = new Packed<{ products: number }>(container({ sections, products: 5 }, data), "goods.bin");
  expect(packed.head.products).toBe(5);
  expect([...packed.f32("a", 3)]).toEqual([1, 2, 3]);
  expect([...packed.u16("b", 1)]).toEqual([7, 8]);
});

test("what is not as promised is refused, by name", () => {
  expect(() => new Packed(new ArrayBuffer(4), "goods.bin")).toThrow("goods.bin is not MGV1");
  expect(() => new Packed(container({}, data), "goods.bin")).toThrow("no sections");
  const packed = new Packed(container({ sections: { a: { ...sections.a, count: 900 } } }, data), "goods.bin");
  expect(() => packed.f32("a", 3)).toThrow("a is cut off");
  expect(() => packed.f32("c", 3)).toThrow("no section c");
  expect(() => packed.u16("a", 3)).toThrow("no section a of u16");
});
