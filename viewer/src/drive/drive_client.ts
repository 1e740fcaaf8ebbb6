// Asks the server of a drive: its status, shapes and pictures; and its socket.
import { Client, posted } from "../store/client";
import { Packed } from "../store/packed";
import { ReplayClient } from "../replay/replay_client";
import type { Command, DriveAsk, DriveMoment, DriveNote, DriveStatus, Verb } from "./contract";

export class DriveClient extends Client {
  constructor(
    private readonly storeNumber: number,
    private readonly secret: string | null,
    private readonly below = "/drive",
  ) {
    super(storeNumber, secret);
  }

  override address(path: string): string {
    return super.address(this.below + path);
  }

  status(): Promise<DriveStatus> {
    return this.json("");
  }
  async begin(ask: DriveAsk): Promise<DriveStatus> {
    return (await (await posted(this.address("/begin"), ask, "begin")).json()) as DriveStatus;
  }
  // Shapes of the goods from a row on, up to another.
  shapes(first: number, end: number): DriveClient {
    return new DriveClient(this.storeNumber, this.secret, `/drive/shapes/${first}-${end}`);
  }
  // -1: the store itself.
  ofPlace(place: number): Client {
    return new ReplayClient(this.storeNumber, this.secret).ofPlace(place);
  }
}

export interface SocketActions {
  moment(message: Packed<DriveMoment>): void;
  note(note: DriveNote): void;
  closed(): void;
}

export class DriveSocket {
  private readonly socket: WebSocket;

  constructor(client: DriveClient, actions: SocketActions) {
    const address = new URL(client.address("/socket"), location.href);
    address.protocol = address.protocol === "https:" ? "wss:" : "ws:";
    this.socket = new WebSocket(address);
    this.socket.binaryType = "arraybuffer";
    this.socket.addEventListener("message", ({ data }: MessageEvent<string | ArrayBuffer>) => {
      if (typeof data === "string") actions.note(JSON.parse(data) as DriveNote);
      else actions.moment(new Packed<DriveMoment>(data, "drive"));
    });
    this.socket.addEventListener("close", () => actions.closed());
  }

  get open(): boolean {
    return this.socket.readyState === WebSocket.OPEN;
  }

  say(verb: Verb): void {
    this.send({ verb });
  }
  move(command: Command): void {
    this.send({ verb: "move", command });
  }
  close(): void {
    this.socket.close();
  }

  private send(message: object): void {
    if (this.open) this.socket.send(JSON.stringify(message));
  }
}
