import { expect, test } from "vitest";
import { divideRoom, grains, type Batch } from "../src/stage/room_parts";
import { halved } from "../src/stage/page_array";

type Point = [number, number, number];
const between = (a: Point, b: Point): Point => [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2];
const long = (a: Point, b: Point): number => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);

// As the server cuts them: the longest edge is halved until all are short.
function cut(corners: [Point, Point, Point], into: [Point, Point, Point][]): void {
  const edges = [0, 1, 2].map((k) => long(corners[(k + 1) % 3]!, corners[k]!));
  const longest = edges.indexOf(Math.max(...edges));
  if (edges[longest]! <= 0.6) return void into.push(corners);
  const next = (longest + 1) % 3;
  const middle = between(corners[longest]!, corners[next]!);
  const [first, second] = [[...corners], [...corners]] as [[Point, Point, Point], [Point, Point, Point]];
  first[next] = second[longest] = middle;
  cut(first, into);
  cut(second, into);
}

// A floor of so many metres, as two triangles that are cut.
function floor(size: number): { source: Parameters<typeof divideRoom>[0]; batch: Batch } {
  const pieces: [Point, Point, Point][] = [];
  cut([[0, 0, 0], [size, 0, 0], [size, size, 0]], pieces);
  cut([[0, 0, 0], [size, size, 0], [0, size, 0]], pieces);
  const known = new Map<string, number>();
  const position: number[] = [];
  const index = pieces.flat().map((point) => {
    const found = known.get(point.join());
    if (found !== undefined) return found;
    position.push(...point);
    known.set(point.join(), position.length / 3 - 1);
    return position.length / 3 - 1;
  });
  const count = position.length / 3;
  const source = {
    position: new Float32Array(position),
    normal: new Int8Array(count * 4).map((_, i) => (i % 4 === 2 ? 127 : 0)),
    color: new Uint8Array(count * 4).fill(200),
    index: new Uint32Array(index),
    owner: new Uint16Array(count * 2).fill(65535).map((x, i) => (i % 2 === 0 ? 5 : x)),
  };
  return { source, batch: { first: 0, count: index.length, surface: 0, exact: false } };
}

const areaOf = (position: Float32Array, index: Uint32Array): number => {
  let area = 0;
  for (let i = 0; i < index.length; i += 3) {
    const [a, b, c] = [index[i]! * 3, index[i + 1]! * 3, index[i + 2]! * 3];
    area += ((position[b]! - position[a]!) * (position[c + 1]! - position[a + 1]!) - (position[c]! - position[a]!) * (position[b + 1]! - position[a + 1]!)) / 2;
  }
  return area;
};

test("what was cut for the light is joined again, and covers the same floor", async () => {
  const { source, batch } = floor(2.4);
  const { parts, indices } = await divideRoom(source, [batch]);
  expect(parts).toHaveLength(1);
  expect(indices).toHaveLength(grains.length);
  const triangles = indices.map((level) => level.length / 3);
  expect(triangles[0]).toBe(source.index.length / 3);
  expect(triangles[1]).toBeLessThanOrEqual(triangles[0]! / 4);
  expect(triangles[3]).toBe(2);
  for (const level of indices) expect(areaOf(source.position, level)).toBeCloseTo(2.4 ** 2, 4);
});

test("a floor that is too long stays in pieces", async () => {
  const { source, batch } = floor(9.6);
  const { indices } = await divideRoom(source, [batch]);
  expect(indices[3]!.length / 3).toBeGreaterThan(2);
  expect(areaOf(source.position, indices[3]!)).toBeCloseTo(9.6 ** 2, 3);
});

test("a smaller copy of a picture has the means of its pixels", () => {
  const picture = Uint8Array.from({ length: 4 * 2 * 4 }, (_, i) => i);
  const half = halved(picture, 4, 2);
  expect([...half]).toEqual([10, 11, 12, 13, 18, 19, 20, 21]);
  expect([...halved(half, 2, 1)]).toEqual([14, 15, 16, 17]);
});
