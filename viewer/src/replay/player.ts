// One episode on the stage, recorded or running: brings everything to where it is at a step.
import type { Stage } from "../stage/stage";
import type { RoomLight } from "./actor_light";
import { Actors, matrixOf, type Actor } from "./actors";
import type { Client } from "../store/client";
import type { Packed } from "../store/packed";
import type { MotionHead, Replay, ReplayThing } from "./contract";
import type { ReplayClient } from "./replay_client";
import { BodyTracks, ThingTracks, type BodyPlaces, type ThingPlaces } from "./tracks";

const aboveFrame = 0.3; // metres: frames are at the foot of things
const lightAgain = 0.5; // metres from where the light on something was taken last
type Point = readonly [number, number, number];

// What stands on the stage.
export interface Cast {
  readonly bodies: readonly string[];
  readonly things: readonly ReplayThing[];
}

interface Lit {
  readonly actor: Actor;
  litAt: Point | undefined;
}

export class Player<Shown extends Cast = Replay> {
  readonly robotBodies: number;
  private readonly things: (Lit | undefined)[]; // by thing; undefined: it has not come
  private readonly robot: Lit;
  private shown: number | undefined;

  private constructor(
    private readonly stage: Stage,
    readonly replay: Shown,
    private readonly actors: Actors,
    private readonly bodies: BodyPlaces,
    private readonly tracks: ThingPlaces,
  ) {
    this.robotBodies = bodiesOfRobot(replay);
    this.robot = { actor: actors.bodies[0]!, litAt: undefined };
    this.things = replay.things.map(({ kind }) => (kind === "basket" ? { actor: actors.bodies.at(-1)!, litAt: undefined } : undefined));
    stage.scene.add(actors.group);
  }

  // With the robot and the first steps; goods come with addGoods().
  static async create(client: ReplayClient, stage: Stage, replay: Replay, failed: (error: unknown) => void): Promise<Player> {
    const [robot, things] = await Promise.all([client.packed<unknown>("/robot.bin"), client.packed<unknown>("/things.bin")]);
    const load = (first: number, count: number): Promise<Packed<MotionHead>> => client.packed(`/motion.bin?from=${first}&steps=${count}`);
    let player: Player | undefined;
    const came = (error?: unknown): void => {
      if (error !== undefined) failed(error);
      if (player) player.shown = undefined;
      stage.redraw();
    };
    const tracks = new BodyTracks(bodiesOfRobot(replay), replay.steps, load, came);
    tracks.want(0);
    player = new Player(stage, replay, new Actors(robot, stage.shared), tracks, new ThingTracks(things));
    return player;
  }

  // One that runs; its goods come with addGoods(), as many times as there are more.
  static live<Shown extends Cast>(robot: Packed<unknown>, stage: Stage, cast: Shown, bodies: BodyPlaces, things: ThingPlaces): Player<Shown> {
    return new Player(stage, cast, new Actors(robot, stage.shared), bodies, things);
  }

  // `things`: those from the `first` on; `client` has their shapes from the row `firstMesh` on.
  async addGoods(client: Client, things: readonly ReplayThing[] = this.replay.things, first = 0, firstMesh = 0): Promise<void> {
    const wanted = things.flatMap(({ mesh }, thing) => (mesh >= 0 ? [{ thing: first + thing, mesh: mesh - firstMesh }] : []));
    const made = await this.actors.addGoods(client, this.stage.renderer, this.stage.limits, wanted.map(({ mesh }) => mesh));
    made.forEach((actor, i) => (this.things[wanted[i]!.thing] = { actor, litAt: undefined }));
    this.shown = undefined;
    this.stage.redraw();
  }

  get goodsAreThere(): boolean {
    return this.things.every((thing) => thing !== undefined);
  }

  // What the goods of the store leave out: they are drawn as they move.
  static movedRows(replays: readonly Pick<Cast, "things">[]): Set<number> {
    return new Set(replays.flatMap(({ things }) => things.filter(({ kind }) => kind === "product").map(({ number }) => number)));
  }

  // Of two episodes in one store: what the other one moves stands here where it stood at first.
  standStill(other: Player<Cast>): void {
    const own = Player.movedRows([this.replay]);
    other.replay.things.forEach(({ kind, number }, i) => {
      const actor = other.things[i]?.actor;
      if (kind !== "product" || own.has(number) || !actor) return;
      const still = actor.mesh.clone();
      still.matrixAutoUpdate = false;
      still.matrix.copy(matrixOf(other.tracks.at(i, 0)));
      still.matrixWorldNeedsUpdate = true;
      this.actors.group.add(still);
    });
  }

  // Whether it is seen; with its doors as they are at the step that it shows.
  reveal(seen: boolean): void {
    this.actors.group.visible = seen;
    if (seen && this.shown !== undefined) this.moveJoints(this.shown);
  }

  // False: the robot's places at that step have not come yet, and nothing has moved.
  show(step: number): boolean {
    this.bodies.want(step);
    const places = Array.from({ length: this.robotBodies }, (_, body) => this.bodies.at(step, body));
    if (places.some((place) => place === undefined)) return false;
    if (this.shown === step) return true;
    this.shown = step;
    places.forEach((place, body) => this.actors.bodies[body]!.place(place!));
    this.things.forEach((thing, i) => thing?.actor.place(this.tracks.at(i, step)));
    this.moveJoints(step);
    this.stage.redraw();
    return true;
  }

  // Where the robot's base is.
  get robotAt(): Point {
    return this.robot.actor.at;
  }
  // Its heading over the floor.
  get heading(): readonly [number, number] {
    const e = this.robot.actor.mesh.matrix.elements;
    return [e[0]!, e[1]!];
  }

  thingAt(thing: number): Point | undefined {
    return this.things[thing]?.actor.at;
  }
  // Its matrix, column by column.
  thingMatrix(thing: number): number[] | undefined {
    return this.things[thing]?.actor.mesh.matrix.elements.slice();
  }
  bodyAt(body: number): Point {
    return this.actors.bodies[body]!.at;
  }

  // Takes the light anew where something has come far from where it was taken. `spare`: at most so many at once.
  relight(light: RoomLight, spare: number): void {
    for (const lit of [this.robot, ...this.things]) {
      if (!lit || spare <= 0) continue;
      const { at } = lit.actor;
      if (lit.litAt && Math.hypot(...at.map((x, i) => x - lit.litAt![i]!)) < lightAgain) continue;
      lit.litAt = at;
      spare--;
      const cube = light.cubeAt([at[0], at[1], at[2] + aboveFrame]);
      if (lit === this.robot) for (let body = 0; body < this.robotBodies; body++) this.actors.bodies[body]!.light(cube);
      else lit.actor.light(cube);
      this.stage.redraw();
    }
  }

  // Joints that only the other of two episodes moves are at rest here.
  restingJoints: readonly number[] = [];
  get joints(): readonly number[] {
    return Array.from(this.tracks.joints);
  }

  private moveJoints(step: number): void {
    const { room } = this.stage;
    if (!room) return;
    for (const joint of this.restingJoints) if (room.moving.positions[joint] !== 0) room.move(joint, 0);
    this.joints.forEach((joint, row) => {
      const to = this.tracks.jointAt(row, step);
      if (room.moving.positions[joint] !== to) room.move(joint, to);
    });
  }
}

function bodiesOfRobot({ bodies, things }: Cast): number {
  return bodies.length - (things.some(({ kind }) => kind === "basket") ? 1 : 0);
}
