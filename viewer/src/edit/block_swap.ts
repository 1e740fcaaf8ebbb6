// Two blocks of products on a line of shelves that change places: which there are, and the patch that says it.
import type { Patch } from "./contract";

export interface RunBlock {
  readonly facing: number; // the page's goods have its number
  readonly fixture: string;
  readonly side: "front" | "back";
  readonly shelf: number;
  readonly position: number; // from the left
  readonly sku: string;
  readonly facings: number;
  readonly products: number; // 0: it is sold out
}

// `facings`: packs of `a` side by side in its new place; undefined: as many as now.
export function swapOf(a: RunBlock, b: RunBlock, facings?: number): Patch {
  const place = ({ fixture, side, shelf, position, sku }: RunBlock): object => ({ fixture, side, shelf, position, sku });
  return { swap_blocks: { a: { ...place(a), ...(facings !== undefined && { facings }) }, b: place(b) } };
}

// Shelves as a person looks at them: from above, each from the left. Blocks of both sides of a line are told apart by the caller.
export function byShelf(blocks: readonly RunBlock[]): (readonly [string, readonly RunBlock[]])[] {
  const shelves = new Map<string, RunBlock[]>();
  for (const block of blocks) {
    const key = `${block.fixture} · ${block.shelf}`;
    shelves.set(key, [...(shelves.get(key) ?? []), block]);
  }
  return [...shelves].sort(([, [a]], [, [b]]) => b!.shelf - a!.shelf || a!.fixture.localeCompare(b!.fixture, "en", { numeric: true }));
}
