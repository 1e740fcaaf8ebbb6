// Where each SKU's label lies: a tile of a page of the atlas, and a layer of the near sheets when it is loaded. Read by the shaders
// as a texture of two texels a SKU.
import { DataTexture, FloatType, NearestFilter, RGBAFormat } from "three";

export interface Tile {
  readonly page: number; // -1: no label
  readonly u: number;
  readonly v: number;
  readonly width: number;
  readonly height: number;
}

const skusInRow = 512;

export class SkuPlaces {
  readonly texture: DataTexture;
  readonly count: number; // of SKUs
  private readonly texels: Float32Array;

  // `tiles`: page, u0, v0, u1, v1 a SKU, of pages that fill `fill` of their layer in each direction.
  constructor(
    tiles: Float32Array,
    fill: readonly (readonly [number, number])[],
  ) {
    const count = (this.count = tiles.length / 5);
    const rows = Math.max(Math.ceil(count / skusInRow), 1);
    this.texels = new Float32Array(rows * skusInRow * 8);
    for (let sku = 0; sku < count; sku++) {
      const [page, u0, v0, u1, v1] = tiles.subarray(sku * 5, sku * 5 + 5) as unknown as [number, number, number, number, number];
      const [x, y] = fill[page] ?? [1, 1];
      this.texels.set([u0 * x, v0 * y, (u1 - u0) * x, (v1 - v0) * y, page, -1, 0, 0], sku * 8);
    }
    this.texture = new DataTexture(this.texels, skusInRow * 2, rows, RGBAFormat, FloatType);
    this.texture.minFilter = this.texture.magFilter = NearestFilter;
    this.texture.needsUpdate = true;
  }

  tile(sku: number): Tile {
    const [u, v, width, height, page] = this.texels.subarray(sku * 8, sku * 8 + 5) as unknown as [number, number, number, number, number];
    return { u, v, width, height, page };
  }

  setSheet(sku: number, layer: number): void {
    this.texels[sku * 8 + 5] = layer;
    this.texture.needsUpdate = true;
  }
}
