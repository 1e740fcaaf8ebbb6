// What the server says of an edit, as the tables that the page draws: rows of the store as it was opened, and rows that are new.
import type { GoodsTable } from "../stage/goods_table";
import type { Shaped } from "../stage/room_parts";
import type { RoomHead } from "../store/contract";
import { MemorySections, PackedError, type Sections } from "../store/packed";
import { wayOf, type NearLight } from "./light";

export const none = 0xffffffff;
const noRow = 65535;
const columns = [
  ["position", "f32", 3],
  ["rotation", "i16", 4],
  ["sku", "u16", 1],
  ["fixture", "u16", 1],
  ["shelf", "u16", 1],
  ["facing", "u32", 1],
  ["tint", "u8", 3],
] as const;

type Columns = Pick<GoodsTable, (typeof columns)[number][0]>;

// The goods as they stand now, as goods.bin would have them; `from`: of each its row in the store as it was opened, or none.
export function editedGoods(base: Columns & { readonly count: number }, edit: Sections): { goods: Sections; from: Uint32Array } {
  const runs = edit.u32("runs", 2);
  let count = 0;
  for (let i = 1; i < runs.length; i += 2) count += runs[i]!;
  const from = new Uint32Array(count);
  const arrays: Record<string, Float32Array | Int16Array | Uint8Array | Uint16Array | Uint32Array> = {};
  for (const [name, kind, width] of columns) {
    const changed = edit[kind](`goods_${name}`, width);
    const whole = new (changed.constructor as new (length: number) => typeof changed)(count * width);
    copyRuns(runs, base[name], changed, whole, width, base.count);
    arrays[name] = whole;
  }
  writeFrom(runs, from);
  const fixtures = edit.u16("fixture_rows", 1);
  renumber(from, arrays["facing"]!, edit.u32("facing_rows", 1), none);
  const shelves = arrays["shelf"]!;
  renumber(from, shelves, edit.u32("shelf_rows", 1), noRow);
  renumber(from, arrays["fixture"]!, fixtures, noRow);
  return { goods: new MemorySections(arrays), from };
}

function copyRuns(runs: Uint32Array, base: ArrayLike<number>, changed: ArrayLike<number>, whole: { set(values: ArrayLike<number>, at: number): void }, width: number, rows: number): void {
  let [at, taken] = [0, 0];
  const part = (values: ArrayLike<number>, first: number, count: number): ArrayLike<number> =>
    (values as Float32Array).subarray(first * width, (first + count) * width);
  for (let i = 0; i < runs.length; i += 2) {
    const [first, count] = [runs[i]!, runs[i + 1]!];
    if (first !== none && first + count > rows) throw new PackedError("edit.bin names rows that the store does not have");
    whole.set(first === none ? part(changed, taken, count) : part(base, first, count), at * width);
    if (first === none) taken += count;
    at += count;
  }
}

function writeFrom(runs: Uint32Array, from: Uint32Array): void {
  let at = 0;
  for (let i = 0; i < runs.length; i += 2) {
    for (let k = 0; k < runs[i + 1]!; k++) from[at++] = runs[i] === none ? none : runs[i]! + k;
  }
}

// Numbers of rows that stay, as they are now.
function renumber(from: Uint32Array, values: Record<number, number>, rows: ArrayLike<number>, nothing: number): void {
  for (let i = 0; i < from.length; i++) {
    const value = values[i]!;
    if (from[i] !== none && value !== nothing && value < rows.length) values[i] = rows[value]!;
  }
}

// By row now: the row that was shown before, where both come from one row of the store as it was opened. `before`: undefined while the
// opened store is shown.
export function rowsBefore(from: Uint32Array, before: Uint32Array | undefined, rows: number): Uint32Array {
  if (!before) return from;
  const shown = new Uint32Array(rows).fill(none);
  before.forEach((row, i) => row !== none && (shown[row] = i));
  return from.map((row) => (row === none ? none : shown[row]!));
}

// The light on goods: their own where they stay, else that of where they stand now.
export function editedGoodsLight(light: Uint8Array, near: NearLight, position: Float32Array, from: Uint32Array): Uint8Array {
  const row = 18;
  const out = new Uint8Array(from.length * row);
  for (let i = 0; i < from.length; i++) {
    const old = from[i]!;
    if (old !== none) out.set(light.subarray(old * row, (old + 1) * row), i * row);
    else near.read(position[i * 3]!, position[i * 3 + 1]!, position[i * 3 + 2]!, 0, out, i * row);
  }
  return out;
}

// Fixtures that are new or stand otherwise, as room.bin would have them: each shape at its places. Undefined: there are none.
export function editedRoom(edit: Sections, near: NearLight): EditedRoom | undefined {
  const places = edit.u32("places", 2);
  const shapes = edit.u32("shapes", 5);
  if (places.length === 0) return undefined;
  const room = new RoomOfPlaces(edit, near);
  const glass: (readonly [number, number, number])[] = []; // vertices of a place before its shape's, first index, how many
  for (let i = 0; i < places.length / 2; i++) {
    const [first, count, index, solid, panes] = shapes.subarray(places[i * 2]! * 5) as unknown as readonly [number, number, number, number, number];
    const shift = room.vertices - first;
    room.addVertices(i, first, count);
    room.addIndices(shift, index, solid);
    glass.push([shift, index + solid, panes]);
  }
  room.endLayer("solid");
  for (const [shift, index, panes] of glass) room.addIndices(shift, index, panes);
  room.endLayer("glass");
  return room.sections();
}

