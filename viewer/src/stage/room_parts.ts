// The room's triangles by what they belong to (a fixture, or a piece of the shell), in four finenesses: far off, what the server has cut
// for the light along it is joined again, and what is smaller than a few pixels is drawn together. Runs of indices, to be copied into
// what is drawn.
export interface RoomSource {
  readonly position: Float32Array;
  readonly normal: Int8Array; // 4 a vertex
  readonly color: Uint8Array; // 4 a vertex
  readonly index: Uint32Array;
  readonly owner: Uint16Array; // fixture, joint
}

export interface Run {
  readonly start: number;
  readonly end: number;
}

type Corner = readonly [number, number, number];

export interface Part {
  readonly surface: number; // which of the batches' materials
  fixture: number; // -1: the shell
  readonly joint: number; // that carries it; -1: none
  low: Corner;
  high: Corner;
  readonly runs: readonly Run[]; // in `indices` of each fineness
}

export const grains = [0, 0.01, 0.03, 0.1] as const; // metres that are one point
const edges = [0, 1.21, 2.41, 4.81] as const; // metres: pieces of one triangle are joined while no edge becomes longer
const shellPiece = 4; // metres
const none = 65535;

export interface Batch {
  readonly first: number;
  readonly count: number;
  readonly surface: number;
  readonly exact: boolean; // print: points keep their place on the picture
}

function pieceOf(source: RoomSource, vertex: number): number {
  const [fixture, joint] = [source.owner[vertex * 2]!, source.owner[vertex * 2 + 1]!];
  if (joint !== none) return 131072 + joint; // a door moves without the frame: they share no corners
  if (fixture !== none) return fixture;
  const column = (k: number): number => Math.floor(source.position[vertex * 3 + k]! / shellPiece) + 128;
  return 65536 + column(0) * 256 + column(1);
}

// The server halves a triangle's longest edge until all are short (view_mesh.cpp): the halves follow one another, and here they become
// one again. So neighbours still meet at the same corners.
class Joined {
  private readonly open: number[] = []; // corners of triangles that may be first halves

  constructor(
    private readonly position: Float32Array,
    private readonly longest: number,
  ) {}

  of(triangles: Uint32Array): number[] {
    const { open } = this;
    open.length = 0;
    for (let i = 0; i < triangles.length; i += 3) {
      open.push(triangles[i]!, triangles[i + 1]!, triangles[i + 2]!);
      while (open.length >= 6 && this.join());
    }
    return open;
  }

  // The last two, where they are the halves of a triangle that is short enough.
  private join(): boolean {
    const { open } = this;
    const [first, second] = [open.length - 6, open.length - 3];
    for (let k = 0; k < 3; k++) {
      const next = (k + 1) % 3;
      const other = (k + 2) % 3;
      const [a, middle, b] = [open[first + k]!, open[first + next]!, open[second + next]!];
      if (open[second + k] !== middle || open[first + other] !== open[second + other]) continue;
      if (!this.isMiddle(middle, a, b) || this.between(a, b) > this.longest) continue;
      open.length = second;
      open[first + next] = b;
      return true;
    }
    return false;
  }

  private isMiddle(middle: number, a: number, b: number): boolean {
    const p = this.position;
    for (let k = 0; k < 3; k++) if (Math.abs(p[a * 3 + k]! + p[b * 3 + k]! - 2 * p[middle * 3 + k]!) > 1e-4) return false;
    return true;
  }

  private between(a: number, b: number): number {
    const p = this.position;
    return Math.hypot(p[a * 3]! - p[b * 3]!, p[a * 3 + 1]! - p[b * 3 + 1]!, p[a * 3 + 2]! - p[b * 3 + 2]!);
  }
}

// Draws together all points of a grain that face one way in one colour.
class Grains {
  private readonly cells: Float64Array; // by vertex, of the part and fineness at hand
  private readonly standIns: Uint32Array;
  private readonly stamp: Uint32Array; // which part and fineness that was
  private now = 0;
  private readonly first = new Map<number, number>();

  constructor(private readonly source: RoomSource) {
    const vertices = source.position.length / 3;
    this.cells = new Float64Array(vertices);
    this.standIns = new Uint32Array(vertices);
    this.stamp = new Uint32Array(vertices);
  }

  of(triangles: ArrayLike<number>, low: readonly number[], size: number, exact: boolean): number[] {
    const { cells, standIns } = this;
    this.now++;
    this.first.clear();
    const kept: number[] = [];
    for (let i = 0; i < triangles.length; i += 3) {
      const [a, b, c] = [triangles[i]!, triangles[i + 1]!, triangles[i + 2]!];
      this.place(a, low, size);
      this.place(b, low, size);
      this.place(c, low, size);
      if (cells[a] === cells[b] || cells[b] === cells[c] || cells[a] === cells[c]) continue;
      if (exact) kept.push(a, b, c);
      else kept.push(standIns[a]!, standIns[b]!, standIns[c]!);
    }
    return kept;
  }

  private place(vertex: number, low: readonly number[], size: number): void {
    if (this.stamp[vertex] === this.now) return;
    this.stamp[vertex] = this.now;
    const { position, normal, color } = this.source;
    const at = (k: number): number => Math.floor((position[vertex * 3 + k]! - low[k]!) / size);
    const cell = (this.cells[vertex] = at(0) + 2048 * (at(1) + 2048 * at(2)));
    const [x, y, z] = [normal[vertex * 4]!, normal[vertex * 4 + 1]!, normal[vertex * 4 + 2]!];
    const [ax, ay, az] = [Math.abs(x), Math.abs(y), Math.abs(z)];
    const way = ax >= ay && ax >= az ? (x > 0 ? 0 : 1) : ay >= az ? (y > 0 ? 2 : 3) : z > 0 ? 4 : 5;
    const tone = ((color[vertex * 4]! >> 5) << 6) | ((color[vertex * 4 + 1]! >> 5) << 3) | (color[vertex * 4 + 2]! >> 5);
    const key = (cell * 6 + way) * 512 + tone;
    const found = this.first.get(key);
    if (found === undefined) this.first.set(key, vertex);
    this.standIns[vertex] = found ?? vertex;
  }
}

