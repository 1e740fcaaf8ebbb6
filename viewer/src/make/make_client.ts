// Asks the server to make stores.
import { got, posted, withToken } from "../store/client";
import type { Ask, Kept, MakeOptions, Tries } from "./contract";

export class MakeClient {
  constructor(readonly token: string | null) {}

  options(): Promise<MakeOptions> {
    return this.read("api/make");
  }
  tries(): Promise<Tries> {
    return this.read("api/make/tries");
  }
  async begin(ask: Ask): Promise<Tries> {
    return (await (await posted(withToken("api/make/try", this.token), ask, "try")).json()) as Tries;
  }
  async keep(batch: number, seed: number, name: string): Promise<Kept> {
    return (await (await posted(withToken("api/make/keep", this.token), { batch, seed, name }, "keep")).json()) as Kept;
  }
  pictureAddress(batch: number, seed: number): string {
    return withToken(`api/make/pictures/${batch}-${seed}.png`, this.token);
  }

  private async read<T>(path: string): Promise<T> {
    return (await (await got(withToken(path, this.token), path)).json()) as T;
  }
}