export type EditedRoom = Sections & { readonly head: RoomHead; readonly shaped: ReadonlyMap<number, Shaped> };

class RoomOfPlaces {
  vertices = 0;
  private readonly source;
  private readonly out;
  private readonly index: Uint32Array;
  private indices = 0;
  private readonly shaped = new Map<number, Shaped>();
  private readonly batches: RoomHead["batches"][number][] = [];
  private layerBegan = 0;

  constructor(
    private readonly edit: Sections,
    private readonly near: NearLight,
  ) {
    this.source = {
      position: edit.f32("position", 3),
      normal: edit.i8("normal", 4),
      color: edit.u8("color", 4),
      light: edit.u8("light", 4),
      finish: edit.u8("finish", 4),
      index: edit.u32("index", 1),
    };
    const places = edit.u32("places", 2);
    const shapes = edit.u32("shapes", 5);
    let [count, indices] = [0, 0];
    for (let i = 0; i < places.length; i += 2) {
      const [, vertices, , solid, panes] = shapes.subarray(places[i]! * 5) as unknown as readonly [number, number, number, number, number];
      count += vertices;
      indices += solid + panes;
    }
    this.index = new Uint32Array(indices);
    this.out = {
      position: new Float32Array(count * 3),
      normal: new Int8Array(count * 4),
      uv: new Float32Array(count * 2),
      color: new Uint8Array(count * 4),
      light: new Uint8Array(count * 4),
      finish: new Uint8Array(count * 4),
      owner: new Uint16Array(count * 2),
    };
  }

  // Of the place with that number.
  addVertices(place: number, first: number, count: number): void {
    const [shape, fixture] = this.edit.u32("places", 2).subarray(place * 2) as unknown as readonly [number, number];
    const at = this.edit.f32("place_at", 3).subarray(place * 3, place * 3 + 3);
    this.shaped.set(fixture, { shape, vertex: this.vertices });
    const turned = quarterTurn(this.edit.u8("place_turns", 1)[place]!);
    const { source, out, vertices } = this;
    for (const name of ["color", "light", "finish"] as const) out[name].set(source[name].subarray(first * 4, (first + count) * 4), vertices * 4);
    for (let i = 0; i < count; i++) {
      const [from, to] = [first + i, vertices + i];
      const [x, y] = turned(source.position[from * 3]!, source.position[from * 3 + 1]!);
      out.position[to * 3] = x + at[0]!;
      out.position[to * 3 + 1] = y + at[1]!;
      out.position[to * 3 + 2] = source.position[from * 3 + 2]! + at[2]!;
      const [nx, ny] = turned(source.normal[from * 4]!, source.normal[from * 4 + 1]!);
      out.normal[to * 4] = nx;
      out.normal[to * 4 + 1] = ny;
      out.normal[to * 4 + 2] = source.normal[from * 4 + 2]!;
      out.owner[to * 2] = fixture;
      out.owner[to * 2 + 1] = noRow;
      this.shine(to);
    }
    this.vertices += count;
  }

  addIndices(shift: number, first: number, count: number): void {
    for (let i = first; i < first + count; i++) this.index[this.indices++] = this.source.index[i]! + shift;
  }

  endLayer(layer: "solid" | "glass"): void {
    const count = this.indices - this.layerBegan;
    if (count > 0) this.batches.push({ first_index: this.layerBegan, index_count: count, layer, texture: -1, low_m: [0, 0, 0], high_m: [0, 0, 0] });
    this.layerBegan = this.indices;
  }

  sections(): EditedRoom {
    const arrays = new MemorySections({ ...this.out, index: this.index });
    return Object.assign(arrays, { head: { batches: this.batches, textures: [] }, shaped: this.shaped });
  }

  // Lamps have their light already.
  private shine(vertex: number): void {
    const { position, normal, light } = this.out;
    const [v3, v4] = [vertex * 3, vertex * 4];
    if (light[v4]! + light[v4 + 1]! + light[v4 + 2]! > 0) return;
    const way = wayOf(normal[v4]!, normal[v4 + 1]!, normal[v4 + 2]!);
    this.near.read(position[v3]!, position[v3 + 1]!, position[v3 + 2]!, way, light, v4);
  }
}

function quarterTurn(turns: number): (x: number, y: number) => readonly [number, number] {
  const turn = turns % 4;
  if (turn === 1) return (x, y) => [-y, x];
  if (turn === 2) return (x, y) => [-x, -y];
  if (turn === 3) return (x, y) => [y, -x];
  return (x, y) => [x, y];
}
