// Sticks and buttons on the glass, for fingers: as a gamepad has them.
import { element } from "../ui/dom";
import type { Speech } from "../ui/speech";
import { padButtons, type Pad } from "./controls";
import { say, type DriveKey } from "./strings";

const reach = 44; // pixels from a stick's middle to its end
// In two columns: what goes up stands above what goes down.
const held: readonly (readonly [keyof typeof padButtons, DriveKey])[] = [
  ["grip", "touchGrip"],
  ["arm", "touchArm"],
  ["up", "touchUp"],
  ["liftUp", "touchLiftUp"],
  ["down", "touchDown"],
  ["liftDown", "touchLiftDown"],
  ["axes", "touchAxes"],
];
const kept = ["twist", "touchTwist"] as const; // until it is pressed again

export class TouchPad implements Pad {
  readonly axes: number[] = [0, 0, 0, 0];
  readonly buttons = Array.from({ length: 17 }, () => ({ pressed: false, value: 0 }));
  readonly panel = element("section", { class: "drive-touch" });

  // `lifts`: the robot has a lift; `arms`: how many.
  constructor(
    private readonly speech: Speech,
    { lifts, arms }: { readonly lifts: boolean; readonly arms: number },
  ) {
    const buttons = element("div", { class: "touch-buttons" });
    for (const [name, key] of held) {
      if ((!lifts && name.startsWith("lift")) || (arms < 2 && name === "arm")) continue;
      buttons.append(this.button(name, key));
    }
    buttons.append(this.keeper());
    this.panel.append(this.stick(0, "touchDrive"), buttons, this.stick(2, "touchMove"));
    speech.bind(() => this.panel.setAttribute("aria-label", say(speech.language, "touch")));
  }

  private name(part: HTMLElement, key: DriveKey, shown: boolean): void {
    this.speech.bind(() => {
      const text = say(this.speech.language, key);
      if (shown) part.textContent = text;
      else part.setAttribute("aria-label", text);
    });
  }

  private set(name: keyof typeof padButtons, down: boolean): void {
    Object.assign(this.buttons[padButtons[name]]!, { pressed: down, value: down ? 1 : 0 });
  }

  private button(name: keyof typeof padButtons, key: DriveKey): HTMLElement {
    const button = element("button", { attributes: { type: "button", "data-pad": name } });
    button.addEventListener("pointerdown", (event) => {
      button.setPointerCapture(event.pointerId);
      this.set(name, true);
    });
    for (const end of ["pointerup", "pointercancel", "lostpointercapture"] as const) button.addEventListener(end, () => this.set(name, false));
    button.addEventListener("contextmenu", (event) => event.preventDefault());
    this.name(button, key, true);
    return button;
  }

  private keeper(): HTMLElement {
    const [name, key] = kept;
    const button = element("button", { attributes: { type: "button", "aria-pressed": "false", "data-pad": name } });
    button.addEventListener("click", () => {
      const down = !this.buttons[padButtons[name]]!.pressed;
      this.set(name, down);
      button.setAttribute("aria-pressed", String(down));
    });
    this.name(button, key, true);
    return button;
  }

  private stick(axis: 0 | 2, key: DriveKey): HTMLElement {
    const knob = element("span");
    const stick = element("div", { class: "stick", attributes: { role: "group", "data-stick": axis === 0 ? "drive" : "move" } }, knob);
    let finger: number | undefined;
    const lean = (x: number, y: number): void => {
      const [across, down] = leaning(x, y);
      [this.axes[axis], this.axes[axis + 1]] = [across, down];
      knob.style.transform = `translate(${across * reach}px, ${down * reach}px)`;
    };
    const move = (event: PointerEvent): void => {
      if (event.pointerId !== finger) return;
      const box = stick.getBoundingClientRect();
      lean(event.clientX - box.left - box.width / 2, event.clientY - box.top - box.height / 2);
    };
    const end = (event: PointerEvent): void => {
      if (event.pointerId !== finger) return;
      finger = undefined;
      lean(0, 0);
    };
    stick.addEventListener("pointerdown", (event) => {
      finger ??= event.pointerId;
      stick.setPointerCapture(event.pointerId);
      move(event);
    });
    stick.addEventListener("pointermove", move);
    for (const name of ["pointerup", "pointercancel", "lostpointercapture"] as const) stick.addEventListener(name, end);
    this.name(stick, key, false);
    return stick;
  }
}

// Pixels from the middle as shares of the way to the end, no farther than that.
export function leaning(x: number, y: number): [number, number] {
  const far = Math.max(Math.hypot(x, y), reach);
  return [x / far, y / far];
}

// Whatever is pressed or leans farther, of two.
export function together(pad: Pad | undefined, touch: Pad): Pad {
  if (!pad) return touch;
  const axes = touch.axes.map((value, i) => (Math.abs(value) > Math.abs(pad.axes[i] ?? 0) ? value : (pad.axes[i] ?? 0)));
  const buttons = touch.buttons.map((button, i) => (button.pressed ? button : (pad.buttons[i] ?? button)));
  return { axes, buttons };
}
