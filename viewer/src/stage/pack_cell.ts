// One cell's packs merged into one mesh in the store frame, with the stored light at the vertices.
import { BufferAttribute, BufferGeometry, Box3, Mesh, Sphere, Vector3, type RawShaderMaterial } from "three";
import { lightOn, type GoodsLight } from "./goods_light";
import { rotationOf, type Cell, type GoodsTable } from "./goods_table";
import type { MeshSet } from "./mesh_set";

interface Buffers {
  position: Float32Array;
  uv: Uint16Array;
  color: Uint8Array;
  light: Uint8Array;
  sku: Uint16Array;
  opaque: Uint32Array;
  clear: Uint32Array;
}

// Factors of linear light as factors of sRGB bytes.
const encodedFactor = Float32Array.from({ length: 256 }, (_, byte) => (byte / 200) ** (1 / 2.2));

export class PackCell {
  readonly meshes: Mesh[] = [];
  readonly triangles: number;

  constructor(cell: Cell, rows: Uint32Array, table: GoodsTable, set: MeshSet, light: GoodsLight, materials: readonly [RawShaderMaterial, RawShaderMaterial]) {
    const buffers = allocate(rows, table, set);
    let vertex = 0;
    let opaque = 0;
    let clear = 0;
    for (const row of rows) {
      const range = set.range(table.sku[row]!);
      writeVertices(row, range.firstVertex, range.vertices, vertex, table, set, light, buffers);
      const shift = vertex - range.firstVertex;
      const middle = range.firstIndex + range.opaque;
      for (let i = range.firstIndex; i < middle; i++) buffers.opaque[opaque++] = set.index[i]! + shift;
      for (let i = middle; i < middle + range.clear; i++) buffers.clear[clear++] = set.index[i]! + shift;
      vertex += range.vertices;
    }
    this.triangles = (opaque + clear) / 3;
    const box = new Box3(new Vector3(...cell.low), new Vector3(...cell.high));
    const attributes = attributesOf(buffers);
    [buffers.opaque, buffers.clear].forEach((index, i) => {
      if (index.length > 0) this.meshes.push(meshOf(attributes, index, box, materials[i]!, i === 1));
    });
  }

  dispose(): void {
    for (const mesh of this.meshes) mesh.geometry.dispose();
  }
}

function allocate(rows: Uint32Array, table: GoodsTable, set: MeshSet): Buffers {
  let [vertices, opaque, clear] = [0, 0, 0];
  for (const row of rows) {
    const range = set.range(table.sku[row]!);
    vertices += range.vertices;
    opaque += range.opaque;
    clear += range.clear;
  }
  return {
    position: new Float32Array(vertices * 3),
    uv: new Uint16Array(vertices * 2),
    color: new Uint8Array(vertices * 4),
    light: new Uint8Array(vertices * 4),
    sku: new Uint16Array(vertices),
    opaque: new Uint32Array(opaque),
    clear: new Uint32Array(clear),
  };
}

function writeVertices(row: number, from: number, count: number, to: number, table: GoodsTable, set: MeshSet, light: GoodsLight, out: Buffers): void {
  const [x, y, z, w] = rotationOf(table, row);
  const px = table.position[row * 3]!;
  const py = table.position[row * 3 + 1]!;
  const pz = table.position[row * 3 + 2]!;
  // The rotation as a matrix.
  const [m00, m01, m02] = [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)];
  const [m10, m11, m12] = [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)];
  const [m20, m21, m22] = [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)];
  const tint = [0, 1, 2].map((k) => encodedFactor[table.tint[row * 3 + k]!]!);
  out.sku.fill(table.sku[row]!, to, to + count);
  for (let k = 0; k < count; k++) {
    const i = from + k;
    const o = to + k;
    const [vx, vy, vz] = [set.position[i * 3]!, set.position[i * 3 + 1]!, set.position[i * 3 + 2]!];
    out.position[o * 3] = m00 * vx + m01 * vy + m02 * vz + px;
    out.position[o * 3 + 1] = m10 * vx + m11 * vy + m12 * vz + py;
    out.position[o * 3 + 2] = m20 * vx + m21 * vy + m22 * vz + pz;
    const [nx, ny, nz] = [set.normal[i * 4]! / 127, set.normal[i * 4 + 1]! / 127, set.normal[i * 4 + 2]! / 127];
    lightOn(light, row, m00 * nx + m01 * ny + m02 * nz, m10 * nx + m11 * ny + m12 * nz, m20 * nx + m21 * ny + m22 * nz, out.light, o * 4);
    out.uv[o * 2] = Math.min(Math.max(set.uv[i * 2]!, 0), 1) * 65535;
    out.uv[o * 2 + 1] = Math.min(Math.max(set.uv[i * 2 + 1]!, 0), 1) * 65535;
    for (let c = 0; c < 3; c++) out.color[o * 4 + c] = Math.min(set.color[i * 4 + c]! * tint[c]!, 255);
    out.color[o * 4 + 3] = set.color[i * 4 + 3]!;
  }
}

function attributesOf(buffers: Buffers): Record<string, BufferAttribute> {
  return {
    position: new BufferAttribute(buffers.position, 3),
    uv: new BufferAttribute(buffers.uv, 2, true),
    color: new BufferAttribute(buffers.color, 4, true),
    light: new BufferAttribute(buffers.light, 4, true),
    sku: new BufferAttribute(buffers.sku, 1, false),
  };
}

function meshOf(attributes: Record<string, BufferAttribute>, index: Uint32Array, box: Box3, material: RawShaderMaterial, clear: boolean): Mesh {
  const geometry = new BufferGeometry();
  for (const [name, attribute] of Object.entries(attributes)) geometry.setAttribute(name, attribute);
  geometry.setIndex(new BufferAttribute(index, 1));
  geometry.boundingBox = box;
  geometry.boundingSphere = box.getBoundingSphere(new Sphere());
  const mesh = new Mesh(geometry, material);
  mesh.matrixAutoUpdate = false;
  if (clear) mesh.renderOrder = 30;
  return mesh;
}
