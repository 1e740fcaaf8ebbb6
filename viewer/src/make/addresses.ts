// The page in which stores are made: what stands behind "?" in the address.
export interface MakePlace {
  readonly token: string | null;
  readonly from: number | undefined; // a store whose words are to be changed
}

// Undefined: the page is another one.
export function readMakePlace(search: string): MakePlace | undefined {
  const address = new URLSearchParams(search);
  if (!address.has("make")) return undefined;
  const from = address.get("from");
  return { token: address.get("token"), from: from !== null && /^\d{1,6}$/.test(from) ? Number(from) : undefined };
}

export function makeLink(token: string | null, from?: number): string {
  const address = new URLSearchParams({ make: "" });
  if (from !== undefined) address.set("from", String(from));
  if (token !== null) address.set("token", token);
  return `?${address}`;
}
