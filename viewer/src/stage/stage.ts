// The picture: renderer, camera and what stands in it. Draws only when something has changed.
import {
  ColorManagement,
  LinearSRGBColorSpace,
  NoToneMapping,
  PerspectiveCamera,
  Raycaster,
  Scene,
  Vector2,
  Vector3,
  WebGLRenderer,
} from "three";
import { direction, type Pose } from "../camera/pose";
import type { Vec3 } from "../camera/vector";
import { element } from "../ui/dom";
import { Pace, type Effort } from "./effort";
import type { Goods, Limits } from "./goods";
import type { Overlays } from "./overlays";
import { pick, type Picked, type Ray } from "./pick";
import type { Room } from "./room";
import { newShared, type Shared } from "./shading";
import { Sight } from "./sight";

ColorManagement.enabled = false; // the shaders write what the screen shows

const soonMilliseconds = 350;
const fenceMilliseconds = 10;
const stillAfter = 200; // milliseconds without a move: the picture is drawn once more, finely

export interface Figures {
  frames: number;
  calls: number;
  triangles: number;
}

// WebGL without a GPU: fewer extras.
function isSoftware(gl: WebGL2RenderingContext): boolean {
  const info = gl.getExtension("WEBGL_debug_renderer_info");
  const name = info ? String(gl.getParameter(info.UNMASKED_RENDERER_WEBGL)) : "";
  return /swiftshader|llvmpipe|software/i.test(name);
}

interface Drawn {
  readonly canvas: HTMLCanvasElement;
  readonly gl: WebGL2RenderingContext;
}

function newCanvas(antialias: boolean): Drawn | undefined {
  const canvas = element("canvas", { attributes: { tabindex: "0", role: "application" } });
  const gl = canvas.getContext("webgl2", { antialias, alpha: false, powerPreference: "high-performance", preserveDrawingBuffer: false });
  return gl ? { canvas, gl } : undefined;
}

export class Stage {
  readonly camera = new PerspectiveCamera(55, 1, 0.03, 200);
  readonly scene = new Scene();
  readonly shared: Shared = newShared();
  readonly renderer: WebGLRenderer;
  readonly canvas: HTMLCanvasElement;
  readonly figures: Figures = { frames: 0, calls: 0, triangles: 0 };
  goods: Goods | undefined;
  room: Room | undefined;
  annexe: Room | undefined; // fixtures that an edit has made
  overlays: Overlays | undefined;
  sight = new Sight([]);
  ceilingHeight = 3;
  readonly pace: Pace;
  // Two pictures side by side, of the same eye: brings the scene to what the left (0) or right half (1) shows.
  halves: ((half: 0 | 1) => void) | undefined;
  private dirty = true;
  private wasBusy = false;
  private began = 0; // the last picture
  private moved = -Infinity;
  private still = false;
  // While pieces are still coming a picture is soon out of date: none is drawn finely.
  private coming = true;
  private soon: number | undefined;

  private constructor(
    { canvas, gl }: Drawn,
    readonly software: boolean,
  ) {
    this.canvas = canvas;
    this.pace = new Pace(software);
    this.renderer = new WebGLRenderer({ canvas, context: gl, antialias: !software });
    this.renderer.outputColorSpace = LinearSRGBColorSpace;
    this.renderer.toneMapping = NoToneMapping;
    this.renderer.debug.checkShaderErrors = false; // asking waits for all that is being drawn; WebGL itself complains of a faulty one
    this.renderer.info.autoReset = true;
    this.camera.up.set(0, 0, 1);
    this.scene.matrixAutoUpdate = false;
  }

  // Undefined: the browser has no WebGL 2.
  static create(): Stage | undefined {
    const plain = newCanvas(false);
    if (!plain || isSoftware(plain.gl)) return plain && new Stage(plain, true); // one context: a second takes long where there is no GPU
    plain.gl.getExtension("WEBGL_lose_context")?.loseContext();
    const smooth = newCanvas(true);
    return smooth && new Stage(smooth, false);
  }

  get limits(): Limits {
    const small = Math.min(screen.width, screen.height) < 600;
    return { sheetLayers: small ? 16 : 40, sharpness: this.software ? 1 : 8, quick: this.software };
  }

  setBackground(color: string): void {
    this.renderer.setClearColor(color, 1);
    this.redraw();
  }

  redraw(): void {
    this.dirty = true;
  }

  // For what comes piece by piece: not a picture each.
  readonly redrawSoon = (): void => {
    this.soon ??= window.setTimeout(() => {
      this.soon = undefined;
      this.redraw();
    }, soonMilliseconds);
  };

  resize(): void {
    const { clientWidth, clientHeight } = this.canvas;
    if (clientWidth === 0 || clientHeight === 0) return;
    this.renderer.setPixelRatio(this.pixelRatio());
    this.renderer.setSize(clientWidth, clientHeight, false);
    this.camera.aspect = clientWidth / clientHeight / (this.halves ? 2 : 1);
    this.camera.updateProjectionMatrix();
    this.redraw();
  }

  private effort(still: boolean): Effort {
    return still ? this.pace.resting : this.pace.moving;
  }

  private pixelRatio(): number {
    return (this.software ? 1 : Math.min(devicePixelRatio, 2)) * this.effort(this.still).pixels;
  }

  // Everything is there.
  complete(): void {
    this.coming = false;
    this.redraw();
  }

