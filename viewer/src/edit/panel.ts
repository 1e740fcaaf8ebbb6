// The panel in which a store is edited.
import type { Summary } from "../store/contract";
import { element } from "../ui/dom";
import type { Speech } from "../ui/speech";
import type { EditHead, Patch, Preview, Saved } from "./contract";
import { PlanMap, type MapActions } from "./plan_map";
import { heldAt, pinsOf } from "./runs";
import { lineText } from "./steps";
import { ZoneCard } from "./zone_card";

export interface PanelActions {
  change(patches: readonly Patch[]): void;
  preview(patches: readonly Patch[]): void;
  told(text: string, isFault: boolean): void;
  front(run: string): void;
  say(words: string): void;
  undo(): void;
  redo(): void;
  save(name: string): void;
  again(): void;
  close(): void;
}

export class EditPanel {
  readonly panel = element("section", { class: "edit panel", id: "edit" });
  private readonly heading = element("h2", {});
  private readonly fault = element("p", { class: "fault-text", attributes: { role: "alert" } });
  private readonly state = element("p", { class: "muted", attributes: { role: "status" } });
  private readonly body = element("div", { class: "edit-body" });
  private readonly taken = element("div", { class: "edit-taken" });
  private readonly map: PlanMap;
  private readonly card: ZoneCard;
  private readonly undo: HTMLButtonElement;
  private readonly redo: HTMLButtonElement;
  private readonly lines = element("ol", { class: "lines" });
  private readonly saved = element("div", { class: "saved", attributes: { role: "status" } });
  private readonly name = element("input", { attributes: { type: "text", maxlength: "100", autocomplete: "off", spellcheck: "false" } });
  private head: EditHead | undefined;
  private zone: string | undefined;

  constructor(
    private readonly speech: Speech,
    private readonly actions: PanelActions,
    summary: Summary,
  ) {
    this.map = new PlanMap(speech, this.mapActions(), summary);
    this.card = new ZoneCard(speech, (patches) => actions.change(patches), (run) => actions.front(run));
    this.undo = this.button("editUndo", () => actions.undo());
    this.redo = this.button("editRedo", () => actions.redo());
    const close = element("button", { class: "close", text: "×", attributes: { type: "button" }, on: { click: () => actions.close() } });
    this.panel.append(element("header", {}, this.heading, close), this.taken, this.body);
    this.body.append(this.map.root as unknown as Node, this.fault, this.state, this.card.root, this.sayForm(), this.steps(), this.saveForm());
    this.panel.hidden = this.taken.hidden = true;
    this.panel.addEventListener("keydown", (event) => this.key(event));
    speech.bind(() => {
      this.heading.textContent = speech.say("editOn");
      this.panel.setAttribute("aria-label", speech.say("editOn"));
      close.setAttribute("aria-label", speech.say("close"));
      if (this.head) this.show(this.head);
    });
  }

  get isOpen(): boolean {
    return !this.panel.hidden;
  }

  open(open: boolean): void {
    this.panel.hidden = !open;
    document.body.classList.toggle("editing", open);
    if (open) this.heading.closest("section")?.querySelector<HTMLElement>(".close")?.focus({ preventScroll: true });
  }

  busy(busy: boolean): void {
    this.panel.setAttribute("aria-busy", String(busy));
  }

  show(head: EditHead): void {
    if (this.head?.save_as !== head.save_as || this.name.value === "") this.name.value = head.save_as;
    this.head = head;
    this.taken.hidden = true;
    this.body.hidden = false;
    this.tell("", "");
    this.map.show(head);
    this.showZone();
    this.undo.disabled = head.done === 0;
    this.redo.disabled = head.done === head.lines.length;
    this.state.textContent = this.stateOf(head);
    this.showLines(head);
  }

  // Undefined: the map is as it was.
  showPreview(preview: Preview | undefined): void {
    if (!preview) {
      if (this.head) this.show(this.head);
      return;
    }
    this.map.showPreview(preview);
    const broken = preview.offences.map(({ message }) => this.speech.say("editBroken", { message })).join("\n");
    this.tell(broken, broken ? "" : this.speech.say("editFits"));
  }

  // What cannot be tried at all: the map stays as it is.
  showPreviewFault(message: string): void {
    this.tell(message, "");
  }

  showFault(message: string): void {
    if (this.head) this.show(this.head);
    this.tell(message, this.state.textContent);
  }

  // Somebody else edits.
  showTaken(message: string): void {
    this.body.hidden = true;
    this.taken.hidden = false;
    this.tell("", "");
    this.taken.replaceChildren(element("p", { text: message, attributes: { role: "status" } }), this.button("editTryAgain", () => this.actions.again()));
  }

