// The page: what the reader does becomes what is shown.
import { Navigator, topFov } from "./camera/navigator";
import type { Mode } from "./camera/modes";
import { modes } from "./camera/modes";
import { lookingAt, type Pose } from "./camera/pose";
import { roomOf } from "./camera/store_room";
import { add, distance, type Vec3 } from "./camera/vector";
import { readAddress, writeAddress, type ViewState } from "./state/address";
import { layerNames, type LayerName } from "./state/layers";
import type { RunBlock } from "./edit/block_swap";
import type { EditClient } from "./edit/client";
import { Editing } from "./edit/editing";
import { makeLink } from "./make/addresses";
import type { Hit, StoreCamera, Summary } from "./store/contract";
import { elevationOf } from "./stage/elevation";
import { fronts, facingOf, rotationOf } from "./stage/goods_table";
import { heatOf, type HeatName } from "./stage/heat";
import { screensOf, Sight } from "./stage/sight";
import type { Stage } from "./stage/stage";
import { CardPanel } from "./ui/cards";
import { element, reduced } from "./ui/dom";
import { ElevationPanel } from "./ui/elevation";
import { Hands } from "./ui/hands";
import { Help } from "./ui/help";
import type { Movable } from "./ui/joint_controls";
import { drawLayers } from "./ui/layer_marks";
import { LayersPanel } from "./ui/layers";
import { Marks } from "./ui/marks";
import { SearchPanel, shownHits } from "./ui/search";
import type { Speech } from "./ui/speech";
import type { Status } from "./ui/status";
import { Tape } from "./ui/tape";
import { Theme } from "./ui/theme";
import { Toolbar } from "./ui/toolbar";

const longestStep = 0.1; // seconds: however slow the pictures, a walker makes no leap (a flight does)
const addressPause = 250;
const defaultFov = 55;

export class App {
  readonly navigator: Navigator;
  private readonly hands: Hands;
  private readonly toolbar: Toolbar;
  private readonly search: SearchPanel;
  private readonly card: CardPanel;
  private readonly help: Help;
  private readonly marks = new Marks();
  private readonly theme: Theme;
  private readonly layers = new Set<LayerName>();
  private heat: HeatName | undefined;
  private readonly layersPanel: LayersPanel;
  private readonly elevation: ElevationPanel;
  private readonly editing: Editing;
  private readonly tape: Tape;
  private product: number | undefined;
  private fixture: number | undefined;
  private addressTimer = 0;
  private lastFrame = 0;
  private shownPose: Pose | undefined;
  private choosing: AbortController | undefined;

  constructor(
    private readonly client: EditClient,
    private readonly stage: Stage,
    private readonly summary: Summary,
    private readonly speech: Speech,
    private readonly status: Status,
  ) {
    stage.ceilingHeight = summary.ceiling_m;
    stage.sight = new Sight(screensOf(summary.fixtures));
    const wanted = readAddress(location.hash);
    this.tape = new Tape(stage, this.marks, speech);
    stage.setLens(this.usualFov());
    this.navigator = this.startNavigator(wanted);
    this.theme = new Theme((background) => stage.setBackground(background));
    this.search = this.makeSearch();
    this.card = new CardPanel(speech, {
      close: () => this.deselect(),
      goTo: () => this.product !== undefined && this.goToProduct(this.product),
      showAll: () => this.product !== undefined && this.showAllOf(this.product),
      elevation: (run) => this.elevation.open(run),
      move: (joint, to) => this.moveJoint(joint, to),
    });
    this.elevation = this.makeElevation();
    this.help = new Help(speech);
    const layerActions = { toggle: (layer: LayerName) => this.toggleLayer(layer), heat: (name: HeatName | undefined) => this.setHeat(name), close: () => this.openLayers(false) };
    this.layersPanel = new LayersPanel(speech, layerActions, summary.violations.map(({ message }) => message));
    this.editing = this.makeEditing();
    this.toolbar = this.makeToolbar();
    this.hands = this.makeHands();
    document.body.append(element("div", { class: "crosshair" }), this.marks.layer, this.search.panel, this.card.panel, this.elevation.panel, this.layersPanel.panel, this.editing.panel.panel, this.toolbar.bar, this.help.dialog);
    document.title = `${summary.name} · MarketGen`;
    speech.bind(() => {
      stage.canvas.setAttribute("aria-label", speech.say("view3d"));
      this.showLayers();
      if (this.heat) this.showHeat();
      this.tape.show();
    });
    window.addEventListener("hashchange", () => this.apply(readAddress(location.hash)));
    this.showTools();
  }