export interface RoomParts {
  readonly parts: readonly Part[];
  readonly indices: readonly Uint32Array[]; // by fineness
  readonly surfaces: readonly number[]; // how many indices at most each surface shows
}

// Fixtures of one shape have the same triangles, from their first vertices on.
export interface Shaped {
  readonly shape: number;
  readonly vertex: number; // its first
}

interface PartSource {
  readonly batch: Batch;
  readonly triangles: Uint32Array;
}

function groupsOf(source: RoomSource, batches: readonly Batch[]): PartSource[] {
  const groups = new Map<number, { batch: Batch; triangles: number[] }>();
  for (const batch of batches) {
    for (let i = batch.first; i < batch.first + batch.count; i += 3) {
      const piece = pieceOf(source, source.index[i]!);
      const key = batch.surface * 262_144 + piece;
      let group = groups.get(key);
      if (!group) groups.set(key, (group = { batch, triangles: [] }));
      group.triangles.push(source.index[i]!, source.index[i + 1]!, source.index[i + 2]!);
    }
  }
  return [...groups.values()].map(({ batch, triangles }) => ({ batch, triangles: new Uint32Array(triangles) }));
}

// Where the triangles of each fixture lie together.
function stretchesOf({ index, owner }: RoomSource, batches: readonly Batch[]): PartSource[] {
  const stretches: PartSource[] = [];
  for (const batch of batches) {
    const end = batch.first + batch.count;
    for (let first = batch.first; first < end; ) {
      let next = first + 3;
      while (next < end && owner[index[next]! * 2] === owner[index[first]! * 2]) next += 3;
      stretches.push({ batch, triangles: index.subarray(first, next) });
      first = next;
    }
  }
  return stretches;
}

// Groups in turn: between two of them the page lives on.
export async function divideRoom(source: RoomSource, batches: readonly Batch[]): Promise<RoomParts> {
  const levels: number[][] = grains.map(() => []);
  const together = new Grains(source);
  const parts: Part[] = [];
  let worked = performance.now();
  for (const { batch, triangles } of groupsOf(source, batches)) {
    parts.push(partOf(source, batch, triangles, levels, together));
    if (performance.now() - worked < 12) continue;
    await new Promise((done) => setTimeout(done));
    worked = performance.now();
  }
  return joined(parts, levels);
}

// At once, each shape the first time that it stands somewhere. `shaped`: by fixture row; in each batch one fixture comes after another.
export function divideShapes(source: RoomSource, batches: readonly Batch[], shaped: ReadonlyMap<number, Shaped>): RoomParts {
  const levels: number[][] = grains.map(() => []);
  const together = new Grains(source);
  const known = new Map<string, { part: Part; vertex: number }>();
  const parts = stretchesOf(source, batches).map(({ batch, triangles }) => {
    const { shape, vertex } = shaped.get(source.owner[triangles[0]! * 2]!)!;
    const key = `${batch.surface} ${shape}`;
    const like = known.get(key);
    if (like) return copied(like.part, vertex - like.vertex, source, levels, triangles);
    const part = partOf(source, batch, triangles, levels, together);
    known.set(key, { part, vertex });
    return part;
  });
  return joined(parts, levels);
}

function copied(like: Part, shift: number, source: RoomSource, levels: readonly number[][], triangles: Uint32Array): Part {
  const runs = like.runs.map(({ start, end }, level): Run => {
    const into = levels[level]!;
    const from = into.length;
    for (let i = start; i < end; i++) into.push(into[i]! + shift);
    return { start: from, end: into.length };
  });
  return { ...like, fixture: source.owner[triangles[0]! * 2]!, ...boundsOf(source.position, triangles), runs };
}

function joined(parts: readonly Part[], levels: readonly number[][]): RoomParts {
  const surfaces: number[] = [];
  for (const { surface, runs } of parts) surfaces[surface] = (surfaces[surface] ?? 0) + runs[0]!.end - runs[0]!.start;
  return { parts, indices: levels.map((level) => new Uint32Array(level)), surfaces };
}

export function boundsOf(position: Float32Array, vertices: Uint32Array): { low: Corner; high: Corner } {
  const low: [number, number, number] = [Infinity, Infinity, Infinity];
  const high: [number, number, number] = [-Infinity, -Infinity, -Infinity];
  for (const vertex of vertices) {
    for (let k = 0; k < 3; k++) {
      low[k] = Math.min(low[k]!, position[vertex * 3 + k]!);
      high[k] = Math.max(high[k]!, position[vertex * 3 + k]!);
    }
  }
  return { low, high };
}

function partOf(source: RoomSource, batch: Batch, triangles: Uint32Array, levels: readonly number[][], together: Grains): Part {
  const { low, high } = boundsOf(source.position, triangles);
  const runs = grains.map((size, level): Run => {
    const into = levels[level]!;
    const start = into.length;
    const kept = size === 0 ? triangles : together.of(new Joined(source.position, edges[level]!).of(triangles), low, size, batch.exact);
    for (const vertex of kept) into.push(vertex);
    return { start, end: into.length };
  });
  const [fixture, joint] = [source.owner[triangles[0]! * 2]!, source.owner[triangles[0]! * 2 + 1]!].map((row) => (row === none ? -1 : row));
  return { surface: batch.surface, fixture: fixture!, joint: joint!, low, high, runs };
}
