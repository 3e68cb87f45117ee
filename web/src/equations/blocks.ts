import type { Equations } from "../engine/engine";

export type NamedMatrix = Equations["matrices"][number];
export type SymbolicMatrix = Equations["formulas"][number];

/** A range of rows or columns: a body's translation, a body's rotation, or one coordinate of a joint. */
export interface Stretch {
  from: number;
  length: number;
  /** Index of the body whose colour the range has; -1 for none. */
  body: number;
}

/** A block of a matrix: the entries in a range of rows and a range of columns. */
export interface Block {
  rows: Stretch;
  columns: Stretch;
  /** Entries of the block, row by row. */
  values: number[][];
  isZero: boolean;
}

/** Entries below this fraction of a matrix's largest entry are shown as 0: they are rounding errors of sums. */
const NOISE = 1e-12;

export function entry({ data, column_labels }: NamedMatrix, row: number, column: number): number {
  return data[row * column_labels.length + column];
}

export function largest({ data }: NamedMatrix): number {
  return data.reduce((so, value) => Math.max(so, Math.abs(value)), 0);
}

/** Whether an entry is shown as zero. */
export function isZero(matrix: NamedMatrix, value: number): boolean {
  return Math.abs(value) <= NOISE * largest(matrix);
}

/**
 * Divides rows or columns into ranges: the three translations or the three rotations of a body, or one coordinate of a
 * joint. `bodyOf` returns the index of the body of a label.
 */
export function stretchesOf(labels: readonly string[], units: readonly string[], bodyOf: (label: string) => number): Stretch[] {
  const stretches: Stretch[] = [];
  labels.forEach((label, at) => {
    const last = stretches.at(-1);
    const body = bodyOf(label);
    const isOfLast = last && hasParts(label) && last.body === body && units[at] === units[last.from] && stem(labels[last.from]) === stem(label);
    if (isOfLast && last.length < 3) last.length += 1;
    else stretches.push({ from: at, length: 1, body });
  });
  return stretches;
}

/**
 * Whether a label belongs to a component of a body's motion, such as `ship.omega_x` or `ship.roll`; `slew` does not.
 */
function hasParts(label: string): boolean {
  return label.includes(".");
}

const stem = (label: string) => label.slice(0, label.lastIndexOf("."));

/** Divides a matrix into blocks, row by row. */
export function blocksOf(matrix: NamedMatrix, rows: readonly Stretch[], columns: readonly Stretch[]): Block[][] {
  const noise = NOISE * largest(matrix);
  return rows.map((down) =>
    columns.map((across) => {
      const values = Array.from({ length: down.length }, (_, i) =>
        Array.from({ length: across.length }, (_, j) => entry(matrix, down.from + i, across.from + j)),
      );
      return { rows: down, columns: across, values, isZero: values.flat().every((value) => Math.abs(value) <= noise) };
    }),
  );
}

/** Formats a number for a cell: at most three digits, without trailing zeros. */
export function inCell(value: number): string {
  if (!Number.isFinite(value)) return "–";
  const size = Math.abs(value);
  const text = size >= 1e4 || size < 1e-2 ? value.toExponential(1).replace("e+", "e") : String(Number(value.toPrecision(3)));
  return text.replace(/-/g, "−");
}
