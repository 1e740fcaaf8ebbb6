// Packs that are not near enough for their mesh: boxes with pictures of the pack on them, or for round ones a picture that turns with
// the eye. Two draws of still vertices (what is cut out costs more); what is in view is chosen by copying runs of indices, a cell's sides at a time.
// (Not instanced: WebGL without a GPU takes 0.1 ms an instance.)
import { BufferAttribute, BufferGeometry, DynamicDrawUsage, Group, Mesh, Vector3, type RawShaderMaterial, type Texture } from "three";
import type { Sku } from "../store/contract";
import { faceLight, type GoodsLight } from "./goods_light";
import { facesAnyway, fronts, rotationOf, type Cell, type GoodsTable, type Quaternion } from "./goods_table";
import { standInMaterial, type Shared } from "./shading";

export enum Form {
  solid = 0, // fills its box
  cut = 1, // does not: its pictures are cut out
  round = 2, // about its upright axis
}

export interface Portraits {
  readonly texture: Texture;
  readonly cells: readonly [number, number]; // across and down
  readonly cellTexels: readonly [number, number];
  readonly forms: Uint8Array; // by SKU row
}

// Sides of a box, in the product frame: -1..1 across, 0..1 up.
const sides = [
  { corners: [[-1, -1, 0], [1, -1, 0], [1, -1, 1], [-1, -1, 1]], normal: [0, -1, 0], view: 0 }, // front
  { corners: [[1, -1, 0], [1, 1, 0], [1, 1, 1], [1, -1, 1]], normal: [1, 0, 0], view: 1 }, // right
  { corners: [[-1, 1, 0], [-1, -1, 0], [-1, -1, 1], [-1, 1, 1]], normal: [-1, 0, 0], view: 1 }, // left
  { corners: [[-1, -1, 1], [1, -1, 1], [1, 1, 1], [-1, 1, 1]], normal: [0, 0, 1], view: 2 }, // top
  { corners: [[1, 1, 0], [-1, 1, 0], [-1, 1, 1], [1, 1, 1]], normal: [0, 1, 0], view: 0 }, // back
] as const;
enum Side {
  front = 0,
  right = 1,
  left = 2,
  top = 3,
  back = 4,
}
const corners = sides.length * 4; // of a pack
const picture = [
  [0, 0],
  [1, 0],
  [1, 1],
  [0, 1],
] as const; // of a side's corners
const seenRows = 2; // how many packs behind one another show their front
const plainTimes = 2; // times as far as where packs are shown by their fronts alone: only the first row is
const topShare = 0.93; // of the height: where a round pack's picture from above lies
const inset = 1.5; // texels about a picture that are not its own

// The indices of one side of all packs in the table's order; a pack without that side has none.
interface Run {
  readonly indices: Uint32Array;
  readonly starts: Uint32Array; // of each pack, and the end
}

