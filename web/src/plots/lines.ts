import type { Channel, ModelInfo } from "../engine/engine";
import { texts } from "../texts";

/** Colours that say about which axis something turns. */
export type AxisColour = "pitch" | "yaw" | "roll";

/** What can be drawn as one line: a column of the recording, or the length of a vector of columns. */
export interface Line {
  /** What a kept view names it by: the column, or the columns of the vector joined. */
  id: string;
  /** Whose it is; empty for what is of the whole model. */
  thing: string;
  /** What it is, under the name of whose it is. */
  what: string;
  /** The same in the engine's words. */
  about: string;
  columns: readonly string[];
  /** SI unit of the columns. */
  unit: string;
  /** Added to the column, in its unit. */
  offset?: number;
  colour?: AxisColour;
  /** Angles jump from +180 to -180 degrees: no line is drawn there. */
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

/** Whose a column is and the rest of its labels: the last dimension is the fastest. */
function labelsAt({ dims, labels }: Channel, place: number): [string, string[]] {
  const found: string[] = [];
  let left = place;
  for (const along of [...labels].reverse()) {
    found.unshift(along[left % along.length]);
    left = Math.floor(left / along.length);
  }
  return dims[0] === "axis" || dims.length === 0 ? ["", found] : [found[0], found.slice(1)];
}

/** The length of the force that a joint or a loop carries: of a hanging load's joint the hook load. */
export function carriedLine(thing: string, variable: string): Line {
  const columns = ["x", "y", "z"].map((axis) => `${thing}.${variable}.force_${axis}`);
  return { id: columns.join("+"), thing, what: texts.plots.carried, about: "", columns, unit: "N" };
}

/** Rise of a hull's centre of mass above its place at the draught of its data. */
export function heaveLine({ body, origin_m }: Pick<ModelInfo["hulls"][number], "body" | "origin_m">): Line {
  return { id: `${body}.heave`, thing: body, what: texts.plots.heave, about: "", columns: [`${body}.position.z`], unit: "m", offset: origin_m[2], colour: "pitch" };
}

/** All that can be drawn of a run: every column but the time, and what is made of them. */
export function linesOf(model: ModelInfo, channels: readonly Channel[]): Line[] {
  const carrying = ["joint_reaction", "loop_reaction"].flatMap((variable) => {
    const things = channels.find((channel) => channel.variable === variable)?.labels[0] ?? [];
    return things.map((thing) => carriedLine(thing, variable));
  });
  const columns = channels.filter(({ variable }) => variable !== "time");
  return [...columns.flatMap((channel) => channel.columns.map((_, place) => lineOf(channel, place))), ...carrying, ...model.hulls.map(heaveLine)];
}

/** As a legend has it. */
export function labelOf({ thing, what }: Line): string {
  return thing === "" ? what : `${inWords(thing)} ${beside(thing, what)}`;
}

/** What is said of a thing, without words at its head that the name beside it has: of `aft_line` the `line speed` is its `speed`. */
export function beside(thing: string, what: string): string {
  const known = inWords(thing).split(" ");
  const words = what.split(" ");
  return words.slice(words.findIndex((word, at) => !known.includes(word) || at === words.length - 1)).join(" ");
}

/** A name of the scenario as a person writes it. */
export function inWords(name: string): string {
  return name.replaceAll("_", " ");
}

/** Whether a line has these words, in any order, in its name, in that of its columns or in what is said of it. */
export function hasWords(line: Line, search: string): boolean {
  const name = `${labelOf(line)} ${line.about} ${line.columns.join(" ")}`.toLowerCase();
  return search.toLowerCase().split(/\s+/).every((word) => name.includes(word));
}
