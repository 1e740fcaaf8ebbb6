// What /api/make answers: docs/viewer.md, "Making stores".
import type { Zone, Violation } from "../store/contract";

export interface MakeOptions {
  readonly folder: string;
  readonly max_count: number;
  readonly profiles: readonly string[];
  readonly styles: readonly string[];
  readonly countries: readonly string[];
  readonly vary: readonly string[]; // axes that may have a seed of their own
  readonly planners: readonly string[]; // the offline one first
}

export interface DroppedFile {
  readonly name: string;
  readonly base64: string;
}

export interface Ask {
  readonly words: string;
  readonly size?: string;
  readonly profile?: string;
  readonly style?: string;
  readonly country?: string;
  readonly time?: string;
  readonly vary?: readonly string[]; // "fill=3"
  readonly skin?: string;
  readonly planner?: string;
  readonly catalogs?: readonly DroppedFile[];
  readonly floor_plan?: DroppedFile;
  readonly floor_plan_scale?: string;
  readonly images?: readonly DroppedFile[];
  readonly seed: number;
  readonly count: number;
}

export interface SaidError {
  readonly code: string;
  readonly where: string;
  readonly message: string;
}

export interface Wish {
  readonly text: string;
  readonly met: boolean;
  readonly why: string;
}

export interface Report {
  readonly requirements: readonly Wish[];
  readonly rules: readonly Violation[];
  readonly understood: boolean;
  readonly unparsed: readonly { readonly text: string }[];
  readonly conflicts: readonly { readonly kept: string; readonly dropped: string; readonly why: string }[];
  readonly metrics: { readonly fill: number; readonly REACH: number; readonly selling_area_m2: number };
}

export interface MadeFixture {
  readonly zone: string;
  readonly rect_mm: readonly [number, number, number, number];
}

export interface Opening {
  readonly kind: string;
  readonly low_m: readonly [number, number, number];
  readonly high_m: readonly [number, number, number];
}

export interface MadeStore {
  readonly name: string;
  readonly save_as: string;
  readonly scene_hash: string;
  readonly counts: { readonly products: number; readonly skus: number; readonly fixtures: number };
  readonly report: Report;
  readonly outline_mm: readonly (readonly [number, number])[];
  readonly openings: readonly Opening[];
  readonly zones: readonly Zone[];
  readonly fixtures: readonly MadeFixture[];
}

export interface Try {
  readonly seed: number;
  readonly state: "waiting" | "working" | "ready" | "failed";
  readonly error?: SaidError;
  readonly store?: MadeStore;
}

export interface Tries {
  readonly batch: number;
  readonly working: boolean;
  readonly warnings: readonly string[];
  readonly error?: SaidError;
  readonly tries: readonly Try[];
}

export interface Kept {
  readonly store: number;
  readonly folder: string;
  readonly scene_hash: string;
}
