// The state of the view in the address after "#": shared by link, read again when the page opens.
import type { Mode } from "../camera/modes";
import { modes } from "../camera/modes";
import type { Pose } from "../camera/pose";
import { heatNames, type HeatName } from "../stage/heat";
import { layerNames, type LayerName } from "./layers";

export interface ViewState {
  readonly mode?: Mode;
  readonly pose?: Pose;
  readonly distance?: number; // from the eye to what orbit turns about
  readonly product?: number; // row of the selected product
  readonly fixture?: number; // row of the selected fixture
  readonly layers?: readonly LayerName[]; // beside the zones
  readonly heat?: HeatName;
  readonly zones?: boolean;
  readonly query?: string;
}

function numbers(text: string | null, count: number): number[] | undefined {
  if (text === null) return undefined;
  const found = text.split(",").map(Number);
  return found.length === count && found.every(Number.isFinite) ? found : undefined;
}

function row(text: string | null): number | undefined {
  return text !== null && /^\d{1,9}$/.test(text) ? Number(text) : undefined;
}

// Whatever is missing or makes no sense is left out.
export function readAddress(hash: string): ViewState {
  const entries = new URLSearchParams(hash.replace(/^#/, ""));
  const eye = numbers(entries.get("eye"), 3);
  const look = numbers(entries.get("look"), 2);
  const distance = numbers(entries.get("around"), 1)?.[0];
  const mode = modes.find((name) => name === entries.get("mode"));
  const product = row(entries.get("product"));
  const fixture = row(entries.get("fixture"));
  const named = entries.get("layers")?.split(",") ?? [];
  const layers = layerNames.filter((name) => name !== "zones" && named.includes(name));
  const heat = heatNames.find((name) => name === entries.get("heat"));
  const query = entries.get("q");
  return {
    ...(mode && { mode }),
    ...(eye && look && { pose: { eye: [eye[0]!, eye[1]!, eye[2]!], yaw: look[0]!, pitch: look[1]! } }),
    ...(distance !== undefined && distance > 0 && { distance }),
    ...(product !== undefined && { product }),
    ...(fixture !== undefined && { fixture }),
    ...(entries.get("zones") === "1" && { zones: true }),
    ...(layers.length > 0 && { layers }),
    ...(heat && { heat }),
    ...(query && { query }),
  };
}

const rounded = (x: number, digits: number): string => String(Number(x.toFixed(digits)));

export function writeAddress(state: ViewState): string {
  const entries: string[] = [];
  const put = (name: string, value: string): number => entries.push(`${name}=${value}`);
  if (state.mode) put("mode", state.mode);
  if (state.pose) {
    put("eye", state.pose.eye.map((x) => rounded(x, 3)).join(","));
    put("look", `${rounded(state.pose.yaw, 4)},${rounded(state.pose.pitch, 4)}`);
  }
  if (state.distance !== undefined) put("around", rounded(state.distance, 3));
  if (state.product !== undefined) put("product", String(state.product));
  if (state.fixture !== undefined) put("fixture", String(state.fixture));
  if (state.zones) put("zones", "1");
  if (state.layers && state.layers.length > 0) put("layers", state.layers.join(","));
  if (state.heat) put("heat", state.heat);
  if (state.query) put("q", encodeURIComponent(state.query));
  return entries.length > 0 ? `#${entries.join("&")}` : "";
}
