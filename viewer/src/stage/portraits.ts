// Pictures of every pack from the front, the right and above, drawn once from the far meshes: what the stand-ins wear.
import { BufferAttribute, BufferGeometry, Color, ExternalTexture, Mesh, OrthographicCamera, WebGLRenderTarget, type Texture, type WebGLRenderer } from "three";
import { coverage, type MeshSet } from "./mesh_set";
import { portraitMaterial } from "./shading";
import { Form, type Portraits } from "./stand_ins";
import type { SkuPlaces } from "./sku_places";

const cellWidth = 32;
const cellHeight = 64;
const across = 64;
const margin = 1.5 / cellWidth; // kept free round a picture; the stand-ins' shader leaves it out again
const marginV = 1.5 / cellHeight;
const batch = 128; // SKUs a draw: whole rows of cells
const batchRows = (batch * 3) / across;

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

function geometryOf(set: MeshSet, from: number, end: number, places: SkuPlaces): BufferGeometry {
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
      const cell = (sku - from) * views.length + number;
      const left = cell % across;
      const top = Math.floor(cell / across);
      const first = v;
      for (let i = range.firstVertex; i < range.firstVertex + range.vertices; i++, v++) {
        const share = (axis: 0 | 1 | 2): number => (set.position[i * 3 + axis]! - low[axis]) / size[axis];
        const near = view.toward > 0 ? share(view.near) : 1 - share(view.near);
        position[v * 3] = (2 * (left + margin + (1 - 2 * margin) * share(view.right))) / across - 1;
        position[v * 3 + 1] = (2 * (top + marginV + (1 - 2 * marginV) * share(view.up))) / batchRows - 1;
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

// The pictures together. They are drawn a batch at a time, so that only one of those needs room for depth.
class Sheet {
  readonly texture: Texture;
  private readonly gl: WebGL2RenderingContext;
  private readonly handle: WebGLTexture;
  private readonly target = new WebGLRenderTarget(across * cellWidth, batchRows * cellHeight, { depthBuffer: true });
  private readonly width = across * cellWidth;

  constructor(
    private readonly renderer: WebGLRenderer,
    private readonly rows: number,
    quick: boolean,
  ) {
    const gl = (this.gl = renderer.getContext() as WebGL2RenderingContext);
    const height = rows * cellHeight;
    this.handle = gl.createTexture();
    this.bound(() => {
      gl.texStorage2D(gl.TEXTURE_2D, 1 + Math.floor(Math.log2(Math.max(this.width, height))), gl.RGBA8, this.width, height);
      gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, quick ? gl.LINEAR_MIPMAP_NEAREST : gl.LINEAR_MIPMAP_LINEAR);
      gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.LINEAR);
      gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);
      gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
    });
    this.texture = new ExternalTexture(this.handle);
  }

  // From that row of cells on.
  draw(mesh: Mesh, firstRow: number): void {
    const { renderer, gl } = this;
    const background = renderer.getClearColor(new Color());
    const alpha = renderer.getClearAlpha();
    renderer.setClearColor(0x000000, 0);
    renderer.setRenderTarget(this.target);
    renderer.render(mesh, new OrthographicCamera());
    const rows = Math.min(batchRows, this.rows - firstRow);
    this.bound(() => gl.copyTexSubImage2D(gl.TEXTURE_2D, 0, 0, firstRow * cellHeight, 0, 0, this.width, rows * cellHeight));
    renderer.setRenderTarget(null);
    renderer.setClearColor(background, alpha);
  }

  finish(): void {
    this.bound(() => this.gl.generateMipmap(this.gl.TEXTURE_2D));
    this.renderer.resetState();
    this.target.dispose();
  }

  private bound(work: () => void): void {
    const gl = this.gl;
    this.renderer.state.activeTexture(gl.TEXTURE0);
    this.renderer.state.bindTexture(gl.TEXTURE_2D, this.handle);
    work();
    this.renderer.state.unbindTexture();
  }
}

// Resolves after a few frames: between two draws the page lives on.
export async function drawPortraits(renderer: WebGLRenderer, set: MeshSet, skus: number, places: SkuPlaces, atlas: Texture, quick: boolean): Promise<Portraits> {
  const rows = Math.max(Math.ceil((skus * views.length) / across), 1);
  const sheet = new Sheet(renderer, rows, quick);
  const material = portraitMaterial({ atlas: { value: atlas } });
  const forms = new Uint8Array(skus);
  for (let from = 0; from < skus; from += batch) {
    const end = Math.min(from + batch, skus);
    for (let sku = from; sku < end; sku++) forms[sku] = formOf(set, sku);
    const mesh = new Mesh(geometryOf(set, from, end, places), material);
    mesh.frustumCulled = false;
    sheet.draw(mesh, (from * views.length) / across);
    mesh.geometry.dispose();
    if (end < skus) await new Promise((done) => setTimeout(done));
  }
  sheet.finish();
  material.dispose();
  return { texture: sheet.texture, cells: [across, rows], cellTexels: [cellWidth, cellHeight], forms };
}
