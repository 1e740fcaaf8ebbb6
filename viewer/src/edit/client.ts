// Asks the server for a store that is edited: what is read comes from the edit, in the numbers of rows that the page has.
import { Client, posted, ServerError } from "../store/client";
import type { FixtureCard, Hit, ProductCard } from "../store/contract";
import { Packed } from "../store/packed";
import type { RunBlock } from "./block_swap";
import type { EditHead, Patch, Preview, Saved } from "./contract";

// Which rows of the edit are which of the page.
export interface RowNames {
  readonly skuOfServer: Uint32Array; // the page's SKU rows, by the server's
  readonly serverOfNew: readonly number[]; // the server's rows of the SKUs that came after the page's own
  readonly pageSkus: number; // its own
  readonly jointOfServer: Uint32Array; // 4,294,967,295: none that the page draws
}

const noJoint = 0xffffffff;
const ofTheEdit = /^\/(products|fixtures|search|blocks)\b/;
const labelOrMesh = /^\/skus\/(\d+)(\/.*)$/;

export class EditClient extends Client {
  private names: RowNames | undefined;
  private mine = "";

  // The page's rows are those of an edit from now on; undefined: those of the store as it was opened.
  setRows(names: RowNames | undefined): void {
    this.names = names;
  }

  get editing(): boolean {
    return this.mine !== "";
  }

  override address(path: string): string {
    return super.address(this.names ? this.inEdit(path, this.names) : path);
  }

  override async product(row: number, signal?: AbortSignal): Promise<ProductCard> {
    const card = await super.product(row, signal);
    return this.names ? { ...card, sku_row: this.names.skuOfServer[card.sku_row]! } : card;
  }

  override async fixture(row: number, signal?: AbortSignal): Promise<FixtureCard> {
    const card = await super.fixture(row, signal);
    const { names } = this;
    if (!names) return card;
    return { ...card, joints: card.joints.map((joint) => names.jointOfServer[joint]!).filter((joint) => joint !== noJoint) };
  }

  override async search(query: string, signal?: AbortSignal): Promise<readonly Hit[]> {
    const hits = await super.search(query, signal);
    const { names } = this;
    return names ? hits.map((hit) => ({ ...hit, sku_row: names.skuOfServer[hit.sku_row]! })) : hits;
  }

  async blocks(run: string): Promise<readonly RunBlock[]> {
    return (await this.json<{ blocks: readonly RunBlock[] }>(`/blocks?run=${encodeURIComponent(run)}`)).blocks;
  }

  // Errors: server.edit_taken while another page edits.
  async begin(): Promise<Packed<EditHead>> {
    const status = await this.json<{ taken: boolean }>("/edit");
    if (status.taken && !this.keptToken()) throw new ServerError("server.edit_taken", "another page edits this store");
    const packed = await this.change("begin", {}, this.keptToken());
    this.mine = packed.head.token;
    this.keepToken(this.mine);
    return packed;
  }
  patch(patches: readonly Patch[]): Promise<Packed<EditHead>> {
    return this.change("patches", { patches });
  }
  say(words: string): Promise<Packed<EditHead>> {
    return this.change("say", { words });
  }
  undo(): Promise<Packed<EditHead>> {
    return this.change("undo", {});
  }
  redo(): Promise<Packed<EditHead>> {
    return this.change("redo", {});
  }
  async preview(patches: readonly Patch[]): Promise<Preview> {
    return (await (await this.post("preview", { patches })).json()) as Preview;
  }
  async save(name: string): Promise<Saved> {
    return (await (await this.post("save", { name })).json()) as Saved;
  }
  async beat(): Promise<void> {
    await this.post("beat", {});
  }
  // Also while the page goes away.
  async end(): Promise<void> {
    if (!this.editing) return;
    const token = this.mine;
    this.mine = "";
    this.keepToken("");
    await this.post("end", {}, token, { keepalive: true });
  }

  private async change(verb: string, body: object, token = this.mine): Promise<Packed<EditHead>> {
    return new Packed<EditHead>(await (await this.post(verb, body, token)).arrayBuffer(), `edit/${verb}`);
  }

  private post(verb: string, body: object, token = this.mine, more: RequestInit = {}): Promise<Response> {
    return posted(super.address(`/edit/${verb}`), { token, ...body }, verb, more);
  }

  private inEdit(path: string, { pageSkus, serverOfNew }: RowNames): string {
    if (ofTheEdit.test(path)) return `/edit${path}`;
    const sku = labelOrMesh.exec(path);
    if (!sku || Number(sku[1]) < pageSkus) return path;
    return `/edit/skus/${serverOfNew[Number(sku[1]) - pageSkus]}${sku[2]}`;
  }

  // In the tab alone: a page that is loaded anew goes on with its edit.
  private keptToken(): string {
    return sessionStorage.getItem(this.tokenName()) ?? "";
  }
  private keepToken(token: string): void {
    if (token) sessionStorage.setItem(this.tokenName(), token);
    else sessionStorage.removeItem(this.tokenName());
  }
  private tokenName(): string {
    return `edit ${super.address("")}`;
  }
}
