// The bar at the foot of the page: ways of moving, views, tools.
import { modes, type Mode } from "../camera/modes";
import type { StoreCamera, Summary } from "../store/contract";
import type { TextKey } from "../text/strings";
import { element, icon, type IconName } from "./dom";
import { Menu } from "./menu";
import type { Speech } from "./speech";

export interface ToolbarActions {
  mode(mode: Mode): void;
  view(camera: StoreCamera): void;
  measure(): void;
  zones(): void;
  layers(): void;
  edit?(): void; // where the server takes edits
  make?(): void; // and makes stores
  picture(): void;
  share(): void;
  theme(): void;
  help(): void;
}

const keys: Partial<Record<TextKey, string>> = { orbit: "1", walk: "2", fly: "3", top: "4", measure: "M", zones: "Z", layers: "L", edit: "R", screenshot: "P", help: "?" };

export class Toolbar {
  readonly bar: HTMLElement;
  private readonly buttons = new Map<TextKey, HTMLButtonElement>();

  constructor(
    private readonly speech: Speech,
    private readonly actions: ToolbarActions,
    cameras: readonly StoreCamera[],
    zones: Summary["zones"],
  ) {
    const ways = element("div", { class: "group", attributes: { role: "group" } });
    for (const mode of modes) ways.append(this.button(mode, mode, () => actions.mode(mode)));
    const views = new Menu(
      this.button("views", "views"),
      () => cameras.map((camera) => ({ text: nameOf(camera, zones), choose: () => actions.view(camera) })),
    );
    const tools = element(
      "div",
      { class: "group" },
      views.root,
      this.button("measure", "measure", () => actions.measure()),
      this.button("zones", "zones", () => actions.zones()),
      this.button("layers", "layers", () => actions.layers()),
      actions.edit && this.button("edit", "edit", () => actions.edit?.()),
      this.more(),
    );
    this.bar = element("div", { class: "toolbar panel", attributes: { role: "toolbar" } }, ways, element("span", { class: "divider" }), tools);
    this.bar.addEventListener("keydown", (event) => this.step(event));
  }

  show(state: { mode: Mode; measuring: boolean; zones: boolean; layers: boolean; edit: boolean }): void {
    for (const mode of modes) this.press(mode, mode === state.mode);
    this.press("measure", state.measuring);
    this.press("zones", state.zones);
    this.press("layers", state.layers);
    this.press("edit", state.edit);
  }

  private more(): HTMLElement {
    const { speech, actions } = this;
    const entry = (key: TextKey, choose: () => void): { text: string; choose: () => void } => ({ text: speech.say(key), choose });
    const { make } = actions;
    return new Menu(this.button("more", "more"), () => [
      ...(make ? [entry("newStore", () => make())] : []),
      entry("screenshot", () => actions.picture()),
      entry("share", () => actions.share()),
      entry("theme", () => actions.theme()),
      entry("language", () => speech.toggle()),
      entry("help", () => actions.help()),
    ]).root;
  }

  private button(key: TextKey, picture: IconName, press?: () => void): HTMLButtonElement {
    const made = element("button", { class: "tool", attributes: { type: "button" } }, icon(picture));
    if (press) made.addEventListener("click", press);
    this.speech.bind(() => {
      const text = this.speech.say(key);
      made.setAttribute("aria-label", text);
      made.title = keys[key] ? `${text} (${keys[key]})` : text;
    });
    this.buttons.set(key, made);
    return made;
  }

  private press(key: TextKey, pressed: boolean): void {
    this.buttons.get(key)?.setAttribute("aria-pressed", String(pressed));
  }

  // Left and right go from button to button, as in every toolbar.
  private step(event: KeyboardEvent): void {
    if (event.key !== "ArrowLeft" && event.key !== "ArrowRight") return;
    const all = [...this.bar.querySelectorAll<HTMLButtonElement>("button.tool")];
    const now = all.indexOf(document.activeElement as HTMLButtonElement);
    if (now < 0) return;
    all[(now + (event.key === "ArrowRight" ? 1 : all.length - 1)) % all.length]!.focus();
    event.preventDefault();
    event.stopPropagation();
  }
}

function nameOf(camera: StoreCamera, zones: Summary["zones"]): string {
  const zone = camera.name.startsWith("zone:") ? camera.name.slice(5) : undefined;
  const label = zone && zones.find(({ id }) => id === zone)?.label;
  const name = label ?? zone ?? camera.name;
  return name.charAt(0).toUpperCase() + name.slice(1).replace(/_/g, " ");
}
