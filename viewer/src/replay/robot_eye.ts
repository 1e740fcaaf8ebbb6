// The eye that goes along with a robot, and comes before it.
import type { Navigator } from "../camera/navigator";
import { lookingAt, turned } from "../camera/pose";
import { add, distance, scale, sub, type Vec3 } from "../camera/vector";

// Where one looks from, seen from the robot: ahead, to its left, up; and what at.
export interface RobotView {
  readonly from: Vec3;
  readonly at: Vec3;
}
export const counterView: RobotView = { from: [1.75, -0.75, 1.05], at: [0.5, 0.05, 0.12] };
export const aisleView: RobotView = { from: [-1.9, 1.1, 2.6], at: [0.35, 0, 0.75] };

// Where it is and where it heads over the floor.
export interface Followed {
  readonly robotAt: Vec3;
  readonly heading: readonly [number, number];
}

export class RobotEye {
  following = true;
  private was: Vec3 | undefined;
  private headed: readonly [number, number] | undefined;
  private placed = false; // the eye was brought before the robot

  // `away`: so many times as far off as the view says; `turns`: with the robot.
  constructor(
    private readonly navigator: Navigator,
    public view: RobotView,
    private readonly away = 1,
    private readonly turns = false,
  ) {}

  // Keeps its place beside the robot; the first time it comes before it.
  follow(robot: Followed): void {
    if (!this.placed) this.come(robot, true);
    const [was, headed] = [this.was ?? robot.robotAt, this.headed ?? robot.heading];
    const moved = distance(was, robot.robotAt) > 1e-4 || (this.turns && Math.hypot(headed[0] - robot.heading[0], headed[1] - robot.heading[1]) > 1e-4);
    [this.was, this.headed] = [robot.robotAt, robot.heading];
    if (!moved || !this.following || this.navigator.flying || this.navigator.mode === "top") return;
    const { pose } = this.navigator;
    const turn = this.turns ? Math.atan2(headed[0] * robot.heading[1] - headed[1] * robot.heading[0], headed[0] * robot.heading[0] + headed[1] * robot.heading[1]) : 0;
    const [x, y, z] = sub(pose.eye, was);
    const [c, s] = [Math.cos(turn), Math.sin(turn)];
    const eye: Vec3 = [robot.robotAt[0] + c * x - s * y, robot.robotAt[1] + s * x + c * y, was[2] + z];
    this.navigator.pose = { ...turned(pose, turn, 0), eye };
  }

  toggle(robot: Followed, atOnce: boolean): void {
    this.following = !this.following;
    this.was = this.headed = undefined;
    if (this.following && this.navigator.mode !== "top") this.come(robot, atOnce);
  }

  // To where the view has it.
  come(robot: Followed, atOnce: boolean): void {
    this.placed = true;
    const { from, at } = this.view;
    const [fx, fy] = robot.heading;
    const seen = ([ahead, left, up]: Vec3): Vec3 => add(robot.robotAt, [fx * ahead - fy * left, fy * ahead + fx * left, up]);
    const target = seen(at);
    const eye = add(target, scale(sub(seen(from), target), this.away));
    this.navigator.goTo(lookingAt(eye, target), distance(eye, target), atOnce);
  }
}