  // Once the goods are there: what the address asks for beside the pose.
  restore(): void {
    const state = readAddress(location.hash);
    const { product, fixture, query } = state;
    this.setLayers(layersOf(state));
    if (state.heat) this.setHeat(state.heat);
    if (query) void this.search.start(query);
    if (product !== undefined) void this.selectProduct(product);
    else if (fixture !== undefined) void this.selectFixture(fixture);
  }

  // One turn of the page's loop.
  frame(now: number): void {
    const seconds = (now - this.lastFrame) / 1000;
    this.lastFrame = now;
    this.navigator.step(this.navigator.flying ? seconds : Math.min(seconds, longestStep), this.hands.held(this.navigator.mode));
    const moved = this.navigator.pose !== this.shownPose;
    if (moved) {
      this.shownPose = this.navigator.pose;
      this.stage.setPose(this.navigator.pose);
      this.addressSoon();
    }
    if (this.stage.frame(moved)) this.marks.place((point) => this.stage.project(point), this.navigator.pose.eye);
  }

  private startNavigator(wanted: ViewState): Navigator {
    const room = roomOf(this.summary);
    const camera = this.summary.cameras.find(({ name }) => name === "entrance") ?? this.summary.cameras[0];
    const eye: Vec3 = camera?.from_m ?? add(room.low, [1, 1, 1.6]);
    const at: Vec3 = camera?.at_m ?? add(room.high, [0, 0, -2]);
    if (wanted.pose) return new Navigator(room, wanted.mode ?? "orbit", wanted.pose, wanted.distance ?? 2);
    return new Navigator(room, wanted.mode ?? "orbit", lookingAt(eye, at), distance(eye, at));
  }

  private makeSearch(): SearchPanel {
    return new SearchPanel(
      this.speech,
      {
        ask: (query, signal) => this.client.search(query, signal),
        found: (hits, query) => this.showFound(hits, query),
        choose: (hit) => this.choose(hit),
        failed: (error) => this.status.say(this.status.textOf(error)),
      },
      this.summary,
    );
  }

  private makeElevation(): ElevationPanel {
    const { summary } = this;
    return new ElevationPanel(this.speech, summary.skus, {
      of: (run, side) => this.stage.goods && elevationOf(run, side, summary.fixtures, this.stage.goods.table, summary.skus),
      choose: (product) => void this.selectProduct(product),
      closed: () => this.stage.canvas.focus({ preventScroll: true }),
      blocks: (run) => this.blocksOf(run),
      swap: {
        preview: (patches) => this.editing.look(patches),
        change: (patches) => this.editing.change(patches),
        nameOf: (sku) => {
          const row = summary.skus.find((known) => known.sku === sku);
          return row ? this.speech.nameOf(row) : sku;
        },
      },
      isEdited: () => this.editing.isOn,
    });
  }

  private async blocksOf(run: string): Promise<readonly RunBlock[]> {
    try {
      return await this.client.blocks(run);
    } catch (error) {
      this.status.say(this.status.textOf(error));
      return [];
    }
  }

