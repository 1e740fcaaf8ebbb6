// Mouse, touch and keys on the picture, as what the navigator understands.
import type { Held } from "../camera/navigator";
import type { Mode } from "../camera/modes";

export interface HandActions {
  drag(dx: number, dy: number, pan: boolean): void;
  zoom(factor: number): void;
  click(x: number, y: number): void;
  key(event: KeyboardEvent): boolean; // true: used
  wake(): void;
}

const still = 5; // pixels a click may shake

interface Finger {
  x: number;
  y: number;
}

export class Hands {
  private readonly fingers = new Map<number, Finger>();
  private readonly down = new Set<string>();
  private travelled = 0;
  private pan = false;

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly actions: HandActions,
  ) {
    canvas.addEventListener("pointerdown", (event) => this.press(event));
    canvas.addEventListener("pointermove", (event) => this.move(event));
    canvas.addEventListener("pointerup", (event) => this.lift(event));
    canvas.addEventListener("pointercancel", (event) => this.fingers.delete(event.pointerId));
    canvas.addEventListener("contextmenu", (event) => event.preventDefault());
    canvas.addEventListener("wheel", (event) => this.wheel(event), { passive: false });
    window.addEventListener("keydown", (event) => this.keyDown(event));
    window.addEventListener("keyup", (event) => this.down.delete(event.code));
    window.addEventListener("blur", () => this.down.clear());
  }

  held(mode: Mode): Held {
    const key = (...codes: string[]): number => (codes.some((code) => this.down.has(code)) ? 1 : 0);
    const onFoot = mode === "walk" || mode === "fly";
    const [up, down, left, right] = [key("ArrowUp"), key("ArrowDown"), key("ArrowLeft"), key("ArrowRight")];
    const inPlan = mode === "top";
    return {
      forward: key("KeyW") - key("KeyS") + (onFoot || inPlan ? up - down : 0),
      right: key("KeyD") - key("KeyA") + (inPlan ? right - left : 0),
      up: key("KeyE") - key("KeyQ"),
      turn: inPlan ? 0 : left - right,
      tilt: onFoot ? key("PageUp") - key("PageDown") : up - down,
      fast: this.down.has("ShiftLeft") || this.down.has("ShiftRight"),
    };
  }

  // By their codes: "KeyW".
  get keysDown(): ReadonlySet<string> {
    return this.down;
  }

  get busy(): boolean {
    return this.down.size > 0 || this.fingers.size > 0;
  }

  private press(event: PointerEvent): void {
    this.canvas.focus({ preventScroll: true });
    this.canvas.setPointerCapture(event.pointerId);
    this.fingers.set(event.pointerId, { x: event.offsetX, y: event.offsetY });
    if (this.fingers.size === 1) this.travelled = 0;
    this.pan = event.button !== 0 || event.shiftKey;
  }

  private move(event: PointerEvent): void {
    const finger = this.fingers.get(event.pointerId);
    if (!finger) return;
    const [dx, dy] = [event.offsetX - finger.x, event.offsetY - finger.y];
    this.travelled += Math.abs(dx) + Math.abs(dy);
    if (this.fingers.size === 1) {
      finger.x += dx;
      finger.y += dy;
      if (this.travelled > still) this.actions.drag(dx, dy, this.pan);
    } else {
      const before = this.spread();
      finger.x += dx;
      finger.y += dy;
      const after = this.spread();
      if (before > 0 && after > 0) this.actions.zoom(after / before);
      this.actions.drag(dx / 2, dy / 2, true);
    }
    this.actions.wake();
  }

  private lift(event: PointerEvent): void {
    const single = this.fingers.size === 1;
    if (!this.fingers.delete(event.pointerId)) return;
    if (single && this.travelled <= still && event.button === 0) this.actions.click(event.offsetX, event.offsetY);
  }

  private spread(): number {
    const [a, b] = [...this.fingers.values()];
    return a && b ? Math.hypot(a.x - b.x, a.y - b.y) : 0;
  }

  private wheel(event: WheelEvent): void {
    event.preventDefault();
    const lines = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 16 : 1;
    this.actions.zoom(Math.exp(-event.deltaY * lines * 0.0014));
    this.actions.wake();
  }

  private keyDown(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const { target } = event;
    if (!(target instanceof Element)) return;
    if (target.closest("input, textarea, select, dialog, [role=menu]")) return;
    if (this.actions.key(event)) {
      event.preventDefault();
      return;
    }
    if (target.closest("button")) return;
    this.down.add(event.code);
    if (/^(Arrow|Page)/.test(event.code)) event.preventDefault();
    this.actions.wake();
  }
}
