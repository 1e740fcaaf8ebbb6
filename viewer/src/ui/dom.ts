// Elements of the page. Text is only ever set as text.
export interface Options {
  readonly class?: string;
  readonly id?: string;
  readonly text?: string;
  readonly attributes?: Readonly<Record<string, string>>;
  readonly on?: { readonly [K in keyof HTMLElementEventMap]?: (event: HTMLElementEventMap[K]) => void };
}

export function element<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  options: Options = {},
  ...children: readonly (Node | undefined)[]
): HTMLElementTagNameMap[K] {
  const made = document.createElement(tag);
  if (options.class) made.className = options.class;
  if (options.id) made.id = options.id;
  if (options.text !== undefined) made.textContent = options.text;
  for (const [name, value] of Object.entries(options.attributes ?? {})) made.setAttribute(name, value);
  for (const [name, listener] of Object.entries(options.on ?? {})) made.addEventListener(name, listener as EventListener);
  for (const child of children) if (child) made.append(child);
  return made;
}

// "glass_door_cooler" as words.
export function words(id: string): string {
  const text = id.replace(/[_-]+/g, " ");
  return text.charAt(0).toUpperCase() + text.slice(1);
}

// Icons: 16 x 16, drawn with lines.
const paths = {
  orbit: "M8 2.2a5.8 5.8 0 1 0 0 11.6A5.8 5.8 0 0 0 8 2.2M2.2 8c0-1.4 2.6-2.6 5.8-2.6s5.8 1.2 5.8 2.6-2.6 2.6-5.8 2.6S2.2 9.400 2.200 8",
  walk: "M8.600 3.300a1.100 1.100 0 1 0 0-2.200 1.100 1.100 0 0 0 0 2.200M8 5l-2.300 1-.9 2.300M8 5l.7 3 2.400 1.200M8 5l.2 3.600-1.200 2.200L5.500 14.500M8.200 8.600l1.600 2.400.6 3.500",
  fly: "M14 2 2 7l4.500 2L14 2l-3.500 11-4-4v4.500l2-2.500",
  top: "M2.500 2.500h11v11h-11zM2.500 6.500h6v7M8.500 9.500h5",
  views: "M2 5h2.500l1-1.500h5L11.500 5H14v8H2zM8 6.700a2.200 2.200 0 1 0 0 4.400 2.200 2.200 0 0 0 0-4.400",
  measure: "M1.800 10.800 10.800 1.800l3.400 3.400-9 9zM4.500 8.100l1.600 1.600M6.700 5.900 8.900 8.100M8.900 3.700l1.600 1.600",
  zones: "M2 4l4-1.500 4 1.500 4-1.500v9.500l-4 1.500-4-1.500-4 1.500zM6 2.500v9.500M10 4v9.500",
  layers: "M8 2 14 5 8 8 2 5zM2 8l6 3 6-3M2 11l6 3 6-3",
  elevation: "M2 2.500h12v11h-12zM2 6h12M2 9.800h12M6 2.500V6M10 6v3.800M5.500 9.800v3.700",
  edit: "M2.500 13.500l.8-3.300 7.700-7.700 2.500 2.500-7.700 7.700zM9.300 4.200l2.500 2.500",
  more: "M2.5 8a1 1 0 1 0 2 0 1 1 0 1 0-2 0M7 8a1 1 0 1 0 2 0 1 1 0 1 0-2 0M11.500 8a1 1 0 1 0 2 0 1 1 0 1 0-2 0",
  search: "M7 2.500a4.500 4.500 0 1 0 0 9 4.500 4.500 0 0 0 0-9M10.300 10.300 13.700 13.700",
  close: "M4 4l8 8M12 4l-8 8",
  place: "M8 14.500s4.500-4.400 4.500-8a4.500 4.500 0 0 0-9 0c0 3.600 4.500 8 4.500 8M8 5.200a1.500 1.500 0 1 0 0 3 1.500 1.500 0 0 0 0-3",
  all: "M2.500 2.500h4v4h-4zM9.500 2.500h4v4h-4zM2.500 9.500h4v4h-4zM9.500 9.500h4v4h-4z",
} as const;
export type IconName = keyof typeof paths;

const svg = "http://www.w3.org/2000/svg";

export function icon(name: IconName): SVGSVGElement {
  const picture = document.createElementNS(svg, "svg");
  picture.setAttribute("viewBox", "0 0 16 16");
  picture.setAttribute("class", "icon");
  picture.setAttribute("aria-hidden", "true");
  const path = document.createElementNS(svg, "path");
  path.setAttribute("d", paths[name]);
  picture.append(path);
  return picture;
}

// Whether the reader wants no movement that they did not make.
export function reduced(): boolean {
  return matchMedia("(prefers-reduced-motion: reduce)").matches;
}