  private makeEditing(): Editing {
    const { client, stage, summary, speech, status } = this;
    return new Editing(client, stage, summary, speech, status, {
      changing: () => {
        this.deselect();
        if (this.search.query) this.search.clear();
      },
      changed: () => {
        this.elevation.refresh();
        this.navigator.room = roomOf(summary);
        this.search.showCounts();
        this.layersPanel.setViolations(summary.violations.map(({ message }) => message));
        this.showLayers();
        this.showHeat();
      },
      closed: () => {
        this.elevation.refresh();
        this.stage.canvas.focus({ preventScroll: true });
        this.showTools();
      },
      told: (text, isFault) => this.elevation.tell(text, isFault),
      front: (run) => this.elevation.open(run),
    });
  }

  private toggleEditing(): void {
    this.editing.toggle();
    this.elevation.refresh();
    this.showTools();
  }

  private makeToolbar(): Toolbar {
    const actions = {
      mode: (mode: Mode) => this.enter(mode),
      view: (camera: StoreCamera) => this.goToCamera(camera),
      measure: () => this.toggleMeasure(),
      zones: () => this.toggleLayer("zones"),
      layers: () => this.openLayers(!this.layersPanel.isOpen),
      ...(this.summary.may_edit && { edit: () => this.toggleEditing(), make: () => location.assign(makeLink(new URLSearchParams(location.search).get("token"))) }),
      picture: () => void this.savePicture(),
      share: () => void this.share(),
      theme: () => this.theme.toggle(),
      help: () => this.help.open(),
    };
    return new Toolbar(this.speech, actions, this.summary.cameras, this.summary.zones);
  }

  private makeHands(): Hands {
    const fov = (): number => (this.stage.camera.fov * Math.PI) / 180;
    return new Hands(this.stage.canvas, {
      drag: (dx, dy, pan) => this.navigator.drag(dx, dy, this.stage.canvas.clientHeight, fov(), pan),
      zoom: (factor) => this.navigator.zoom(factor),
      click: (x, y) => this.click(x, y),
      key: (event) => this.key(event),
      wake: () => undefined,
    });
  }

  private key(event: KeyboardEvent): boolean {
    const onButton = (event.target as HTMLElement).closest("button, a, [role=option]") !== null;
    const mode = modes[Number(event.key) - 1];
    if (mode) this.enter(mode);
    else if (event.key === "/") this.search.focus();
    else if (event.key === "?") this.help.open();
    else if (event.key === "m" || event.key === "M") this.toggleMeasure();
    else if (event.key === "z" || event.key === "Z") this.toggleLayer("zones");
    else if (event.key === "l" || event.key === "L") this.openLayers(!this.layersPanel.isOpen);
    else if (event.key === "r" || event.key === "R") this.toggleEditing();
    else if (event.key === "p" || event.key === "P") void this.savePicture();
    else if (event.key === "Escape") this.escape();
    else if (event.key === "Enter" && !onButton) this.click(this.stage.canvas.clientWidth / 2, this.stage.canvas.clientHeight / 2);
    else return false;
    return true;
  }

  private escape(): void {
    if (this.tape.isOut) this.toggleMeasure();
    else if (this.layersPanel.isOpen) this.openLayers(false);
    else if (this.product !== undefined || this.fixture !== undefined) this.deselect();
    else this.search.clear();
  }

  private enter(mode: Mode): void {
    // The view from above has a lens of its own: there is no flight between the two.
    this.navigator.enter(mode, reduced() || mode === "top" || this.navigator.mode === "top");
    this.showTools();
    this.addressSoon();
  }

  private goToCamera(camera: StoreCamera): void {
    if (camera.ortho_height_m > 0) return this.enter("top");
    const still = reduced() || this.navigator.mode === "top";
    this.navigator.mode = "orbit";
    this.stage.setLens(camera.fov_deg);
    this.navigator.goTo(lookingAt(camera.from_m, camera.at_m), distance(camera.from_m, camera.at_m), still);
    this.showTools();
  }

  private usualFov(): number {
    return this.summary.cameras.find(({ name }) => name === "entrance")?.fov_deg ?? defaultFov;
  }

