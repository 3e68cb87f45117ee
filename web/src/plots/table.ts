import { texts } from "../texts";

/** Largest number of times in a table. */
const MOST_ROWS = 12;

/** Returns evenly spaced indices below `length`, at most `most`, including the last. */
export function places(length: number, most = MOST_ROWS): number[] {
  const count = Math.min(length, most);
  return Array.from({ length: count }, (_, i) => (count === 1 ? length - 1 : Math.round((i * (length - 1)) / (count - 1))));
}

/** Returns the lines of a plot as rows of numbers: the smallest, the largest and some values of each. */
export function rowsOf(times: ArrayLike<number>, lines: readonly ArrayLike<number>[], write: (value: number, line: number) => string): string[][] {
  const moments = places(times.length).map((at) => [`${Number(times[at].toPrecision(6))} s`, ...lines.map((line, i) => write(line[at], i))]);
  const ends = (of: (a: number, b: number) => number) => lines.map((line, i) => write(Array.from(line).reduce((so, value) => of(so, value), line[0]), i));
  return times.length > 0 ? [[texts.plots.least, ...ends(Math.min)], [texts.plots.greatest, ...ends(Math.max)], ...moments] : [];
}
