// Where the camera is and looks: yaw 0 looks east, counter-clockwise from above; pitch 0 is level.
import { add, clamp, distance, length, mix, scale, sub, type Vec3 } from "./vector";

export interface Pose {
  readonly eye: Vec3;
  readonly yaw: number;
  readonly pitch: number;
}

// Straight up and down have no heading: a hair less keeps one.
export const maxPitch = Math.PI / 2 - 0.001;

export function direction(pose: Pose): Vec3 {
  const level = Math.cos(pose.pitch);
  return [level * Math.cos(pose.yaw), level * Math.sin(pose.yaw), Math.sin(pose.pitch)];
}

export function turned(pose: Pose, yawBy: number, pitchBy: number): Pose {
  return { ...pose, yaw: wrapped(pose.yaw + yawBy), pitch: clamp(pose.pitch + pitchBy, -maxPitch, maxPitch) };
}

export function lookingAt(eye: Vec3, target: Vec3, yawIfVertical = Math.PI / 2): Pose {
  const way = sub(target, eye);
  const level = Math.hypot(way[0], way[1]);
  const yaw = level > 1e-6 * length(way) ? Math.atan2(way[1], way[0]) : yawIfVertical;
  return { eye, yaw, pitch: clamp(Math.atan2(way[2], level), -maxPitch, maxPitch) };
}

export function wrapped(angle: number): number {
  return angle - 2 * Math.PI * Math.round(angle / (2 * Math.PI));
}

// The way from one pose to another, by the shorter turn; t in 0..1 is eased at both ends.
export function between(from: Pose, to: Pose, t: number): Pose {
  const s = t * t * (3 - 2 * t);
  return {
    eye: mix(from.eye, to.eye, s),
    yaw: wrapped(from.yaw + wrapped(to.yaw - from.yaw) * s),
    pitch: from.pitch + (to.pitch - from.pitch) * s,
  };
}

// How long a flight takes: near things quickly, the other end of the store not slowly.
export function flightSeconds(from: Pose, to: Pose): number {
  return clamp(0.35 + 0.12 * distance(from.eye, to.eye), 0.35, 1.4);
}

// The point `ahead` metres before the eye.
export function ahead(pose: Pose, metres: number): Vec3 {
  return add(pose.eye, scale(direction(pose), metres));
}
