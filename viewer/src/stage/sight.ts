// What can be seen from the eye: inside the picture, and not behind a shelf that is higher than what is looked for.
import { Box3, Frustum, Matrix4, Vector3, type PerspectiveCamera } from "three";
import type { Vec3 } from "../camera/vector";
import type { Fixture } from "../store/contract";

// A shelf's back panel as an upright rectangle over the floor.
interface Screen {
  readonly fixture: number;
  readonly from: readonly [number, number];
  readonly to: readonly [number, number];
  readonly top: number;
}

const backed = new Set(["gondola", "wall_unit", "multideck", "peg_wall", "wine_rack", "glass_door_cooler"]);
const usualFov = 55; // degrees
const lowest = 1.2; // metres: lower ones hide nothing worth it
const within = 0.96; // share of a panel's size that is taken for sure

export function screensOf(fixtures: readonly Fixture[]): Screen[] {
  return fixtures
    .filter(({ generator, size_m, position_m }) => backed.has(generator) && size_m[2] >= lowest && position_m[2] < 0.1)
    .map(({ row, position_m, yaw_deg, size_m }) => {
      const yaw = (yaw_deg * Math.PI) / 180;
      const [dx, dy] = [(Math.cos(yaw) * size_m[0]) / 2, (Math.sin(yaw) * size_m[0]) / 2];
      const [x, y] = position_m;
      return { fixture: row, from: [x - dx, y - dy], to: [x + dx, y + dy], top: size_m[2] * within };
    });
}

export class Sight {
  readonly eye = new Vector3();
  private zoom = 1; // what looks as near as it would with the usual angle
  private readonly frustum = new Frustum();
  private readonly box = new Box3();
  private near: readonly Screen[] = [];

  constructor(private readonly screens: readonly Screen[]) {}

  look(camera: PerspectiveCamera): void {
    this.eye.copy(camera.position);
    this.zoom = Math.tan((camera.fov * Math.PI) / 360) / Math.tan((usualFov * Math.PI) / 360);
    this.frustum.setFromProjectionMatrix(new Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse));
    // Who looks down over the shelves sees behind them.
    this.near = this.screens.filter(({ top }) => top > this.eye.z - 0.6);
  }

  // How far off it looks: a narrow angle brings it nearer.
  distance(low: Vec3, high: Vec3): number {
    this.box.min.set(...low);
    this.box.max.set(...high);
    return this.box.distanceToPoint(this.eye) * this.zoom;
  }

  // `fixture`: whose part it is; its own back does not hide it. -1: of the shell, of which some may be seen where no corner is.
  sees(low: Vec3, high: Vec3, fixture: number): boolean {
    this.box.min.set(...low);
    this.box.max.set(...high);
    if (!this.frustum.intersectsBox(this.box)) return false;
    if (fixture < 0 || this.near.length === 0 || this.box.containsPoint(this.eye)) return true;
    for (const x of [low[0], high[0]]) {
      for (const y of [low[1], high[1]]) if (!this.isHidden(x, y, high[2], fixture)) return true;
    }
    return !this.isHidden((low[0] + high[0]) / 2, (low[1] + high[1]) / 2, high[2], fixture);
  }

  private isHidden(x: number, y: number, z: number, fixture: number): boolean {
    const { eye } = this;
    for (const { fixture: own, from, to, top } of this.near) {
      if (own === fixture) continue;
      // Where the way from the eye to the point crosses the panel, seen from above.
      const [ex, ey, px, py] = [x - eye.x, y - eye.y, to[0] - from[0], to[1] - from[1]];
      const det = ex * py - ey * px;
      if (Math.abs(det) < 1e-9) continue;
      const [ax, ay] = [from[0] - eye.x, from[1] - eye.y];
      const along = (ax * py - ay * px) / det;
      const across = (ax * ey - ay * ex) / det;
      if (along <= 0.01 || along >= 0.99 || across < 0 || across > 1) continue;
      if (eye.z + (z - eye.z) * along < top) return true;
    }
    return false;
  }
}