interface Box {
  readonly turn: Quaternion;
  readonly place: readonly [number, number, number];
  readonly size: readonly [number, number, number];
  readonly round: boolean;
}

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
  private portraits: Portraits | undefined;
  private painted: Uint8Array | undefined; // RGB by product row
  private readonly seen: Uint32Array; // by cell: where those end that show their front
  private readonly firstRow: Uint32Array; // and the first row

  constructor(
    private readonly table: GoodsTable,
    private readonly skus: readonly Sku[],
    private readonly shared: Shared,
  ) {
    const vertices = table.count * corners;
    this.position = new Float32Array(vertices * 3);
    this.across = new Float32Array(vertices);
    this.uv = new Uint16Array(vertices * 2);
    this.color = new Uint8Array(vertices * 4);
    this.light = new Uint8Array(vertices * 4);
    this.seen = Uint32Array.from(table.cells, (cell) => this.rowsEnd(cell, seenRows));
    this.firstRow = Uint32Array.from(table.cells, (cell) => this.rowsEnd(cell, 1));
    this.writeShapes(undefined);
    this.writeLight(undefined);
    const attributes = this.attributes();
    const plain = standInMaterial(shared, this.uniforms, []);
    this.draws = [drawOf(attributes, table.count, plain, -500), drawOf(attributes, table.count, plain, -400)];
    this.group.add(...this.draws.map(({ mesh }) => mesh));
  }

  // What a table that takes this one's place wears from the start.
  get pictures(): Portraits | undefined {
    return this.portraits;
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

  // Farther off than `plainFrom` metres, sides between packs and packs behind packs are left out; `quick`: twice as far, tops as well.
  begin(plainFrom: number, quick: boolean): void {
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
      if (along > leftmost && (beyond || !few)) this.copy(Side.right, first, seenEnd);
      if (along < rightmost && (beyond || !few)) this.copy(Side.left, first, seenEnd);
    }
    if (rowOnly && cell.facing !== facesAnyway && eye.z < high[2]) return;
    if (eye.z > low[2]) this.copy(Side.top, first, few ? frontEnd : end);
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
    this.writeShapes(portraits);
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
      indices[filled++] = v;
      indices[filled++] = v + 1;
      indices[filled++] = v + 2;
      indices[filled++] = v;
      indices[filled++] = v + 2;
      indices[filled++] = v + 3;
    }
    starts[count] = filled;
    return { indices: indices.slice(0, filled), starts };
  }

  private writeShapes(portraits: Portraits | undefined): void {
    const { order, sku, position } = this.table;
    const forms = new Uint8Array(this.table.count);
    order.forEach((row, i) => {
      const type = sku[row]!;
      const turn = rotationOf(this.table, row);
      const upright = turn[0] ** 2 + turn[1] ** 2 < 0.02;
      const box: Box = {
        turn,
        place: [position[row * 3]!, position[row * 3 + 1]!, position[row * 3 + 2]!],
        size: this.skus[type]!.size_m,
        round: upright && portraits?.forms[type] === Form.round,
      };
      const form = portraits?.forms[type] ?? Form.solid;
      forms[i] = form === Form.round && !box.round ? Form.cut : form;
      for (let side = 0; side < sides.length; side++) this.writeSide(i * corners + side * 4, side, box);
      if (portraits && type < portraits.forms.length) this.writePictures(i, type, portraits);
    });
    this.writeColors();
    const turns = [Side.front, Side.top]; // what a round pack has
    this.runs = sides.map((_, side): readonly [Run, Run] => [
      this.runOf(side, (pack) => forms[pack] === Form.solid),
      this.runOf(side, (pack) => forms[pack] === Form.cut || (forms[pack] === Form.round && turns.includes(side))),
    ]);
  }

  private writeColors(): void {
    const { order, sku, tint } = this.table;
    const pictured = (type: number): boolean => type < (this.portraits?.forms.length ?? 0);
    const words = new Uint32Array(this.color.buffer);
    const colors = this.skus.map(({ color }, type) => (pictured(type) ? 0xffffff : Number.parseInt(color.slice(1), 16)));
    order.forEach((row, i) => {
      const color = colors[sku[row]!]!;
      const own = (k: number): number => Math.min(((color >> (16 - 8 * k)) & 255) * (tint[row * 3 + k]! / 200) ** 0.4545, 255);
      const [r, g, b] = [0, 1, 2].map((k) => (this.painted ? this.painted[row * 3 + k]! : own(k))) as [number, number, number];
      const alpha = !this.portraits || pictured(sku[row]!) ? 255 : 0;
      words.fill(wordOf(r, g, b, alpha), i * corners, (i + 1) * corners);
    });
  }

  private writeSide(vertex: number, side: number, { turn, place, size, round }: Box): void {
    const [x, y, z, w] = turn;
    const shape = sides[side]!.corners;
    for (let k = 0; k < 4; k++) {
      const corner = shape[k]!;
      const v = vertex + k;
      let [lx, ly, lz] = [(corner[0] * size[0]) / 2, (corner[1] * size[1]) / 2, corner[2] * size[2]];
      this.across[v] = 0;
      if (round && side === Side.front) {
        lx = ly = 0;
        this.across[v] = (corner[0] * Math.max(size[0], size[1])) / 2;
      } else if (round && side === Side.top) lz = size[2] * topShare;
      // As rotated() has it, without an array a corner.
      const tx = 2 * (y * lz - z * ly);
      const ty = 2 * (z * lx - x * lz);
      const tz = 2 * (x * ly - y * lx);
      this.position[v * 3] = place[0] + lx + w * tx + y * tz - z * ty;
      this.position[v * 3 + 1] = place[1] + ly + w * ty + z * tx - x * tz;
      this.position[v * 3 + 2] = place[2] + lz + w * tz + x * ty - y * tx;
    }
  }

  private writePictures(pack: number, sku: number, { cells, cellTexels }: Portraits): void {
    for (let side = 0; side < sides.length; side++) {
      const cell = sku * 3 + sides[side]!.view;
      const column = cell % cells[0];
      const line = Math.floor(cell / cells[0]);
      for (let k = 0; k < 4; k++) {
        const o = (pack * corners + side * 4 + k) * 2;
        this.uv[o] = ((column + within(picture[k]![0], cellTexels[0])) / cells[0]) * 65535;
        this.uv[o + 1] = ((line + within(picture[k]![1], cellTexels[1])) / cells[1]) * 65535;
      }
    }
  }

  private writeLight(light: GoodsLight | undefined): void {
    const words = new Uint32Array(this.light.buffer);
    const { order } = this.table;
    for (let i = 0; i < order.length; i++) {
      const row = order[i]!;
      const turn = rotationOf(this.table, row);
      for (let side = 0; side < sides.length; side++) {
        const word = light ? faceLight(light, row, turn, sides[side]!.normal) : side === Side.top ? 0x747474 : 0x6a6a6a;
        const first = i * corners + side * 4;
        words.fill((word | 0xff000000) >>> 0, first, first + 4);
      }
    }
  }
}

const within = (share: number, texels: number): number => (inset + share * (texels - 2 * inset)) / texels;

// As the bytes of a colour lie in memory; WebGL runs on machines that have the lowest first.
const wordOf = (r: number, g: number, b: number, a: number): number => ((r | (g << 8) | (b << 16)) | (a << 24)) >>> 0;
