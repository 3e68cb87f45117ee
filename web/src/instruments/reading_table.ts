import type { Moment } from "../app/recording/recording";
import type { Run, Session } from "../app/session";
import { texts } from "../texts";
import { make, setText } from "../ui/dom";
import { number } from "./bar";
import { rangeOf } from "./range";
import { pointsOf, readingsOf, SHOWN } from "./readings";

interface Row {
  column: string;
  unit: string;
  cells: HTMLElement[];
}

/**
 * Table of readings at present and over the last minute: tensions of ropes, angles, gaps, and heave of named points.
 */
export class ReadingTable {
  readonly element: HTMLElement;
  private readonly rows: Row[] = [];

  private constructor(
    run: Run,
    private readonly session: Session,
  ) {
    const readings = readingsOf(run.channels);
    const points = pointsOf(run.channels);
    const groups = [...new Set(readings.map(({ thing }) => thing))].map((thing) =>
      this.group(thing, readings.filter((one) => one.thing === thing)),
    );
    const { height, rise } = texts.instruments;
    const ofPoints = points.map((point) =>
      this.group(point.name, [
        { label: height, column: point.height, unit: "m" },
        { label: rise, column: point.speed, unit: "m/s" },
      ]),
    );
    const head = make("thead", {}, make("tr", {}, make("td", {}), ...texts.instruments.columns.map((text) => make("th", { scope: "col" }, text))));
    this.element = make("table", { class: "readings" }, make("caption", {}, texts.instruments.readings), head, ...groups, ...ofPoints);
  }

  /** Returns the table for a run; null if it has no readings. */
  static of(run: Run, session: Session): ReadingTable | null {
    const table = new ReadingTable(run, session);
    return table.rows.length > 0 ? table : null;
  }

  show({ columns }: Run, { time_s, row }: Moment): void {
    const { rows } = this.session.shown.recording!;
    for (const { column, unit, cells } of this.rows) {
      const [word, factor] = SHOWN[unit] ?? [unit, 1];
      const now = columns.read(row, column);
      const [low, high] = rangeOf(rows, columns.at(column), time_s);
      const values = [now, Math.min(now, low), Math.max(now, high)].map((value) => number(value * factor));
      cells.forEach((cell, k) => setText(cell, k === 0 ? `${values[0]} ${word}`.trimEnd() : values[k]));
    }
  }

  private group(thing: string, readings: { label: string; column: string; unit: string }[]): HTMLElement {
    const name = make("tr", {}, make("th", { colspan: 4, scope: "rowgroup" }, thing.replaceAll("_", " ")));
    const rows = readings.map(({ label, column, unit }) => {
      const cells = [0, 1, 2].map(() => make("td", {}));
      this.rows.push({ column, unit, cells });
      return make("tr", {}, make("th", { scope: "row", title: column }, label), ...cells);
    });
    return make("tbody", {}, name, ...rows);
  }
}
