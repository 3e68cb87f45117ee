/** Levels of the lines of a fan: shares of the futures below each line. */
export const LEVELS = [0.05, 0.25, 0.5, 0.75, 0.95] as const;

/**
 * Returns a quantile of a sample in ascending order: a further value is equally likely in each of the n + 1 gaps
 * (Weibull's plotting position), so that a band of 90 % contains 90 % for any n that is large enough.
 */
export function quantile(ascending: ArrayLike<number>, share: number): number {
  const n = ascending.length;
  if (n === 0) return NaN;
  const place = Math.min(n - 1, Math.max(0, share * (n + 1) - 1));
  const below = Math.floor(place);
  const above = Math.min(n - 1, below + 1);
  return ascending[below] + (place - below) * (ascending[above] - ascending[below]);
}

/**
 * Returns the lines of a fan: for each level a value at each time. `values[k]` holds the values of all futures at time
 * k.
 */
export function fanOf(values: readonly Float64Array[]): Float64Array[] {
  const lines = LEVELS.map(() => new Float64Array(values.length));
  values.forEach((all, k) => {
    const ascending = all.filter(Number.isFinite).sort();
    LEVELS.forEach((level, i) => (lines[i][k] = quantile(ascending, level)));
  });
  return lines;
}
