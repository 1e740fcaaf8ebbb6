// The shader that the first picture takes, compiled while the goods are still on their way: without a GPU that takes as long as
// asking for them.
import { PerspectiveCamera, Scene, Vector3 } from "three";
import type { GoodsTable } from "./goods_table";
import type { Stage } from "./stage";
import { StandIns, type Look } from "./stand_ins";

const none = 65535;

// One pack, drawn before anything else and then forgotten.
const onePack: GoodsTable = {
  count: 1,
  position: new Float32Array(3),
  rotation: Int16Array.of(0, 0, 0, 32767),
  sku: new Uint16Array(1),
  fixture: Uint16Array.of(none),
  shelf: Uint16Array.of(none),
  facing: Uint32Array.of(0xffffffff),
  tint: new Uint8Array(3),
  rank: new Uint8Array(1),
  order: new Uint32Array(1),
  cells: [{ first: 0, deep: 1, end: 1, facing: 0, fixture: none, low: [0, 0, 0], high: [1, 1, 1] }],
};
const box: Look = { color: "#000000", size_m: [1, 1, 1] };

export class WarmUp {
  private readonly standIns: StandIns;
  private readonly scene: Scene;
  private readonly camera = new PerspectiveCamera();

  // Begins to compile; nothing waits for it yet.
  constructor(private readonly stage: Stage) {
    this.standIns = new StandIns(onePack, [box], stage.shared);
    this.standIns.begin(0, false);
    this.standIns.add(0, 0, new Vector3(0, -3, 0), 3);
    this.standIns.finish();
    this.scene = new Scene().add(this.standIns.group);
    stage.renderer.compile(this.scene, this.camera);
  }

  // What is compiled at the first draw only.
  draw(): void {
    this.stage.renderer.render(this.scene, this.camera);
  }

  // Whatever needs the shader has it by now.
  end(): void {
    this.standIns.dispose();
  }
}
