// The stored light at every product: an ambient cube of six colours, as bytes whose square is the light.
import type { Quaternion } from "./goods_table";

export interface GoodsLight {
  readonly cube: Uint8Array; // 18 a product: +x -x +y -y +z -z of the store frame, RGB
}

export function rotated([x, y, z, w]: Quaternion, v: readonly [number, number, number]): [number, number, number] {
  const tx = 2 * (y * v[2] - z * v[1]);
  const ty = 2 * (z * v[0] - x * v[2]);
  const tz = 2 * (x * v[1] - y * v[0]);
  return [v[0] + w * tx + y * tz - z * ty, v[1] + w * ty + z * tx - x * tz, v[2] + w * tz + x * ty - y * tx];
}

// The cube's light on a surface with the normal (x, y, z) of the store frame, again as bytes: three of them from `out[o]`.
export function lightOn(light: GoodsLight, row: number, x: number, y: number, z: number, out: Uint8Array, o: number): void {
  const base = row * 18;
  const ax = base + (x >= 0 ? 0 : 3);
  const ay = base + (y >= 0 ? 6 : 9);
  const az = base + (z >= 0 ? 12 : 15);
  const cube = light.cube;
  for (let k = 0; k < 3; k++) {
    const fx = cube[ax + k]!;
    const fy = cube[ay + k]!;
    const fz = cube[az + k]!;
    out[o + k] = Math.sqrt(x * x * fx * fx + y * y * fy * fy + z * z * fz * fz);
  }
}
