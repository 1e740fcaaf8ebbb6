// The camera as the hands move it. Knows nothing of the page: input comes as pixels dragged, factors and keys held.
import { walked, type Obstacle, type Outline } from "./floor";
import type { Mode } from "./modes";
import { ahead, between, direction, flightSeconds, lookingAt, maxPitch, turned, type Pose } from "./pose";
import { add, clamp, distance, scale, sub, type Vec3 } from "./vector";

// What is held down, each -1, 0 or 1.
export interface Held {
  readonly forward: number;
  readonly right: number;
  readonly up: number;
  readonly turn: number; // left is positive
  readonly tilt: number;
  readonly fast: boolean;
}

export interface Room {
  readonly low: Vec3;
  readonly high: Vec3;
  readonly outline: Outline;
  readonly obstacles: readonly Obstacle[];
}

export const topFov = 14; // degrees: from above, nearly a plan
export const eyeHeight = 1.62;
const walkSpeed = 1.7; // m/s, a brisk shopper
const flySpeed = 3;
const fastFactor = 2.5;
const turnSpeed = 1.6; // rad/s
const settle = 12; // 1/s: how quickly a held key's speed is reached
const lookPerPixel = 0.0042;
const nearestAround = 0.12;
const farthest = 7; // times the room's diagonal

interface Flight {
  readonly from: Pose;
  readonly to: Pose;
  readonly around: number;
  readonly seconds: number;
  gone: number;
}

export class Navigator {
  pose: Pose;
  around: number; // metres to what orbit turns about
  private flight: Flight | undefined;
  private velocity: Vec3 = [0, 0, 0];

  constructor(
    public room: Room,
    public mode: Mode,
    pose: Pose,
    around: number,
  ) {
    this.pose = pose;
    this.around = around;
  }

  get target(): Vec3 {
    return ahead(this.pose, this.around);
  }

  get flying(): boolean {
    return this.flight !== undefined;
  }

  get moving(): boolean {
    return this.flying || distance(this.velocity, [0, 0, 0]) > 1e-3;
  }

  // Changes the way of moving; the eye goes where that way of moving can be.
  enter(mode: Mode, still = false): void {
    if (mode === this.mode) return;
    const from = this.mode;
    this.mode = mode;
    this.velocity = [0, 0, 0];
    if (mode === "top") this.lookDown(still);
    else if (mode === "walk") this.stand(from, still);
    else if (mode === "orbit") this.aroundWhatIsSeen(from, still);
  }

  goTo(pose: Pose, around: number, still = false): void {
    this.velocity = [0, 0, 0];
    this.flight = { from: this.pose, to: pose, around, seconds: still ? 0 : flightSeconds(this.pose, pose), gone: 0 };
    if (still) this.fly(0);
  }

  // Pixels dragged over a picture `height` pixels high, with the angle `fov` from its top to its bottom.
  drag(dx: number, dy: number, height: number, fov: number, pan: boolean): void {
    this.flight = undefined;
    if (pan || this.mode === "top") this.pan(dx, dy, (2 * Math.tan(fov / 2) * this.reach()) / height);
    else if (this.mode === "orbit") this.orbit(dx * lookPerPixel * 1.4, dy * lookPerPixel * 1.4);
    else this.pose = turned(this.pose, dx * lookPerPixel, dy * lookPerPixel);
  }

  // Above 1: nearer.
  zoom(factor: number): void {
    this.flight = undefined;
    if (this.mode === "walk") {
      this.walk(scale(this.level(), Math.log(factor) * 1.2));
      return;
    }
    if (this.mode === "fly") {
      this.moveTo(add(this.pose.eye, scale(direction(this.pose), Math.log(factor) * 2)));
      return;
    }
    const target = this.target;
    const wanted = clamp(this.around / factor, nearestAround, this.diagonal() * farthest);
    this.around = wanted;
    this.pose = { ...this.pose, eye: sub(target, scale(direction(this.pose), wanted)) };
  }

  step(seconds: number, held: Held): void {
    if (this.flight) {
      if (isHeld(held)) this.flight = undefined;
      else return this.fly(seconds);
    }
    const turn = turnSpeed * seconds;
    if (this.mode === "orbit") this.orbit(-held.turn * turn, -held.tilt * turn);
    // The same pose stays the same object: by that the page knows that it stands still.
    else if (this.mode !== "top" && (held.turn !== 0 || held.tilt !== 0)) this.pose = turned(this.pose, held.turn * turn, held.tilt * turn);
    this.glide(seconds, held);
  }

  private glide(seconds: number, held: Held): void {
    const speed = (this.mode === "walk" ? walkSpeed : this.mode === "fly" ? flySpeed : Math.max(flySpeed, this.breadth() * 0.6)) *
      (held.fast ? fastFactor : 1);
    const [x, y] = this.level();
    const ahead3: Vec3 = this.mode === "fly" ? direction(this.pose) : [x, y, 0];
    const up = this.mode === "walk" ? 0 : held.up;
    const wanted = add(add(scale(ahead3, held.forward), scale([y, -x, 0], held.right)), [0, 0, up]);
    const size = Math.hypot(...wanted);
    const goal = size > 1 ? scale(wanted, speed / size) : scale(wanted, speed);
    const share = 1 - Math.exp(-settle * seconds);
    this.velocity = add(scale(this.velocity, 1 - share), scale(goal, share));
    if (Math.hypot(...this.velocity) < 1e-3) {
      this.velocity = [0, 0, 0];
      return;
    }
    const way = scale(this.velocity, seconds);
    if (this.mode === "walk") this.walk(way);
    else this.moveTo(add(this.pose.eye, way));
  }