  showSaved(saved: Saved, address: string): void {
    const { folder, seed } = saved;
    const how = this.speech.say(saved.follows_from_plan ? "editFollows" : "editFollowsNot", { folder, seed });
    const link = element("a", { text: this.speech.say("editOpen"), attributes: { href: address } });
    this.saved.replaceChildren(element("p", { text: this.speech.say("editSaved", { folder }) }), element("p", { class: "muted", text: how }), link);
  }

  private tell(fault: string, state: string): void {
    this.fault.textContent = fault;
    this.state.textContent = state;
    this.actions.told(fault || state, fault !== "");
  }

  private mapActions(): MapActions {
    const ratio = (node: string, value: number): Patch[] => [{ set_ratio: { node, ratio: value } }];
    return {
      choose: (zone) => {
        this.zone = zone === this.zone ? undefined : zone;
        this.map.choose(this.zone);
        this.showZone();
      },
      border: ({ node }, value) => this.actions.preview(ratio(node, value)),
      letGo: ({ node }, value) => (value === undefined ? this.showPreview(undefined) : this.actions.change(ratio(node, value))),
      carry: (run, by) => this.actions.preview(heldAt(run, by)),
      putDown: (run, by) => (by === undefined ? this.showPreview(undefined) : this.actions.change(pinsOf(run, by))),
      swap: (a, b) => this.actions.change([{ swap_leaves: { a, b } }]),
    };
  }

  private key(event: KeyboardEvent): void {
    const inText = (event.target as Element).closest("input, select") !== null;
    if (event.key === "Escape" && !inText) this.actions.close();
    if (!event.ctrlKey && !event.metaKey) event.stopPropagation(); // the store is not walked through from here
  }

  private button(key: "editUndo" | "editRedo" | "editTryAgain" | "editDo" | "editSave", press?: () => void): HTMLButtonElement {
    const made = element("button", { class: "act", attributes: { type: press ? "button" : "submit" } });
    if (press) made.addEventListener("click", press);
    this.speech.bind(() => (made.textContent = this.speech.say(key)));
    return made;
  }

  private form(label: "editWords" | "editSaveAs", input: HTMLInputElement, send: HTMLButtonElement, take: (text: string) => void): HTMLElement {
    const text = element("span", {});
    this.speech.bind(() => (text.textContent = this.speech.say(label)));
    const form = element("form", {}, element("label", {}, text, input), send);
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      if (input.value.trim()) take(input.value.trim());
    });
    return form;
  }

  private sayForm(): HTMLElement {
    const input = element("input", { attributes: { type: "text", maxlength: "2000", autocomplete: "off", lang: "en" } });
    this.speech.bind(() => (input.placeholder = this.speech.say("editWordsHint")));
    return this.form("editWords", input, this.button("editDo"), (words) => this.actions.say(words));
  }

  private saveForm(): HTMLElement {
    const note = element("p", { class: "muted" });
    this.speech.bind(() => (note.textContent = this.speech.say("editLight")));
    return element("div", {}, this.form("editSaveAs", this.name, this.button("editSave"), (name) => this.actions.save(name)), this.saved, note);
  }

  private steps(): HTMLElement {
    const title = element("h3", {});
    this.speech.bind(() => (title.textContent = this.speech.say("editSteps")));
    return element("div", { class: "steps" }, element("header", {}, title, this.undo, this.redo), this.lines);
  }

  private showZone(): void {
    const { head } = this;
    if (head) this.card.show(head.zones.find(({ id }) => id === this.zone), head);
  }

  private stateOf(head: EditHead): string {
    const { speech } = this;
    const { products, skus, fixtures } = head.counts;
    const counts = speech.say("counts", { products: speech.number(products), skus: speech.number(skus), fixtures: speech.number(fixtures) });
    const said = [
      ...head.unparsed.map((words) => speech.say("editNotUnderstood", { words })),
      ...head.so_already.map((words) => speech.say("editSoAlready", { words })),
      ...head.given_up.map(({ dropped, kept }) => speech.say("editGivenUp", { dropped, kept })),
    ];
    return [counts, speech.say("editSoft", { count: head.violations.length }), ...said].join(" · ");
  }

  private showLines(head: EditHead): void {
    const { speech } = this;
    const number = (value: number): string => speech.number(value);
    const entries = head.lines.map((line, i) => {
      const { kept, moved, added, gone } = line.changes.products;
      const counts = speech.say("editProducts", { kept: number(kept), moved: number(moved), added: number(added), gone: number(gone) });
      const lost = line.lost.map((wish) => element("span", { class: "lost", text: speech.say("editNoLonger", { wish }) }));
      return element("li", { class: i < head.done ? "" : "undone" }, element("span", { text: lineText(line, speech) }), element("span", { class: "muted", text: counts }), ...lost);
    });
    if (entries.length === 0) entries.push(element("li", { class: "none muted", text: speech.say("editNoSteps") }));
    this.lines.replaceChildren(...entries);
  }
}

