// What the server answers: market-view/1. Lengths in metres, angles in radians unless a name says otherwise; Z up.
type Triple = readonly [number, number, number];

export interface Summary {
  readonly store: number;
  readonly may_edit: boolean;
  readonly may_drive: boolean;
  readonly name: string;
  readonly folder: string;
  readonly scene_hash: string;
  readonly prompt: string;
  readonly counts: { readonly products: number; readonly skus: number; readonly fixtures: number; readonly facings: number };
  readonly bounds: { readonly low_m: Triple; readonly high_m: Triple };
  readonly outline_mm: readonly (readonly [number, number])[];
  readonly ceiling_m: number;
  readonly cameras: readonly StoreCamera[];
  readonly zones: readonly Zone[];
  readonly aisles: readonly Aisle[];
  readonly violations: readonly Violation[];
  readonly fixtures: readonly Fixture[];
  readonly joints: readonly Joint[];
  readonly skus: readonly Sku[];
}

export interface StoreLine {
  readonly store: number;
  readonly name: string;
  readonly folder: string;
  readonly seed: number;
  readonly prompt: string;
  readonly products: number;
}

export interface StoreCamera {
  readonly name: string;
  readonly from_m: Triple;
  readonly at_m: Triple;
  readonly fov_deg: number;
  readonly ortho_height_m: number; // above 0: seen straight from above
}

export interface Zone {
  readonly id: string;
  readonly type: string;
  readonly label: string;
  readonly polygon_mm: readonly (readonly [number, number])[];
  readonly area_m2: number;
}

export interface Aisle {
  readonly id: string;
  readonly kind: string;
  readonly polygon_mm: readonly (readonly [number, number])[];
  readonly width_mm: number;
}

export interface Violation {
  readonly code: string;
  readonly severity: string;
  readonly where: string;
  readonly message: string;
  readonly at_mm?: readonly [number, number];
}

export interface Fixture {
  readonly row: number;
  readonly id: string;
  readonly kind: string;
  readonly generator: string; // rows that are built alike have the same
  readonly zone: string;
  readonly run: string; // the line it stands in
  readonly position_m: Triple;
  readonly yaw_deg: number;
  readonly size_m: Triple;
  readonly levels: number;
}

// Store frame; the axis as it is with all joints at position 0.
export interface Joint {
  readonly row: number;
  readonly fixture: number;
  readonly name: string;
  readonly kind: "hinge" | "slide" | "belt";
  readonly parent: number; // -1: none
  readonly origin_m: Triple;
  readonly axis: Triple;
  readonly lower: number;
  readonly upper: number;
  readonly states: readonly { readonly name: string; readonly position: number }[];
}

export interface Sku {
  readonly sku: string;
  readonly name: string;
  readonly name_zh: string;
  readonly brand: string;
  readonly variant: string;
  readonly category: string;
  readonly price: number;
  readonly currency: string; // ISO 4217
  readonly size_m: Triple;
  readonly mass_kg: number;
  readonly pick_rate: number; // of the grasp study; -1: it had none
  readonly color: string;
  readonly products: number;
}

export interface Progress {
  readonly state: "building" | "ready" | "failed";
  readonly stage: string;
  readonly share: number;
}

export interface Hit {
  readonly sku_row: number;
  readonly sku: string;
  readonly name: string;
  readonly price: number;
  readonly currency: string; // ISO 4217
  readonly products: readonly number[];
}

export interface ProductCard {
  readonly row: number;
  readonly id: string;
  readonly sku_row: number;
  readonly sku: string;
  readonly ean: string;
  readonly plu: string;
  readonly name: string;
  readonly name_zh: string;
  readonly brand: string;
  readonly variant: string;
  readonly description: string;
  readonly category: string;
  readonly subcategory: string;
  readonly net: string;
  readonly price: number;
  readonly currency: string; // ISO 4217
  readonly promotion: boolean;
  readonly size_mm: Triple;
  readonly mass_kg: number;
  readonly friction: number;
  readonly material: string;
  readonly storage: string;
  readonly shelf_life_days: number;
  readonly position_m: Triple;
  readonly fixture: { readonly row: number; readonly id: string; readonly kind: string };
  readonly zone: string;
  readonly level: number;
  readonly facing: { readonly facings: number; readonly rows_deep: number; readonly stack: number; readonly products: number };
  readonly facings_in_store: number;
  readonly items_in_store: number;
  readonly grasps: readonly { readonly tool: string; readonly tries: number; readonly held: number }[];
}

export interface FixtureCard {
  readonly row: number;
  readonly id: string;
  readonly run: string;
  readonly kind: string;
  readonly zone: string;
  readonly size_m: Triple;
  readonly levels: number;
  readonly material: string;
  readonly shelves: readonly {
    readonly level: number;
    readonly side: number;
    readonly use: string;
    readonly width_m: number;
    readonly depth_m: number;
    readonly clearance_m: number;
    readonly height_m: number;
    readonly facings: number;
    readonly products: number;
  }[];
  readonly joints: readonly number[];
  readonly products: number;
  readonly skus: number;
}

export interface MeshesHead {
  readonly pages: readonly { readonly width: number; readonly height: number }[];
}

export interface RoomHead {
  readonly batches: readonly {
    readonly first_index: number;
    readonly index_count: number;
    readonly layer: "solid" | "glass" | "ceiling";
    readonly texture: number;
    readonly low_m: Triple;
    readonly high_m: Triple;
  }[];
  readonly textures: readonly { readonly path: string; readonly width: number; readonly height: number; readonly repeat: boolean }[];
}
