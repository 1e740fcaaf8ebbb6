// Packs that are not near enough for their mesh: boxes with pictures of the pack on them, or for round ones a picture that turns with
// the eye. Two draws of still vertices (what is cut out costs more); what is in view is chosen by copying runs of indices, a cell's sides at a time.
// (Not instanced: WebGL without a GPU takes 0.1 ms an instance.)
import { BufferAttribute, BufferGeometry, DynamicDrawUsage, Group, Mesh, Vector3, type RawShaderMaterial, type Texture } from "three";
import type { Sku } from "../store/contract";
import { lightOn, type GoodsLight } from "./goods_light";
import { facesAnyway, fronts, type Cell, type GoodsTable } from "./goods_table";
import { standInMaterial, type Shared } from "./shading";

export enum Form {
  solid = 0, // fills its box
  cut = 1, // does not: its pictures are cut out
  round = 2, // about its upright axis
}

export type Look = Pick<Sku, "color" | "size_m">;

export interface Portraits {
  readonly texture: Texture;
  readonly cells: readonly [number, number]; // across and down
  readonly cellTexels: readonly [number, number];
  readonly forms: Uint8Array; // by SKU row
}

// Sides of a box, in the product frame: -1..1 across, 0..1 up. `look`: along which axis (first of its three numbers), and which way.
const sides = [
  { corners: [[-1, -1, 0], [1, -1, 0], [1, -1, 1], [-1, -1, 1]], look: [3, -1], view: 0 }, // front
  { corners: [[1, -1, 0], [1, 1, 0], [1, 1, 1], [1, -1, 1]], look: [0, 1], view: 1 }, // right
  { corners: [[-1, 1, 0], [-1, -1, 0], [-1, -1, 1], [-1, 1, 1]], look: [0, -1], view: 1 }, // left
  { corners: [[-1, -1, 1], [1, -1, 1], [1, 1, 1], [-1, 1, 1]], look: [6, 1], view: 2 }, // top
  { corners: [[1, 1, 0], [-1, 1, 0], [-1, 1, 1], [1, 1, 1]], look: [3, 1], view: 0 }, // back
] as const;
enum Side {
  front = 0,
  right = 1,
  left = 2,
  top = 3,
  back = 4,
}
const corners = sides.length * 4; // of a pack
const boxCorners = Float32Array.from(sides.flatMap((side) => side.corners.flat()));
const tints = Float64Array.from({ length: 256 }, (_, tint) => (tint / 200) ** 0.4545);
const picture = [
  [0, 0],
  [1, 0],
  [1, 1],
  [0, 1],
] as const; // of a side's corners
const twoTriangles = [0, 1, 2, 0, 2, 3] as const; // of a side's corners
const perCorner = [
  ["position", 3],
  ["across", 1],
  ["uv", 2],
  ["color", 4],
  ["light", 4],
] as const;
const seenRows = 2; // how many packs behind one another show their front
const plainTimes = 2; // times as far as where packs are shown by their fronts alone: only the first row is
const topShare = 0.93; // of the height: where a round pack's picture from above lies
const inset = 1.5; // texels about a picture that are not its own

// The indices of one side of all packs in the table's order; a pack without that side has none.
interface Run {
  readonly indices: Uint32Array;
  readonly starts: Uint32Array; // of each pack, and the end
}

// A table of before, whose packs stand as they stood.
export interface Before {
  readonly standIns: StandIns;
  readonly rows: Uint32Array; // by row now: the row then, or nowhere
}
export const nowhere = 0xffffffff;

interface Draw {
  readonly mesh: Mesh;
  readonly shown: Uint32Array;
  filled: number;
}

