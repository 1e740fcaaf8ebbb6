import { expect, test } from "vitest";
import { newShared, responseIn, setFilm } from "../src/stage/shading";

// Like the renderer's: light is taken in ever less the brighter it is, and encoded.
const curve = Float32Array.from({ length: 69 }, (_, i) => (1 - Math.exp(-1.6 * 2 ** (i / 4 - 13))) ** (1 / 2.2));
const seen = ([a, b, c]: readonly number[], x: number): number => x * (a! + x * (b! + x * c!));

// As the shaders look it up.
function lookedUp(table: Float32Array, light: number): number[] {
  const last = table.length / 3 - 1;
  const at = Math.min((Math.sqrt(light) * last) / 2, last - 1e-3);
  const low = Math.floor(at);
  return [0, 1, 2].map((k) => table[low * 3 + k]! + (table[low * 3 + 3 + k]! - table[low * 3 + k]!) * (at - low));
}

test("three greys become what the film makes of them", () => {
  const response = responseIn(curve, 1);
  const linear = (encoded: number): number => ((encoded + 0.055) / 1.055) ** 2.4;
  for (const grey of [0.3, 0.6, 0.95]) expect(seen(response, grey)).toBeCloseTo((1 - Math.exp(-1.6 * linear(grey))) ** (1 / 2.2), 2);
});

test("what shaders look up is the curve within a byte, in all light that the server sends", () => {
  const shared = newShared();
  setFilm(shared, curve);
  for (let byte = 0; byte <= 255; byte++) {
    const light = 4 * (byte / 255) ** 2;
    for (const x of [0.1, 0.5, 0.9]) expect(Math.abs(seen(lookedUp(shared.uResponse.value, light), x) - seen(responseIn(curve, light), x))).toBeLessThan(byte < 4 ? 8 / 255 : 1 / 255);
  }
});

test("a film curve of another length is refused", () => {
  expect(() => setFilm(newShared(), new Float32Array(10))).toThrow("film curve");
});
