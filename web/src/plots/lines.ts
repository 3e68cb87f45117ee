import type { Channel, ModelInfo } from "../engine/engine";
import { texts } from "../texts";

/** Names of the colours of rotations. */
export type AxisColour = "pitch" | "yaw" | "roll";

/** A line that can be drawn: a column of the recording, or the magnitude of a vector in several columns. */
export interface Line {
  /** Id in a stored view: the column, or all columns of the vector joined. */
  id: string;
  /** Element or body to which the line belongs; empty for the whole model. */
  thing: string;
  /** Name of the line without the name of the element or body. */
  what: string;
  /** Description by the engine. */
  about: string;
  columns: readonly string[];
  /** SI unit of the columns. */
  unit: string;
  /** Number that is added to the column, in its unit. */
  offset?: number;
  colour?: AxisColour;
  /** Whether the line is interrupted where an angle jumps from +180 to -180 degrees. */
  wraps?: boolean;
  /** Name of the quantity whose points along the element this line is one of. */
  along?: string;
}

/** Lines of one quantity at the points along an element, which a list shows as one entry. */
export interface Fold {
  name: string;
  lines: Line[];
}

const COLOUR_OF: Record<string, AxisColour> = { x: "roll", y: "pitch", z: "yaw", roll: "roll", pitch: "pitch", yaw: "yaw" };
const TURNS_AROUND = ["roll", "pitch", "yaw"];

function lineOf(channel: Channel, place: number): Line {
  const { variable, long_name, columns, units } = channel;
  const [thing, components] = labelsAt(channel, place);
  const words = [variable, ...components].map(inWords).reduce((so, next) => `${so} ${beside(so, next)}`);
  const along = channel.along ? { along: beside(thing, inWords(variable)) } : {};
  return {
    id: columns[place],
    thing,
    what: words,
    about: long_name,
    columns: [columns[place]],
    unit: units[place],
    colour: COLOUR_OF[components.at(-1) ?? variable],
    wraps: TURNS_AROUND.includes(variable) && units[place] === "rad",
    ...along,
  };
}

/** Returns the element or body of a column, and the other labels of the column; the last dimension varies fastest. */
function labelsAt({ along, dims, labels }: Channel, place: number): [string, string[]] {
  // The label of a point along an element begins with the name of the element.
  if (along) return [along.lines[place], [labels[0][place].slice(along.lines[place].length + 1)]];
  const found: string[] = [];
  let left = place;
  for (const names of [...labels].reverse()) {
    found.unshift(names[left % names.length]);
    left = Math.floor(left / names.length);
  }
  return dims[0] === "axis" || dims.length === 0 ? ["", found] : [found[0], found.slice(1)];
}

/** Returns the magnitude of the force in a joint or a loop; for the joint of a hanging load this is the hook load. */
export function carriedLine(thing: string, variable: string): Line {
  const columns = ["x", "y", "z"].map((axis) => `${thing}.${variable}.force_${axis}`);
  return { id: columns.join("+"), thing, what: texts.plots.carried, about: "", columns, unit: "N" };
}

/** Returns the heave of a hull: the height of its centre of mass above the position at the draught of its data. */
export function heaveLine({ body, origin_m }: Pick<ModelInfo["hulls"][number], "body" | "origin_m">): Line {
  return { id: `${body}.heave`, thing: body, what: texts.plots.heave, about: "", columns: [`${body}.position.z`], unit: "m", offset: origin_m[2], colour: "pitch" };
}

/** Returns all lines that a run offers: every column except the time, and derived quantities. */
export function linesOf(model: ModelInfo, channels: readonly Channel[]): Line[] {
  const carrying = ["joint_reaction", "loop_reaction"].flatMap((variable) => {
    const things = channels.find((channel) => channel.variable === variable)?.labels[0] ?? [];
    return things.map((thing) => carriedLine(thing, variable));
  });
  const columns = channels.filter(({ variable }) => variable !== "time");
  return [...columns.flatMap((channel) => channel.columns.map((_, place) => lineOf(channel, place))), ...carrying, ...model.hulls.map(heaveLine)];
}

/** Returns lines in their order, with those at points along an element as one entry in the place of the first. */
export function foldPoints(lines: readonly Line[]): (Line | Fold)[] {
  const folds = new Map<string, Fold>();
  return lines.flatMap((line): (Line | Fold)[] => {
    if (line.along === undefined) return [line];
    const key = `${line.thing}.${line.along}`;
    const fold = folds.get(key);
    fold?.lines.push(line);
    if (fold) return [];
    const first = { name: line.along, lines: [line] };
    folds.set(key, first);
    return [first];
  });
}

/** Returns the name of a line in a legend. */
export function labelOf({ thing, what }: Line): string {
  return thing === "" ? what : `${inWords(thing)} ${beside(thing, what)}`;
}

/**
 * Leaves out of a description the leading words that the element's name contains: for `aft_line`, `line speed` becomes
 * `speed`.
 */
export function beside(thing: string, what: string): string {
  const known = inWords(thing).split(" ");
  const words = what.split(" ");
  return words.slice(words.findIndex((word, at) => !known.includes(word) || at === words.length - 1)).join(" ");
}

/** Returns a name of the scenario with spaces instead of underscores. */
export function inWords(name: string): string {
  return name.replaceAll("_", " ");
}

/** Whether the name, the columns or the description of a line contain these words, in any order. */
export function hasWords(line: Line, search: string): boolean {
  const name = `${labelOf(line)} ${line.about} ${line.columns.join(" ")}`.toLowerCase();
  return search.toLowerCase().split(/\s+/).every((word) => name.includes(word));
}