function drawOf(attributes: Record<string, BufferAttribute>, packs: number, material: RawShaderMaterial, order: number): Draw {
  const geometry = new BufferGeometry();
  for (const [name, attribute] of Object.entries(attributes)) geometry.setAttribute(name, attribute);
  const shown = new Uint32Array(Math.max(packs, 1) * sides.length * 6);
  const index = new BufferAttribute(shown, 1);
  index.setUsage(DynamicDrawUsage);
  geometry.setIndex(index);
  const mesh = new Mesh(geometry, material);
  mesh.frustumCulled = false;
  mesh.matrixAutoUpdate = false;
  mesh.renderOrder = order;
  return { mesh, shown, filled: 0 };
}

export class StandIns {
  readonly group = new Group();
  private readonly position: Float32Array;
  private readonly across: Float32Array;
  private readonly uv: Uint16Array;
  private readonly color: Uint8Array;
  private readonly light: Uint8Array;
  private runs: readonly (readonly [Run, Run])[] = []; // by side: solid, cut out
  private readonly draws: readonly [Draw, Draw];
  private readonly uniforms = { pictures: { value: null as Texture | null } };
  private plainFrom = 0;
  private rowOnlyFrom = Infinity;
  private quick = false;
  private portraits: Portraits | undefined;
  private painted: Uint8Array | undefined; // RGB by product row
  private readonly seen: Uint32Array; // by cell: where those end that show their front
  private readonly firstRow: Uint32Array; // and the first row
  private readonly forms: Uint8Array; // by place in the table's order

  // `light`: the goods' own; undefined: it is still to come.
  constructor(
    private readonly table: GoodsTable,
    private readonly skus: readonly Look[],
    private readonly shared: Shared,
    light?: GoodsLight,
    before?: Before,
  ) {
    const vertices = table.count * corners;
    this.position = new Float32Array(vertices * 3);
    this.across = new Float32Array(vertices);
    this.uv = new Uint16Array(vertices * 2);
    this.color = new Uint8Array(vertices * 4);
    this.light = new Uint8Array(vertices * 4);
    this.forms = new Uint8Array(table.order.length);
    this.seen = Uint32Array.from(table.cells, (cell) => this.rowsEnd(cell, seenRows));
    this.firstRow = Uint32Array.from(table.cells, (cell) => this.rowsEnd(cell, 1));
    this.portraits = before?.standIns.portraits;
    this.uniforms.pictures.value = this.portraits?.texture ?? null;
    const fresh = before ? this.copyFrom(before) : undefined;
    this.writeShapes(fresh);
    this.writeColors(before?.standIns.painted ? undefined : fresh);
    this.writeLight(light, fresh);
    const attributes = this.attributes();
    const plain = standInMaterial(shared, this.uniforms, []);
    this.draws = [drawOf(attributes, table.count, plain, -500), drawOf(attributes, table.count, plain, -400)];
    this.group.add(...this.draws.map(({ mesh }) => mesh));
    if (this.portraits) this.wear();
  }

  dispose(): void {
    for (const { mesh } of this.draws) {
      mesh.geometry.dispose();
      (mesh.material as RawShaderMaterial).dispose();
    }
  }

  get triangles(): number {
    return (this.draws[0].filled + this.draws[1].filled) / 3;
  }

  // Farther off than `plainFrom` metres, sides between packs and packs behind packs are left out; `quick`: twice as far, all sides and
  // tops as well, and near ones show the tops of their first rows alone.
  begin(plainFrom: number, quick: boolean): void {
    this.quick = quick;
    this.rowOnlyFrom = quick ? plainTimes * plainFrom : Infinity;
    this.plainFrom = plainFrom;
    for (const draw of this.draws) draw.filled = 0;
  }

