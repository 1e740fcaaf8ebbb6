// A store that was made, from above: floors of zones in their colours, fixtures, doors.
import { zoneColor } from "../stage/overlays";
import type { MadeStore } from "./contract";

const svg = "http://www.w3.org/2000/svg";
const margin = 300; // millimetres

function shape(name: string, attributes: Readonly<Record<string, string | number>>): SVGElement {
  const made = document.createElementNS(svg, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, String(value));
  return made;
}

// North is up; `label` tells those who do not see it.
export function planPicture({ outline_mm, zones, fixtures, openings }: MadeStore, label: string): SVGElement {
  const xs = outline_mm.map(([x]) => x);
  const ys = outline_mm.map(([, y]) => y);
  const [left, bottom, top] = [Math.min(...xs), Math.min(...ys), Math.max(...ys)];
  const points = (polygon: readonly (readonly [number, number])[]): string => polygon.map(([x, y]) => `${x},${top - y}`).join(" ");
  const types = [...new Set(zones.map(({ type }) => type))];
  const picture = shape("svg", { class: "made-plan", role: "img", "aria-label": label, viewBox: `${left - margin} ${-margin} ${Math.max(...xs) - left + 2 * margin} ${top - bottom + 2 * margin}` });
  picture.append(shape("polygon", { class: "outline", points: points(outline_mm) }));
  for (const zone of zones) {
    const floor = shape("polygon", { class: "zone", points: points(zone.polygon_mm), fill: `#${zoneColor(types.indexOf(zone.type)).getHexString()}` });
    const name = shape("title", {});
    name.textContent = zone.label || zone.id;
    floor.append(name);
    picture.append(floor);
  }
  for (const { rect_mm: [x0, y0, x1, y1] } of fixtures) picture.append(shape("rect", { class: "fixture", x: x0, y: top - y1, width: x1 - x0, height: y1 - y0 }));
  for (const { kind, low_m, high_m } of openings)
    picture.append(shape("line", { class: `door ${kind}`, x1: low_m[0] * 1000, y1: top - low_m[1] * 1000, x2: high_m[0] * 1000, y2: top - high_m[1] * 1000 }));
  return picture;
}
