// The store from above, to be changed by hand: borders between zones are dragged (or moved by arrow keys), a zone is dragged onto
// another to swap the two, a click chooses one.
import type { Fixture, Summary, Violation, Zone } from "../store/contract";
import { zoneColor } from "../stage/overlays";
import type { Speech } from "../ui/speech";
import type { Cut } from "./contract";
import { limited, lineOf, ratioAt } from "./cuts";

export interface MapActions {
  choose(zone: string): void;
  // While it is dragged, and when it is let go or given up (undefined).
  border(cut: Cut, ratio: number): void;
  letGo(cut: Cut, ratio: number | undefined): void;
  swap(a: string, b: string): void;
}

const svg = "http://www.w3.org/2000/svg";
const margin = 300; // millimetres round the store
const clickMoves = 6; // pixels a click may shake
const keyStep = 0.01;

type Attributes = Readonly<Record<string, string | number>>;

function shape(name: string, attributes: Attributes, text?: string): SVGElement {
  const made = document.createElementNS(svg, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, String(value));
  if (text !== undefined) made.textContent = text;
  return made;
}

export class PlanMap {
  readonly root = shape("svg", { class: "plan", role: "group" }) as SVGSVGElement;
  private cuts: readonly Cut[] = [];
  private zones: readonly Zone[] = [];
  private fixtures: readonly Fixture[] = [];
  private violations: readonly Violation[] = [];
  private chosen: string | undefined;
  private held: { cut: Cut; ratio: number } | undefined;
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

  show(floors: readonly Zone[], fixtures: readonly Fixture[], cuts: readonly Cut[], violations: readonly Violation[]): void {
    Object.assign(this, { zones: floors, fixtures, cuts, violations, held: undefined });
    this.draw();
  }

  // While a border is held: floors as they would be, without the fixtures that would move.
  showPreview(floors: readonly Zone[], violations: readonly Violation[]): void {
    Object.assign(this, { zones: floors, violations });
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
      ...(this.held ? [] : this.fixtures.map((fixture) => this.fixtureShape(fixture))),
      ...this.zones.map((zone) => this.nameOf(zone)),
      ...this.cuts.map((cut) => this.border(cut)),
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

  private fixtureShape({ position_m: [x, y], size_m: [width, depth], yaw_deg }: Fixture): SVGElement {
    const [w, d] = yaw_deg % 180 === 0 ? [width * 1000, depth * 1000] : [depth * 1000, width * 1000];
    return shape("rect", { class: "fixture", x: x * 1000 - w / 2, y: this.height - y * 1000 - d / 2, width: w, height: d });
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
    handle.addEventListener("blur", () => this.blurred(cut));
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

  // The pointer is followed on the whole page: the shape under it is drawn anew while it moves.
  private follow(event: PointerEvent, moved: (event: PointerEvent) => void, done: (event: PointerEvent | undefined) => void): void {
    event.preventDefault();
    const controller = new AbortController();
    const { signal } = controller;
    const end = (last: PointerEvent | undefined): void => {
      controller.abort();
      done(last);
    };
    window.addEventListener("pointermove", moved, { signal });
    window.addEventListener("pointerup", end, { signal });
    window.addEventListener("pointercancel", () => end(undefined), { signal });
    window.addEventListener("keydown", (key) => key.key === "Escape" && (key.stopPropagation(), end(undefined)), { signal, capture: true });
  }

  private liftBorder(event: PointerEvent, cut: Cut): void {
    (event.currentTarget as SVGElement).focus();
    this.follow(
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
  private blurred(cut: Cut): void {
    setTimeout(() => {
      const key = document.activeElement?.getAttribute("data-key");
      if (this.held?.cut.node === cut.node && key !== `cut ${cut.node}`) this.release(cut, true);
    });
  }

  private liftZone(event: PointerEvent, zone: string): void {
    (event.currentTarget as SVGElement).focus();
    const [x, y] = [event.clientX, event.clientY];
    const under = (at: PointerEvent): string | undefined =>
      document.elementsFromPoint(at.clientX, at.clientY).find((found) => found.hasAttribute("data-zone") && this.root.contains(found))?.getAttribute("data-zone") ?? undefined;
    const mark = (target: string | undefined): void => {
      for (const found of this.root.querySelectorAll(".zone")) found.classList.toggle("target", target !== zone && found.getAttribute("data-zone") === target);
    };
    this.follow(
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