  // What of a cell is seen from the eye, so far off; its packs before `first` are shown otherwise.
  add(number: number, first: number, eye: Vector3, distance: number): void {
    const cell = this.table.cells[number]!;
    const { low, high, end } = cell;
    const above = eye.z - high[2] > 0.5 * distance; // one looks down on it
    const few = distance > this.plainFrom && !above;
    const rowOnly = few && distance > this.rowOnlyFrom;
    const frontEnd = Math.max(first, (rowOnly ? this.firstRow : this.seen)[number]!);
    if (cell.facing === facesAnyway) {
      const all = [Side.front, Side.right, Side.left, Side.back] as const;
      for (const side of all) this.copy(side, first, end);
    } else {
      const [x, y] = fronts[cell.facing]!;
      const [rx, ry] = [-y, x]; // the pack's right
      const along = eye.x * rx + eye.y * ry;
      const leftmost = Math.min(low[0] * rx, high[0] * rx) + Math.min(low[1] * ry, high[1] * ry);
      const rightmost = Math.max(low[0] * rx, high[0] * rx) + Math.max(low[1] * ry, high[1] * ry);
      // From beyond an end of the shelf all its rows are seen, else the first ones.
      const beyond = along > rightmost || along < leftmost;
      const seenEnd = beyond && !few ? end : frontEnd;
      this.copy(Side.front, first, seenEnd);
      const sided = !few || (beyond && !rowOnly);
      if (sided && along > leftmost) this.copy(Side.right, first, seenEnd);
      if (sided && along < rightmost) this.copy(Side.left, first, seenEnd);
    }
    if (rowOnly && cell.facing !== facesAnyway && eye.z < high[2]) return;
    const topsEnd = few || (this.quick && !above && cell.facing !== facesAnyway) ? frontEnd : end;
    if (eye.z > low[2]) this.copy(Side.top, first, topsEnd);
  }

  finish(): void {
    for (const { mesh, filled } of this.draws) {
      mesh.geometry.setDrawRange(0, filled);
      mesh.visible = filled > 0;
      const index = mesh.geometry.index!;
      index.clearUpdateRanges();
      index.addUpdateRange(0, filled);
      index.needsUpdate = true;
    }
  }

  setPortraits(portraits: Portraits): void {
    this.uniforms.pictures.value = portraits.texture;
    this.portraits = portraits;
    this.writeShapes();
    this.writeColors();
    this.wear();
    for (const name of ["position", "across", "uv"]) this.draws[0].mesh.geometry.getAttribute(name).needsUpdate = true;
  }

  // The pack at that place of the table's order; -1: none.
  hide(pack: number): void {
    if (pack < 0) return;
    this.position.fill(0, pack * corners * 3, (pack + 1) * corners * 3);
    this.across.fill(0, pack * corners, (pack + 1) * corners);
    for (const name of ["position", "across"]) this.draws[0].mesh.geometry.getAttribute(name).needsUpdate = true;
  }

  // Colours of the products instead of what they wear; undefined: as they are again.
  paint(colors: Uint8Array | undefined): void {
    this.painted = colors;
    this.writeColors();
    this.wear();
  }

  private wear(): void {
    const pictures = this.portraits && !this.painted ? (["PICTURES"] as const) : [];
    const plain = this.painted ? (["PLAIN"] as const) : [];
    this.draws.forEach(({ mesh }, i) => {
      (mesh.material as RawShaderMaterial).dispose();
      mesh.material = standInMaterial(this.shared, this.uniforms, [...pictures, ...plain, ...(pictures.length > 0 && i === 1 ? (["CUT"] as const) : [])]);
    });
    this.draws[0].mesh.geometry.getAttribute("color").needsUpdate = true;
  }

  setLight(light: GoodsLight): void {
    this.writeLight(light);
    this.draws[0].mesh.geometry.getAttribute("light").needsUpdate = true;
  }

  private rowsEnd(cell: Cell, rows: number): number {
    let end = cell.first;
    while (end < cell.end && this.table.rank[this.table.order[end]!]! < rows) end++;
    return end;
  }

  private copy(side: Side, first: number, end: number): void {
    if (end <= first) return;
    this.runs[side]!.forEach(({ indices, starts }, i) => {
      const draw = this.draws[i]!;
      draw.shown.set(indices.subarray(starts[first]!, starts[end]!), draw.filled);
      draw.filled += starts[end]! - starts[first]!;
    });
  }

