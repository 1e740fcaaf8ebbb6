// What a replay says of goals, events and time, in the page's language.
import type { Language } from "../text/strings";
import { words } from "../ui/dom";
import type { Speech } from "../ui/speech";
import type { Replay, ReplayEvent, ReplayGoal, SideEffects } from "./contract";
import { say, type ReplayKey } from "./strings";

export class ReplayWords {
  constructor(readonly speech: Speech) {}

  say(key: ReplayKey, values?: Readonly<Record<string, string | number>>): string {
    return say(this.speech.language, key, values);
  }

  // "1:05.20"
  time(seconds: number): string {
    return timeText(seconds);
  }

  goal({ count, reached, since_s }: ReplayGoal): string {
    if (reached === 0) return this.say("notReached");
    if (reached < count) return this.say("reachedSome", { reached, count });
    return since_s >= 0 ? this.say("inPlaceSince", { time: timeText(since_s) }) : this.say("reachedSome", { reached, count });
  }

  event(event: ReplayEvent, replay: Pick<Replay, "things">): string {
    const name = event.sku ? nameOf(event.sku, replay, this.speech.language) : this.say(event.target as ReplayKey);
    return this.say(event.kind, { name, force: this.speech.number(event.force_n, event.force_n < 10 ? 1 : 0) });
  }

  effects(effects: SideEffects): readonly (readonly [string, string])[] {
    const { speech } = this;
    return [
      [this.say("contactsByForce"), [effects.light_contacts, effects.firm_contacts, effects.hard_contacts].map((n) => speech.number(n)).join(" · ")],
      [this.say("hardest"), this.say("newtons", { value: speech.number(effects.hardest_n, 0) })],
      [this.say("toppledCount"), speech.number(effects.toppled)],
      [this.say("droppedCount"), speech.number(effects.dropped)],
      [this.say("displacedCount"), speech.number(effects.displaced)],
      [this.say("strayedCount"), speech.number(effects.strayed)],
      [this.say("wrongCount"), speech.number(effects.wrong_items)],
      [this.say("tilt"), this.say("degrees", { value: speech.number(effects.basket_tilt_deg, 1) })],
      [this.say("collisions"), speech.number(effects.base_collisions)],
      [this.say("stops"), speech.number(effects.protective_stops)],
      ...(effects.doors_open === undefined ? [] : [[this.say("doorsOpen"), speech.number(effects.doors_open)] as const]),
    ];
  }

  nameOfGoal(goal: Pick<ReplayGoal, "name" | "name_zh" | "count">): string {
    const name = this.speech.language === "zh" && goal.name_zh ? goal.name_zh : goal.name;
    return goal.count > 1 ? `${goal.count} × ${name}` : name;
  }

  outcome({ failure, strict, clean, void: isVoid, error }: Replay["result"]): string {
    if (isVoid) return this.say("void");
    if (error) return `${words(failure)} (${error})`;
    if (!strict) return failureText(failure);
    return clean ? `${this.say("reachedAll")}, ${this.say("clean")}` : this.say("reachedAll");
  }
}

// Codes stay as results have them; a result that failed without a code says so.
export function failureText(code: string): string {
  return code === "None" ? "–" : code;
}

export function timeText(seconds: number): string {
  const all = Math.round(seconds * 100);
  const [minutes, rest] = [Math.floor(all / 6000), all % 6000];
  return `${minutes}:${(rest / 100).toFixed(2).padStart(5, "0")}`;
}

function nameOf(sku: string, replay: Pick<Replay, "things">, language: Language): string {
  const thing = replay.things.find((each) => each.sku === sku);
  if (!thing) return sku;
  return language === "zh" && thing.name_zh ? thing.name_zh : thing.name;
}
