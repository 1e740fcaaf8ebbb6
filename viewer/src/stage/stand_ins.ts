// Packs that are not near enough for their mesh: one instanced draw of boxes with pictures of the pack on them. What is in view is
// copied cell by cell into the buffer of instances.
import {
  BufferAttribute,
  DynamicDrawUsage,
  InstancedBufferGeometry,
  InstancedInterleavedBuffer,
  InterleavedBufferAttribute,
  Mesh,
  Vector2,
  type RawShaderMaterial,
  type Texture,
} from "three";
import type { Sku } from "../store/contract";
import type { GoodsTable } from "./goods_table";
import { rotationOf } from "./goods_table";
import { faceLight, type GoodsLight } from "./goods_light";
import { standInMaterial, type Shared } from "./shading";

// An instance is twelve words: place (3 floats), turn (4 x 16 bits), size in 1/10 mm and SKU row (4 x 16), light at the front, right,
// left and top (4 x rgb), colour and form.
const words = 12;
const at = { place: 0, turn: 3, size: 5, light: 7, color: 11 };

export enum Form {
  box = 0,
  post = 1, // round about its axis
  ball = 2,
}

export interface Portraits {
  readonly texture: Texture;
  readonly cells: readonly [number, number];
  readonly cellTexels: readonly [number, number];
  readonly forms: Uint8Array; // by SKU row
}

const quads: readonly (readonly (readonly [number, number, number])[])[] = [
  [[-1, -1, 0], [1, -1, 0], [1, -1, 1], [-1, -1, 1]],
  [[1, -1, 0], [1, 1, 0], [1, 1, 1], [1, -1, 1]],
  [[1, 1, 0], [-1, 1, 0], [-1, 1, 1], [1, 1, 1]],
  [[-1, 1, 0], [-1, -1, 0], [-1, -1, 1], [-1, 1, 1]],
  [[-1, -1, 1], [1, -1, 1], [1, 1, 1], [-1, 1, 1]],
];
const sideNormals = [
  [0, -1, 0],
  [1, 0, 0],
  [-1, 0, 0],
  [0, 0, 1],
] as const;

function boxOfQuads(geometry: InstancedBufferGeometry): void {
  const sides = quads.flatMap((quad, side) => quad.map(() => side));
  const index = quads.flatMap((_, side) => [0, 1, 2, 0, 2, 3].map((k) => side * 4 + k));
  geometry.setAttribute("corner", new BufferAttribute(new Float32Array(quads.flat(2)), 3));
  geometry.setAttribute("side", new BufferAttribute(new Float32Array(sides), 1));
  geometry.setIndex(index);
}

const pack16 = (low: number, high: number): number => ((low & 0xffff) | ((high & 0xffff) << 16)) >>> 0;

export class StandIns {
  readonly mesh: Mesh;
  private readonly source: Uint32Array; // every product, in the table's order
  private readonly shown: Uint32Array;
  private readonly geometry = new InstancedBufferGeometry();
  private readonly buffer: InstancedInterleavedBuffer;
  private readonly uniforms = {
    pictures: { value: null as Texture | null },
    cells: { value: new Vector2(1, 1) },
    cellTexels: { value: new Vector2(1, 1) },
  };
  private plain: RawShaderMaterial;
  private filled = 0;

  constructor(
    private readonly table: GoodsTable,
    private readonly skus: readonly Sku[],
    private readonly shared: Shared,
  ) {
    this.source = new Uint32Array(table.count * words);
    this.writePlaces();
    this.writeColors(undefined);
    this.writeLight(undefined);
    this.shown = new Uint32Array(Math.max(table.count, 1) * words);
    this.buffer = new InstancedInterleavedBuffer(this.shown, words, 1);
    this.buffer.setUsage(DynamicDrawUsage);
    boxOfQuads(this.geometry);
    ["wordsA", "wordsB", "wordsC"].forEach((name, i) => {
      this.geometry.setAttribute(name, new InterleavedBufferAttribute(this.buffer, 4, i * 4, false));
    });
    this.plain = standInMaterial(shared, this.uniforms, false);
    this.mesh = new Mesh(this.geometry, this.plain);
    this.mesh.frustumCulled = false;
    this.mesh.matrixAutoUpdate = false;
    this.mesh.renderOrder = 1;
  }

  get count(): number {
    return this.filled;
  }

  begin(): void {
    this.filled = 0;
  }

  // Rows of the table's order.
  add(first: number, end: number): void {
    if (end <= first) return;
    this.shown.set(this.source.subarray(first * words, end * words), this.filled * words);
    this.filled += end - first;
  }

  finish(): void {
    this.geometry.instanceCount = this.filled;
    this.mesh.visible = this.filled > 0;
    this.buffer.clearUpdateRanges();
    this.buffer.addUpdateRange(0, this.filled * words);
    this.buffer.needsUpdate = true;
  }

  setPortraits(portraits: Portraits): void {
    this.uniforms.pictures.value = portraits.texture;
    this.uniforms.cells.value.set(...portraits.cells);
    this.uniforms.cellTexels.value.set(...portraits.cellTexels);
    this.writeColors(portraits.forms);
    this.mesh.material = standInMaterial(this.shared, this.uniforms, true);
    this.plain.dispose();
  }

  setLight(light: GoodsLight): void {
    this.writeLight(light);
  }

  private writePlaces(): void {
    const floats = new Float32Array(this.source.buffer);
    this.table.order.forEach((row, i) => {
      const o = i * words;
      floats.set(this.table.position.subarray(row * 3, row * 3 + 3), o + at.place);
      const r = this.table.rotation;
      this.source[o + at.turn] = pack16(r[row * 4]!, r[row * 4 + 1]!);
      this.source[o + at.turn + 1] = pack16(r[row * 4 + 2]!, r[row * 4 + 3]!);
      const sku = this.table.sku[row]!;
      const [w, d, h] = this.skus[sku]!.size_m.map((x) => Math.min(Math.round(x * 10000), 65535)) as [number, number, number];
      this.source[o + at.size] = pack16(w, d);
      this.source[o + at.size + 1] = pack16(h, sku);
    });
  }

  // With forms there are pictures, which have the colour.
  private writeColors(forms: Uint8Array | undefined): void {
    const colors = this.skus.map((sku) => (forms ? 0xffffff : Number.parseInt(sku.color.slice(1), 16)));
    this.table.order.forEach((row, i) => {
      const sku = this.table.sku[row]!;
      const color = colors[sku]!;
      const part = (shift: number, k: number): number =>
        Math.min(Math.round((((color >> shift) & 255) * this.table.tint[row * 3 + k]!) / 200), 255);
      this.source[i * words + at.color] = (part(16, 0) | (part(8, 1) << 8) | (part(0, 2) << 16) | ((forms?.[sku] ?? 0) << 24)) >>> 0;
    });
  }

  private writeLight(light: GoodsLight | undefined): void {
    this.table.order.forEach((row, i) => {
      const turn = rotationOf(this.table, row);
      sideNormals.forEach((normal, side) => {
        this.source[i * words + at.light + side] = light ? faceLight(light, row, turn, normal) : side === 3 ? 0x747474 : 0x6a6a6a;
      });
    });
  }
}