  setPose(pose: Pose): void {
    const [x, y, z] = direction(pose);
    this.camera.position.set(...pose.eye);
    this.camera.lookAt(pose.eye[0] + x, pose.eye[1] + y, pose.eye[2] + z);
    this.roomChanged();
    this.camera.updateProjectionMatrix();
    this.camera.updateMatrixWorld();
    this.redraw();
  }

  // Degrees from the picture's top to its bottom. A narrow angle is for views from far above.
  setLens(fov: number): void {
    const far = fov < 30;
    Object.assign(this.camera, { fov, near: far ? 1 : 0.03, far: far ? 4000 : 400 });
    this.camera.updateProjectionMatrix();
    this.redraw();
  }

  // From above the ceiling one looks into the room.
  roomChanged(): void {
    this.room?.showCeiling(this.camera.position.z < this.ceilingHeight - 0.1);
    this.redraw();
  }

  // Draws if need be; true when it did. `moving`: frames follow one another, so that their time says how fast this machine is.
  frame(moving: boolean): boolean {
    const began = performance.now();
    if (moving) this.moved = began;
    const still = began - this.moved > stillAfter && !(this.coming && this.software);
    this.dirty ||= still && !this.still;
    this.still = still;
    if (!this.dirty) {
      this.wasBusy = false;
      return false;
    }
    this.dirty = false;
    if (this.renderer.getPixelRatio() !== this.pixelRatio()) this.renderer.setPixelRatio(this.pixelRatio());
    const done = this.draw(still);
    this.count(began, moving && this.wasBusy);
    this.wasBusy = moving;
    if (!done) this.redraw();
    return true;
  }

  // False: more is to come.
  draw(still: boolean): boolean {
    const done = this.prepare(still);
    if (this.halves) this.drawHalves(this.halves);
    else this.renderer.render(this.scene, this.camera);
    return done;
  }

  private drawHalves(bring: (half: 0 | 1) => void): void {
    const { clientWidth, clientHeight } = this.canvas;
    const middle = Math.round(clientWidth / 2);
    this.renderer.setScissorTest(true);
    for (const half of [0, 1] as const) {
      bring(half);
      const [x, width] = half === 0 ? [0, middle - 1] : [middle + 1, clientWidth - middle - 1];
      this.renderer.setViewport(x, 0, width, clientHeight);
      this.renderer.setScissor(x, 0, width, clientHeight);
      this.renderer.render(this.scene, this.camera);
    }
    this.renderer.setScissorTest(false);
  }

  private prepare(still: boolean): boolean {
    this.sight.look(this.camera);
    const effort = this.effort(still);
    const done = this.goods?.update(this.sight, effort, this.pace.resting.meshes) ?? true;
    for (const room of [this.room, this.annexe]) room?.update(this.sight, effort);
    return done;
  }

  // While one moves, pictures follow one another as fast as the machine draws them: that time is what is minded.
  private count(began: number, following: boolean): void {
    const { figures } = this;
    figures.frames++;
    figures.calls = this.renderer.info.render.calls;
    figures.triangles = this.renderer.info.render.triangles;
    if (following) this.pace.took(began - this.began);
    this.began = began;
  }

  // Of a point of the canvas, in CSS pixels from its upper left corner.
  rayAt(x: number, y: number): Ray {
    const { clientWidth, clientHeight } = this.canvas;
    const caster = new Raycaster();
    caster.setFromCamera(new Vector2((x / clientWidth) * 2 - 1, 1 - (y / clientHeight) * 2), this.camera);
    const { origin, direction: way } = caster.ray;
    return { from: [origin.x, origin.y, origin.z], way: [way.x, way.y, way.z] };
  }

  pickAt(x: number, y: number): Picked | undefined {
    const goods = this.goods;
    if (!goods) return undefined;
    const ray = this.rayAt(x, y);
    const [first, second] = [this.room, this.annexe].map((room) =>
      pick(ray, {
        table: goods.table,
        skus: goods.skus,
        meshes: goods.farMeshes,
        room: room?.arrays,
        roomHidden: (index) => room?.isPassed(index) ?? false,
      }),
    );
    return first && second && second.distance < first.distance ? second : (first ?? second);
  }

  // Where a point of the store is on the canvas, or undefined when it is behind the eye.
  project(point: Vec3): { x: number; y: number } | undefined {
    const seen = new Vector3(...point).project(this.camera);
    if (seen.z > 1) return undefined;
    return { x: ((seen.x + 1) / 2) * this.canvas.clientWidth, y: ((1 - seen.y) / 2) * this.canvas.clientHeight };
  }

  // Resolves when the next picture is there: not asked for alone, but drawn.
  async drawn(): Promise<void> {
    const before = this.figures.frames;
    const turn = (): Promise<unknown> => new Promise((done) => setTimeout(done, fenceMilliseconds));
    while (this.figures.frames === before) await turn();
    const gl = this.renderer.getContext() as WebGL2RenderingContext;
    const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    if (!fence) return; // the picture's memory was lost; what comes next says so
    gl.flush();
    while (gl.getSyncParameter(fence, gl.SYNC_STATUS) === gl.UNSIGNALED) await turn();
    gl.deleteSync(fence);
  }

  async picture(): Promise<Blob | null> {
    this.still = true;
    this.renderer.setPixelRatio(this.pixelRatio());
    while (!this.prepare(true)); // builds all before it draws once
    this.draw(true);
    return new Promise((resolve) => this.canvas.toBlob(resolve, "image/png"));
  }
}
