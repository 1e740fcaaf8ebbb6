// What the server answers to who edits: the head of edit.bin, and the JSON of previews and saves (docs/viewer.md).
import type { Aisle, Fixture, Sku, Summary, Violation, Zone } from "../store/contract";

// An operation of market-patch/1, by its name.
export type Patch = Readonly<Record<string, unknown>>;

export interface ChangeCount {
  readonly kept: number;
  readonly moved: number;
  readonly added: number;
  readonly gone: number;
}

export interface EditLine {
  readonly words: string;
  readonly patches: readonly Patch[];
  readonly changes: { readonly zones: ChangeCount; readonly fixtures: ChangeCount; readonly products: ChangeCount };
  readonly lost: readonly string[];
}

export interface Cut {
  readonly node: string;
  readonly split: "x" | "y"; // y: first child south, x: first child west
  readonly ratio: number;
  readonly gap_mm: number;
  readonly rect_mm: readonly [number, number, number, number]; // west, south, east, north
}

// A run of shelves that can be moved: by pinning one of its modules.
export interface Run {
  readonly id: string;
  readonly zone: string;
  readonly fixture: string;
  readonly at_mm: readonly [number, number]; // the module's middle
  readonly rect_mm: Rect;
  readonly pinned: boolean;
}

export type Rect = readonly [number, number, number, number]; // west, south, east, north

export interface EditZone {
  readonly id: string;
  readonly type: string;
  readonly label: string;
  readonly kind: string;
  readonly levels?: number;
  readonly usual_levels: number;
  readonly level_range: readonly [number, number];
  readonly fill: number;
  readonly facings: readonly [number, number]; // of one SKU
  readonly aisle_mm?: number; // undefined: as usual
  readonly fixtures: number;
  readonly products: number;
}

export interface EditHead {
  readonly token: string; // of who has begun
  readonly revision: number;
  readonly lines: readonly EditLine[];
  readonly done: number;
  readonly counts: Summary["counts"];
  readonly floors: readonly Zone[];
  readonly aisles: readonly Aisle[];
  readonly violations: readonly Violation[];
  readonly fixtures: readonly Fixture[];
  readonly new_skus: readonly Sku[];
  readonly new_sku_rows: readonly number[];
  readonly cuts: readonly Cut[];
  readonly runs: readonly Run[];
  readonly places: readonly { readonly fixture: string; readonly field: string; readonly value: string }[]; // that are pinned
  readonly zones: readonly EditZone[];
  readonly kinds: readonly string[];
  readonly unparsed: readonly string[];
  readonly so_already: readonly string[];
  readonly given_up: readonly { readonly dropped: string; readonly kept: string; readonly why: string }[];
  readonly save_as: string;
}

export interface Preview {
  readonly zones: readonly Zone[];
  readonly offences: readonly Violation[];
  readonly violations: readonly Violation[];
  readonly fixtures: readonly { readonly run: string; readonly rect_mm: Rect }[];
}

export interface Saved {
  readonly folder: string;
  readonly scene_hash: string;
  readonly store: number;
  readonly follows_from_plan: boolean;
  readonly seed: number;
}
