import type { Channel, ModelInfo } from "../engine/engine";
import { texts } from "../texts";
import { beside, inWords, labelOf, linesOf } from "./lines";
import type { Line } from "./lines";

/** Group of lines that are chosen together. */
export interface Figure {
  title: string;
  lines: Line[];
  /** Name of each line below the title. */
  labels: string[];
}

/** Largest number of lines in one plot: more lines cannot be distinguished. */
export const MOST_LINES = 8;
/** Kind of the joints of flexible bodies: they have many coordinates, and a few of them do not describe the motion. */
const BENDS = "elastic";

/** Lines that a run offers, groups of them, and the default selection. */
export class Figures {
  readonly lines: Line[];
  readonly all: Figure[];
  private readonly byId: Map<string, Line>;

  constructor(
    private readonly model: ModelInfo,
    private readonly channels: readonly Channel[],
  ) {
    this.lines = linesOf(model, channels);
    this.byId = new Map(this.lines.map((line) => [line.id, line]));
    const floating = model.bodies.filter(({ floats }) => floats).map(({ name }) => name);
    const bodies = floating.length > 0 ? floating : model.bodies.slice(0, 1).map(({ name }) => name);
    const turning = bodies.flatMap((body) => [this.rates(body), this.angles(body)]);
    const joints = [this.joints("joint_velocity", texts.plots.joint_rates), this.joints("joint_position", texts.plots.joint_positions)];
    const limited = this.limited().map((id) => this.line(id)!);
    const forces: Figure = { title: texts.plots.limited_forces, lines: limited, labels: limited.map((line) => shortLabelOf(line, limited)) };
    this.all = [...turning, ...model.hulls.map((hull) => this.heave(hull)), ...joints, ...(limited.length > 1 ? [forces] : []), ...this.vectors()].filter(({ lines }) => lines.length > 0);
  }

  line(id: string): Line | undefined {
    return this.byId.get(id);
  }

  /** Returns the group with exactly these lines. */
  ofLines(ids: readonly string[]): Figure | undefined {
    return this.all.find(({ lines }) => lines.length === ids.length && lines.every(({ id }, i) => id === ids[i]));
  }

  /** Returns the default lines of each plot: those of the scenario, or motions of bodies, and forces with limits. */
  defaults(): string[][] {
    const { hulls, bodies, view } = this.model;
    const chosen = view.plots.map((plot) => plot.filter((id) => this.byId.has(id))).filter((plot) => plot.length > 0);
    if (chosen.length > 0) return chosen;
    const moving = [...hulls.map(({ body }) => body), ...bodies.filter(({ floats }) => floats).map(({ name }) => name)].filter((body) => !this.isHeld(body));
    const [body] = moving;
    if (body === undefined) return [this.joints("joint_velocity", ""), this.joints("joint_position", "")].map(idsOf).map((ids) => (ids.length > 0 ? ids : idsOf(this.rates(bodies[0].name))));
    if (bodies.length === 1 && hulls.length === 1) return [idsOf(this.heave(hulls[0])), [`${body}.velocity.z`]];
    const angles = idsOf(this.angles(body));
    const limited = this.limited();
    return [limited.length > 0 ? limited : idsOf(this.rates(body)), angles];
  }

  /** Whether a floating body can move in no coordinate. */
  private isHeld(body: string): boolean {
    const joint = this.model.joints.find((one) => one.body === body);
    return joint?.kind === "floating" && joint.free_coordinates.length === 0 && joint.prescribed.length === 0;
  }

  /** Returns the columns of forces with limits. */
  private limited(): string[] {
    const columns = [...new Set(this.model.limits.map(({ column }) => column))];
    return columns.filter((column) => this.line(column)?.unit === "N").slice(0, MOST_LINES);
  }

  private rates(body: string): Figure {
    return this.named(texts.plots.rates_of(inWords(body)), ["y", "z", "x"].map((axis) => `${body}.angular_velocity.${axis}`), texts.plots.turns);
  }

  private angles(body: string): Figure {
    return this.named(texts.plots.angles_of(inWords(body)), ["pitch", "yaw", "roll"].map((angle) => `${body}.${angle}`), texts.plots.turns);
  }

  /** Groups the heave of a hull with the wave. */
  private heave({ name, body }: ModelInfo["hulls"][number]): Figure {
    return this.named(texts.plots.heave_of(inWords(body)), [`${body}.heave`, `${name}.wave_elevation`], texts.plots.heave_and_wave);
  }

  /** Groups the coordinates that move freely or by a prescribed motion. */
  private joints(variable: string, title: string): Figure {
    const moving = this.model.joints.filter(({ kind, free_coordinates, prescribed }) => kind !== BENDS && kind !== "floating" && free_coordinates.length + prescribed.length > 0);
    const names = this.channels.find((channel) => channel.variable === variable)?.labels[0] ?? [];
    const own = names.filter((name) => moving.some((joint) => name === joint.name || joint.free_coordinates.includes(name)));
    return this.named(title, own.slice(0, MOST_LINES).map((name) => `${name}.${variable}`), own.map(inWords));
  }

  private named(title: string, ids: readonly string[], labels: readonly string[]): Figure {
    const found = ids.map((id, i) => ({ line: this.line(id), label: labels[i] })).filter((one): one is { line: Line; label: string } => one.line !== undefined);
    return { title, lines: found.map(({ line }) => line), labels: found.map(({ label }) => label) };
  }

  /**
   * Groups the components of a vector for each element; forces and moments are in separate groups, one for each unit.
   */
  private vectors(): Figure[] {
    const several = this.channels.filter(({ dims }) => dims.length > 1);
    return several.flatMap((channel) => {
      const [things, ...along] = channel.labels;
      const width = along.reduce((product, { length }) => product * length, 1);
      return things.flatMap((thing, i) => this.ofThing(channel, thing, channel.columns.slice(i * width, (i + 1) * width)));
    });
  }

  private ofThing({ variable }: Channel, thing: string, columns: readonly string[]): Figure[] {
    const lines = columns.map((column) => this.line(column)!);
    const units = [...new Set(lines.map(({ unit }) => unit))];
    const words = inWords(variable);
    return units.map((unit) => {
      const own = lines.filter((line) => line.unit === unit).slice(0, MOST_LINES);
      const heading = `${inWords(thing)}: ${beside(thing, words)}`;
      const title = units.length > 1 ? `${heading} (${unit})` : heading;
      return { title, lines: own, labels: own.map(({ what }) => what.slice(words.length + 1) || what) };
    });
  }
}

/** Returns the name of a line's element, or of the whole line if another one is of the same element. */
function shortLabelOf(line: Line, among: readonly Line[]): string {
  const isAlone = line.thing !== "" && among.every((other) => other === line || other.thing !== line.thing);
  return isAlone ? inWords(line.thing) : labelOf(line);
}

function idsOf({ lines }: Figure): string[] {
  return lines.map(({ id }) => id);
}

/**
 * Returns the title and the labels of lines that were chosen one by one: if all belong to one element, the title has
 * its name and the labels omit it.
 */
export function titleAndLabels(lines: readonly Line[], figure: Figure | undefined): { title: string; labels: string[] } {
  if (figure) return figure;
  const things = new Set(lines.map(({ thing }) => thing));
  const [thing] = things;
  if (lines.length > 1 && things.size === 1 && thing !== "") return { title: inWords(thing), labels: lines.map(({ what }) => what) };
  const labels = lines.map(labelOf);
  return { title: labels.join(", ") || texts.plots.empty, labels };
}

