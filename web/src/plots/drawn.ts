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
  /** Time from which it counts, s. */
  from_s: number;
}

/** A line of a plot: the columns of its numbers, their display, its colour and its limits. */
export class DrawnLine {
  readonly places: Places;
  readonly shown: ShownUnit;
  readonly bounds: Bound[];
  /** Largest magnitude of the visible numbers on its axis, in the displayed unit. */
  largest = 0;

  constructor(
    readonly line: Line,
    readonly label: string,
    /** Name of a colour of the theme. */
    readonly colour: string,
    columns: Columns,
    angle: Angle,
    limits: readonly LimitInfo[],
  ) {
    this.places = line.columns.map((name) => columns.at(name));
    this.shown = shownUnit(line.unit, angle);
    const own = line.columns.length === 1 ? limits.filter(({ column }) => column === line.columns[0]) : [];
    this.bounds = own.flatMap((limit) =>
      [limit.at_least, limit.at_most]
        .filter((bound) => bound !== null)
        .map((bound) => ({ name: limit.name.replaceAll("_", " "), value: this.scaled(bound * limit.unit_si), from_s: limit.from_s })),
    );
  }

  /** A recorded number in the displayed unit. */
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

/** Colours of the theme for lines that do not belong to an axis. */
const FREE = ["yaw", "roll", "pitch", "line-4", "line-5", "line-6", "line-7", "line-8"];

/** A colour for each line: the colour of its axis unless another line has it. */
export function coloursOf(lines: readonly Line[]): string[] {
  const taken = new Set<string>();
  const take = (colour: string) => (taken.add(colour), colour);
  const own = lines.map(({ colour }) => (colour && !taken.has(colour) ? take(colour) : null));
  return own.map((colour) => colour ?? take(FREE.find((one) => !taken.has(one)) ?? FREE[FREE.length - 1]));
}