  private attributes(): Record<string, BufferAttribute> {
    return {
      position: new BufferAttribute(this.position, 3),
      across: new BufferAttribute(this.across, 1),
      uv: new BufferAttribute(this.uv, 2, true),
      color: new BufferAttribute(this.color, 4, true),
      light: new BufferAttribute(this.light, 4, true),
    };
  }

  private runOf(side: number, has: (pack: number) => boolean): Run {
    const { count } = this.table;
    const starts = new Uint32Array(count + 1);
    const indices = new Uint32Array(count * 6);
    let filled = 0;
    for (let i = 0; i < count; i++) {
      starts[i] = filled;
      if (!has(i)) continue;
      const v = i * corners + side * 4;
      for (const corner of twoTriangles) indices[filled++] = v + corner;
    }
    starts[count] = filled;
    return { indices: indices.slice(0, filled), starts };
  }

  // Takes over what has been written of packs before; the places in the table's order of those that are left.
  private copyFrom({ standIns: old, rows }: Before): Uint32Array {
    const { order } = this.table;
    const packs = new Uint32Array(old.table.count).fill(nowhere);
    old.table.order.forEach((row, i) => (packs[row] = i));
    const packOf = (i: number): number => (i < order.length && rows[order[i]!] !== nowhere ? packs[rows[order[i]!]!]! : nowhere);
    const left: number[] = [];
    for (let i = 0; i < order.length; ) {
      const first = packOf(i);
      if (first === nowhere) {
        left.push(i++);
        continue;
      }
      let count = 1;
      while (packOf(i + count) === first + count) count++;
      this.copyPacks(old, first, i, count);
      i += count;
    }
    return Uint32Array.from(left);
  }

  private copyPacks(old: StandIns, from: number, to: number, count: number): void {
    this.forms.set(old.forms.subarray(from, from + count), to);
    for (const [name, width] of perCorner) {
      const size = width * corners;
      this[name].set(old[name].subarray(from * size, (from + count) * size), to * size);
    }
  }

  private writeShapes(which: Iterable<number> = this.table.order.keys()): void {
    const { order, sku, position } = this.table;
    const { portraits, forms } = this;
    for (const i of which) {
      const row = order[i]!;
      const type = sku[row]!;
      readAxes(this.table.rotation, row);
      const upright = axes[8]! > 0.96;
      const round = upright && portraits?.forms[type] === Form.round;
      const form = portraits?.forms[type] ?? Form.solid;
      forms[i] = form === Form.round && !round ? Form.cut : form;
      this.writeBox(i * corners, position, row * 3, this.skus[type]!.size_m, round);
      if (portraits && type < portraits.forms.length) this.uv.set(picturesOf(type, portraits), i * corners * 2);
    }
    const turns = [Side.front, Side.top]; // what a round pack has
    this.runs = sides.map((_, side): readonly [Run, Run] => [
      this.runOf(side, (pack) => forms[pack] === Form.solid),
      this.runOf(side, (pack) => forms[pack] === Form.cut || (forms[pack] === Form.round && turns.includes(side))),
    ]);
  }

  private writeColors(which: Iterable<number> = this.table.order.keys()): void {
    const { order, sku, tint } = this.table;
    const pictured = (type: number): boolean => type < (this.portraits?.forms.length ?? 0);
    const colors = this.skus.map(({ color }, type) => (pictured(type) ? 0xffffff : Number.parseInt(color.slice(1), 16)));
    const out = this.color;
    for (const i of which) {
      const row = order[i]!;
      const color = colors[sku[row]!]!;
      const o = i * corners * 4;
      for (let k = 0; k < 3; k++) {
        const own = ((color >> (16 - 8 * k)) & 255) * tints[tint[row * 3 + k]!]!;
        out[o + k] = this.painted ? this.painted[row * 3 + k]! : Math.min(own, 255);
      }
      out[o + 3] = !this.portraits || pictured(sku[row]!) ? 255 : 0;
      spread(out, o, corners);
    }
  }

