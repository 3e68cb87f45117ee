import type { Equations } from "../engine/engine";

export type NamedMatrix = Equations["matrices"][number];
export type SymbolicMatrix = Equations["formulas"][number];

/** A range of rows or columns that belong together: a body's translation or rotation, or a coordinate. */
export interface Stretch {
  from: number;
  length: number;
  /** Index of the body that gives its colour; -1 for none. */
  body: number;
}

/** A block of a matrix: the entries of a range of rows and a range of columns. */
export interface Block {
  rows: Stretch;
  columns: Stretch;
  /** Entries by rows. */
  values: number[][];
  isZero: boolean;
}

/** Entries below this fraction of a matrix's largest entry are shown as 0: rounding of sums. */
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
 * Rows or columns in ranges: three translations or three rotations of one body together, a joint's coordinate alone. `bodyOf` gives the
 * index of the body of a label.
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

/** `ship.omega_x` and `ship.roll` are parts of a body's motion, `slew` is not. */
function hasParts(label: string): boolean {
  return label.includes(".");
}

const stem = (label: string) => label.slice(0, label.lastIndexOf("."));

/** The blocks of a matrix, row by row. */
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

/** A number in a cell: three digits, as short as they go. */
export function inCell(value: number): string {
  if (!Number.isFinite(value)) return "–";
  const size = Math.abs(value);
  const text = size >= 1e4 || size < 1e-2 ? value.toExponential(1).replace("e+", "e") : String(Number(value.toPrecision(3)));
  return text.replace(/-/g, "−");
}
