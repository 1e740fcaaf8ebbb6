// The form: words, dropped files, and what else may be said.
import { element } from "../ui/dom";
import type { Speech } from "../ui/speech";
import type { Ask, DroppedFile, MakeOptions } from "./contract";
import { acceptedFiles, maxFilesBytes, readDropped, usesOf, type Use } from "./dropped";
import { isMakeKey, say, type MakeKey } from "./strings";

// As one types them; they are read in English.
export const examples = [
  "a 20 x 14 m supermarket with dairy along the back wall, a bakery by the entrance and three checkouts",
  "a 9 x 7 m corner shop with drinks, snacks and sweets, one checkout",
  "a 24 x 16 m organic market with produce at the entrance, wide aisles and a cheese counter",
] as const;

const textOfUse = { image: "asImage", floor_plan: "asFloorPlan", catalog: "asCatalog" } as const satisfies Record<Use, MakeKey>;

interface Dropped {
  readonly file: File;
  use: Use;
  scale: string; // of a floor plan
}

export class AskForm {
  readonly root = element("form", { class: "ask panel" });
  private readonly words = element("textarea", { attributes: { rows: "4", maxlength: "20000" } });
  private readonly size = element("input", { attributes: { autocomplete: "off", maxlength: "40" } });
  private readonly profile = element("select");
  private readonly style = element("select");
  private readonly country = element("select");
  private readonly skin = element("select");
  private readonly planner = element("select");
  private readonly time = element("input", { attributes: { autocomplete: "off", maxlength: "40" } });
  private readonly vary = new Map<string, HTMLInputElement>(); // by axis
  private readonly seed = element("input", { attributes: { type: "number", min: "0", max: "9007199254740991", step: "1", required: "" } });
  private readonly count = element("input", { attributes: { type: "number", min: "1", step: "1", required: "" } });
  private readonly button = element("button", { class: "main", attributes: { type: "submit" } });
  private readonly fault = element("p", { class: "failed", attributes: { role: "alert" } });
  private readonly files = element("ul", { class: "files" });
  private dropped: Dropped[] = [];

  constructor(
    private readonly speech: Speech,
    private readonly options: MakeOptions,
    private readonly begin: (ask: Ask) => Promise<void>,
    private readonly textOf: (error: unknown) => string,
  ) {
    this.seed.value = "1";
    this.count.value = "3";
    this.count.max = String(options.max_count);
    const labelled = (key: MakeKey, input: HTMLElement): HTMLElement => element("label", {}, this.text("span", key), input);
    const figures = element("div", { class: "figures" }, labelled("count", this.count), labelled("seed", this.seed));
    const plans = options.planners.length > 1 ? [labelled("planner", this.planner)] : [];
    const more = element(
      "details",
      {},
      this.text("summary", "more"),
      element("div", { class: "figures" }, labelled("size", this.size), labelled("profile", this.profile), labelled("style", this.style), labelled("skin", this.skin), labelled("time", this.time), labelled("country", this.country), ...plans),
      this.varied(labelled),
    );
    this.root.append(labelled("describe", this.words), this.tryOne(), this.dropZone(), more, figures, this.button, this.fault);
    this.root.addEventListener("submit", (event) => {
      event.preventDefault();
      void this.submit();
    });
    speech.bind(() => this.translate());
  }

  // The words of another store, and its seed.
  start(words: string, seed: number): void {
    this.words.value = words;
    this.seed.value = String(seed);
    this.words.focus();
  }

  busy(working: boolean): void {
    this.button.textContent = this.say(working ? "making" : "make");
    this.button.setAttribute("aria-busy", String(working));
  }

  private varied(labelled: (key: MakeKey, input: HTMLElement) => HTMLElement): HTMLElement {
    const inputs = this.options.vary.map((axis) => {
      const input = element("input", { attributes: { type: "number", min: "0", max: "9007199254740991", step: "1" } });
      this.vary.set(axis, input);
      return isMakeKey(axis) ? labelled(axis, input) : element("label", {}, element("span", { text: axis }), input);
    });
    return element("fieldset", {}, this.text("legend", "vary"), element("p", { class: "muted" }, this.text("span", "varyHint")), element("div", { class: "figures" }, ...inputs));
  }

  private say(key: MakeKey, values?: Readonly<Record<string, string | number>>): string {
    return say(this.speech.language, key, values);
  }

  private text<K extends "span" | "summary" | "legend">(tag: K, key: MakeKey): HTMLElementTagNameMap[K] {
    const made = element(tag);
    this.speech.bind(() => (made.textContent = this.say(key)));
    return made;
  }

  private translate(): void {
    this.words.placeholder = this.say("describeHint");
    this.size.placeholder = this.say("sizeHint");
    this.time.placeholder = this.say("timeHint");
    const { profiles, styles, countries, planners } = this.options;
    this.offer(this.profile, "asSaid", profiles);
    this.offer(this.style, "asSaid", styles);
    this.offer(this.skin, "noSkin", styles);
    this.offer(this.country, "asSaid", countries);
    this.offer(this.planner, "offline", planners.slice(1));
    this.busy(this.button.getAttribute("aria-busy") === "true");
    this.listFiles();
  }

