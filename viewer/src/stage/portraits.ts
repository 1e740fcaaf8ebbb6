// Pictures of every pack from the front, the right and above, drawn once from the far meshes: what the stand-ins wear.
import {
  BufferAttribute,
  BufferGeometry,
  Color,
  LinearFilter,
  LinearMipmapLinearFilter,
  LinearMipmapNearestFilter,
  Mesh,
  OrthographicCamera,
  WebGLRenderTarget,
  type RawShaderMaterial,
  type Texture,
  type WebGLRenderer,
} from "three";
import { coverage, type MeshSet } from "./mesh_set";
import { portraitMaterial } from "./shading";
import { Form, type Portraits } from "./stand_ins";
import type { SkuPlaces } from "./sku_places";

const cellWidth = 32;
const cellHeight = 64;
const across = 64;
const margin = 1.5 / cellWidth; // kept free round a picture; the stand-ins' shader leaves it out again
const marginV = 1.5 / cellHeight;
const batch = 128; // SKUs a draw

// Axes of the three views: what goes right, what goes up, what comes towards the eye.
const views: readonly { right: 0 | 1; up: 1 | 2; near: 0 | 1 | 2; toward: 1 | -1 }[] = [
  { right: 0, up: 2, near: 1, toward: -1 },
  { right: 1, up: 2, near: 0, toward: 1 },
  { right: 0, up: 1, near: 2, toward: 1 },
];

interface Extent {
  low: [number, number, number];
  high: [number, number, number];
}

function extentOf(set: MeshSet, first: number, count: number): Extent {
  const extent: Extent = { low: [Infinity, Infinity, Infinity], high: [-Infinity, -Infinity, -Infinity] };
  for (let i = first; i < first + count; i++) {
    for (let k = 0; k < 3; k++) {
      const x = set.position[i * 3 + k]!;
      extent.low[k] = Math.min(extent.low[k]!, x);
      extent.high[k] = Math.max(extent.high[k]!, x);
    }
  }
  return extent;
}

// Round: a can, a bottle, an apple; seen from above a disc as wide as deep. Solid: a carton, whose pictures have no holes.
function formOf(set: MeshSet, sku: number): Form {
  const { firstVertex, vertices } = set.range(sku);
  if (vertices === 0) return Form.solid;
  const [above, front, right] = [coverage(set, sku, 0, 1), coverage(set, sku, 0, 2), coverage(set, sku, 1, 2)];
  if (Math.min(above, front, right) > 0.96) return Form.solid;
  if (above > 0.88) return Form.cut;
  const { low, high } = extentOf(set, firstVertex, vertices);
  const [w, d] = [high[0] - low[0], high[1] - low[1]];
  return Math.min(w, d) / Math.max(w, d) < 0.8 ? Form.cut : Form.round;
}

function geometryOf(set: MeshSet, from: number, end: number, rows: number, places: SkuPlaces): BufferGeometry {
  let [vertices, indices] = [0, 0];
  for (let sku = from; sku < end; sku++) {
    const range = set.range(sku);
    vertices += range.vertices * views.length;
    indices += range.vertices > 0 ? (range.opaque + range.clear) * views.length : 0;
  }
  const position = new Float32Array(vertices * 3);
  const uv = new Float32Array(vertices * 2);
  const color = new Uint8Array(vertices * 4);
  const page = new Float32Array(vertices);
  const index = new Uint32Array(indices);
  let [v, filled] = [0, 0];
  for (let sku = from; sku < end; sku++) {
    const range = set.range(sku);
    if (range.vertices === 0) continue;
    const { low, high } = extentOf(set, range.firstVertex, range.vertices);
    const size = [0, 1, 2].map((k) => Math.max(high[k]! - low[k]!, 1e-6)) as [number, number, number];
    const tile = places.tile(sku);
    views.forEach((view, number) => {
      const cell = sku * views.length + number;
      const left = cell % across;
      const top = Math.floor(cell / across);
      const first = v;
      for (let i = range.firstVertex; i < range.firstVertex + range.vertices; i++, v++) {
        const share = (axis: 0 | 1 | 2): number => (set.position[i * 3 + axis]! - low[axis]) / size[axis];
        const near = view.toward > 0 ? share(view.near) : 1 - share(view.near);
        position[v * 3] = (2 * (left + margin + (1 - 2 * margin) * share(view.right))) / across - 1;
        position[v * 3 + 1] = (2 * (top + marginV + (1 - 2 * marginV) * share(view.up))) / rows - 1;
        position[v * 3 + 2] = 0.9 - 1.8 * near;
        uv[v * 2] = tile.u + set.uv[i * 2]! * tile.width;
        uv[v * 2 + 1] = tile.v + set.uv[i * 2 + 1]! * tile.height;
        for (let c = 0; c < 4; c++) color[v * 4 + c] = set.color[i * 4 + c]!;
        page[v] = set.color[i * 4 + 3]! > 127 ? tile.page : -1;
      }
      const last = range.firstIndex + range.opaque + range.clear;
      for (let i = range.firstIndex; i < last; i++) index[filled++] = set.index[i]! - range.firstVertex + first;
    });
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(position, 3));
  geometry.setAttribute("uv", new BufferAttribute(uv, 2));
  geometry.setAttribute("color", new BufferAttribute(color, 4, true));
  geometry.setAttribute("page", new BufferAttribute(page, 1));
  geometry.setIndex(new BufferAttribute(index, 1));
  return geometry;
}

function draw(renderer: WebGLRenderer, target: WebGLRenderTarget, geometry: BufferGeometry, material: RawShaderMaterial): void {
  const mesh = new Mesh(geometry, material);
  mesh.frustumCulled = false;
  renderer.setRenderTarget(target);
  renderer.render(mesh, new OrthographicCamera());
  renderer.setRenderTarget(null);
  geometry.dispose();
}

// Resolves after a few frames: between two draws the page lives on.
export async function drawPortraits(renderer: WebGLRenderer, set: MeshSet, skus: number, places: SkuPlaces, atlas: Texture, quick: boolean): Promise<Portraits> {
  const rows = 2 ** Math.ceil(Math.log2(Math.max(Math.ceil((skus * 3) / across), 1)));
  const target = new WebGLRenderTarget(across * cellWidth, rows * cellHeight, {
    minFilter: quick ? LinearMipmapNearestFilter : LinearMipmapLinearFilter,
    magFilter: LinearFilter,
    generateMipmaps: false,
    depthBuffer: true,
  });
  const background = new Color();
  renderer.getClearColor(background);
  const alpha = renderer.getClearAlpha();
  const material = portraitMaterial({ atlas: { value: atlas } });
  const forms = new Uint8Array(skus);
  for (let from = 0; from < skus; from += batch) {
    const end = Math.min(from + batch, skus);
    for (let sku = from; sku < end; sku++) forms[sku] = formOf(set, sku);
    const geometry = geometryOf(set, from, end, rows, places);
    target.texture.generateMipmaps = end === skus;
    renderer.autoClear = from === 0;
    renderer.setClearColor(0x000000, 0);
    draw(renderer, target, geometry, material);
    renderer.autoClear = true;
    renderer.setClearColor(background, alpha);
    if (end < skus) await new Promise((done) => setTimeout(done));
  }
  material.dispose();
  return { texture: target.texture, cells: [across, rows], cellTexels: [cellWidth, cellHeight], forms };
}
