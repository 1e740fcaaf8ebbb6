// How much is drawn into a picture: as much as this machine draws in time. Without a GPU triangles cost about as much as pixels do,
// so that both become fewer while one moves, and a walk begins with few; with one, only the meshes of packs follow.
export interface Effort {
  readonly pixels: number; // share in each direction
  readonly fineWithin: number; // metres in which the room is drawn as it is
  readonly plainFrom: number; // metres from which packs are shown by their fronts alone
  readonly meshes: number; // triangles of packs' meshes
  readonly quick: boolean; // far shelves by their first row's fronts
  readonly labels: boolean; // those of what is near are brought in
}

type Measures = Omit<Effort, "quick" | "labels">;
interface Span {
  readonly least: Measures;
  readonly most: Measures;
  readonly goal: number; // milliseconds a picture
}

const software: Span = {
  least: { pixels: 0.4, fineWithin: 0.3, plainFrom: 1.5, meshes: 0 },
  most: { pixels: 1, fineWithin: 4, plainFrom: 6, meshes: 60_000 },
  goal: 55,
};
const hardware: Span = {
  least: { pixels: 1, fineWithin: 2.5, plainFrom: 6, meshes: 12_000 },
  most: { pixels: 1, fineWithin: 6, plainFrom: 6, meshes: 1_500_000 },
  goal: 18,
};
const stillMeshes = { software: 110_000, hardware: 350_000 };
const start = { software: 0.1, hardware: 0.3 };
const smoothing = 0.3; // of the newest picture in the mean

function between(least: number, most: number, share: number): number {
  return least + (most - least) * share;
}

export class Pace {
  milliseconds = 0; // of the last pictures, smoothed; 0: none yet
  private share: number; // 0 least .. 1 most
  private readonly span: Span;

  constructor(private readonly withoutGpu: boolean) {
    this.span = withoutGpu ? software : hardware;
    this.share = withoutGpu ? start.software : start.hardware;
  }

  get moving(): Effort {
    const { least, most } = this.span;
    // Meshes are many more at the upper end: they grow with the square.
    return {
      pixels: between(least.pixels, most.pixels, Math.round(this.share * 6) / 6), // each step is a new picture buffer
      fineWithin: between(least.fineWithin, most.fineWithin, this.share),
      plainFrom: between(least.plainFrom, most.plainFrom, this.share),
      meshes: between(least.meshes, most.meshes, this.share ** 2),
      quick: this.withoutGpu,
      labels: !this.withoutGpu, // their copies into the picture's memory hold up a walk
    };
  }

  // Of a picture that stands still, which may take longer.
  get resting(): Effort {
    const meshes = this.withoutGpu ? stillMeshes.software : stillMeshes.hardware;
    return { ...hardware.most, meshes: Math.max(meshes, this.moving.meshes), quick: false, labels: true };
  }

  // One picture more while one moves: it took so long.
  took(milliseconds: number): void {
    this.milliseconds = this.milliseconds === 0 ? milliseconds : this.milliseconds * (1 - smoothing) + milliseconds * smoothing;
    const ratio = this.span.goal / this.milliseconds;
    if (ratio < 0.83) this.share = Math.max(this.share * Math.max(ratio, 0.6) - 0.005, 0);
    else if (ratio > 1.33) this.share = Math.min(this.share * 1.03 + 0.003, 1);
  }
}
