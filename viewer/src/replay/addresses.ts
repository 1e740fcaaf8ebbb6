// Where pages of replays are: what stands behind "?" in the address.
export interface ReplayPlace {
  readonly store: number;
  readonly token: string | null;
  readonly run: number | undefined; // none: the list
  readonly episode: number | undefined;
  readonly beside: number | undefined; // another run, whose same episode stands beside it
}

function row(text: string | null): number | undefined {
  return text !== null && /^\d{1,6}$/.test(text) ? Number(text) : undefined;
}

// Undefined: the page is the store's.
export function readReplayPlace(search: string): ReplayPlace | undefined {
  const address = new URLSearchParams(search);
  if (!address.has("replay")) return undefined;
  return { store: row(address.get("store")) ?? 0, token: address.get("token"), run: row(address.get("run")), episode: row(address.get("episode")), beside: row(address.get("beside")) };
}

function link(token: string | null, entries: Readonly<Record<string, number | string>>): string {
  const address = new URLSearchParams(Object.entries(entries).map(([name, value]) => [name, String(value)]));
  if (token !== null) address.set("token", token);
  return `?${address}`;
}

export const storeLink = ({ store, token }: Pick<ReplayPlace, "store" | "token">): string => link(token, { store });
export const listLink = ({ store, token }: Pick<ReplayPlace, "store" | "token">): string => link(token, { store, replay: "" });
export const episodeLink = ({ store, token }: Pick<ReplayPlace, "store" | "token">, run: number, episode: number, beside?: number): string =>
  link(token, { store, replay: "", run, episode, ...(beside !== undefined && { beside }) });
