// What the server says of a drive, and what it is sent. Lengths in metres, times in seconds.
import type { ReplayEvent, ReplayThing, SideEffects } from "../replay/contract";

export interface DriveGoal {
  readonly sku: string;
  readonly name: string;
  readonly name_zh: string;
  readonly count: number;
}

export interface DriveEpisode {
  readonly id: string;
  readonly instruction: string;
  readonly robot: string;
  readonly tools: string;
  readonly track: string;
  readonly place: number; // -1: the store itself
  readonly step_s: number;
  readonly limit_s: number;
  readonly has_base: boolean;
  readonly arms: readonly string[]; // "left_"
  readonly bodies: readonly string[];
  readonly cameras: readonly string[];
  readonly joints: readonly { readonly name: string; readonly dimension: string }[];
  readonly goals: readonly DriveGoal[];
  readonly things: readonly ReplayThing[];
}

export interface DriveStatus {
  readonly phase: "idle" | "opening" | "driving" | "failed";
  readonly generation: number;
  readonly taken: boolean;
  readonly watched: boolean; // a program acts: pages look on
  readonly error_code: string;
  readonly error: string;
  readonly logs: string;
  readonly tracks: readonly { readonly track: string; readonly tools: readonly string[] }[];
  readonly offers: readonly { readonly id: string; readonly track: string; readonly instruction: string }[];
  readonly episode?: DriveEpisode;
}

export interface DriveAsk {
  readonly track: string;
  readonly episode: string;
  readonly tools: string;
  readonly seed: number;
}

// The head of a message of state.
export interface DriveMoment {
  readonly generation: number;
  readonly step: number;
  readonly time_s: number;
  readonly speed: number; // simulated seconds a second; 0: not known
  readonly bodies: number;
  readonly things: number;
  readonly runs: boolean;
  readonly stopped: boolean;
  readonly openings: readonly number[]; // 1 open, -1 closed
  readonly reached: readonly number[];
  readonly side_effects: SideEffects;
  readonly events: readonly ReplayEvent[];
  readonly verdict?: { readonly success: boolean; readonly hits: number; readonly asked: number; readonly failure: string };
}

export interface DriveNote {
  readonly kind: "you" | "saved" | "opened" | "error";
  readonly drives: boolean;
  readonly taken: boolean;
  readonly file: string;
  readonly code: string;
  readonly message: string;
}

export type Axes = "base" | "tool";
export type Grip = "keep" | "open" | "close";
export type Triple = readonly [number, number, number];

// Shares of the most that a control step can do.
export interface Command {
  readonly drive: number;
  readonly turn: number;
  readonly move: Triple;
  readonly twist: Triple;
  readonly joints: readonly number[];
  readonly arm: number;
  readonly axes: Axes;
  readonly grip: Grip;
}

export type Verb = "move" | "go" | "pause" | "done" | "reset" | "save" | "take";
