// All products: which cells show meshes, which stand-ins, and what is built next.
import { Box3, Group, Vector3, type IUniform, type RawShaderMaterial, type Texture, type WebGLRenderer } from "three";
import type { Client } from "../store/client";
import type { MeshesHead, Sku } from "../store/contract";
import type { Packed } from "../store/packed";
import type { Effort } from "./effort";
import type { GoodsLight } from "./goods_light";
import { facesAnyway, fronts, type Cell, type GoodsTable } from "./goods_table";
import type { Heat } from "./heat";
import { MeshSet } from "./mesh_set";
import { PackCell } from "./pack_cell";
import { PageArray } from "./page_array";
import { drawPortraits } from "./portraits";
import { packMaterial, type Shared } from "./shading";
import { Sheets, type Near } from "./sheets";
import type { Sight } from "./sight";
import { SkuPlaces } from "./sku_places";
import { StandIns } from "./stand_ins";

// Goods that were shown before: the same SKUs, and perhaps fewer.
export interface Earlier {
  readonly goods: Goods;
  readonly rows: Uint32Array; // by row now: the row then, which stands as it stood; or `nowhere`
  readonly light: GoodsLight; // on the goods now
}

export interface Limits {
  readonly sheetLayers: number;
  readonly sharpness: number; // anisotropy
  readonly quick: boolean; // one mip level a point, for WebGL without a GPU
}

interface Shown {
  readonly number: number; // in the table's cells
  readonly cell: Cell;
  readonly box: Box3;
  triangles: number; // of its meshes
  built: PackCell | undefined;
  distance: number;
}

const sheetSize = [1024, 512] as const; // pixels of a label nearby
const labelsWithin = 2.6; // metres
const meshesWithin = 14;
const kept = 1.5; // times as many triangles as may be shown stay built
const buildMilliseconds = 8; // a frame
const hidden = -1000; // metres

export class Goods {
  readonly group = new Group();
  readonly standIns: StandIns;
  readonly shown: readonly Shown[];
  private far: MeshSet | undefined;
  private light: GoodsLight | undefined;
  private sheets: Sheets | undefined;
  private materials: readonly [RawShaderMaterial, RawShaderMaterial] | undefined;
  private triangles = 0;
  private heat: Heat | undefined;

  constructor(
    readonly table: GoodsTable,
    readonly skus: readonly Sku[],
    private readonly shared: Shared,
    private readonly changed: () => void,
    private readonly changedSoon: () => void,
    earlier?: Earlier,
  ) {
    this.light = earlier?.light;
    this.standIns = new StandIns(table, skus, shared, earlier?.light, earlier && { standIns: earlier.goods.standIns, rows: earlier.rows });
    this.group.add(this.standIns.group);
    this.shown = table.cells.map((cell, number) => ({
      number,
      cell,
      box: new Box3(new Vector3(...cell.low), new Vector3(...cell.high)),
      triangles: 0,
      built: undefined,
      distance: 0,
    }));
    if (earlier) this.takeOver(earlier.goods);
  }

  get trianglesOfMeshes(): number {
    return this.triangles;
  }
  get labelsSettled(): boolean {
    return this.sheets?.settled ?? false;
  }
  get labelsLoaded(): number {
    return this.sheets?.loaded ?? 0;
  }
  get farMeshes(): MeshSet | undefined {
    return this.far;
  }

  // Figures in colours; undefined: the goods as they are.
  showHeat(heat: Heat | undefined): void {
    this.heat = heat;
    this.standIns.paint(heat?.colors);
    this.changed();
  }

  setLight(light: GoodsLight): void {
    this.light = light;
    this.standIns.setLight(light);
    this.changed();
  }

  async setMeshes(packed: Packed<MeshesHead>, client: Client, renderer: WebGLRenderer, limits: Limits): Promise<void> {
    const far = new MeshSet(packed);
    const sizes = packed.head.pages;
    const width = Math.max(1, ...sizes.map((page) => page.width));
    const height = Math.max(1, ...sizes.map((page) => page.height));
    const places = new SkuPlaces(packed.f32("tile", 5), sizes.map((page) => [page.width / width, page.height / height]));
    const atlas = new PageArray(renderer, width, height, Math.max(sizes.length, 1), 4, limits.sharpness, limits.quick);
    const pictures = await Promise.all(sizes.map((_, page) => client.picture(`/goods-${page}.jpg`)));
    pictures.forEach((picture, page) => {
      atlas.put(page, 0, picture);
      picture.close();
    });
    atlas.makeSmallerCopies();

    const sheets: IUniform<Texture> = { value: atlas.texture }; // until there are some
    const newSheets = (): PageArray => {
      const pages = new PageArray(renderer, sheetSize[0], sheetSize[1], limits.sheetLayers, 11, limits.sharpness, limits.quick);
      sheets.value = pages.texture;
      return pages;
    };
    const uniforms: Record<string, IUniform> = { skus: { value: places.texture }, atlas: { value: atlas.texture }, sheets };
    this.standIns.setPortraits(await drawPortraits(renderer, far, this.skus.length, places, atlas.texture, limits.quick));
    this.sheets = new Sheets(client, newSheets, limits.sheetLayers, sheetSize[1], places, this.changedSoon);
    this.materials = [packMaterial(this.shared, uniforms, false), packMaterial(this.shared, uniforms, true)];
    this.far = far;
    for (const shown of this.shown) shown.triangles = this.trianglesOf(shown.cell, far);
    this.changed();
  }

