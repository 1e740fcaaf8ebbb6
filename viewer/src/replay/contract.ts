// What the server answers of recorded episodes. Lengths in metres, times in seconds, forces in newton.
export interface RunLine {
  readonly run: number;
  readonly folder: string;
  readonly policy: string;
  readonly realism: string;
  readonly version: string;
  readonly split: string;
  readonly instructions: string;
  readonly episodes: number;
  readonly strict: number;
  readonly clean: number;
  readonly failures: readonly { readonly code: string; readonly episodes: number }[];
}

export interface EpisodeLine {
  readonly episode: number;
  readonly id: string;
  readonly track: string;
  readonly failure: string; // "None": none
  readonly error: string; // it could not be run
  readonly detail: string;
  readonly hits: number;
  readonly asked: number;
  readonly partial: number;
  readonly strict: boolean;
  readonly clean: boolean;
  readonly void: boolean;
  readonly recorded: boolean;
  readonly simulated_s: number;
}

export interface RunEpisodes {
  readonly run: RunLine;
  readonly episodes: readonly EpisodeLine[];
}

export interface ReplayGoal {
  readonly sku: string;
  readonly name: string;
  readonly name_zh: string;
  readonly count: number;
  readonly reached: number;
  readonly since_s: number; // -1: none lies there
}

export interface ReplayThing {
  readonly kind: "item" | "product" | "basket";
  readonly number: number;
  readonly sku: string;
  readonly name: string;
  readonly name_zh: string;
  readonly mesh: number; // of meshes.bin; -1: the last body of robot.bin
  readonly goal: boolean;
}

export type EventKind = "held" | "contact" | "toppled" | "dropped" | "displaced" | "base_collision" | "protective_stop";

export interface ReplayEvent {
  readonly kind: EventKind;
  readonly step: number;
  readonly last_step: number;
  readonly target: "nothing" | "item" | "product" | "fixture" | "room" | "other";
  readonly number: number;
  readonly sku: string;
  readonly force_n: number;
}

export interface SideEffects {
  readonly light_contacts: number;
  readonly firm_contacts: number;
  readonly hard_contacts: number;
  readonly hardest_n: number;
  readonly toppled: number;
  readonly dropped: number;
  readonly displaced: number;
  readonly strayed: number;
  readonly wrong_items: number;
  readonly basket_tilt_deg: number;
  readonly base_collisions: number;
  readonly protective_stops: number;
  readonly doors_open?: number; // of episodes with doors
}

export interface Replay {
  readonly result: EpisodeLine;
  readonly run: RunLine;
  readonly instruction: string;
  readonly robot: string;
  readonly place: number; // -1: the store itself
  readonly step_s: number;
  readonly steps: number;
  readonly bodies: readonly string[];
  readonly goals: readonly ReplayGoal[];
  readonly things: readonly ReplayThing[];
  readonly events: readonly ReplayEvent[];
  readonly side_effects: SideEffects;
  readonly cameras: readonly string[];
}

export interface MotionHead {
  readonly first: number;
  readonly steps: number;
  readonly bodies: number;
}
