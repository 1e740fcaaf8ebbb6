// Files that were dropped on the page: what each is meant as, and its bytes for the server.
import type { DroppedFile } from "./contract";

export const acceptedFiles = ".svg,.dxf,.png,.jpg,.jpeg,.csv,.json";
export const maxFilesBytes = 16 * 1024 * 1024; // in all; the server takes no more

export type Use = "floor_plan" | "image" | "catalog";

// A vector drawing can only be of the room, a table only products of the user's own; of a picture the server finds out whether it
// is a drawing of zones or a photo.
export function usesOf(name: string): readonly Use[] {
  const ending = name.toLowerCase().split(".").at(-1);
  if (ending === "svg" || ending === "dxf") return ["floor_plan"];
  if (ending === "csv" || ending === "json") return ["catalog"];
  return ending === "png" || ending === "jpg" || ending === "jpeg" ? ["image", "floor_plan"] : [];
}

export async function readDropped(file: File): Promise<DroppedFile> {
  const bytes = new Uint8Array(await file.arrayBuffer());
  const step = 32_768; // arguments of a call at most
  let text = "";
  for (let at = 0; at < bytes.length; at += step) text += String.fromCharCode(...bytes.subarray(at, at + step));
  return { name: file.name, base64: btoa(text) };
}
