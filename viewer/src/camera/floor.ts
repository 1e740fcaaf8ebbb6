// What a walker runs into: upright boxes, turned about Z by any angle, and the outline of the room.
import type { Vec3 } from "./vector";

export interface Obstacle {
  readonly center: readonly [number, number];
  readonly half: readonly [number, number];
  readonly yaw: number;
}

export type Outline = readonly (readonly [number, number])[];

export const walkerRadius = 0.25;
const passes = 4; // corners between two boxes need more than one

interface Push {
  x: number;
  y: number;
}

function outOfBox(x: number, y: number, box: Obstacle, radius: number): Push | undefined {
  const cos = Math.cos(box.yaw);
  const sin = Math.sin(box.yaw);
  const dx = x - box.center[0];
  const dy = y - box.center[1];
  const u = cos * dx + sin * dy;
  const v = -sin * dx + cos * dy;
  const nearU = Math.min(Math.max(u, -box.half[0]), box.half[0]);
  const nearV = Math.min(Math.max(v, -box.half[1]), box.half[1]);
  let pushU = u - nearU;
  let pushV = v - nearV;
  const away = Math.hypot(pushU, pushV);
  if (away >= radius) return undefined;
  if (away > 1e-9) {
    pushU *= radius / away - 1;
    pushV *= radius / away - 1;
  } else {
    // The middle is inside: out by the nearest side.
    const roomU = box.half[0] - Math.abs(u) + radius;
    const roomV = box.half[1] - Math.abs(v) + radius;
    pushU = roomU <= roomV ? Math.sign(u || 1) * roomU : 0;
    pushV = roomU <= roomV ? 0 : Math.sign(v || 1) * roomV;
  }
  return { x: cos * pushU - sin * pushV, y: sin * pushU + cos * pushV };
}

export function isInside(x: number, y: number, outline: Outline): boolean {
  let inside = false;
  for (let i = 0, j = outline.length - 1; i < outline.length; j = i++) {
    const [ax, ay] = outline[i]!;
    const [bx, by] = outline[j]!;
    if (ay > y !== by > y && x < ((bx - ax) * (y - ay)) / (by - ay) + ax) inside = !inside;
  }
  return inside;
}

function outOfWall(x: number, y: number, outline: Outline, radius: number): Push | undefined {
  for (let i = 0; i < outline.length; i++) {
    const [ax, ay] = outline[i]!;
    const [bx, by] = outline[(i + 1) % outline.length]!;
    const long2 = (bx - ax) ** 2 + (by - ay) ** 2;
    const t = long2 > 0 ? Math.min(Math.max(((x - ax) * (bx - ax) + (y - ay) * (by - ay)) / long2, 0), 1) : 0;
    const dx = x - (ax + t * (bx - ax));
    const dy = y - (ay + t * (by - ay));
    const away = Math.hypot(dx, dy);
    if (away > 1e-9 && away < radius) return { x: dx * (radius / away - 1), y: dy * (radius / away - 1) };
  }
  return undefined;
}

// Where a walker at `from` comes to who wants to be at `to`: along what is in the way, never through it. The room's outline
// holds only who was inside before.
export function walked(from: Vec3, to: Vec3, obstacles: readonly Obstacle[], outline: Outline, radius = walkerRadius): Vec3 {
  let [x, y] = to;
  const held = isInside(from[0], from[1], outline);
  for (let pass = 0; pass < passes; pass++) {
    let pushed = false;
    for (const box of obstacles) {
      const push = outOfBox(x, y, box, radius);
      if (!push) continue;
      x += push.x;
      y += push.y;
      pushed = true;
    }
    const push = held ? outOfWall(x, y, outline, radius) : undefined;
    if (push) {
      x += push.x;
      y += push.y;
      pushed = true;
    }
    if (!pushed) return !held || isInside(x, y, outline) ? [x, y, to[2]] : [from[0], from[1], to[2]];
  }
  return [from[0], from[1], to[2]]; // no room there
}
