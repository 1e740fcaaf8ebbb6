// All products: which cells show meshes, which stand-ins, and what is built next.
import { Box3, Frustum, Group, Matrix4, Vector3, type Camera, type IUniform, type RawShaderMaterial, type WebGLRenderer } from "three";
import type { Client } from "../store/client";
import type { MeshesHead, Sku } from "../store/contract";
import type { Packed } from "../store/packed";
import type { GoodsLight } from "./goods_light";
import { facesAnyway, fronts, type Cell, type GoodsTable } from "./goods_table";
import { MeshSet } from "./mesh_set";
import { PackCell } from "./pack_cell";
import { PageArray } from "./page_array";
import { drawPortraits } from "./portraits";
import { packMaterial, type Shared } from "./shading";
import { Sheets, type Near } from "./sheets";
import { SkuPlaces } from "./sku_places";
import { StandIns } from "./stand_ins";

export interface Limits {
  readonly sheetLayers: number;
  readonly sharpness: number; // anisotropy
}

type Detail = "far" | "middle";

interface Shown {
  readonly number: number; // in the table's cells
  readonly cell: Cell;
  readonly box: Box3;
  readonly built: Map<Detail, PackCell>;
  distance: number;
}

const middleWithin = 1.5; // metres
const labelsWithin = 2.6;
const keptFor = 1.5; // times the radius, before a mesh is thrown away
export const farthestMeshes = 14;
const nearestMeshes = 2.2;

export class Goods {
  readonly group = new Group();
  readonly standIns: StandIns;
  readonly shown: readonly Shown[];
  meshRadius = 4.5;
  private far: MeshSet | undefined;
  private middle: MeshSet | undefined;
  private light: GoodsLight | undefined;
  private sheets: Sheets | undefined;
  private materials: readonly [RawShaderMaterial, RawShaderMaterial] | undefined;
  private readonly frustum = new Frustum();
  private triangles = 0;

  constructor(
    readonly table: GoodsTable,
    readonly skus: readonly Sku[],
    private readonly shared: Shared,
    private readonly changed: () => void,
  ) {
    this.standIns = new StandIns(table, skus, shared);
    this.group.add(this.standIns.mesh);
    this.shown = table.cells.map((cell, number) => ({
      number,
      cell,
      box: new Box3(new Vector3(...cell.low), new Vector3(...cell.high)),
      built: new Map(),
      distance: 0,
    }));
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
    const atlas = new PageArray(renderer, width, height, Math.max(sizes.length, 1), 4, limits.sharpness);
    const pictures = await Promise.all(sizes.map((_, page) => client.picture(`/goods-${page}.jpg`)));
    pictures.forEach((picture, page) => {
      atlas.put(page, 0, picture);
      picture.close();
    });
    atlas.makeSmallerCopies();

    const sheets = new PageArray(renderer, 1024, 512, limits.sheetLayers, 11, limits.sharpness);
    const uniforms: Record<string, IUniform> = {
      skus: { value: places.texture },
      atlas: { value: atlas.texture },
      sheets: { value: sheets.texture },
    };
    this.standIns.setPortraits(await drawPortraits(renderer, far, this.skus.length, places, atlas.texture));
    this.sheets = new Sheets(client, sheets, places, this.changed);
    this.materials = [packMaterial(this.shared, uniforms, false), packMaterial(this.shared, uniforms, true)];
    this.far = far;
    this.changed();
  }

  setMiddle(packed: Packed<MeshesHead>): void {
    this.middle = new MeshSet(packed);
    this.changed();
  }

  // Chooses what is seen from the camera. False: more is to be built; call again in the next frame.
  update(camera: Camera, eye: Vector3): boolean {
    this.frustum.setFromProjectionMatrix(new Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse));
    for (const shown of this.shown) shown.distance = shown.box.distanceToPoint(eye);
    const byDistance = [...this.shown].sort((a, b) => a.distance - b.distance);
    let missing: { shown: Shown; detail: Detail } | undefined;
    this.hideMeshes();
    this.standIns.begin();
    let order = 0;
    for (const shown of byDistance) {
      if (!this.frustum.intersectsBox(shown.box) || !this.facesEye(shown, eye)) continue;
      const detail = this.detailOf(shown);
      const best = detail && (shown.built.get(detail) ?? shown.built.get("far"));
      if (detail && !shown.built.has(detail)) missing ??= { shown, detail };
      if (best) this.show(best, ++order);
      this.standIns.add(shown.number, best ? shown.cell.deep : shown.cell.first, eye);
    }
    this.standIns.finish();
    if (missing) this.build(missing.shown, missing.detail);
    this.forget();
    this.wantLabels(byDistance, eye);
    return missing === undefined;
  }

  private detailOf(shown: Shown): Detail | undefined {
    if (!this.far || !this.light || shown.distance > this.meshRadius) return undefined;
    return this.middle && shown.distance < Math.min(middleWithin, this.meshRadius / 2) ? "middle" : "far";
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
    for (const shown of this.shown) {
      for (const built of shown.built.values()) for (const mesh of built.meshes) mesh.visible = false;
    }
  }

  private show(cell: PackCell, order: number): void {
    this.triangles += cell.triangles;
    cell.meshes.forEach((mesh, i) => {
      mesh.visible = true;
      mesh.renderOrder = i === 0 ? -1000 + order : 1000 - order;
    });
  }

  private build(shown: Shown, detail: Detail): void {
    const { cell } = shown;
    const set = detail === "middle" ? this.middle! : this.far!;
    const rows = this.table.order.subarray(cell.first, cell.deep);
    const built = new PackCell(cell, rows, this.table, set, this.light!, this.materials!);
    shown.built.set(detail, built);
    for (const mesh of built.meshes) {
      mesh.visible = false;
      this.group.add(mesh);
    }
  }

  private forget(): void {
    for (const shown of this.shown) {
      for (const [detail, built] of shown.built) {
        const radius = detail === "middle" ? middleWithin : this.meshRadius;
        if (shown.distance <= radius * keptFor) continue;
        this.group.remove(...built.meshes);
        built.dispose();
        shown.built.delete(detail);
      }
    }
  }

  private wantLabels(byDistance: readonly Shown[], eye: Vector3): void {
    if (!this.sheets) return;
    const nearest = new Map<number, number>();
    const { position, order, sku } = this.table;
    for (const shown of byDistance) {
      if (shown.distance > labelsWithin) break;
      if (!this.facesEye(shown, eye) || !this.frustum.intersectsBox(shown.box)) continue;
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

  // Frames that take long show meshes in a smaller radius.
  adapt(milliseconds: number, goal: number): void {
    if (milliseconds > goal * 1.25) this.meshRadius = Math.max(this.meshRadius * 0.94, nearestMeshes);
    else if (milliseconds < goal * 0.7) this.meshRadius = Math.min(this.meshRadius * 1.03, farthestMeshes);
  }
}
