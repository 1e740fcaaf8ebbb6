// Zones, aisles and broken rules in the picture: what is drawn, and the words on it.
import type { Vec3 } from "../camera/vector";
import type { Stage } from "../stage/stage";
import type { LayerName } from "../state/layers";
import type { Summary } from "../store/contract";
import type { Marks } from "./marks";
import type { Speech } from "./speech";

export function drawLayers(layers: ReadonlySet<LayerName>, summary: Summary, stage: Stage, marks: Marks, speech: Speech): void {
  const shown = <T>(layer: LayerName, all: readonly T[]): readonly T[] => (layers.has(layer) ? all : []);
  const zones = shown("zones", summary.zones);
  const aisles = shown("aisles", summary.aisles);
  const violations = shown("violations", summary.violations);
  stage.overlays?.showZones(zones);
  stage.overlays?.showAisles(aisles);
  stage.overlays?.showViolations(violations);
  const metres = (mm: number): string => speech.say("metres", { value: speech.number(mm / 1000, 2) });
  marks.set("zones", zones.map((zone) => ({ text: zone.label, at: middleOf(zone.polygon_mm, 1.5), kind: "zone" })));
  marks.set("aisles", aisles.map((aisle) => ({ text: metres(aisle.width_mm), at: middleOf(aisle.polygon_mm, 0.05), kind: "aisle" })));
  const placed = violations.flatMap(({ message, at_mm }) => (at_mm ? [{ text: message, at: [at_mm[0] / 1000, at_mm[1] / 1000, 2.3] as const, kind: "violation" as const }] : []));
  marks.set("violations", placed);
  stage.redraw();
}

function middleOf(polygon: readonly (readonly [number, number])[], height: number): Vec3 {
  const xs = polygon.map(([x]) => x / 1000);
  const ys = polygon.map(([, y]) => y / 1000);
  return [(Math.min(...xs) + Math.max(...xs)) / 2, (Math.min(...ys) + Math.max(...ys)) / 2, height];
}
