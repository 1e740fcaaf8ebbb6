// Doors, lids and drawers of the room: the corners of what a joint carries, moved from where they are at position 0.
import type { Joint } from "../store/contract";
import { rotated } from "./goods_light";
import type { Quaternion } from "./goods_table";

type Point = [number, number, number];

const shortest = 0.005; // metres or radians: less is not seen
const longest = 4 * Math.PI; // wheels turn as far as they like

export class MovingParts {
  readonly positions: Float64Array; // by joint
  private readonly corners = new Map<number, Uint32Array>(); // vertices by the joint that carries them
  private readonly rest = new Map<number, Float32Array>(); // where they are at position 0

  // `owner`: fixture and joint of every vertex. `position` is what is moved.
  constructor(
    private readonly joints: readonly Joint[],
    owner: Uint16Array,
    private readonly position: Float32Array,
  ) {
    this.positions = new Float64Array(joints.length);
    const found = new Map<number, number[]>();
    for (let vertex = 0; vertex * 2 < owner.length; vertex++) {
      const joint = owner[vertex * 2 + 1]!;
      if (joint >= joints.length) continue;
      const known = found.get(joint);
      if (known) known.push(vertex);
      else found.set(joint, [vertex]);
    }
    for (const [joint, vertices] of found) {
      this.corners.set(joint, Uint32Array.from(vertices));
      this.rest.set(joint, Float32Array.from(vertices.flatMap((v) => [position[v * 3]!, position[v * 3 + 1]!, position[v * 3 + 2]!])));
    }
  }

  // Whether moving it by hand shows anything.
  canMove(joint: number): boolean {
    const { kind, lower, upper } = this.joints[joint]!;
    const span = upper - lower;
    return kind !== "belt" && span >= shortest && span <= longest && this.carried(joint).length > 0;
  }

  // Brings it there, within its limits. The joints whose corners have moved: it and what it carries.
  move(joint: number, to: number): readonly number[] {
    const { lower, upper } = this.joints[joint]!;
    this.positions[joint] = Math.min(Math.max(to, lower), upper);
    const moved = this.carried(joint);
    for (const each of moved) this.place(each);
    return moved;
  }

  private carried(joint: number): number[] {
    return [...this.corners.keys()].filter((each) => {
      let at = each;
      while (at !== joint && at >= 0) at = this.joints[at]!.parent;
      return at === joint;
    });
  }

  private place(joint: number): void {
    const rest = this.rest.get(joint)!;
    this.corners.get(joint)!.forEach((vertex, i) => {
      let at: Point = [rest[i * 3]!, rest[i * 3 + 1]!, rest[i * 3 + 2]!];
      for (let each = joint; each >= 0; each = this.joints[each]!.parent) at = displaced(this.joints[each]!, this.positions[each]!, at);
      this.position.set(at, vertex * 3);
    });
  }
}

function displaced({ kind, origin_m: [ox, oy, oz], axis }: Joint, by: number, [x, y, z]: Point): Point {
  if (kind !== "hinge") return [x + axis[0] * by, y + axis[1] * by, z + axis[2] * by];
  const s = Math.sin(by / 2);
  const turn: Quaternion = [axis[0] * s, axis[1] * s, axis[2] * s, Math.cos(by / 2)];
  const [tx, ty, tz] = rotated(turn, [x - ox, y - oy, z - oz]);
  return [tx + ox, ty + oy, tz + oz];
}
