// Shapes of the plan, and pointers that are followed over it.
const svg = "http://www.w3.org/2000/svg";

export type Attributes = Readonly<Record<string, string | number>>;

export function shape(name: string, attributes: Attributes, text?: string): SVGElement {
  const made = document.createElementNS(svg, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, String(value));
  if (text !== undefined) made.textContent = text;
  return made;
}

export const clickMoves = 6; // pixels a click may shake

// The pointer is followed on the whole page: the shape under it is drawn anew while it moves.
export function follow(event: PointerEvent, moved: (event: PointerEvent) => void, done: (event: PointerEvent | undefined) => void): void {
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
