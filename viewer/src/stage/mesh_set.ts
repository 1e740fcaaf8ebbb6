// The meshes of all SKUs in one detail, as the server sends them.
import type { MeshesHead } from "../store/contract";
import type { Packed } from "../store/packed";

export interface Range {
  readonly firstVertex: number;
  readonly vertices: number;
  readonly firstIndex: number;
  readonly opaque: number; // indices
  readonly clear: number; // behind the opaque ones
}

export class MeshSet {
  readonly position: Float32Array;
  readonly normal: Int8Array;
  readonly uv: Float32Array;
  readonly color: Uint8Array;
  readonly index: Uint32Array;
  private readonly ranges: Uint32Array;

  constructor(packed: Packed<MeshesHead>) {
    this.position = packed.f32("position", 3);
    this.normal = packed.i8("normal", 4);
    this.uv = packed.f32("uv", 2);
    this.color = packed.u8("color", 4);
    this.index = packed.u32("index", 1);
    this.ranges = packed.u32("range", 6);
  }

  // Of SKUs that came after the set was made: nothing.
  range(sku: number): Range {
    const r = this.ranges;
    const i = sku * 6;
    if (i >= r.length) return { firstVertex: 0, vertices: 0, firstIndex: 0, opaque: 0, clear: 0 };
    return { firstVertex: r[i]!, vertices: r[i + 1]!, firstIndex: r[i + 2]!, opaque: r[i + 3]!, clear: r[i + 4]! };
  }
}

// How much of the box round a pack its outline fills in the plane of two axes: about pi / 4 for what is round.
export function coverage(set: MeshSet, sku: number, u: 0 | 1, v: 1 | 2): number {
  const { firstIndex, opaque, clear, firstVertex, vertices } = set.range(sku);
  const p = set.position;
  let area = 0;
  for (let i = firstIndex; i < firstIndex + opaque + clear; i += 3) {
    const a = set.index[i]! * 3;
    const b = set.index[i + 1]! * 3;
    const c = set.index[i + 2]! * 3;
    const twice = (p[b + u]! - p[a + u]!) * (p[c + v]! - p[a + v]!) - (p[c + u]! - p[a + u]!) * (p[b + v]! - p[a + v]!);
    area += Math.abs(twice) / 2; // both sides of the pack: counted twice in all
  }
  let [lowU, highU, lowV, highV] = [Infinity, -Infinity, Infinity, -Infinity];
  for (let i = firstVertex; i < firstVertex + vertices; i++) {
    lowU = Math.min(lowU, p[i * 3 + u]!);
    highU = Math.max(highU, p[i * 3 + u]!);
    lowV = Math.min(lowV, p[i * 3 + v]!);
    highV = Math.max(highV, p[i * 3 + v]!);
  }
  const box = (highU - lowU) * (highV - lowV);
  return box > 0 ? area / 2 / box : 1;
}
