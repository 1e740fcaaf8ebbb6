// Whether two pictures of one camera have their edges at the same places. Pictures: grey bytes, row by row from above.

// Sobel's gradient: how strongly the tone changes at each pixel.
export function gradient({ grey, width, height }) {
  const strength = new Float32Array(width * height);
  for (let y = 1; y < height - 1; y++) {
    for (let x = 1; x < width - 1; x++) {
      const i = y * width + x;
      const at = (dx, dy) => grey[i + dy * width + dx];
      const across = at(1, -1) + 2 * at(1, 0) + at(1, 1) - at(-1, -1) - 2 * at(-1, 0) - at(-1, 1);
      const down = at(-1, 1) + 2 * at(0, 1) + at(1, 1) - at(-1, -1) - 2 * at(0, -1) - at(1, -1);
      strength[i] = Math.hypot(across, down);
    }
  }
  return { strength, width, height };
}

// The pixels with the strongest gradient, so large a share of all.
export function strongest({ strength }, share) {
  const least = Float32Array.from(strength).sort()[Math.floor(strength.length * (1 - share))];
  return Uint8Array.from(strength, (s) => (s > 0 && s >= least ? 1 : 0));
}

// Of the edges of one picture, the share that has an edge of the other within so many pixels; `off`: with the other one moved.
export function shareWithin(edges, others, { width, height }, pixels, off = 0) {
  let [met, all] = [0, 0];
  const reach = Math.ceil(pixels);
  for (let y = reach; y < height - reach; y++) {
    for (let x = reach + off; x < width - reach - off; x++) {
      if (edges[y * width + x] === 0) continue;
      all++;
      met += isNear(others, width, x + off, y, pixels, reach) ? 1 : 0;
    }
  }
  return met / all;
}

function isNear(others, width, x, y, pixels, reach) {
  for (let dy = -reach; dy <= reach; dy++) {
    for (let dx = -reach; dx <= reach; dx++) if (dx * dx + dy * dy <= pixels * pixels && others[(y + dy) * width + x + dx] === 1) return true;
  }
  return false;
}

// By how much the second picture has to be moved so that the gradients agree best, in pixels; in a part of the picture.
export function shiftOf(first, second, far, part = { left: 0, top: 0, right: first.width, bottom: first.height }) {
  const cap = 400; // one glaring edge is not to speak for all
  const { width, height } = first;
  let best = { worth: -1, across: 0, down: 0 };
  for (let down = -far; down <= far; down++) {
    for (let across = -far; across <= far; across++) {
      let worth = 0;
      for (let y = Math.max(part.top, far); y < Math.min(part.bottom, height - far); y++) {
        for (let x = Math.max(part.left, far); x < Math.min(part.right, width - far); x++) {
          worth += Math.min(first.strength[y * width + x], cap) * Math.min(second.strength[(y + down) * width + x + across], cap);
        }
      }
      if (worth > best.worth) best = { worth, across, down };
    }
  }
  return best;
}

// Of each tile of the picture that has edges enough.
export function shiftsOfTiles(first, second, edges, far, columns = 4, rows = 3, least = 1500) {
  const { width, height } = first;
  const shifts = [];
  for (let row = 0; row < rows; row++) {
    for (let column = 0; column < columns; column++) {
      const part = { left: Math.round((column * width) / columns), right: Math.round(((column + 1) * width) / columns), top: Math.round((row * height) / rows), bottom: Math.round(((row + 1) * height) / rows) };
      let count = 0;
      for (let y = part.top; y < part.bottom; y++) for (let x = part.left; x < part.right; x++) count += edges[y * width + x];
      if (count >= least) shifts.push({ column, row, ...shiftOf(first, second, far, part) });
    }
  }
  return shifts;
}
