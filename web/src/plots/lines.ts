import type { Channel, ModelInfo } from "../engine/engine";
import { texts } from "../texts";

/** Colours of the axes of rotation. */
export type AxisColour = "pitch" | "yaw" | "roll";

/** A possible line: a column of the recording, or the magnitude of a vector of columns. */
export interface Line {
  /** Its id in a stored view: the column, or the joined columns of the vector. */
  id: string;
  /** The element or body that it belongs to; empty for the whole model. */
  thing: string;
  /** Its name without that of the element or body. */
  what: string;
  /** The engine's description. */
  about: string;
  columns: readonly string[];
  /** SI unit of the columns. */
  unit: string;
  /** Added to the column, in its unit. */
  offset?: number;
  colour?: AxisColour;
  /** No line is drawn where an angle jumps from +180 to -180 degrees. */
  wraps?: boolean;
}

const COLOUR_OF: Record<string, AxisColour> = { x: "roll", y: "pitch", z: "yaw", roll: "roll", pitch: "pitch", yaw: "yaw" };
const TURNS_AROUND = ["roll", "pitch", "yaw"];

function lineOf(channel: Channel, place: number): Line {
  const { variable, long_name, columns, units } = channel;
  const [thing, components] = labelsAt(channel, place);
  const words = [variable, ...components].map(inWords).reduce((so, next) => `${so} ${beside(so, next)}`);
  return {
    id: columns[place],
    thing,
    what: words,
    about: long_name,
    columns: [columns[place]],
    unit: units[place],
    colour: COLOUR_OF[components.at(-1) ?? variable],
    wraps: TURNS_AROUND.includes(variable) && units[place] === "rad",
  };
}

/** The owner of a column, and its other labels: the last dimension is the fastest. */
function labelsAt({ dims, labels }: Channel, place: number): [string, string[]] {
  const found: string[] = [];
  let left = place;
  for (const along of [...labels].reverse()) {
    found.unshift(along[left % along.length]);
    left = Math.floor(left / along.length);
  }
  return dims[0] === "axis" || dims.length === 0 ? ["", found] : [found[0], found.slice(1)];
}

/** The magnitude of the force in a joint or a loop: for the joint of a hanging load it is the hook load. */
export function carriedLine(thing: string, variable: string): Line {
  const columns = ["x", "y", "z"].map((axis) => `${thing}.${variable}.force_${axis}`);
  return { id: columns.join("+"), thing, what: texts.plots.carried, about: "", columns, unit: "N" };
}

/** Rise of a hull's centre of mass above its position at the draught of its data. */
export function heaveLine({ body, origin_m }: Pick<ModelInfo["hulls"][number], "body" | "origin_m">): Line {
  return { id: `${body}.heave`, thing: body, what: texts.plots.heave, about: "", columns: [`${body}.position.z`], unit: "m", offset: origin_m[2], colour: "pitch" };
}

/** All possible lines of a run: every column except the time, and derived quantities. */
export function linesOf(model: ModelInfo, channels: readonly Channel[]): Line[] {
  const carrying = ["joint_reaction", "loop_reaction"].flatMap((variable) => {
    const things = channels.find((channel) => channel.variable === variable)?.labels[0] ?? [];
    return things.map((thing) => carriedLine(thing, variable));
  });
  const columns = channels.filter(({ variable }) => variable !== "time");
  return [...columns.flatMap((channel) => channel.columns.map((_, place) => lineOf(channel, place))), ...carrying, ...model.hulls.map(heaveLine)];
}

/** The name in a legend. */
export function labelOf({ thing, what }: Line): string {
  return thing === "" ? what : `${inWords(thing)} ${beside(thing, what)}`;
}

/** A description without leading words that the element's name contains: for `aft_line`, `line speed` becomes `speed`. */
export function beside(thing: string, what: string): string {
  const known = inWords(thing).split(" ");
  const words = what.split(" ");
  return words.slice(words.findIndex((word, at) => !known.includes(word) || at === words.length - 1)).join(" ");
}

/** A name of the scenario in ordinary spelling. */
export function inWords(name: string): string {
  return name.replaceAll("_", " ");
}

/** Whether a line has these words, in any order, in its name, its columns or its description. */
export function hasWords(line: Line, search: string): boolean {
  const name = `${labelOf(line)} ${line.about} ${line.columns.join(" ")}`.toLowerCase();
  return search.toLowerCase().split(/\s+/).every((word) => name.includes(word));
}
