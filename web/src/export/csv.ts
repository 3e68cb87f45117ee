/** Tables as `kingpost run -o FILE.csv` writes them: every number reads back to the same bits. */

/** Digits before the point, and zeros after it, from which on a number is written with a power of ten. */
const LARGEST = 16;
const SMALLEST = -4;

/** A number as Python writes it: the shortest digits that read back to it; empty for NaN. */
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

/** A name or a text, in quotes if needed. */
function cell(text: string): string {
  return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}

/** The recording, in parts of a file: a row for each record, a column for each name. */
export function* rowsAsCsv(names: readonly string[], rows: Iterable<ArrayLike<number>>): Generator<string> {
  yield `${names.map(cell).join(",")}\n`;
  for (const row of rows) yield `${Array.from(row, written).join(",")}\n`;
}

/** The events, as the table next to a CSV file. */
export function eventsAsCsv(events: readonly { time_s: number; name: string; text: string }[]): string {
  const lines = events.map(({ time_s, name, text }) => `${written(time_s)},${cell(name)},${cell(text)}\n`);
  return `event_time,event_element,event_what\n${lines.join("")}`;
}
