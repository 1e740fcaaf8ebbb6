// Floor, walls, ceiling, fixtures, signs and price tags: a draw call for each picture they wear. What is in view, and how finely it
// is drawn, is chosen part by part.
import {
  BufferAttribute,
  BufferGeometry,
  DynamicDrawUsage,
  Group,
  Mesh,
  type RawShaderMaterial,
  type Texture,
} from "three";
import type { Joint, RoomHead } from "../store/contract";
import type { Sections } from "../store/packed";
import type { Effort } from "./effort";
import { boundsOf, divideRoom, divideShapes, type Batch, type RoomParts, type RoomSource, type Shaped } from "./room_parts";
import { MovingParts } from "./moving_parts";
import { roomMaterial, type Shared } from "./shading";
import type { Sight } from "./sight";

export interface RoomArrays {
  readonly position: Float32Array;
  readonly index: Uint32Array;
  readonly owner: Uint16Array; // fixture row, joint row; 65535: none
}

const coarserFrom = [1, 3, 8] as const; // times as far as what is drawn finely: where each coarser fineness begins
const ceilingTimes = 2.5; // a quick picture has the ceiling as if it were so much farther off
const quickShell = 2; // and floor and walls at least as coarse as that fineness
const layers = ["solid", "glass", "ceiling"] as const;
type Layer = (typeof layers)[number];
const none = 65535; // no fixture

interface Surface {
  readonly layer: Layer;
  readonly texture: number;
  readonly print: boolean; // its pictures are not repeated: price tags, signs
  readonly mesh: Mesh;
  shown: Uint32Array;
  filled: number;
}

export class Room {
  readonly group = new Group();
  readonly arrays: RoomArrays;
  readonly moving: MovingParts;
  private readonly surfaces: Surface[] = [];
  private readonly layerOf: Uint8Array; // by triangle
  private readonly materials = new Map<string, RawShaderMaterial>();
  private divided: RoomParts | undefined;
  private ceilingShown = true;
  private firstOwner: Uint16Array | undefined; // before an edit gave fixtures other rows
  private firstFixtures: readonly number[] = []; // of the parts
  private readonly gone = new Set<number>(); // parts that an edit took away

  private constructor(
    private readonly packed: Sections & { readonly head: RoomHead },
    joints: readonly Joint[],
    private readonly shared: Shared,
  ) {
    this.arrays = { position: packed.f32("position", 3), index: packed.u32("index", 1), owner: packed.u16("owner", 2) };
    this.moving = new MovingParts(joints, this.arrays.owner, this.arrays.position);
    this.layerOf = new Uint8Array(this.arrays.index.length / 3);
  }

  static async create(packed: Sections & { readonly head: RoomHead }, joints: readonly Joint[], shared: Shared): Promise<Room> {
    const room = new Room(packed, joints, shared);
    const plan = room.plan();
    room.wear(await divideRoom(room.source, plan));
    return room;
  }

  // Of fixtures alone, few shapes in many places (by fixture row), without joints: at once.
  static ofShapes(packed: Sections & { readonly head: RoomHead }, shaped: ReadonlyMap<number, Shaped>, shared: Shared): Room {
    const room = new Room(packed, [], shared);
    const plan = room.plan();
    room.wear(divideShapes(room.source, plan, shaped));
    return room;
  }

  // Every corner with its light, as the server sends them.
  get corners(): { readonly position: Float32Array; readonly normal: Int8Array; readonly light: Uint8Array } {
    return { position: this.arrays.position, normal: this.packed.i8("normal", 4), light: this.packed.u8("light", 4) };
  }

  textures(): number[] {
    return [...new Set(this.surfaces.map(({ texture }) => texture).filter((row) => row >= 0))];
  }

  setTexture(row: number, texture: Texture): void {
    for (const surface of this.surfaces) {
      if (surface.texture === row) surface.mesh.material = this.materialOf(row, texture, surface.layer);
    }
  }

  // What other things take their light from.
  get lit(): { position: Float32Array; normal: Int8Array; light: Uint8Array } {
    return { position: this.arrays.position, normal: this.packed.i8("normal", 4), light: this.packed.u8("light", 4) };
  }

  // Moves a door, lid or drawer, and what it carries. The light on it stays that of its first place.
  move(joint: number, to: number): void {
    const moved = this.moving.move(joint, to);
    const { parts, indices } = this.divided!;
    for (const part of parts) {
      if (!moved.includes(part.joint)) continue;
      const { start, end } = part.runs[0]!;
      Object.assign(part, boundsOf(this.arrays.position, indices[0]!.subarray(start, end)));
    }
    const [any] = this.surfaces; // all wear the same corners
    if (any) any.mesh.geometry.getAttribute("position").needsUpdate = true;
  }

  showCeiling(show: boolean): void {
    this.ceilingShown = show;
  }

  // After an edit: `rows`, by row as the room came, are the fixtures' rows now, 65535 for those that no longer stand so; `tags`: 0 where
  // a fixture's print no longer holds. `signs`: those that hang over zones still hold.
  revise(rows: Uint16Array, tags: Uint8Array, signs: boolean): void {
    const { parts } = this.divided!;
    const { owner } = this.arrays;
    this.firstOwner ??= owner.slice();
    if (this.firstFixtures.length === 0) this.firstFixtures = parts.map(({ fixture }) => fixture);
    const rowOf = (first: number): number => (first !== none ? rows[first]! : first);
    for (let i = 0; i < owner.length; i += 2) owner[i] = rowOf(this.firstOwner[i]!);
    this.gone.clear();
    parts.forEach((part, i) => {
      const first = this.firstFixtures[i]!;
      const { print } = this.surfaces[part.surface]!;
      if (first < 0) {
        if (print && !signs) this.gone.add(i);
        return;
      }
      const row = rowOf(first);
      const stale = tags[first] === 0 && print;
      if (row === none || stale) this.gone.add(i);
      part.fixture = row === none ? first : row;
    });
  }

