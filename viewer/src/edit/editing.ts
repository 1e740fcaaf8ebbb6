// One edit of the store: asks the server, shows what came of it, and keeps the right to go on.
import { Goods } from "../stage/goods";
import { readGoods, type GoodsTable } from "../stage/goods_table";
import { Overlays } from "../stage/overlays";
import { Room } from "../stage/room";
import { screensOf, Sight } from "../stage/sight";
import type { Stage } from "../stage/stage";
import { ServerError } from "../store/client";
import type { Sku, Summary } from "../store/contract";
import type { Packed } from "../store/packed";
import type { Speech } from "../ui/speech";
import type { Status } from "../ui/status";
import type { EditClient } from "./client";
import type { EditHead, Patch } from "./contract";
import { editedGoods, editedGoodsLight, editedRoom, rowsBefore } from "./delta";
import { NearLight, wayOf } from "./light";
import { EditPanel } from "./panel";

const beatSeconds = 10; // the server waits 30 for it
const taken = "server.edit_taken";
const lampFrom = 180; // bytes of stored light: what is brighter shines by itself

export interface Editor {
  changing(): void; // rows are about to get other numbers
  changed(): void; // the summary says other things
  closed(): void;
  told(text: string, isFault: boolean): void; // of a preview or a change
  front(run: string): void; // is to be seen from the front
}

// The store as it was opened: what the server describes every edit against.
interface Opened {
  readonly table: GoodsTable;
  readonly light: Uint8Array;
  readonly skus: number;
  readonly floors: string; // as JSON
  readonly nearGoods: NearLight;
  readonly nearRoom: NearLight;
}

// Lists of the summary are shared by everything that reads it: they change in place.
function refill<T>(list: readonly T[], rows: readonly T[], from = 0): void {
  (list as T[]).splice(from, list.length - from, ...rows);
}

export class Editing {
  readonly panel: EditPanel;
  private opened: Opened | undefined;
  private working: Promise<void> = Promise.resolve();
  private previewing = false;
  private nextPreview: readonly Patch[] | undefined;
  private previews = 0; // what is let go makes those that are under way void
  private beating = 0;
  private from: Uint32Array | undefined; // of the rows that are shown: rows of the opened store

  constructor(
    private readonly client: EditClient,
    private readonly stage: Stage,
    private readonly summary: Summary,
    private readonly speech: Speech,
    private readonly status: Status,
    private readonly app: Editor,
  ) {
    this.panel = new EditPanel(
      speech,
      {
        change: (patches) => this.change(patches),
        preview: (patches) => void this.preview(patches),
        told: (text, isFault) => this.app.told(text, isFault),
        front: (run) => this.app.front(run),
        say: (words) => this.run(() => this.client.say(words)),
        undo: () => this.run(() => this.client.undo()),
        redo: () => this.run(() => this.client.redo()),
        save: (name) => void this.save(name),
        again: () => this.begin(),
        close: () => this.close(),
      },
      summary,
    );
    window.addEventListener("keydown", (event) => this.key(event), { capture: true });
    window.addEventListener("pagehide", () => void this.client.end().catch(() => undefined));
  }

  toggle(): void {
    if (this.panel.isOpen) return this.close();
    if (!this.summary.may_edit) return;
    if (!this.whole()) return this.status.say(this.speech.say("editWait"));
    this.panel.open(true);
    if (!this.client.editing) this.begin();
  }

  // Whether patches are taken.
  get isOn(): boolean {
    return this.panel.isOpen && this.client.editing;
  }

  change(patches: readonly Patch[]): void {
    this.run(() => this.client.patch(patches));
  }

  // Undefined: what was tried is given up.
  look(patches: readonly Patch[] | undefined): void {
    if (patches) return void this.preview(patches);
    this.previews++;
    this.nextPreview = undefined;
    this.panel.showPreview(undefined);
  }

  // The edit goes on, and stays this page's.
  close(): void {
    this.panel.open(false);
    this.app.closed();
  }

  private begin(): void {
    this.run(() => this.client.begin());
    clearInterval(this.beating);
    this.beating = window.setInterval(() => void this.beat(), beatSeconds * 1000);
  }

  private async beat(): Promise<void> {
    if (!this.client.editing) return;
    try {
      await this.client.beat();
    } catch (error) {
      if (isTaken(error)) this.lose("editLost");
    }
  }

  private lose(text: "editLost" | "editTaken"): void {
    clearInterval(this.beating);
    this.panel.showTaken(this.speech.say(text));
  }

  // One after another.
  private run(ask: () => Promise<Packed<EditHead>>): void {
    this.previews++;
    this.nextPreview = undefined;
    this.working = this.working.then(async () => {
      this.panel.busy(true);
      try {
        this.take(await ask());
      } catch (error) {
        this.fail(error);
      }
      this.panel.busy(false);
    });
  }

  private fail(error: unknown): void {
    if (isTaken(error)) this.lose(this.client.editing ? "editLost" : "editTaken");
    else this.panel.showFault(this.status.textOf(error));
  }

