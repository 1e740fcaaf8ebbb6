// Where everything is at any time of an episode: the robot's bodies at every control step, in pieces as they come; all else as it
// moved. Between two steps things are in between, at a step exactly where the recording has them.
import type { Packed } from "../store/packed";
import type { MotionHead } from "./contract";

export type Quaternion = [number, number, number, number]; // x y z w
export interface Place {
  readonly position: [number, number, number];
  readonly rotation: Quaternion;
}

export const pieceSteps = 1200; // steps that are loaded at a time

// Where bodies are at a step.
export interface BodyPlaces {
  // Asks for what is there at a step and soon after, unless it is there.
  want(step: number): void;
  // Undefined: it has not come yet.
  at(step: number, body: number): Place | undefined;
}

// Where all else is.
export interface ThingPlaces {
  readonly joints: ArrayLike<number>; // rows of the place's joints
  at(thing: number, step: number): Place;
  jointAt(row: number, step: number): number; // of the joint in that row of `joints`
}

export interface Rows {
  readonly position: Float32Array;
  readonly rotation: Int16Array;
}

export function placeAt({ position, rotation }: Rows, row: number): Place {
  const [p, r] = [row * 3, row * 4];
  return {
    position: [position[p]!, position[p + 1]!, position[p + 2]!],
    rotation: [rotation[r]! / 32767, rotation[r + 1]! / 32767, rotation[r + 2]! / 32767, rotation[r + 3]! / 32767],
  };
}

export function between(a: Place, b: Place, share: number): Place {
  if (share <= 0) return a;
  if (share >= 1) return b;
  const [p, q] = [a.rotation, b.rotation];
  const toward = p[0] * q[0] + p[1] * q[1] + p[2] * q[2] + p[3] * q[3] < 0 ? -1 : 1;
  const turn = p.map((x, i) => x * (1 - share) + toward * q[i]! * share) as Quaternion;
  const size = Math.hypot(...turn) || 1;
  return {
    position: a.position.map((x, i) => x + (b.position[i]! - x) * share) as Place["position"],
    rotation: turn.map((x) => x / size) as Quaternion,
  };
}

export class BodyTracks implements BodyPlaces {
  private readonly pieces = new Map<number, Rows | "asked">();

  // `load`: steps from `first` on, as many as there are up to `count`.
  constructor(
    private readonly bodies: number,
    private readonly steps: number,
    private readonly load: (first: number, count: number) => Promise<Packed<MotionHead>>,
    private readonly came: (error?: unknown) => void,
  ) {}

  want(step: number): void {
    const piece = Math.floor(step / pieceSteps);
    for (const wanted of [piece, piece + 1]) {
      if (wanted * pieceSteps >= this.steps || this.pieces.has(wanted)) continue;
      this.pieces.set(wanted, "asked");
      void this.bring(wanted);
    }
  }

  at(step: number, body: number): Place | undefined {
    const low = Math.floor(step);
    const before = this.exactly(low, body);
    const share = step - low;
    if (!before || share === 0) return before;
    const after = this.exactly(Math.min(low + 1, this.steps - 1), body);
    return after && between(before, after, share);
  }

  private exactly(step: number, body: number): Place | undefined {
    const piece = this.pieces.get(Math.floor(step / pieceSteps));
    return piece && piece !== "asked" ? placeAt(piece, (step % pieceSteps) * this.bodies + body) : undefined;
  }

  private async bring(piece: number): Promise<void> {
    try {
      const packed = await this.load(piece * pieceSteps, pieceSteps);
      this.pieces.set(piece, { position: packed.f32("position", 3), rotation: packed.i16("rotation", 4) });
      this.came();
    } catch (error) {
      this.pieces.delete(piece);
      this.came(error);
    }
  }
}

// The last of ascending steps that is not after `step`; -1: none.
export function rowAt(steps: Uint32Array, first: number, count: number, step: number): number {
  let [low, high] = [0, count];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (steps[first + middle]! <= step) low = middle + 1;
    else high = middle;
  }
  return low - 1;
}

export class ThingTracks implements ThingPlaces {
  private readonly range: Uint32Array;
  private readonly step: Uint32Array;
  private readonly rows: Rows;
  readonly joints: Uint32Array;
  private readonly jointRange: Uint32Array;
  private readonly jointStep: Uint32Array;
  private readonly jointPosition: Float32Array;

  constructor(packed: Packed<unknown>) {
    this.range = packed.u32("range", 2);
    this.step = packed.u32("step", 1);
    this.rows = { position: packed.f32("position", 3), rotation: packed.i16("rotation", 4) };
    this.joints = packed.u32("joint", 1);
    this.jointRange = packed.u32("joint_range", 2);
    this.jointStep = packed.u32("joint_step", 1);
    this.jointPosition = packed.f32("joint_position", 1);
  }

  get count(): number {
    return this.range.length / 2;
  }

  // Before its first row it stood where that has it. It stands still between two rows, but for the step before the later one.
  at(thing: number, step: number): Place {
    const [first, count] = [this.range[thing * 2]!, this.range[thing * 2 + 1]!];
    const row = Math.max(rowAt(this.step, first, count, step), 0);
    const now = placeAt(this.rows, first + row);
    if (row + 1 >= count) return now;
    const share = step - (this.step[first + row + 1]! - 1);
    return share > 0 ? between(now, placeAt(this.rows, first + row + 1), share) : now;
  }

  jointAt(row: number, step: number): number {
    const [first, count] = [this.jointRange[row * 2]!, this.jointRange[row * 2 + 1]!];
    return this.jointPosition[first + Math.max(rowAt(this.jointStep, first, count, step), 0)]!;
  }
}