  private click(x: number, y: number): void {
    const picked = this.stage.pickAt(x, y);
    if (this.tape.isOut) {
      if (picked) this.tape.add(picked.point);
    } else if (picked?.product !== undefined) void this.selectProduct(picked.product);
    else if (picked?.fixture !== undefined) void this.selectFixture(picked.fixture);
    else this.deselect();
  }

  private async selectProduct(row: number): Promise<void> {
    if (row >= this.summary.counts.products) return;
    const signal = this.beginChoice();
    this.product = row;
    this.stage.overlays?.selectProduct(row);
    this.stage.redraw();
    await this.fill(async () => {
      const card = await this.client.product(row, signal);
      this.card.show({ kind: "product", card, picture: this.client.address(`/skus/${card.sku_row}/label.png?px=256`) });
    }, signal);
  }

  private async selectFixture(row: number): Promise<void> {
    const fixture = this.summary.fixtures[row];
    if (!fixture) return;
    const signal = this.beginChoice();
    this.fixture = row;
    this.stage.overlays?.selectFixture(fixture);
    this.stage.redraw();
    await this.fill(async () => {
      const card = await this.client.fixture(row, signal);
      this.card.show({ kind: "fixture", card, joints: () => this.movable(card.joints) });
    }, signal);
  }

  private movable(joints: readonly number[]): Movable[] {
    const moving = this.stage.room?.moving;
    if (!moving) return [];
    return joints.filter((row) => moving.canMove(row)).map((row) => ({ joint: this.summary.joints[row]!, position: moving.positions[row]! }));
  }

  private moveJoint(joint: number, to: number): void {
    this.stage.room?.move(joint, to);
    this.stage.redraw();
  }

  private beginChoice(): AbortSignal {
    this.choosing?.abort();
    this.choosing = new AbortController();
    this.product = this.fixture = undefined;
    return this.choosing.signal;
  }

  private async fill(work: () => Promise<void>, signal: AbortSignal): Promise<void> {
    try {
      await work();
    } catch (error) {
      if (signal.aborted) return;
      this.deselect();
      this.status.say(this.status.textOf(error));
    }
    this.addressSoon();
  }

  private deselect(): void {
    this.beginChoice().throwIfAborted();
    this.stage.overlays?.selectProduct(undefined);
    this.card.show(undefined);
    this.stage.redraw();
    this.addressSoon();
  }

  private choose(hit: Hit): void {
    const row = hit.products[0];
    if (row === undefined) return;
    this.goToProduct(row);
    void this.selectProduct(row);
  }

  // Before its shelf, as far off as one stands to read it.
  private goToProduct(row: number): void {
    const table = this.stage.goods?.table;
    if (!table) return;
    const size = this.summary.skus[table.sku[row]!]!.size_m;
    const at: Vec3 = [table.position[row * 3]!, table.position[row * 3 + 1]!, table.position[row * 3 + 2]! + size[2] / 2];
    const [fx, fy] = fronts[facingOf(rotationOf(table, row))]!;
    const away = 0.75 + Math.max(...size) + 0.1 * table.rank[row]!;
    const still = reduced() || this.navigator.mode === "top";
    if (this.navigator.mode === "top") this.navigator.mode = "orbit";
    const high = this.navigator.mode === "walk" ? 1.62 : at[2] + 0.12;
    const eye: Vec3 = [at[0] + fx * away, at[1] + fy * away, high];
    this.navigator.goTo(lookingAt(eye, at), distance(eye, at), still);
    this.showTools();
  }

  private showFound(hits: readonly Hit[], query: string): void {
    const rows = hits.slice(0, shownHits).flatMap((hit) => hit.products);
    this.stage.overlays?.highlight(rows);
    this.stage.shared.uDim.value = rows.length > 0 ? 0.72 : 0;
    this.stage.redraw();
    if (query === "" || hits.length > 0) this.addressSoon();
  }

  private showAllOf(product: number): void {
    const table = this.stage.goods?.table;
    if (!table) return;
    const rows: number[] = [];
    for (let row = 0; row < table.count; row++) if (table.sku[row] === table.sku[product]) rows.push(row);
    this.stage.overlays?.highlight(rows);
    this.stage.shared.uDim.value = 0.72;
    this.enter("top");
    this.stage.redraw();
  }