  private offer(select: HTMLSelectElement, otherwise: MakeKey, ids: readonly string[]): void {
    const chosen = select.value;
    select.replaceChildren(element("option", { text: this.say(otherwise), attributes: { value: "" } }), ...ids.map((id) => element("option", { text: id, attributes: { value: id } })));
    select.value = chosen;
  }

  private tryOne(): HTMLElement {
    const chips = examples.map((example) => element("button", { class: "chip", text: example, attributes: { type: "button" }, on: { click: () => (this.words.value = example) } }));
    return element("div", { class: "examples" }, this.text("span", "tryOne"), ...chips);
  }

  private dropZone(): HTMLElement {
    const input = element("input", { attributes: { type: "file", multiple: "", accept: acceptedFiles, tabindex: "-1" } });
    input.hidden = true;
    const choose = element("button", { class: "link", attributes: { type: "button" }, on: { click: () => input.click() } });
    this.speech.bind(() => (choose.textContent = this.say("chooseFiles")));
    const zone = element("div", { class: "drop", attributes: { role: "group" } }, this.text("span", "drop"), element("p", { class: "muted" }, this.text("span", "dropHint"), choose), input, this.files);
    this.speech.bind(() => zone.setAttribute("aria-label", this.say("drop")));
    input.addEventListener("change", () => {
      this.add([...(input.files ?? [])]);
      input.value = "";
    });
    zone.addEventListener("dragover", (event) => {
      event.preventDefault();
      zone.classList.add("over");
    });
    zone.addEventListener("dragleave", () => zone.classList.remove("over"));
    zone.addEventListener("drop", (event) => {
      event.preventDefault();
      zone.classList.remove("over");
      this.add([...(event.dataTransfer?.files ?? [])]);
    });
    return zone;
  }

  private add(files: readonly File[]): void {
    this.fault.textContent = "";
    for (const file of files) {
      const [use] = usesOf(file.name);
      if (use) this.dropped.push({ file, use, scale: "" });
      else this.fault.textContent = this.say("badFile", { name: file.name });
    }
    this.listFiles();
  }

  private listFiles(): void {
    this.files.replaceChildren(...this.dropped.map((each) => this.fileLine(each)));
  }

  private fileLine(each: Dropped): HTMLElement {
    const { name } = each.file;
    const use = element("select", { attributes: { "aria-label": this.say("useOf", { name }) } }, ...usesOf(name).map((as) => element("option", { text: this.say(textOfUse[as]), attributes: { value: as } })));
    use.value = each.use;
    const label = this.say("scaleOf", { name });
    const scale = element("input", { attributes: { "aria-label": label, title: label, placeholder: this.say("scaleHint"), autocomplete: "off", maxlength: "100" } });
    scale.value = each.scale;
    scale.hidden = each.use !== "floor_plan";
    scale.addEventListener("input", () => (each.scale = scale.value));
    use.addEventListener("change", () => {
      each.use = use.value as Use;
      scale.hidden = each.use !== "floor_plan";
    });
    const remove = element("button", { class: "link", text: "×", attributes: { type: "button", "aria-label": this.say("remove", { name }) } });
    remove.addEventListener("click", () => {
      this.dropped = this.dropped.filter((other) => other !== each);
      this.listFiles();
    });
    return element("li", {}, element("span", { text: name }), use, scale, remove);
  }

  // What is wrong with what is on the form; the server says the rest.
  private complaint(): string | undefined {
    if (this.words.value.trim() === "" && this.dropped.length === 0) return this.say("sayOrDrop");
    const [plan, second] = this.dropped.filter(({ use }) => use === "floor_plan");
    if (plan && second) return this.say("oneFloorPlan", { name: plan.file.name });
    const bytes = this.dropped.reduce((sum, { file }) => sum + file.size, 0);
    return bytes > maxFilesBytes ? this.say("filesTooLarge", { megabytes: maxFilesBytes / 1024 / 1024 }) : undefined;
  }

  private async submit(): Promise<void> {
    this.fault.textContent = this.complaint() ?? "";
    if (this.fault.textContent !== "") return;
    try {
      await this.begin(await this.ask());
    } catch (error) {
      this.fault.textContent = this.textOf(error);
    }
  }

  private async ask(): Promise<Ask> {
    const read = (wanted: Use): Promise<DroppedFile[]> => Promise.all(this.dropped.filter(({ use }) => use === wanted).map(({ file }) => readDropped(file)));
    const [plans, images, catalogs] = await Promise.all([read("floor_plan"), read("image"), read("catalog")]);
    const said = { size: this.size, profile: this.profile, style: this.style, country: this.country, time: this.time, skin: this.skin, planner: this.planner };
    const filled = Object.entries(said).flatMap(([name, { value }]) => (value.trim() ? [[name, value.trim()]] : []));
    const vary = [...this.vary].flatMap(([axis, { value }]) => (value === "" ? [] : [`${axis}=${value}`]));
    const scale = this.dropped.find(({ use }) => use === "floor_plan")?.scale.trim();
    return {
      words: this.words.value.trim(),
      seed: Number(this.seed.value),
      count: Number(this.count.value),
      ...(Object.fromEntries(filled) as Partial<Record<keyof typeof said, string>>),
      ...(vary.length > 0 && { vary }),
      ...(plans[0] && { floor_plan: plans[0] }),
      ...(scale && { floor_plan_scale: scale }),
      ...(images.length > 0 && { images }),
      ...(catalogs.length > 0 && { catalogs }),
    };
  }
}
