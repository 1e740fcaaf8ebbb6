// The light on what moves: an ambient cube, taken from the room's stored light about a point.
export type Cube = Float32Array; // +x -x +y -y +z -z, RGB, each sqrt(light / 4) as the server's bytes / 255
type Point = readonly [number, number, number];

export interface LitCorners {
  readonly position: ArrayLike<number>;
  readonly normal: ArrayLike<number>; // 4 a corner, x y z in 127ths
  readonly light: ArrayLike<number>; // 4 a corner, bytes
}

// A room without light, as goods have it before theirs has come.
export const plainCube: Cube = Float32Array.from({ length: 18 }, (_, i) => (i < 12 ? 0.42 : i < 15 ? 0.47 : 0.36));
const cellSize = 1; // metres
const reach = 3; // cells
const soft = 0.3; // square metres: what is nearer counts no more
const faces = 6;

// What the corners of a cubic metre throw back, by the way they face.
interface LitCell {
  readonly sum: Float64Array; // 18: light times weight
  readonly weights: Float64Array; // 6
  readonly middle: Float64Array; // 3: sum of places
  corners: number;
}

const cellOf = (x: number): number => Math.floor(x / cellSize);
const keyOf = (x: number, y: number, z: number): number => (x + 512) * 1048576 + (y + 512) * 1024 + (z + 512);

export class RoomLight {
  private readonly cells = new Map<number, LitCell>();

  constructor(corners: LitCorners) {
    const { position } = corners;
    for (let v = 0; v * 3 < position.length; v++) this.add(corners, v);
  }

  cubeAt([x, y, z]: Point): Cube {
    const sum = new Float64Array(18);
    const weights = new Float64Array(faces);
    for (const cell of this.near(x, y, z)) {
      const [mx, my, mz] = cell.middle;
      const n = cell.corners;
      const weight = 1 / (soft + (mx! / n - x) ** 2 + (my! / n - y) ** 2 + (mz! / n - z) ** 2) ** 2;
      for (let face = 0; face < faces; face++) weights[face]! += cell.weights[face]! * weight;
      for (let i = 0; i < 18; i++) sum[i]! += cell.sum[i]! * weight;
    }
    return Float32Array.from(sum, (value, i) => {
      const weight = weights[Math.floor(i / 3)]!;
      return weight > 1e-9 ? Math.sqrt(value / weight) : plainCube[i]!;
    });
  }

  private *near(x: number, y: number, z: number): Generator<LitCell> {
    const [cx, cy, cz] = [cellOf(x), cellOf(y), cellOf(z)];
    for (let i = cx - reach; i <= cx + reach; i++) {
      for (let j = cy - reach; j <= cy + reach; j++) {
        for (let k = cz - reach; k <= cz + reach; k++) {
          const cell = this.cells.get(keyOf(i, j, k));
          if (cell) yield cell;
        }
      }
    }
  }

  private add({ position, normal, light }: LitCorners, v: number): void {
    const [x, y, z] = [position[v * 3]!, position[v * 3 + 1]!, position[v * 3 + 2]!];
    const key = keyOf(cellOf(x), cellOf(y), cellOf(z));
    let cell = this.cells.get(key);
    if (!cell) this.cells.set(key, (cell = { sum: new Float64Array(18), weights: new Float64Array(faces), middle: new Float64Array(3), corners: 0 }));
    cell.corners++;
    cell.middle[0]! += x;
    cell.middle[1]! += y;
    cell.middle[2]! += z;
    for (let axis = 0; axis < 3; axis++) {
      const along = normal[v * 4 + axis]! / 127;
      const face = axis * 2 + (along >= 0 ? 0 : 1);
      cell.weights[face]! += along * along;
      for (let k = 0; k < 3; k++) cell.sum[face * 3 + k]! += along * along * (light[v * 4 + k]! / 255) ** 2;
    }
  }
}