  // By the pack's axes.
  private writeBox(vertex: number, places: Float32Array, place: number, size: readonly [number, number, number], round: boolean): void {
    const [front, top] = [(Side.front + 1) * 4, Side.top * 4];
    for (let k = 0; k < corners; k++) {
      const turns = round && k < front; // with the eye, about the upright axis
      const flat = turns ? 0 : 1;
      const x = (boxCorners[k * 3]! * size[0] * flat) / 2;
      const y = (boxCorners[k * 3 + 1]! * size[1] * flat) / 2;
      const z = round && k >= top && k < top + 4 ? size[2] * topShare : boxCorners[k * 3 + 2]! * size[2];
      this.across[vertex + k] = turns ? (boxCorners[k * 3]! * Math.max(size[0], size[1])) / 2 : 0;
      const o = (vertex + k) * 3;
      for (let axis = 0; axis < 3; axis++) this.position[o + axis] = places[place + axis]! + x * axes[axis]! + y * axes[3 + axis]! + z * axes[6 + axis]!;
    }
  }

  private writeLight(light: GoodsLight | undefined, which: Iterable<number> = this.table.order.keys()): void {
    const out = this.light;
    for (const i of which) {
      const row = this.table.order[i]!;
      readAxes(this.table.rotation, row);
      for (let side = 0; side < sides.length; side++) {
        const o = (i * corners + side * 4) * 4;
        const [axis, sign] = sides[side]!.look;
        if (light) lightOn(light, row, sign * axes[axis]!, sign * axes[axis + 1]!, sign * axes[axis + 2]!, out, o);
        else out.fill(side === Side.top ? 0x74 : 0x6a, o, o + 3);
        out[o + 3] = 255;
        spread(out, o, 4);
      }
    }
  }
}

// A pack's x, y and z axis in the store, one after another.
const axes = new Float64Array(9);

function readAxes(rotation: Int16Array, row: number): void {
  const [x, y, z, w] = [rotation[row * 4]! / 32767, rotation[row * 4 + 1]! / 32767, rotation[row * 4 + 2]! / 32767, rotation[row * 4 + 3]! / 32767];
  axes[0] = 1 - 2 * (y * y + z * z);
  axes[1] = 2 * (x * y + w * z);
  axes[2] = 2 * (x * z - w * y);
  axes[3] = 2 * (x * y - w * z);
  axes[4] = 1 - 2 * (x * x + z * z);
  axes[5] = 2 * (y * z + w * x);
  axes[6] = 2 * (x * z + w * y);
  axes[7] = 2 * (y * z - w * x);
  axes[8] = 1 - 2 * (x * x + y * y);
}

// The first of so many colours is that of all.
function spread(colors: Uint8Array, o: number, count: number): void {
  for (let filled = 4; filled < count * 4; filled *= 2) colors.copyWithin(o + filled, o, o + Math.min(filled, count * 4 - filled));
}

const pictures = new WeakMap<Portraits, Map<number, Uint16Array>>();

// Where a SKU's pictures lie, for all corners of its box.
function picturesOf(sku: number, portraits: Portraits): Uint16Array {
  let known = pictures.get(portraits);
  if (!known) pictures.set(portraits, (known = new Map<number, Uint16Array>()));
  let uv = known.get(sku);
  if (!uv) known.set(sku, (uv = writtenPictures(sku, portraits)));
  return uv;
}

function writtenPictures(sku: number, { cells, cellTexels }: Portraits): Uint16Array {
  const uv = new Uint16Array(corners * 2);
  const within = (share: number, texels: number): number => (inset + share * (texels - 2 * inset)) / texels;
  sides.forEach(({ view }, side) => {
    const cell = sku * 3 + view;
    const [column, line] = [cell % cells[0], Math.floor(cell / cells[0])];
    picture.forEach(([u, v], k) => {
      uv[(side * 4 + k) * 2] = ((column + within(u, cellTexels[0])) / cells[0]) * 65535;
      uv[(side * 4 + k) * 2 + 1] = ((line + within(v, cellTexels[1])) / cells[1]) * 65535;
    });
  });
  return uv;
}