  // What is left of a fixture that stands so no more.
  private isGone(index: number): boolean {
    const vertex = this.arrays.index[index]!;
    return this.firstOwner !== undefined && this.firstOwner[vertex * 2] !== none && this.arrays.owner[vertex * 2] === none;
  }

  dispose(): void {
    this.group.removeFromParent();
    for (const { mesh } of this.surfaces) mesh.geometry.dispose();
    for (const material of this.materials.values()) material.dispose();
  }

  // Whether a ray passes a triangle: through glass, and through a ceiling that is not shown. `index`: its first.
  isPassed(index: number): boolean {
    const layer = layers[this.layerOf[index / 3]!];
    if (this.isGone(index)) return true;
    return layer === "glass" || (layer === "ceiling" && !this.ceilingShown);
  }

  // `fineWithin`: metres in which everything is drawn as it is, but for a ceiling in a quick picture.
  update(sight: Sight, { fineWithin, quick }: Pick<Effort, "fineWithin" | "quick">): void {
    const { parts, indices } = this.divided!;
    for (const surface of this.surfaces) surface.filled = 0;
    for (const [number, part] of parts.entries()) {
      const surface = this.surfaces[part.surface]!;
      if (this.gone.has(number)) continue;
      if (surface.layer === "ceiling" && !this.ceilingShown) continue;
      if (!sight.sees(part.low, part.high, part.fixture)) continue;
      const times = quick && surface.layer === "ceiling" ? ceilingTimes : 1;
      const away = fineness(sight.distance(part.low, part.high) * times, fineWithin);
      const level = quick && part.fixture < 0 && !surface.print ? Math.max(away, quickShell) : away;
      const run = part.runs[level]!;
      surface.shown.set(indices[level]!.subarray(run.start, run.end), surface.filled);
      surface.filled += run.end - run.start;
    }
    for (const surface of this.surfaces) hand(surface);
  }

  private get source(): RoomSource {
    return { ...this.arrays, normal: this.packed.i8("normal", 4), color: this.packed.u8("color", 4) };
  }

  private plan(): Batch[] {
    const { packed } = this;
    const { batches, textures } = packed.head;
    const attributes = {
      position: new BufferAttribute(this.arrays.position, 3),
      normal: new BufferAttribute(packed.i8("normal", 4), 4, true),
      uv: new BufferAttribute(packed.f32("uv", 2), 2),
      color: new BufferAttribute(packed.u8("color", 4), 4, true),
      light: new BufferAttribute(packed.u8("light", 4), 4, true),
      finish: new BufferAttribute(packed.u8("finish", 4), 4, true),
    };
    return batches.map((batch): Batch => {
      this.layerOf.fill(layers.indexOf(batch.layer), batch.first_index / 3, (batch.first_index + batch.index_count) / 3);
      const exact = batch.texture >= 0 && !(textures[batch.texture]?.repeat ?? false);
      return { first: batch.first_index, count: batch.index_count, surface: this.surfaceOf(batch, exact, attributes), exact };
    });
  }

  private wear(divided: RoomParts): void {
    this.divided = divided;
    this.surfaces.forEach((surface, i) => {
      surface.shown = new Uint32Array(divided.surfaces[i] ?? 0);
      const index = new BufferAttribute(surface.shown, 1);
      index.setUsage(DynamicDrawUsage);
      surface.mesh.geometry.setIndex(index);
    });
  }

  private surfaceOf({ layer, texture }: { layer: Layer; texture: number }, print: boolean, attributes: Record<string, BufferAttribute>): number {
    const known = this.surfaces.findIndex((surface) => surface.layer === layer && surface.texture === texture);
    if (known >= 0) return known;
    const geometry = new BufferGeometry();
    for (const [name, attribute] of Object.entries(attributes)) geometry.setAttribute(name, attribute);
    const mesh = new Mesh(geometry, this.materialOf(-1, null, layer));
    mesh.matrixAutoUpdate = false;
    mesh.frustumCulled = false;
    if (layer === "glass") mesh.renderOrder = 500;
    this.group.add(mesh);
    return this.surfaces.push({ layer, texture, print, mesh, shown: new Uint32Array(0), filled: 0 }) - 1;
  }

  private materialOf(row: number, texture: Texture | null, layer: Layer): RawShaderMaterial {
    const key = `${row} ${layer === "glass"}`;
    let material = this.materials.get(key);
    if (!material) this.materials.set(key, (material = roomMaterial(this.shared, texture, layer === "glass")));
    return material;
  }
}

function fineness(away: number, fineWithin: number): number {
  return coarserFrom.filter((times) => away >= times * fineWithin).length;
}

function hand({ mesh, filled }: Surface): void {
  const index = mesh.geometry.index!;
  mesh.visible = filled > 0;
  mesh.geometry.setDrawRange(0, filled);
  index.clearUpdateRanges();
  index.addUpdateRange(0, filled);
  index.needsUpdate = true;
}
