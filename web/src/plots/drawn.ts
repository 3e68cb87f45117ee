import type { Columns } from "../engine/columns";
import type { LimitInfo } from "../engine/engine";
import type { Line } from "./lines";
import type { Places } from "./stretch";
import { decimalsFor, shownUnit } from "./units";
import type { Angle, ShownUnit } from "./units";

/** A bound of a limit in a plot, in the displayed unit. */
export interface Bound {
  name: string;
  value: number;
  /** Time from which the bound counts, s. */
  from_s: number;
  /** Time until which it counts, s. */
  until_s: number;
}

/** Line of a plot: its columns, displayed unit, colour and limits. */
export class DrawnLine {
  readonly places: Places;
  readonly shown: ShownUnit;
  readonly bounds: Bound[];
  /** Largest magnitude of the visible values on the line's axis, in the displayed unit. */
  largest = 0;

  constructor(
    readonly line: Line,
    readonly label: string,
    /** Name of one of the theme's colours. */
    readonly colour: string,
    columns: Columns,
    angle: Angle,
    limits: readonly LimitInfo[],
  ) {
    this.places = line.columns.map((name) => columns.at(name));
    this.shown = shownUnit(line.unit, angle);
    const own = line.columns.length === 1 ? limits.filter(({ column, steps }) => column === line.columns[0] && steps.length === 0) : [];
    this.bounds = own.flatMap((limit) =>
      [limit.at_least, limit.at_most]
        .filter((bound) => bound !== null)
        .map((bound) => ({ name: limit.name.replaceAll("_", " "), value: this.scaled(bound * limit.unit_si), from_s: limit.from_s, until_s: limit.until_s ?? Infinity })),
    );
  }

  /** Converts a recorded value to the displayed unit. */
  scaled(value: number): number {
    return (value + (this.line.offset ?? 0)) * this.shown.scale;
  }

  get decimals(): number {
    return decimalsFor(this.shown, this.largest);
  }

  /** Half a turn in the displayed unit. */
  get half(): number {
    return Math.PI * this.shown.scale;
  }
}

/** Colours of the theme for lines that have no axis of rotation. */
const FREE = ["yaw", "roll", "pitch", "line-4", "line-5", "line-6", "line-7", "line-8"];

/** Returns a colour for each line: the colour of its axis of rotation, or another one if that is taken. */
export function coloursOf(lines: readonly Line[]): string[] {
  const taken = new Set<string>();
  const take = (colour: string) => (taken.add(colour), colour);
  const own = lines.map(({ colour }) => (colour && !taken.has(colour) ? take(colour) : null));
  return own.map((colour) => colour ?? take(FREE.find((one) => !taken.has(one)) ?? FREE[FREE.length - 1]));
}
