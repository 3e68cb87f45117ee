import type { Recording } from "../app/recording/recording";
import { fixed } from "../app/format";
import type { ModelInfo, Value, Values } from "../engine/engine";
import { words } from "./words";

/** Largest number of changes in a name. */
const MOST_CHANGES = 2;

/** Data of a run from which its name is made. */
export interface Nameable {
  model: ModelInfo;
  /** Values of the scenario when it was opened, and values that override them at the start of the run. */
  first: Values;
  begun: Values;
  changes: Recording["changes"];
  /** Time from which the present run continues, s; null if this run is not left at an earlier moment. */
  left_s: number | null;
}

/** Returns a name for a run: what was changed since its scenario was opened, or the title of its scenario. */
export function nameOf({ model, first, begun, changes, left_s }: Nameable): string {
  const set = changes.flatMap((change) => ("parameter" in change ? [[change.parameter, change.value] as const] : []));
  const values: Values = { ...begun, ...Object.fromEntries(set) };
  const changed = Object.keys(values).filter((name) => first[name] !== undefined && values[name] !== first[name]);
  const said = changed.slice(0, MOST_CHANGES).map((name) => changeOf(model, name, first[name], values[name]));
  if (changed.length > MOST_CHANGES) said.push(words.more(changed.length - MOST_CHANGES));
  if (changes.some((change) => "input" in change)) said.push(words.by_hand);
  const name = said.join(", ") || model.title;
  return left_s === null ? name : words.left(name, fixed(left_s, 2));
}

function changeOf({ parameters }: ModelInfo, name: string, from: Value, to: Value): string {
  const known = parameters.find((parameter) => parameter.name === name);
  return words.changed(known?.label ?? name, written(from), [written(to), known?.unit ?? ""].join(" ").trim());
}

function written(value: Value): string {
  if (typeof value === "boolean") return value ? words.on : words.off;
  return typeof value === "number" ? String(Number(value.toPrecision(6))).replace("-", "−") : String(value).replaceAll("_", " ");
}

/** Returns a name that no other run has: with a number if it is taken. */
export function unlike(name: string, taken: readonly string[]): string {
  let count = 1;
  let own = name;
  while (taken.includes(own)) own = words.again(name, ++count);
  return own;
}

/** Returns the first letter, or letter with a number, that no other run has. */
export function markOf(taken: readonly string[]): string {
  for (let place = 0; ; place++) {
    const letter = String.fromCharCode(65 + (place % 26));
    const mark = place < 26 ? letter : `${letter}${Math.floor(place / 26)}`;
    if (!taken.includes(mark)) return mark;
  }
}