  private fly(seconds: number): void {
    const flight = this.flight!;
    flight.gone += seconds;
    const t = flight.seconds > 0 ? Math.min(flight.gone / flight.seconds, 1) : 1;
    this.pose = t < 1 ? between(flight.from, flight.to, t) : flight.to;
    if (t < 1) return;
    this.around = flight.around;
    this.flight = undefined;
  }

  private orbit(yawBy: number, pitchBy: number): void {
    if (yawBy === 0 && pitchBy === 0) return;
    const target = this.target;
    const pose = turned(this.pose, -yawBy, -pitchBy);
    this.pose = { ...pose, eye: sub(target, scale(direction(pose), this.around)) };
  }

  private pan(dx: number, dy: number, metresPerPixel: number): void {
    const [x, y] = this.level();
    const right: Vec3 = [y, -x, 0];
    const lift = Math.cos(this.pose.pitch);
    const up: Vec3 = [-Math.sin(this.pose.pitch) * x, -Math.sin(this.pose.pitch) * y, lift];
    const way = add(scale(right, -dx * metresPerPixel), scale(up, dy * metresPerPixel));
    if (this.mode === "walk") this.walk([way[0], way[1], 0]);
    else this.moveTo(add(this.pose.eye, way));
  }

  private walk(way: Vec3): void {
    const [x, y] = this.pose.eye;
    const eye = walked([x, y, eyeHeight], [x + way[0], y + way[1], eyeHeight], this.room.obstacles, this.room.outline);
    this.pose = { ...this.pose, eye };
  }

  private moveTo(eye: Vec3): void {
    const spare = this.diagonal() * (farthest - 1);
    const { low, high } = this.room;
    this.pose = {
      ...this.pose,
      eye: [
        clamp(eye[0], low[0] - spare, high[0] + spare),
        clamp(eye[1], low[1] - spare, high[1] + spare),
        clamp(eye[2], 0.05, high[2] + spare),
      ],
    };
  }

  private lookDown(still: boolean): void {
    const { low, high } = this.room;
    const middle: Vec3 = [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, 0];
    const height = Math.max((high[1] - low[1]) * 0.62, (high[0] - low[0]) * 0.36) / Math.tan((topFov * Math.PI) / 360);
    this.goTo({ eye: [middle[0], middle[1], height], yaw: Math.PI / 2, pitch: -maxPitch }, height, still);
  }

  private stand(from: Mode, still: boolean): void {
    const wanted = from === "orbit" || from === "top" ? this.target : this.pose.eye;
    const { low, high } = this.room;
    const x = clamp(wanted[0], low[0] + 0.5, high[0] - 0.5);
    const y = clamp(wanted[1], low[1] + 0.5, high[1] - 0.5);
    const free = this.freeFloor(x, y);
    this.goTo({ eye: free, yaw: this.pose.yaw, pitch: clamp(this.pose.pitch, -0.25, 0.25) }, 2, still);
  }

  // The nearest place about (x, y) where a walker stands free, looked for in widening rings.
  private freeFloor(x: number, y: number): Vec3 {
    for (let radius = 0; radius < this.diagonal(); radius += 0.25) {
      const steps = radius === 0 ? 1 : Math.ceil(radius * 12);
      for (let i = 0; i < steps; i++) {
        const turn = (2 * Math.PI * i) / steps;
        const at: Vec3 = [x + radius * Math.cos(turn), y + radius * Math.sin(turn), eyeHeight];
        const put = walked(at, at, this.room.obstacles, this.room.outline);
        if (distance(put, at) < 1e-6 && this.isIn(at)) return at;
      }
    }
    return [x, y, eyeHeight];
  }

  private isIn(at: Vec3): boolean {
    const { low, high } = this.room;
    return at[0] > low[0] && at[0] < high[0] && at[1] > low[1] && at[1] < high[1];
  }

  private aroundWhatIsSeen(from: Mode, still: boolean): void {
    if (from !== "top") {
      this.around = Math.max(this.around, 1.5);
      return;
    }
    const { low, high } = this.room;
    const middle: Vec3 = [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, 0.5];
    const eye: Vec3 = add(middle, [-(high[0] - low[0]) * 0.35, -(high[1] - low[1]) * 0.85, this.diagonal() * 0.5]);
    this.goTo(lookingAt(eye, middle), distance(eye, middle), still);
  }

  private reach(): number {
    return this.mode === "orbit" || this.mode === "top" ? this.around : 3;
  }

  // About how much of the store is in the picture.
  private breadth(): number {
    return this.mode === "top" ? 2 * this.around * Math.tan((topFov * Math.PI) / 360) : this.reach();
  }

  private level(): Vec3 {
    return [Math.cos(this.pose.yaw), Math.sin(this.pose.yaw), 0];
  }

  private diagonal(): number {
    return distance(this.room.low, this.room.high);
  }
}

function isHeld(held: Held): boolean {
  return [held.forward, held.right, held.up, held.turn, held.tilt].some((x) => x !== 0);
}
