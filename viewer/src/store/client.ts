// Asks the server. Whatever goes wrong becomes a ServerError whose message is for a person.
import type { FixtureCard, Hit, ProductCard, Progress, Summary } from "./contract";
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

export class Client {
  constructor(
    private readonly store: number,
    private readonly token: string | null,
  ) {}

  address(path: string): string {
    const token = this.token === null ? "" : `${path.includes("?") ? "&" : "?"}token=${encodeURIComponent(this.token)}`;
    return `api/stores/${this.store}${path}${token}`;
  }

  async get(path: string, signal?: AbortSignal): Promise<Response> {
    let answer: Response;
    try {
      answer = await fetch(this.address(path), signal ? { signal } : {});
    } catch (error) {
      if (signal?.aborted) throw error;
      throw new ServerError(unreachable, String(error), path);
    }
    if (!answer.ok) throw await errorOf(answer);
    return answer;
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