  // The newest alone: those that were overtaken are not asked.
  private async preview(patches: readonly Patch[]): Promise<void> {
    this.nextPreview = patches;
    if (this.previewing) return;
    this.previewing = true;
    const mine = this.previews;
    while (this.nextPreview && mine === this.previews) {
      const next: readonly Patch[] = this.nextPreview;
      this.nextPreview = undefined;
      try {
        const preview = await this.client.preview(next);
        if (mine === this.previews) this.panel.showPreview(preview);
      } catch (error) {
        if (mine === this.previews) this.panel.showPreviewFault(this.status.textOf(error));
      }
    }
    this.previewing = false;
    if (this.nextPreview) void this.preview(this.nextPreview);
  }

  private async save(name: string): Promise<void> {
    this.panel.busy(true);
    try {
      const saved = await this.client.save(name);
      const address = new URL(location.href);
      address.searchParams.set("store", String(saved.store));
      address.hash = "";
      this.panel.showSaved(saved, address.href);
    } catch (error) {
      this.fail(error);
    }
    this.panel.busy(false);
  }

  private key(event: KeyboardEvent): void {
    if (!this.panel.isOpen || !(event.ctrlKey || event.metaKey) || event.altKey) return;
    if (event.target instanceof HTMLInputElement && event.target.type === "text") return; // its own undo
    const key = event.key.toLowerCase();
    if (key === "z" && !event.shiftKey) this.run(() => this.client.undo());
    else if (key === "y" || key === "z") this.run(() => this.client.redo());
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  private whole(): boolean {
    return this.stage.room !== undefined && this.stage.goods?.storedLight !== undefined && this.stage.goods.farMeshes !== undefined;
  }

  private base(): Opened {
    if (this.opened) return this.opened;
    const { table, storedLight } = this.stage.goods!;
    const light = storedLight!.cube;
    const nearGoods = new NearLight(1, 18);
    for (let row = 0; row < table.count; row++) nearGoods.add(table.position[row * 3]!, table.position[row * 3 + 1]!, table.position[row * 3 + 2]!, 0, light, row * 18);
    return (this.opened = { table, light, skus: this.summary.skus.length, floors: JSON.stringify(this.summary.zones), nearGoods, nearRoom: nearRoom(this.stage.room!) });
  }

  private take(packed: Packed<EditHead>): void {
    const base = this.base();
    const { head } = packed;
    this.app.changing();
    this.takeSummary(head, base);
    this.client.setRows({
      skuOfServer: packed.u32("sku_rows", 1),
      serverOfNew: head.new_sku_rows,
      pageSkus: base.skus,
      jointOfServer: packed.u32("joint_rows", 1),
    });
    this.takeGoods(packed, base);
    this.takeRoom(packed, base);
    this.app.changed();
    this.stage.redraw();
    this.panel.show(head);
  }

  private takeSummary(head: EditHead, base: Opened): void {
    const { summary } = this;
    refill<Sku>(summary.skus, head.new_skus, base.skus);
    refill(summary.fixtures, head.fixtures);
    refill(summary.zones, head.floors);
    refill(summary.aisles, head.aisles);
    refill(summary.violations, head.violations);
    Object.assign(summary.counts, head.counts);
  }

  private takeGoods(packed: Packed<EditHead>, base: Opened): void {
    const { stage, summary } = this;
    const { goods: sections, from } = editedGoods(base.table, packed);
    const table = readGoods(sections, summary.skus);
    const before = stage.goods!;
    const light = { cube: editedGoodsLight(base.light, base.nearGoods, table.position, from) };
    const earlier = { goods: before, rows: rowsBefore(from, this.from, base.table.count), light };
    const goods = new Goods(table, summary.skus, stage.shared, () => stage.redraw(), stage.redrawSoon, earlier);
    this.from = from;
    before.dispose();
    stage.overlays?.group.removeFromParent();
    stage.goods = goods;
    stage.overlays = new Overlays(table, summary.skus);
    stage.scene.add(goods.group, stage.overlays.group);
  }

  private takeRoom(packed: Packed<EditHead>, base: Opened): void {
    const { stage, summary } = this;
    stage.room!.revise(packed.u16("fixture_rows", 1), packed.u8("fixture_tags", 1), JSON.stringify(packed.head.floors) === base.floors);
    const sections = editedRoom(packed, base.nearRoom);
    const annexe = sections && Room.ofShapes(sections, sections.shaped, stage.shared);
    stage.annexe?.dispose();
    stage.annexe = annexe;
    if (annexe) stage.scene.add(annexe.group);
    stage.sight = new Sight(screensOf(summary.fixtures));
    stage.roomChanged();
  }
}

function isTaken(error: unknown): boolean {
  return error instanceof ServerError && error.code === taken;
}

function nearRoom(room: Room): NearLight {
  const near = new NearLight(6, 3);
  const { position, normal, light } = room.lit;
  for (let v = 0; v < position.length / 3; v++) {
    if (light[v * 4]! > lampFrom) continue;
    near.add(position[v * 3]!, position[v * 3 + 1]!, position[v * 3 + 2]!, wayOf(normal[v * 4]!, normal[v * 4 + 1]!, normal[v * 4 + 2]!), light, v * 4);
  }
  return near;
}
