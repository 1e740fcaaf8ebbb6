// What moves in a replay: the robot's bodies, the basket, and the goods of the episode.
import { BufferAttribute, BufferGeometry, Group, Matrix4, Mesh, Quaternion as Turn, Vector3, type IUniform, type RawShaderMaterial, type Texture, type WebGLRenderer } from "three";
import type { Limits } from "../stage/goods";
import { MeshSet } from "../stage/mesh_set";
import { PageArray } from "../stage/page_array";
import type { Shared } from "../stage/shading";
import { SkuPlaces } from "../stage/sku_places";
import type { Client } from "../store/client";
import type { MeshesHead } from "../store/contract";
import type { Packed } from "../store/packed";
import { plainCube, type Cube } from "./actor_light";
import { actorMaterial } from "./actor_material";
import type { Place } from "./tracks";

const one = new Vector3(1, 1, 1);
const scratch = { at: new Vector3(), turn: new Turn(), matrix: new Matrix4() };

export function matrixOf({ position, rotation }: Place): Matrix4 {
  scratch.at.fromArray(position);
  scratch.turn.fromArray(rotation);
  return scratch.matrix.compose(scratch.at, scratch.turn, one);
}

// A mesh with a light of its own.
export class Actor {
  private readonly cube: IUniform<Vector3[]> = { value: Array.from({ length: 6 }, () => new Vector3()) };
  readonly mesh: Mesh;

  constructor(geometry: BufferGeometry, materials: (uniforms: Record<string, IUniform>) => RawShaderMaterial[]) {
    const made = materials({ cube: this.cube });
    this.mesh = new Mesh(geometry, made.length === 1 ? made[0]! : made);
    this.mesh.matrixAutoUpdate = false;
    this.mesh.frustumCulled = false;
    this.light(plainCube);
  }

  light(cube: Cube): void {
    this.cube.value.forEach((face, i) => face.fromArray(cube, i * 3));
  }

  place(place: Place): void {
    this.mesh.matrix.copy(matrixOf(place));
    this.mesh.matrixWorldNeedsUpdate = true;
  }

  get at(): readonly [number, number, number] {
    const e = this.mesh.matrix.elements;
    return [e[12]!, e[13]!, e[14]!];
  }
}

export class Actors {
  readonly group = new Group();
  readonly bodies: readonly Actor[]; // of the robot, then the basket if there is one

  constructor(
    robot: Packed<unknown>,
    private readonly shared: Shared,
  ) {
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(robot.f32("position", 3), 3));
    geometry.setAttribute("normal", new BufferAttribute(robot.i8("normal", 4), 4, true));
    geometry.setAttribute("color", new BufferAttribute(robot.u8("color", 4), 4, true));
    geometry.setIndex(new BufferAttribute(robot.u32("index", 1), 1));
    const range = robot.u32("range", 2);
    this.bodies = Array.from({ length: range.length / 2 }, (_, body) => {
      const actor = new Actor(part(geometry, [[range[body * 2]!, range[body * 2 + 1]!]]), (uniforms) => [actorMaterial(shared, uniforms)]);
      this.group.add(actor.mesh);
      return actor;
    });
  }

  // One for each of `meshes`, rows of the episode's shapes.
  async addGoods(client: Client, renderer: WebGLRenderer, limits: Limits, meshes: readonly number[]): Promise<Actor[]> {
    if (meshes.length === 0) return [];
    const packed = await client.packed<MeshesHead>("/meshes.bin");
    const set = new MeshSet(packed);
    const { geometry, atlas } = await labelled(packed, set, client, renderer, limits);
    return meshes.map((sku) => {
      const { firstIndex, opaque, clear } = set.range(sku);
      const wearing = part(geometry, [[firstIndex, opaque], [firstIndex + opaque, clear]]);
      const actor = new Actor(wearing, (uniforms) => {
        const all = { ...uniforms, atlas: { value: atlas } };
        return [actorMaterial(this.shared, all, ["LABELLED"]), actorMaterial(this.shared, all, ["LABELLED", "CLEAR"])];
      });
      this.group.add(actor.mesh);
      return actor;
    });
  }
}

// The same corners, of which so many indices are drawn: [first, count] a material.
function part(whole: BufferGeometry, runs: readonly (readonly [number, number])[]): BufferGeometry {
  const geometry = new BufferGeometry();
  for (const [name, attribute] of Object.entries(whole.attributes)) geometry.setAttribute(name, attribute);
  geometry.setIndex(whole.index);
  if (runs.length === 1) geometry.setDrawRange(...runs[0]!);
  else runs.forEach(([first, count], material) => count > 0 && geometry.addGroup(first, count, material));
  return geometry;
}

// Corners whose place on their page is known.
async function labelled(packed: Packed<MeshesHead>, set: MeshSet, client: Client, renderer: WebGLRenderer, limits: Limits): Promise<{ geometry: BufferGeometry; atlas: Texture }> {
  const sizes = packed.head.pages;
  const width = Math.max(1, ...sizes.map((page) => page.width));
  const height = Math.max(1, ...sizes.map((page) => page.height));
  const tiles = packed.f32("tile", 5);
  const places = new SkuPlaces(tiles, sizes.map((page) => [page.width / width, page.height / height]));
  const pages = new PageArray(renderer, width, height, Math.max(sizes.length, 1), 4, limits.sharpness, limits.quick);
  const pictures = await Promise.all(sizes.map((_, page) => client.picture(`/goods-${page}.jpg`)));
  pictures.forEach((picture, page) => {
    pages.put(page, 0, picture);
    picture.close();
  });
  pages.makeSmallerCopies();
  const uv = new Float32Array(set.uv.length);
  const page = new Float32Array(set.uv.length / 2).fill(-1);
  for (let sku = 0; sku < tiles.length / 5; sku++) {
    const tile = places.tile(sku);
    const { firstVertex, vertices } = set.range(sku);
    for (let v = firstVertex; v < firstVertex + vertices; v++) {
      uv[v * 2] = tile.u + set.uv[v * 2]! * tile.width;
      uv[v * 2 + 1] = tile.v + set.uv[v * 2 + 1]! * tile.height;
      page[v] = tile.page;
    }
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(set.position, 3));
  geometry.setAttribute("normal", new BufferAttribute(set.normal, 4, true));
  geometry.setAttribute("color", new BufferAttribute(set.color, 4, true));
  geometry.setAttribute("uv", new BufferAttribute(uv, 2));
  geometry.setAttribute("page", new BufferAttribute(page, 1));
  geometry.setIndex(new BufferAttribute(set.index, 1));
  return { geometry, atlas: pages.texture };
}
