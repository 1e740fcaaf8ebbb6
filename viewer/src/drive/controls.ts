// What keys and a gamepad tell a robot. Knows nothing of the page.
import type { Axes, Command, DriveEpisode, Grip, Triple } from "./contract";

// A gamepad of the browser's "standard" mapping.
export interface Pad {
  readonly axes: readonly number[];
  readonly buttons: readonly { readonly pressed: boolean; readonly value: number }[];
}

const usual = { drive: 0.35, turn: 0.45, move: 0.4, twist: 0.4, joint: 1 } as const; // shares that a key asks for
const fineShare = 0.3;
const rest = 0.12; // of a stick: what is less is none
export const padButtons = { grip: 0, arm: 1, axes: 3, twist: 4, fine: 5, down: 6, up: 7, pause: 9, liftUp: 12, liftDown: 13 } as const;
// Keys of further joints, down and up: of the first that is a length (a lift), then of those that are angles (a head).
const liftKeys = ["KeyF", "KeyR"] as const;
const angleKeys = [
  ["BracketLeft", "BracketRight"],
  ["Minus", "Equal"],
] as const;

export const drivingKeys: ReadonlySet<string> = new Set([
  ...["KeyW", "KeyA", "KeyS", "KeyD", "ArrowUp", "ArrowDown", "ArrowLeft", "ArrowRight"],
  ...["KeyI", "KeyK", "KeyJ", "KeyL", "KeyU", "KeyO", ...liftKeys, ...angleKeys.flat()],
]);

export type PadPress = "grip" | "arm" | "axes" | "pause";

export class Controls {
  arm = 0;
  axes: Axes = "base";
  fine = false;
  private grip: Grip = "keep";
  private pressed = new Set<PadPress>();

  constructor(private readonly episode: Pick<DriveEpisode, "has_base" | "arms" | "joints">) {}

  otherArm(): void {
    this.arm = (this.arm + 1) % Math.max(this.episode.arms.length, 1);
  }
  otherAxes(): void {
    this.axes = this.axes === "base" ? "tool" : "base";
  }
  // With the next command.
  take(grip: Grip): void {
    this.grip = grip;
  }

  // Buttons that have gone down since the last time.
  presses(pad: Pad | undefined): PadPress[] {
    const down = new Set((["grip", "arm", "axes", "pause"] as const).filter((name) => pad?.buttons[padButtons[name]]?.pressed));
    const fresh = [...down].filter((name) => !this.pressed.has(name));
    this.pressed = down;
    return fresh;
  }

  // A grip that was taken is told once.
  command(keys: ReadonlySet<string>, pad: Pad | undefined): Command {
    const slow = this.fine || pad?.buttons[padButtons.fine]?.pressed ? fineShare : 1;
    const key = (...codes: string[]): number => (codes.some((code) => keys.has(code)) ? 1 : 0);
    const stick = (axis: number): number => {
      const value = pad?.axes[axis] ?? 0;
      return Math.abs(value) < rest ? 0 : value;
    };
    const button = (name: keyof typeof padButtons): number => pad?.buttons[padButtons[name]]?.value ?? 0;
    const ahead = key("KeyW", "ArrowUp") - key("KeyS", "ArrowDown") - stick(1);
    const left = key("KeyA", "ArrowLeft") - key("KeyD", "ArrowRight") - stick(0);
    // What has no base is moved by its arm.
    const { has_base: drives } = this.episode;
    const along: Triple = [
      key("KeyI") - key("KeyK") - stick(3) + (drives ? 0 : ahead),
      key("KeyJ") - key("KeyL") - stick(2) + (drives ? 0 : left),
      key("KeyU") - key("KeyO") + button("up") - button("down"),
    ];
    const turns = keys.has("ShiftLeft") || keys.has("ShiftRight") || (pad?.buttons[padButtons.twist]?.pressed ?? false);
    const none: Triple = [0, 0, 0];
    const command = {
      drive: drives ? share(ahead * usual.drive * slow) : 0,
      turn: drives ? share(left * usual.turn * slow) : 0,
      move: turns ? none : shares(along, usual.move * slow),
      twist: turns ? shares(about(along), usual.twist * slow) : none,
      joints: this.joints(key, button("liftUp") - button("liftDown"), slow),
      arm: this.arm,
      axes: this.axes,
      grip: this.grip,
    };
    this.grip = "keep";
    return command;
  }

  private joints(key: (code: string) => number, lift: number, slow: number): number[] {
    const angles = angleKeys.values();
    let lifted = false;
    return this.episode.joints.map(({ dimension }) => {
      const isLift: boolean = dimension === "m" && !lifted;
      lifted ||= isLift;
      const pair = isLift ? liftKeys : dimension === "m" ? undefined : angles.next().value;
      return pair ? share((key(pair[1]) - key(pair[0]) + (isLift ? lift : 0)) * usual.joint * slow) : 0;
    });
  }
}

// Whether it moves anything.
export function moves(command: Command): boolean {
  return [command.drive, command.turn, ...command.move, ...command.twist, ...command.joints].some((value) => value !== 0) || command.grip !== "keep";
}

// The keys of ahead, left and up as turns: nose down, about the upright axis, roll.
function about([ahead, left, up]: Triple): Triple {
  return [up, ahead, left];
}

function share(value: number): number {
  return Math.min(Math.max(value, -1), 1) || 0;
}

function shares([x, y, z]: Triple, of: number): Triple {
  return [share(x * of), share(y * of), share(z * of)];
}
