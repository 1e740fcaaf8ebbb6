// The store from above, to be changed by hand: borders between zones are dragged (or moved by arrow keys), a zone is dragged onto
// another to swap the two, a click chooses one; runs of shelves of the chosen zone are dragged (or moved by arrow keys), too.
import type { Fixture, Summary, Violation, Zone } from "../store/contract";
import { zoneColor } from "../stage/overlays";
import type { Speech } from "../ui/speech";
import type { Cut, EditHead, Preview, Rect, Run } from "./contract";
import { limited, lineOf, ratioAt } from "./cuts";
import { keyShift, rounded, shifted, type Shift } from "./runs";
import { clickMoves, follow, shape } from "./shapes";

export interface MapActions {
  choose(zone: string): void;
  // While it is dragged, and when it is let go or given up (undefined).
  border(cut: Cut, ratio: number): void;
  letGo(cut: Cut, ratio: number | undefined): void;
  swap(a: string, b: string): void;
  // A run, while it is carried, and when it is put down or given up (undefined).
  carry(run: Run, by: Shift): void;
  putDown(run: Run, by: Shift | undefined): void;
}

const margin = 300; // millimetres round the store
const keyStep = 0.01;

export class PlanMap {
  readonly root = shape("svg", { class: "plan", role: "group" }) as SVGSVGElement;
  private cuts: readonly Cut[] = [];
  private zones: readonly Zone[] = [];
  private fixtures: readonly Rect[] = [];
  private runs: readonly Run[] = [];
  private violations: readonly Violation[] = [];
  private chosen: string | undefined;
  private held: { cut: Cut; ratio: number } | undefined;
  private carried: { run: Run; by: Shift } | undefined;
  private height = 0; // of the store, so that north is up

  constructor(
    private readonly speech: Speech,
    private readonly actions: MapActions,
    private readonly store: Pick<Summary, "outline_mm" | "bounds">,
  ) {
    const [width, depth] = store.bounds.high_m;
    this.height = depth * 1000;
    this.root.setAttribute("viewBox", `${-margin} ${-margin} ${width * 1000 + 2 * margin} ${this.height + 2 * margin}`);
    speech.bind(() => {
      this.root.setAttribute("aria-label", speech.say("editMap"));
      this.draw();
    });
  }

  show({ floors, fixtures, runs, cuts, violations }: Pick<EditHead, "floors" | "fixtures" | "runs" | "cuts" | "violations">): void {
    Object.assign(this, { zones: floors, fixtures: fixtures.map(rectOf), runs, cuts, violations, held: undefined, carried: undefined });
    this.draw();
  }

  // While a border is held or a run is carried: floors and fixtures as they would be.
  showPreview({ zones, fixtures, offences, violations }: Preview): void {
    Object.assign(this, { zones, fixtures: fixtures.map(({ rect_mm }) => rect_mm), violations: [...offences, ...violations] });
    this.draw();
  }

  choose(zone: string | undefined): void {
    this.chosen = zone;
    this.draw();
  }

  private draw(): void {
    const focused = (document.activeElement as Element | null)?.getAttribute("data-key");
    const types = [...new Set(this.zones.map(({ type }) => type))];
    this.root.replaceChildren(
      shape("polygon", { class: "outline", points: this.points(this.store.outline_mm) }),
      ...this.zones.map((zone) => this.zoneShape(zone, `#${zoneColor(types.indexOf(zone.type)).getHexString()}`)),
      ...this.fixtures.map((fixture) => this.rect(fixture, { class: "fixture" })),
      ...this.zones.map((zone) => this.nameOf(zone)),
      ...this.cuts.map((cut) => this.border(cut)),
      ...this.runs.filter(({ zone }) => zone === this.chosen).map((run) => this.runShape(run)),
      ...this.violations.flatMap((violation) => this.fault(violation)),
    );
    if (focused) this.root.querySelector<SVGElement>(`[data-key="${CSS.escape(focused)}"]`)?.focus();
  }

  private points(polygon: Zone["polygon_mm"]): string {
    return polygon.map(([x, y]) => `${x},${this.height - y}`).join(" ");
  }

