// A slider for each door, lid or drawer of a fixture, and buttons for its named positions.
import type { Joint } from "../store/contract";
import { element, words } from "./dom";
import type { Speech } from "./speech";

export interface Movable {
  readonly joint: Joint;
  readonly position: number;
}

const named = { open: "open", closed: "closed" } as const; // whose words the page has

export function jointControls(speech: Speech, movable: readonly Movable[], move: (joint: number, to: number) => void): HTMLElement | undefined {
  if (movable.length === 0) return undefined;
  const list = element("div", { class: "moving" }, element("h3", { text: speech.say("joints") }));
  for (const each of movable) list.append(control(speech, each, move));
  return list;
}

function control(speech: Speech, { joint, position }: Movable, move: (joint: number, to: number) => void): HTMLElement {
  const { row, name, lower, upper, states } = joint;
  const range = { type: "range", min: String(lower), max: String(upper), step: "any", "aria-label": words(name) };
  const slider = element("input", { attributes: range });
  const told = element("output", { class: "muted" });
  const show = (to: number): void => {
    slider.value = String(to);
    const text = joint.kind === "hinge" ? `${speech.number((to * 180) / Math.PI)}°` : `${speech.number(to * 100)} cm`;
    told.textContent = text;
    slider.setAttribute("aria-valuetext", text);
  };
  slider.addEventListener("input", () => {
    move(row, Number(slider.value));
    show(Number(slider.value));
  });
  const buttons = states.map((state) => {
    const key = named[state.name as keyof typeof named];
    const press = (): void => {
      move(row, state.position);
      show(state.position);
    };
    return element("button", { text: key ? speech.say(key) : words(state.name), attributes: { type: "button", "data-state": state.name }, on: { click: press } });
  });
  show(position);
  return element("div", { class: "joint" }, element("span", { text: words(name) }), told, slider, element("div", { class: "states" }, ...buttons));
}
