// The page in which a robot is driven: what stands behind "?" in the address.
export interface DrivePlace {
  readonly store: number;
  readonly token: string | null;
  readonly chooses: boolean; // another episode, whatever is open
}

// Undefined: the page is another one.
export function readDrivePlace(search: string): DrivePlace | undefined {
  const address = new URLSearchParams(search);
  if (!address.has("drive")) return undefined;
  const store = address.get("store") ?? "";
  return { store: /^\d{1,6}$/.test(store) ? Number(store) : 0, token: address.get("token"), chooses: address.get("drive") === "new" };
}

export function driveLink({ store, token }: Pick<DrivePlace, "store" | "token">, chooses = false): string {
  const address = new URLSearchParams({ store: String(store), drive: chooses ? "new" : "" });
  if (token !== null) address.set("token", token);
  return `?${address}`;
}
