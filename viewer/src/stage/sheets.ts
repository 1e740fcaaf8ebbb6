// The label pictures of the packs nearest to the eye, in as many layers as there are; the farthest gives way. The layers' memory (a
// hundred megabytes) is taken when the first one is there.
import type { Client } from "../store/client";
import type { PageArray } from "./page_array";
import type { SkuPlaces } from "./sku_places";

export interface Near {
  readonly sku: number;
  readonly distance: number;
}

const asked = 4; // at a time: the server draws them
const patience = 0.8; // a label gives its layer to one that is so much nearer

interface Layer {
  sku: number;
  distance: number;
}

export class Sheets {
  private readonly layers: (Layer | undefined)[];
  private readonly layerOf = new Map<number, number>();
  private readonly loading = new Set<number>();
  private readonly failed = new Set<number>();
  private wanted: readonly Near[] = [];

  private pages: PageArray | undefined;

  constructor(
    private readonly client: Client,
    private readonly newPages: () => PageArray,
    layers: number,
    private readonly height: number, // of a layer, in pixels
    private readonly places: SkuPlaces,
    private readonly changed: () => void,
  ) {
    this.layers = new Array<Layer | undefined>(layers).fill(undefined);
  }

  get loaded(): number {
    return this.layerOf.size;
  }

  // True when nothing that is wanted is still to come.
  get settled(): boolean {
    return this.loading.size === 0 && this.next() === undefined;
  }

  // Nearest first.
  want(near: readonly Near[]): void {
    this.wanted = near.filter(({ sku }) => sku < this.places.count).slice(0, this.layers.length);
    const distances = new Map(near.map(({ sku, distance }) => [sku, distance]));
    for (const layer of this.layers) if (layer) layer.distance = distances.get(layer.sku) ?? Infinity;
    this.ask();
  }

  private next(): Near | undefined {
    return this.wanted.find(({ sku }) => !this.layerOf.has(sku) && !this.loading.has(sku) && !this.failed.has(sku));
  }

  private ask(): void {
    while (this.loading.size < asked) {
      const next = this.next();
      if (!next) return;
      void this.load(next.sku);
    }
  }

  private async load(sku: number): Promise<void> {
    this.loading.add(sku);
    try {
      const picture = await this.client.picture(`/skus/${sku}/label.png?px=${this.height}`);
      this.place(sku, picture);
      picture.close();
    } catch {
      this.failed.add(sku); // the atlas has it, if coarser
    }
    this.loading.delete(sku);
    this.changed();
    this.ask();
  }

  private place(sku: number, picture: ImageBitmap): void {
    const distance = this.wanted.find((near) => near.sku === sku)?.distance ?? Infinity;
    let worst = 0;
    for (let i = 0; i < this.layers.length; i++) {
      if ((this.layers[i]?.distance ?? Infinity) > (this.layers[worst]?.distance ?? Infinity) || !this.layers[i]) worst = i;
      if (!this.layers[i]) break;
    }
    const old = this.layers[worst];
    if (old) {
      if (old.distance * patience < distance) return;
      this.layerOf.delete(old.sku);
      this.places.setSheet(old.sku, -1);
    }
    this.layers[worst] = { sku, distance };
    this.layerOf.set(sku, worst);
    this.pages ??= this.newPages();
    this.pages.putWhole(worst, picture);
    this.places.setSheet(sku, worst);
  }
}
