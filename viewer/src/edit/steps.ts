// Patches as a person reads them.
import { words } from "../ui/dom";
import type { Speech } from "../ui/speech";
import type { EditLine, Patch } from "./contract";

function zoneValues(values: Readonly<Record<string, unknown>>): string {
  const entries = Object.entries(values).filter(([key]) => key !== "zone");
  return entries.map(([key, value]) => (key === "usual" ? (value as string[]).map(words).join(", ") : `${words(key)} ${typeof value === "object" ? JSON.stringify(value) : String(value)}`)).join(", ");
}

export function patchText(patch: Patch, speech: Speech): string {
  const [operation, value] = Object.entries(patch).find(([, given]) => given !== undefined) ?? ["", {}];
  const given = value as Record<string, unknown>;
  if (operation === "set_ratio") return speech.say("editPatchRatio", { node: String(given["node"]), share: speech.number(Number(given["ratio"]) * 100, 1) });
  if (operation === "swap_leaves") return speech.say("editPatchSwap", { a: String(given["a"]), b: String(given["b"]) });
  if (operation === "swap_blocks") {
    const name = (place: unknown): string => words((place as { readonly sku?: string }).sku ?? "");
    return speech.say("editPatchSwap", { a: name(given["a"]), b: name(given["b"]) });
  }
  if (operation === "set_override") {
    const value = given["value"] === undefined ? speech.say("editAsUsual") : String(given["value"]);
    return speech.say("editPatchPin", { fixture: String(given["fixture"]), field: words(String(given["field"])), value });
  }
  if (operation === "set_fixture" || operation === "set_stock") return speech.say("editPatchZone", { zone: String(given["zone"]), values: zoneValues(given) });
  return `${words(operation)} ${Object.values(given).map((part) => (typeof part === "object" ? JSON.stringify(part) : String(part))).join(" ")}`;
}

export function lineText(line: EditLine, speech: Speech): string {
  return line.words || line.patches.map((patch) => patchText(patch, speech)).join("; ");
}
