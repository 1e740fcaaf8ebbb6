// What a ray meets first: a product, or the room and its fixtures. Exact to the triangle (the packs' far meshes).
import type { Vec3 } from "../camera/vector";
import { rotated } from "./goods_light";
import { rotationOf, type GoodsTable, type Quaternion } from "./goods_table";
import type { MeshSet } from "./mesh_set";
import type { RoomArrays } from "./room";
import type { Sku } from "../store/contract";

export interface Ray {
  readonly from: Vec3;
  readonly way: Vec3; // unit
}

export interface Picked {
  readonly point: Vec3;
  readonly distance: number;
  readonly product?: number;
  readonly fixture?: number;
}

const none = 65535;

// Distance along the ray at which it enters the box, or Infinity.
export function enters(from: Vec3, way: Vec3, low: Vec3, high: Vec3): number {
  let near = 0;
  let far = Infinity;
  for (let k = 0; k < 3; k++) {
    const a = (low[k]! - from[k]!) / way[k]!;
    const b = (high[k]! - from[k]!) / way[k]!;
    if (Number.isNaN(a) || Number.isNaN(b)) continue; // along a face: inside it
    near = Math.max(near, Math.min(a, b));
    far = Math.min(far, Math.max(a, b));
  }
  return near <= far ? near : Infinity;
}

const edge = 1e-5; // share of a triangle by which it is taken wider: a ray along a common edge meets one of the two

// Moeller and Trumbore; both faces.
export function meets(from: Vec3, way: Vec3, p: Float32Array, a: number, b: number, c: number): number {
  const [ax, ay, az] = [p[a]!, p[a + 1]!, p[a + 2]!];
  const [ux, uy, uz] = [p[b]! - ax, p[b + 1]! - ay, p[b + 2]! - az];
  const [vx, vy, vz] = [p[c]! - ax, p[c + 1]! - ay, p[c + 2]! - az];
  const hx = way[1] * vz - way[2] * vy;
  const hy = way[2] * vx - way[0] * vz;
  const hz = way[0] * vy - way[1] * vx;
  const det = ux * hx + uy * hy + uz * hz;
  if (Math.abs(det) < 1e-14) return Infinity;
  const [sx, sy, sz] = [from[0] - ax, from[1] - ay, from[2] - az];
  const s = (sx * hx + sy * hy + sz * hz) / det;
  if (s < -edge || s > 1 + edge) return Infinity;
  const qx = sy * uz - sz * uy;
  const qy = sz * ux - sx * uz;
  const qz = sx * uy - sy * ux;
  const t = (way[0] * qx + way[1] * qy + way[2] * qz) / det;
  if (t < -edge || s + t > 1 + edge) return Infinity;
  const away = (vx * qx + vy * qy + vz * qz) / det;
  return away > 1e-6 ? away : Infinity;
}

export interface World {
  readonly table: GoodsTable;
  readonly skus: readonly Sku[];
  readonly meshes: MeshSet | undefined;
  readonly room: RoomArrays | undefined;
  readonly roomHidden: (triangle: number) => boolean; // first index of the triangle
}

export function pick(ray: Ray, world: World): Picked | undefined {
  const product = nearestProduct(ray, world);
  const room = nearestOfRoom(ray, world, product?.distance ?? Infinity);
  return room ?? product;
}

function nearestProduct(ray: Ray, world: World): Picked | undefined {
  const { table, skus } = world;
  let best = Infinity;
  let found = -1;
  for (const cell of table.cells) {
    if (enters(ray.from, ray.way, cell.low, cell.high) >= best) continue;
    for (let i = cell.first; i < cell.end; i++) {
      const row = table.order[i]!;
      const away = meetsProduct(ray, world, row, skus[table.sku[row]!]!.size_m, best);
      if (away >= best) continue;
      best = away;
      found = row;
    }
  }
  return found < 0 ? undefined : { point: along(ray, best), distance: best, product: found };
}

function meetsProduct(ray: Ray, { table, meshes }: World, row: number, size: Vec3, best: number): number {
  const position: Vec3 = [table.position[row * 3]!, table.position[row * 3 + 1]!, table.position[row * 3 + 2]!];
  const reach = Math.hypot(...size);
  const toward: Vec3 = [position[0] - ray.from[0], position[1] - ray.from[1], position[2] - ray.from[2]];
  const at = toward[0] * ray.way[0] + toward[1] * ray.way[1] + toward[2] * ray.way[2];
  if (at < -reach || at - reach > best) return Infinity;
  if (toward[0] ** 2 + toward[1] ** 2 + toward[2] ** 2 - at * at > reach * reach) return Infinity;

  const [x, y, z, w] = rotationOf(table, row);
  const back: Quaternion = [-x, -y, -z, w];
  const from = rotated(back, [-toward[0], -toward[1], -toward[2]]);
  const way = rotated(back, ray.way);
  const entered = enters(from, way, [-size[0] / 2, -size[1] / 2, 0], [size[0] / 2, size[1] / 2, size[2]]);
  if (entered >= best || !meshes) return entered;
  const range = meshes.range(table.sku[row]!);
  if (range.vertices === 0) return entered;
  let nearest = Infinity;
  for (let i = range.firstIndex; i < range.firstIndex + range.opaque + range.clear; i += 3) {
    const index = meshes.index;
    nearest = Math.min(nearest, meets(from, way, meshes.position, index[i]! * 3, index[i + 1]! * 3, index[i + 2]! * 3));
  }
  return nearest;
}

function nearestOfRoom(ray: Ray, world: World, best: number): Picked | undefined {
  const room = world.room;
  if (!room) return undefined;
  let found = -1;
  for (let i = 0; i < room.index.length; i += 3) {
    if (world.roomHidden(i)) continue;
    const away = meets(ray.from, ray.way, room.position, room.index[i]! * 3, room.index[i + 1]! * 3, room.index[i + 2]! * 3);
    if (away >= best) continue;
    best = away;
    found = i;
  }
  if (found < 0) return undefined;
  const fixture = room.owner[room.index[found]! * 2]!;
  return { point: along(ray, best), distance: best, ...(fixture !== none && { fixture }) };
}

function along(ray: Ray, away: number): Vec3 {
  return [ray.from[0] + ray.way[0] * away, ray.from[1] + ray.way[1] * away, ray.from[2] + ray.way[2] * away];
}