  // A product that moves from now on, and is drawn otherwise: it is hidden below the floor.
  leaveOut(row: number): void {
    this.table.position[row * 3 + 2] = hidden;
    this.standIns.hide(this.table.order.indexOf(row));
    for (const shown of this.shown) {
      if (!shown.built || !this.table.order.subarray(shown.cell.first, shown.cell.end).includes(row)) continue;
      this.group.remove(...shown.built.meshes);
      shown.built.dispose();
      shown.built = undefined;
    }
    this.changed();
  }

  // Shapes, labels and their pictures; SKUs that are new have none.
  private takeOver(from: Goods): void {
    this.far = from.far;
    this.sheets = from.sheets;
    this.materials = from.materials;
    if (this.far) for (const shown of this.shown) shown.triangles = this.trianglesOf(shown.cell, this.far);
    this.changed();
  }

  // Without what another may have taken over.
  dispose(): void {
    this.group.removeFromParent();
    this.standIns.dispose();
    for (const { built } of this.shown) built?.dispose();
  }

  get storedLight(): GoodsLight | undefined {
    return this.light;
  }

  // Chooses what is seen; `spare`: for so many triangles, what is built is kept. False: more is to be built; call again in the next frame.
  update(sight: Sight, { meshes: budget, plainFrom, quick, labels }: Effort, spare: number): boolean {
    const { eye } = sight;
    for (const shown of this.shown) shown.distance = sight.distance(shown.cell.low, shown.cell.high);
    const byDistance = [...this.shown].sort((a, b) => a.distance - b.distance);
    const seen = byDistance.filter((shown) => this.facesEye(shown, eye) && sight.sees(shown.cell.low, shown.cell.high, shown.cell.fixture));
    this.hideMeshes();
    this.standIns.begin(plainFrom, quick);
    const missing: Shown[] = [];
    let left = this.far && this.light && !this.heat ? budget : -1;
    let order = 0;
    for (const shown of seen) {
      const near = shown.distance < meshesWithin && shown.triangles <= left;
      if (near) left -= shown.triangles;
      if (near && !shown.built) missing.push(shown);
      const meshes = near ? shown.built : undefined;
      if (meshes) this.show(meshes, ++order);
      this.standIns.add(shown.number, meshes ? shown.cell.deep : shown.cell.first, eye, shown.distance);
    }
    this.standIns.finish();
    this.buildSome(missing);
    this.forget(byDistance, Math.max(budget, spare) * kept);
    if (labels) this.wantLabels(seen, eye);
    return missing.length === 0;
  }

  // Infinitely many where a pack has no mesh: its cell is shown by stand-ins.
  private trianglesOf(cell: Cell, meshes: MeshSet): number {
    let count = 0;
    for (let i = cell.first; i < cell.deep; i++) {
      const range = meshes.range(this.table.sku[this.table.order[i]!]!);
      if (range.vertices === 0) return Infinity;
      count += (range.opaque + range.clear) / 3;
    }
    return count;
  }

  private facesEye({ cell, box }: Shown, eye: Vector3): boolean {
    if (cell.facing === facesAnyway) return true;
    const [x, y] = fronts[cell.facing]!;
    // From behind a shelf its back is seen, unless one looks over it.
    const back = Math.min(box.min.x * x, box.max.x * x) + Math.min(box.min.y * y, box.max.y * y);
    return eye.x * x + eye.y * y > back || eye.z > box.max.z;
  }

  private hideMeshes(): void {
    this.triangles = 0;
    for (const { built } of this.shown) for (const mesh of built?.meshes ?? []) mesh.visible = false;
  }

  private show(cell: PackCell, order: number): void {
    this.triangles += cell.triangles;
    cell.meshes.forEach((mesh, i) => {
      mesh.visible = true;
      mesh.renderOrder = i === 0 ? -1000 + order : 1000 - order;
    });
  }

  private buildSome(missing: readonly Shown[]): void {
    const until = performance.now() + buildMilliseconds;
    for (const shown of missing) {
      this.build(shown);
      if (performance.now() > until) return;
    }
  }

  private build(shown: Shown): void {
    const { cell } = shown;
    const rows = this.table.order.subarray(cell.first, cell.deep);
    shown.built = new PackCell(cell, rows, this.table, this.far!, this.light!, this.materials!);
    for (const mesh of shown.built.meshes) {
      mesh.visible = false;
      this.group.add(mesh);
    }
  }

  private forget(byDistance: readonly Shown[], room: number): void {
    for (const shown of byDistance) {
      if (!shown.built) continue;
      room -= shown.triangles;
      if (room >= 0 || shown.built.meshes[0]?.visible) continue;
      this.group.remove(...shown.built.meshes);
      shown.built.dispose();
      shown.built = undefined;
    }
  }

  private wantLabels(seen: readonly Shown[], eye: Vector3): void {
    if (!this.sheets) return;
    const nearest = new Map<number, number>();
    const { position, order, sku } = this.table;
    for (const shown of seen) {
      if (shown.distance > labelsWithin) break;
      for (let i = shown.cell.first; i < shown.cell.deep; i++) {
        const row = order[i]!;
        const away = Math.hypot(position[row * 3]! - eye.x, position[row * 3 + 1]! - eye.y, position[row * 3 + 2]! + 0.1 - eye.z);
        if (away > labelsWithin) continue;
        if (away < (nearest.get(sku[row]!) ?? Infinity)) nearest.set(sku[row]!, away);
      }
    }
    const near: Near[] = [...nearest].map(([row, distance]) => ({ sku: row, distance }));
    this.sheets.want(near.sort((a, b) => a.distance - b.distance));
  }
}
