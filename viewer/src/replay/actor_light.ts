// The light on what moves: an ambient cube, taken from the room's stored light about a point.
export type Cube = Float32Array; // +x -x +y -y +z -z, RGB, each sqrt(light / 4) as the server's bytes / 255

interface LitCorners {
  readonly position: ArrayLike<number>;
  readonly normal: ArrayLike<number>; // 4 a corner, x y z of any length
  readonly light: ArrayLike<number>; // 4 a corner, bytes
}

// A room without light, as goods have it before theirs has come.
export const plainCube: Cube = Float32Array.from({ length: 18 }, (_, i) => (i < 12 ? 0.42 : i < 15 ? 0.47 : 0.36));
const soft = 0.3; // square metres: what is nearer counts no more
const within = 5; // metres

export function cubeAt(corners: LitCorners, [x, y, z]: readonly [number, number, number]): Cube {
  const { position, normal, light } = corners;
  const sum = new Float64Array(18);
  const weights = new Float64Array(6);
  for (let v = 0; v * 3 < position.length; v++) {
    const away = (position[v * 3]! - x) ** 2 + (position[v * 3 + 1]! - y) ** 2 + (position[v * 3 + 2]! - z) ** 2;
    if (away > within * within) continue;
    const weight = 1 / (soft + away) ** 2;
    for (let axis = 0; axis < 3; axis++) {
      const along = normal[v * 4 + axis]! / 127;
      const face = axis * 2 + (along >= 0 ? 0 : 1);
      const share = weight * along * along;
      weights[face]! += share;
      for (let k = 0; k < 3; k++) sum[face * 3 + k]! += share * (light[v * 4 + k]! / 255) ** 2;
    }
  }
  return Float32Array.from(sum, (value, i) => {
    const weight = weights[Math.floor(i / 3)]!;
    return weight > 1e-6 ? Math.sqrt(value / weight) : plainCube[i]!;
  });
}
