// A store as one walks in it: its outline, and what stands in the way.
import type { Summary } from "../store/contract";
import type { Room } from "./navigator";

const hangsAbove = 1.9; // metres: fixtures that hang so high are walked under

export function roomOf(summary: Summary): Room {
  const obstacles = summary.fixtures
    .filter((fixture) => fixture.position_m[2] < hangsAbove && fixture.size_m[2] > 0.05)
    .map((fixture) => ({
      center: [fixture.position_m[0], fixture.position_m[1]] as const,
      half: [fixture.size_m[0] / 2, fixture.size_m[1] / 2] as const,
      yaw: (fixture.yaw_deg * Math.PI) / 180,
    }));
  const outline = summary.outline_mm.map(([x, y]) => [x / 1000, y / 1000] as const);
  return { low: summary.bounds.low_m, high: summary.bounds.high_m, outline, obstacles };
}
