// Asks the server. Whatever goes wrong becomes a ServerError whose message is for a person.
import type { FixtureCard, Hit, ProductCard, Progress, StoreLine, Summary } from "./contract";
import { Packed } from "./packed";

export class ServerError extends Error {
  constructor(
    readonly code: string,
    message: string,
    readonly where = "",
  ) {
    super(message);
  }
}

// What fetch() could not reach; the page says it in the reader's language.
export const unreachable = "view.unreachable";

interface ErrorBody {
  error?: { code?: unknown; where?: unknown; message?: unknown };
}

export async function errorOf(answer: Response): Promise<ServerError> {
  const text = (value: unknown, otherwise: string): string => (typeof value === "string" ? value : otherwise);
  let body: ErrorBody = {};
  try {
    body = (await answer.json()) as ErrorBody;
  } catch {
    // Not of our server: the status is all there is.
  }
  const error = body.error ?? {};
  const status = `HTTP ${answer.status} ${answer.statusText}`.trim();
  return new ServerError(text(error.code, `http.${answer.status}`), text(error.message, status), text(error.where, ""));
}

export const withToken = (path: string, token: string | null): string => (token === null ? path : `${path}${path.includes("?") ? "&" : "?"}token=${encodeURIComponent(token)}`);

async function isRefusal(answer: Response): Promise<boolean> {
  if (!answer.headers.get("Content-Type")?.startsWith("application/json")) return false;
  const body = (await answer.clone().json()) as object;
  return typeof (body as ErrorBody).error === "object" && Object.keys(body).length === 1;
}

// What is posted is answered with what came of it. What the core refuses is an answer with an error in it.
export async function posted(address: string, body: object, where: string, more: RequestInit = {}): Promise<Response> {
  const request = { method: "POST", headers: { "Content-Type": "application/json" }, body: JSON.stringify(body), ...more };
  let answer: Response;
  try {
    answer = await fetch(address, request);
  } catch (error) {
    throw new ServerError(unreachable, String(error), where);
  }
  if (!answer.ok || (await isRefusal(answer))) throw await errorOf(answer);
  return answer;
}

export async function got(address: string, where: string, signal?: AbortSignal): Promise<Response> {
  let answer: Response;
  try {
    answer = await fetch(address, signal ? { signal } : {});
  } catch (error) {
    if (signal?.aborted) throw error;
    throw new ServerError(unreachable, String(error), where);
  }
  if (!answer.ok) throw await errorOf(answer);
  return answer;
}

// Which stores the server shows.
export async function storesOf(token: string | null): Promise<readonly StoreLine[]> {
  const answer = await got(withToken("api/stores", token), "/api/stores");
  return ((await answer.json()) as { stores: readonly StoreLine[] }).stores;
}

export class Client {
  private readonly begun = new Map<string, Promise<Response>>();

  constructor(
    private readonly store: number,
    private readonly token: string | null,
  ) {}

  address(path: string): string {
    return withToken(`api/stores/${this.store}${path}`, this.token);
  }

  // Begins to ask for what is wanted soon; who asks for it first has that answer.
  ahead(path: string): void {
    const asked = got(this.address(path), path);
    asked.catch(() => undefined); // who asks for it is told
    this.begun.set(path, asked);
  }

  get(path: string, signal?: AbortSignal): Promise<Response> {
    const begun = this.begun.get(path);
    this.begun.delete(path);
    return begun ?? got(this.address(path), path, signal);
  }

  async json<T>(path: string, signal?: AbortSignal): Promise<T> {
    const answer = await this.get(path, signal);
    try {
      return (await answer.json()) as T;
    } catch {
      throw new ServerError("view.bad_answer", `${path} is not JSON`, path);
    }
  }

  async packed<Head>(path: string): Promise<Packed<Head>> {
    const answer = await this.get(path);
    return new Packed<Head>(await answer.arrayBuffer(), path);
  }

  async picture(path: string, options: ImageBitmapOptions = {}): Promise<ImageBitmap> {
    const answer = await this.get(path);
    // Colours as they are in the file: they are decoded in the shader.
    return createImageBitmap(await answer.blob(), { colorSpaceConversion: "none", premultiplyAlpha: "none", ...options });
  }

  summary(): Promise<Summary> {
    return this.json("");
  }
  progress(): Promise<Progress> {
    return this.json("/state");
  }
  product(row: number, signal?: AbortSignal): Promise<ProductCard> {
    return this.json(`/products/${row}`, signal);
  }
  fixture(row: number, signal?: AbortSignal): Promise<FixtureCard> {
    return this.json(`/fixtures/${row}`, signal);
  }
  async search(query: string, signal?: AbortSignal): Promise<readonly Hit[]> {
    const answer = await this.json<{ hits: readonly Hit[] }>(`/search?q=${encodeURIComponent(query)}&max=50`, signal);
    return answer.hits;
  }
}