  private zoneShape(zone: Zone, color: string): SVGElement {
    const name = this.speech.say("editZone", { name: zone.label || zone.id, area: this.speech.number(zone.area_m2) });
    const made = shape("polygon", {
      class: zone.id === this.chosen ? "zone chosen" : "zone",
      points: this.points(zone.polygon_mm),
      fill: color,
      tabindex: 0,
      role: "button",
      "aria-label": name,
      "aria-pressed": String(zone.id === this.chosen),
      "data-key": `zone ${zone.id}`,
      "data-zone": zone.id,
    });
    made.addEventListener("pointerdown", (event) => this.liftZone(event, zone.id));
    made.addEventListener("keydown", (event) => {
      if (event.key !== "Enter" && event.key !== " ") return;
      event.preventDefault();
      this.actions.choose(zone.id);
    });
    return made;
  }

  private rect([west, south, east, north]: Rect, more: Readonly<Record<string, string | number>>): SVGElement {
    return shape("rect", { x: west, y: this.height - north, width: east - west, height: north - south, ...more });
  }

  private runShape(run: Run): SVGElement {
    const carried = this.carried?.run.id === run.id ? this.carried : undefined;
    const by = carried?.by ?? { x: 0, y: 0 };
    const metres = (value: number): string => this.speech.number(value / 1000, 2);
    const at = this.speech.say("editRunAt", { x: metres(run.at_mm[0] + by.x), y: metres(run.at_mm[1] + by.y) });
    const handle = this.rect(shifted(run.rect_mm, by), {
      class: `run${carried ? " carried" : ""}${run.pinned ? " pinned" : ""}`,
      tabindex: 0,
      role: "button",
      "aria-label": `${this.speech.say("editRun", { run: run.id })}, ${at}`,
      "data-key": `run ${run.id}`,
      "data-run": run.id,
    });
    handle.append(shape("title", {}, `${run.id}, ${at}`));
    handle.addEventListener("pointerdown", (event) => this.liftRun(event, run));
    handle.addEventListener("keydown", (event) => this.keyOnRun(event, run));
    handle.addEventListener("blur", () => this.left(`run ${run.id}`, () => this.carried?.run.id === run.id && this.putDown(run, true)));
    return handle;
  }

  private nameOf(zone: Zone): SVGElement {
    const xs = zone.polygon_mm.map(([x]) => x);
    const ys = zone.polygon_mm.map(([, y]) => y);
    const [width, depth] = [Math.max(...xs) - Math.min(...xs), Math.max(...ys) - Math.min(...ys)];
    const text = zone.label || zone.id;
    const upright = depth > width * 1.3;
    const [x, y] = [(Math.max(...xs) + Math.min(...xs)) / 2, this.height - (Math.max(...ys) + Math.min(...ys)) / 2];
    const size = Math.min((1.7 * Math.max(width, depth)) / text.length, 0.5 * Math.min(width, depth), this.height / 18);
    return shape("text", { class: "name", x, y, "font-size": size, ...(upright && { transform: `rotate(-90 ${x} ${y})` }) }, text);
  }

  private border(cut: Cut): SVGElement {
    const held = this.held?.cut.node === cut.node ? this.held : undefined;
    const ratio = held?.ratio ?? cut.ratio;
    const { x1, y1, x2, y2 } = lineOf(cut, ratio);
    const places = { x1, y1: this.height - y1, x2, y2: this.height - y2 };
    const handle = shape("g", {
      class: `border ${cut.split}${held ? " held" : ""}`,
      tabindex: 0,
      role: "slider",
      "aria-label": this.speech.say("editBorder", { node: cut.node }),
      "aria-orientation": cut.split === "y" ? "vertical" : "horizontal",
      "aria-valuemin": 8,
      "aria-valuemax": 92,
      "aria-valuenow": Math.round(ratio * 100),
      "aria-valuetext": this.speech.say("editBorderValue", { share: this.speech.number(ratio * 100, 1) }),
      "data-key": `cut ${cut.node}`,
    });
    handle.append(shape("line", { class: "grip", ...places }), shape("line", { class: "line", ...places }));
    handle.addEventListener("pointerdown", (event) => this.liftBorder(event, cut));
    handle.addEventListener("keydown", (event) => this.keyOnBorder(event, cut));
    handle.addEventListener("blur", () => this.left(`cut ${cut.node}`, () => this.held?.cut.node === cut.node && this.release(cut, true)));
    return handle;
  }

  private fault({ at_mm, message }: Violation): SVGElement[] {
    if (!at_mm) return [];
    const mark = shape("circle", { class: "fault", cx: at_mm[0], cy: this.height - at_mm[1], r: this.height / 60 });
    mark.append(shape("title", {}, message));
    return [mark];
  }

  // Millimetres of the store.
  private place(event: PointerEvent): readonly [number, number] {
    const matrix = this.root.getScreenCTM()!.inverse();
    const at = new DOMPoint(event.clientX, event.clientY).matrixTransform(matrix);
    return [at.x, this.height - at.y];
  }