  private toggleMeasure(): void {
    this.tape.toggle();
    if (this.tape.isOut) this.status.say(this.speech.say("measureHint"));
    this.showTools();
  }

  private toggleLayer(layer: LayerName): void {
    if (!this.layers.delete(layer)) this.layers.add(layer);
    this.setLayers([...this.layers]);
  }

  private setLayers(layers: readonly LayerName[]): void {
    this.layers.clear();
    for (const layer of layers) this.layers.add(layer);
    this.showLayers();
    this.showTools();
    this.addressSoon();
  }

  private setHeat(name: HeatName | undefined): void {
    this.heat = name;
    this.showHeat();
    this.addressSoon();
  }

  private showHeat(): void {
    const { goods } = this.stage;
    const heat = this.heat && goods && heatOf(this.heat, goods.table, goods.skus);
    goods?.showHeat(heat);
    this.layersPanel.showHeat(this.heat, heat);
  }

  private openLayers(open: boolean): void {
    this.layersPanel.open(open);
    if (!open) this.stage.canvas.focus({ preventScroll: true });
    this.showTools();
  }

  private showLayers(): void {
    drawLayers(this.layers, this.summary, this.stage, this.marks, this.speech);
    this.layersPanel.show(this.layers);
  }

  private async savePicture(): Promise<void> {
    const blob = await this.stage.picture();
    if (!blob) return;
    const address = URL.createObjectURL(blob);
    const link = element("a", { attributes: { href: address, download: `${this.summary.folder || "store"}.png` } });
    link.click();
    setTimeout(() => URL.revokeObjectURL(address), 10_000);
  }

  private async share(): Promise<void> {
    this.writeAddress();
    try {
      await navigator.clipboard.writeText(location.href);
      this.status.say(this.speech.say("copied"));
    } catch {
      this.status.say(this.speech.say("notCopied"));
    }
  }

  private apply(state: ViewState): void {
    if (state.mode) this.navigator.mode = state.mode;
    if (state.pose) this.navigator.goTo(state.pose, state.distance ?? this.navigator.around, true);
    this.setLayers(layersOf(state));
    if (state.heat !== this.heat) this.setHeat(state.heat);
    if ((state.query ?? "") !== this.search.query) void this.search.start(state.query ?? "");
    if (state.product !== this.product && state.product !== undefined) void this.selectProduct(state.product);
    else if (state.fixture !== this.fixture && state.fixture !== undefined) void this.selectFixture(state.fixture);
    this.showTools();
  }

  private addressSoon(): void {
    clearTimeout(this.addressTimer);
    this.addressTimer = window.setTimeout(() => this.writeAddress(), addressPause);
  }

  private writeAddress(): void {
    const { mode, pose, around } = this.navigator;
    const state: ViewState = {
      mode,
      pose,
      distance: around,
      zones: this.layers.has("zones"),
      layers: layerNames.filter((name) => name !== "zones" && this.layers.has(name)),
      ...(this.product !== undefined && { product: this.product }),
      ...(this.fixture !== undefined && { fixture: this.fixture }),
      ...(this.heat && { heat: this.heat }),
      ...(this.search.query && { query: this.search.query }),
    };
    history.replaceState(null, "", writeAddress(state));
  }

  private showTools(): void {
    if (this.navigator.mode === "top") this.stage.setLens(topFov);
    else if (this.stage.camera.fov === topFov) this.stage.setLens(this.usualFov());
    this.toolbar.show({ mode: this.navigator.mode, measuring: this.tape.isOut, zones: this.layers.has("zones"), layers: this.layersPanel.isOpen, edit: this.editing.panel.isOpen });
  }
}

function layersOf({ zones, layers }: ViewState): LayerName[] {
  return zones ? ["zones", ...(layers ?? [])] : [...(layers ?? [])];
}
