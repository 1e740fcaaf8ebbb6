// Where everything of a running episode is: as the last message of the server has it.
import { placeAt, type BodyPlaces, type Rows, type ThingPlaces } from "../replay/tracks";
import type { Sections } from "../store/packed";

export class Live {
  count = 0; // of things
  private rows: Rows = { position: new Float32Array(), rotation: new Int16Array() };
  private robotBodies = 0;
  private joints: ArrayLike<number> = [];
  private positions: ArrayLike<number> = [];

  readonly bodies: BodyPlaces = {
    want: () => undefined, // the server sends what there is
    at: (_step, body) => (body < this.robotBodies ? placeAt(this.rows, body) : undefined),
  };
  readonly things: ThingPlaces;

  constructor() {
    const joints = (): ArrayLike<number> => this.joints;
    this.things = {
      get joints() {
        return joints();
      },
      at: (thing) => placeAt(this.rows, this.robotBodies + thing),
      jointAt: (row) => this.positions[row]!,
    };
  }

  take(message: Sections, bodies: number, things: number): void {
    this.rows = { position: message.f32("position", 3), rotation: message.i16("rotation", 4) };
    [this.robotBodies, this.count] = [bodies, things];
    this.joints = message.u32("joint", 1);
    this.positions = message.f32("joint_position", 1);
  }
}
