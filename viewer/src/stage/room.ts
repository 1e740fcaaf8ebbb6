// Floor, walls, ceiling, fixtures, signs and price tags: one draw call a batch of the server.
import { BufferAttribute, BufferGeometry, Box3, Group, Mesh, Sphere, Vector3, type RawShaderMaterial, type Texture } from "three";
import type { RoomHead } from "../store/contract";
import type { Packed } from "../store/packed";
import { roomMaterial, type Shared } from "./shading";

export interface RoomArrays {
  readonly position: Float32Array;
  readonly index: Uint32Array;
  readonly owner: Uint16Array; // fixture row, joint row; 65535: none
}

const layers = ["solid", "glass", "ceiling"] as const;

export class Room {
  readonly group = new Group();
  readonly arrays: RoomArrays;
  private readonly ceiling: Mesh[] = [];
  private readonly layerOf: Uint8Array; // by triangle
  private ceilingShown = true;
  private readonly byTexture = new Map<number, { mesh: Mesh; glass: boolean }[]>();
  private readonly materials = new Map<string, RawShaderMaterial>();

  constructor(
    packed: Packed<RoomHead>,
    private readonly shared: Shared,
  ) {
    this.arrays = { position: packed.f32("position", 3), index: packed.u32("index", 1), owner: packed.u16("owner", 2) };
    const attributes = {
      position: new BufferAttribute(this.arrays.position, 3),
      normal: new BufferAttribute(packed.i8("normal", 4), 4, true),
      uv: new BufferAttribute(packed.f32("uv", 2), 2),
      color: new BufferAttribute(packed.u8("color", 4), 4, true),
      light: new BufferAttribute(packed.u8("light", 4), 4, true),
      finish: new BufferAttribute(packed.u8("finish", 4), 4, true),
    };
    const index = new BufferAttribute(this.arrays.index, 1);
    this.layerOf = new Uint8Array(this.arrays.index.length / 3);
    for (const batch of packed.head.batches) {
      this.layerOf.fill(layers.indexOf(batch.layer), batch.first_index / 3, (batch.first_index + batch.index_count) / 3);
      const geometry = new BufferGeometry();
      for (const [name, attribute] of Object.entries(attributes)) geometry.setAttribute(name, attribute);
      geometry.setIndex(index);
      geometry.setDrawRange(batch.first_index, batch.index_count);
      geometry.boundingBox = new Box3(new Vector3(...batch.low_m), new Vector3(...batch.high_m));
      geometry.boundingSphere = geometry.boundingBox.getBoundingSphere(new Sphere());
      const glass = batch.layer === "glass";
      const mesh = new Mesh(geometry, this.materialOf(-1, null, glass));
      mesh.matrixAutoUpdate = false;
      if (glass) mesh.renderOrder = 2;
      if (batch.layer === "ceiling") this.ceiling.push(mesh);
      if (batch.texture >= 0) this.remember(batch.texture, mesh, glass);
      this.group.add(mesh);
    }
  }

  textures(): number[] {
    return [...this.byTexture.keys()];
  }

  setTexture(row: number, texture: Texture): void {
    for (const { mesh, glass } of this.byTexture.get(row) ?? []) mesh.material = this.materialOf(row, texture, glass);
  }

  showCeiling(show: boolean): void {
    this.ceilingShown = show;
    for (const mesh of this.ceiling) mesh.visible = show;
  }

  // Whether a ray passes a triangle: through glass, and through a ceiling that is not shown. `index`: its first.
  isPassed(index: number): boolean {
    const layer = this.layerOf[index / 3];
    return layer === 1 || (layer === 2 && !this.ceilingShown);
  }

  private remember(texture: number, mesh: Mesh, glass: boolean): void {
    const list = this.byTexture.get(texture) ?? [];
    list.push({ mesh, glass });
    this.byTexture.set(texture, list);
  }

  private materialOf(row: number, texture: Texture | null, glass: boolean): RawShaderMaterial {
    const key = `${row} ${glass}`;
    let material = this.materials.get(key);
    if (!material) this.materials.set(key, (material = roomMaterial(this.shared, texture, glass)));
    return material;
  }
}
