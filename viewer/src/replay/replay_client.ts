// Addresses of recorded episodes. What is below an episode or a place is asked for as what is below a store.
import { Client } from "../store/client";
import type { Replay, RunEpisodes, RunLine } from "./contract";

export class ReplayClient extends Client {
  constructor(
    private readonly storeNumber: number,
    private readonly secret: string | null,
    private readonly below = "",
  ) {
    super(storeNumber, secret);
  }

  override address(path: string): string {
    return super.address(this.below + path);
  }

  async runs(): Promise<readonly RunLine[]> {
    return (await this.json<{ runs: readonly RunLine[] }>("/runs")).runs;
  }
  episodes(run: number): Promise<RunEpisodes> {
    return this.json(`/runs/${run}`);
  }
  replay(run: number, episode: number): Promise<Replay> {
    return this.json(`/runs/${run}/episodes/${episode}`);
  }

  ofEpisode(run: number, episode: number): ReplayClient {
    return new ReplayClient(this.storeNumber, this.secret, `/runs/${run}/episodes/${episode}`);
  }
  // -1: the store itself.
  ofPlace(place: number): ReplayClient {
    return place < 0 ? this : new ReplayClient(this.storeNumber, this.secret, `/places/${place}`);
  }
}
