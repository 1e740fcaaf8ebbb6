// The time of a replay: it runs as fast as is wished, whatever the pictures take.
export const speeds = [0.25, 0.5, 1, 2, 4, 8] as const;

export class Clock {
  playing = false;
  speed = 1;
  private at = 0; // seconds

  // Steps 0 .. steps - 1, `stepSeconds` apart.
  constructor(
    readonly steps: number,
    readonly stepSeconds: number,
  ) {}

  get seconds(): number {
    return this.at;
  }
  get end(): number {
    return (this.steps - 1) * this.stepSeconds;
  }
  // With its fraction.
  get step(): number {
    return Math.min(this.at / this.stepSeconds, this.steps - 1);
  }
  get atEnd(): boolean {
    return this.at >= this.end;
  }

  // True when the time has changed. It stops at the end.
  advance(wallSeconds: number): boolean {
    if (!this.playing) return false;
    this.at = Math.min(this.at + wallSeconds * this.speed, this.end);
    if (this.atEnd) this.playing = false;
    return true;
  }

  // From the end it begins anew.
  toggle(): void {
    if (!this.playing && this.atEnd) this.at = 0;
    this.playing = !this.playing && this.end > 0;
  }

  seek(step: number): void {
    this.at = Math.min(Math.max(step, 0), this.steps - 1) * this.stepSeconds;
  }

  // To the next whole step, or the one before.
  nudge(by: 1 | -1): void {
    this.playing = false;
    const step = this.at / this.stepSeconds;
    this.seek(by > 0 ? Math.floor(step + 1e-6) + 1 : Math.ceil(step - 1e-6) - 1);
  }

  // One of the speeds faster or slower.
  change(by: 1 | -1): void {
    const now = speeds.findIndex((speed) => speed >= this.speed);
    this.speed = speeds[Math.min(Math.max(now + by, 0), speeds.length - 1)]!;
  }
}
