import type { Happened } from "../engine/messages";

/** Tables as `kingpost run -o FILE.csv` writes them: each number is read back to the same bits. */

/** Largest number of digits before the decimal point, and of zeros after it, without a power of ten. */
const LARGEST = 16;
const SMALLEST = -4;

/** Formats a number as Python does: the shortest digits that are read back to the same bits; empty for NaN. */
export function written(value: number): string {
  if (Number.isNaN(value)) return "";
  if (!Number.isFinite(value)) return value > 0 ? "inf" : "-inf";
  if (value === 0) return Object.is(value, -0) ? "-0.0" : "0.0";
  const [digits, power] = value.toExponential().split("e");
  const exponent = Number(power);
  if (exponent < SMALLEST || exponent >= LARGEST) return `${digits}e${exponent < 0 ? "-" : "+"}${String(Math.abs(exponent)).padStart(2, "0")}`;
  return plain(value < 0 ? "-" : "", digits.replace("-", "").replace(".", ""), exponent);
}

function plain(sign: string, digits: string, exponent: number): string {
  if (exponent < 0) return `${sign}0.${"0".repeat(-exponent - 1)}${digits}`;
  const whole = digits.slice(0, exponent + 1).padEnd(exponent + 1, "0");
  return `${sign}${whole}.${digits.slice(exponent + 1) || "0"}`;
}

/** Formats a name or a text as a cell, in quotes if needed. */
function cell(text: string): string {
  return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}

/** Writes the recording in parts of a file: a row for each record, a column for each name. */
export function* rowsAsCsv(names: readonly string[], rows: Iterable<ArrayLike<number>>): Generator<string> {
  yield `${names.map(cell).join(",")}\n`;
  for (const row of rows) yield `${Array.from(row, written).join(",")}\n`;
}

/** Rows of a run, with the names of their columns. */
export interface NamedRows {
  run: string;
  names: readonly string[];
  rows: readonly ArrayLike<number>[];
}

/** Writes several runs as one table: the name of the run, then all columns of any run; a cell that a run lacks is empty. */
export function* rowsOfRunsAsCsv(runs: readonly NamedRows[]): Generator<string> {
  const names = [...new Set(runs.flatMap((run) => run.names))];
  yield `${["run", ...names].map(cell).join(",")}\n`;
  for (const { run, names: own, rows } of runs) {
    const at = new Map(own.map((name, place) => [name, place]));
    const places = names.map((name) => at.get(name));
    for (const row of rows) yield `${[cell(run), ...places.map((place) => (place === undefined ? "" : written(row[place])))].join(",")}\n`;
  }
}

/** Writes the events as a table, as `kingpost run` writes it next to a CSV file. */
export function eventsAsCsv(events: readonly Happened[]): string {
  const lines = events.map(({ time_s, code, name, text }) => `${written(time_s)},${cell(code)},${cell(name)},${cell(text)}\n`);
  return `event_time,event_code,event_element,event_what\n${lines.join("")}`;
}
