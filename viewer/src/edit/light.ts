// Light for what an edit has put somewhere: the mean of what the renderer has stored nearest to it. A light of its own is baked when the
// edited store is saved and opened.
const cell = 0.5; // metres
const reach = 6; // cells to look round in
const offset = 512; // cells: a store is at most 200 m wide, and some of it may lie below 0

// Means of rows of bytes, by place and by a kind that places do not mix (which way a surface looks).
export class NearLight {
  private readonly sums = new Map<number, Float64Array>(); // the bytes, and how many rows
  private readonly all = new Map<number, Float64Array>(); // by kind
  private readonly means = new Map<number, Uint8Array | undefined>(); // that were asked for, by place and kind

  constructor(
    private readonly kinds: number,
    private readonly bytes: number,
  ) {}

  add(x: number, y: number, z: number, kind: number, light: Uint8Array, at: number): void {
    if (this.means.size > 0) this.means.clear();
    this.into(this.sums, this.key(this.column(x), this.column(y), this.column(z), kind), light, at);
    this.into(this.all, kind, light, at);
  }

  // Writes the light at a place to `out[o]` and on; nothing where none is known at all.
  read(x: number, y: number, z: number, kind: number, out: Uint8Array, o: number): void {
    const [column, line, layer] = [this.column(x), this.column(y), this.column(z)];
    const key = this.key(column, line, layer, kind);
    let mean = this.means.get(key);
    if (!mean && !this.means.has(key)) this.means.set(key, (mean = this.meanOf(this.nearest(column, line, layer, kind) ?? this.all.get(kind))));
    if (mean) for (let k = 0; k < this.bytes; k++) out[o + k] = mean[k]!;
  }

  private meanOf(sum: Float64Array | undefined): Uint8Array | undefined {
    return sum && Uint8Array.from({ length: this.bytes }, (_, k) => Math.round(sum[k]! / sum[this.bytes]!));
  }

  private nearest(x: number, y: number, z: number, kind: number): Float64Array | undefined {
    for (let ring = 0; ring <= reach; ring++) {
      const sum = new Float64Array(this.bytes + 1);
      for (let dx = -ring; dx <= ring; dx++) {
        for (let dy = -ring; dy <= ring; dy++) {
          if (Math.max(Math.abs(dx), Math.abs(dy)) !== ring) continue;
          const found = this.sums.get(this.key(x + dx, y + dy, z, kind));
          if (found) for (let k = 0; k <= this.bytes; k++) sum[k]! += found[k]!;
        }
      }
      if (sum[this.bytes]! > 0) return sum;
    }
    return undefined;
  }

  private into(sums: Map<number, Float64Array>, key: number, light: Uint8Array, at: number): void {
    let sum = sums.get(key);
    if (!sum) sums.set(key, (sum = new Float64Array(this.bytes + 1)));
    for (let k = 0; k < this.bytes; k++) sum[k]! += light[at + k]!;
    sum[this.bytes]! += 1;
  }

  private column(x: number): number {
    return Math.floor(x / cell) + offset;
  }

  private key(x: number, y: number, z: number, kind: number): number {
    return ((x * 2048 + y) * 2048 + z) * this.kinds + kind;
  }
}

// Which of the six directions a normal (bytes, 127 = 1) is nearest to.
export function wayOf(x: number, y: number, z: number): number {
  const [ax, ay, az] = [Math.abs(x), Math.abs(y), Math.abs(z)];
  if (ax >= ay && ax >= az) return x > 0 ? 0 : 1;
  if (ay >= az) return y > 0 ? 2 : 3;
  return z > 0 ? 4 : 5;
}