  private liftBorder(event: PointerEvent, cut: Cut): void {
    (event.currentTarget as SVGElement).focus();
    follow(
      event,
      (moved) => this.hold(cut, ratioAt(cut, ...this.place(moved))),
      (last) => this.release(cut, last !== undefined),
    );
  }

  private keyOnBorder(event: KeyboardEvent, cut: Cut): void {
    const step = { ArrowUp: keyStep, ArrowRight: keyStep, ArrowDown: -keyStep, ArrowLeft: -keyStep }[event.key];
    if (step !== undefined) this.hold(cut, limited((this.held?.ratio ?? cut.ratio) + step));
    else if (event.key === "Enter") this.release(cut, true);
    else if (event.key === "Escape" && this.held) {
      event.stopPropagation();
      this.release(cut, false);
    } else return;
    event.preventDefault();
  }

  private hold(cut: Cut, ratio: number): void {
    if (this.held?.ratio === ratio) return;
    this.held = { cut, ratio };
    this.draw();
    this.actions.border(cut, ratio);
  }

  private release(cut: Cut, take: boolean): void {
    if (!this.held) return;
    const { ratio } = this.held;
    this.held = undefined;
    this.actions.letGo(cut, take && ratio !== cut.ratio ? ratio : undefined);
  }

  // Drawing anew takes the focus away and gives it back: only who goes elsewhere lets go.
  private left(key: string, letGo: () => void): void {
    setTimeout(() => document.activeElement?.getAttribute("data-key") !== key && letGo());
  }

  private liftRun(event: PointerEvent, run: Run): void {
    (event.currentTarget as SVGElement).focus();
    const [x, y] = this.place(event);
    follow(
      event,
      (moved) => {
        const [nowX, nowY] = this.place(moved);
        this.carry(run, rounded({ x: nowX - x, y: nowY - y }));
      },
      (last) => this.putDown(run, last !== undefined),
    );
  }

  private keyOnRun(event: KeyboardEvent, run: Run): void {
    const step = { ArrowUp: [0, 1], ArrowRight: [1, 0], ArrowDown: [0, -1], ArrowLeft: [-1, 0] }[event.key];
    const by = this.carried?.by ?? { x: 0, y: 0 };
    if (step) this.carry(run, { x: by.x + step[0]! * keyShift, y: by.y + step[1]! * keyShift });
    else if (event.key === "Enter" && this.carried) this.putDown(run, true);
    else if (event.key === "Escape" && this.carried) {
      event.stopPropagation();
      this.putDown(run, false);
    } else return;
    event.preventDefault();
  }

  private carry(run: Run, by: Shift): void {
    const now = this.carried?.by ?? { x: 0, y: 0 };
    if (now.x === by.x && now.y === by.y) return;
    this.carried = { run, by };
    this.draw();
    this.actions.carry(run, by);
  }

  private putDown(run: Run, take: boolean): void {
    if (!this.carried) return;
    const { by } = this.carried;
    this.carried = undefined;
    this.actions.putDown(run, take && (by.x !== 0 || by.y !== 0) ? by : undefined);
  }

  private liftZone(event: PointerEvent, zone: string): void {
    (event.currentTarget as SVGElement).focus();
    const [x, y] = [event.clientX, event.clientY];
    const under = (at: PointerEvent): string | undefined =>
      document.elementsFromPoint(at.clientX, at.clientY).find((found) => found.hasAttribute("data-zone") && this.root.contains(found))?.getAttribute("data-zone") ?? undefined;
    const mark = (target: string | undefined): void => {
      for (const found of this.root.querySelectorAll(".zone")) found.classList.toggle("target", target !== zone && found.getAttribute("data-zone") === target);
    };
    follow(
      event,
      (moved) => mark(under(moved)),
      (last) => {
        mark(undefined);
        if (!last) return;
        const target = under(last);
        const stayed = Math.hypot(last.clientX - x, last.clientY - y) < clickMoves;
        if (stayed || target === zone) this.actions.choose(zone);
        else if (target !== undefined) this.actions.swap(zone, target);
      },
    );
  }
}

function rectOf({ position_m: [x, y], size_m: [width, depth], yaw_deg }: Fixture): Rect {
  const [w, d] = yaw_deg % 180 === 0 ? [width * 500, depth * 500] : [depth * 500, width * 500];
  return [x * 1000 - w, y * 1000 - d, x * 1000 + w, y * 1000 + d];
}
