/** Statistics of a part of a record, as `kingpost statistics` defines them. */
export interface Statistics {
  mean: number;
  /** Standard deviation about the mean. */
  standard_deviation: number;
  minimum: number;
  maximum: number;
  /** Significant double amplitude, four standard deviations; for a wave elevation this is Hs. */
  significant_double_amplitude: number;
  /** Mean time between up-crossings of the mean, s; NaN if there are fewer than two. */
  zero_up_crossing_period: number;
}

/** Smallest number of up-crossings for a mean period. */
const FEWEST_CROSSINGS = 2;

/**
 * Computes the statistics of values at these times; rows that are not evenly spaced, such as thinned rows, are weighted
 * by their duration.
 */
export function statisticsOf(times_s: ArrayLike<number>, values: ArrayLike<number>): Statistics {
  const weights = weightsOf(times_s);
  const mean = weighted(values, weights, (value) => value);
  const deviation = Math.sqrt(weighted(values, weights, (value) => (value - mean) ** 2));
  let [minimum, maximum] = [Infinity, -Infinity];
  for (let i = 0; i < values.length; i++) [minimum, maximum] = [Math.min(minimum, values[i]), Math.max(maximum, values[i])];
  const isEmpty = values.length === 0;
  return {
    mean,
    standard_deviation: deviation,
    minimum: isEmpty ? NaN : minimum,
    maximum: isEmpty ? NaN : maximum,
    significant_double_amplitude: 4 * deviation,
    zero_up_crossing_period: upCrossingPeriod(times_s, values, mean),
  };
}

/**
 * Returns the duration of each record: half of the interval to each neighbour; a record at an end counts its only
 * interval on both sides. Evenly spaced records have equal weight.
 */
function weightsOf(times_s: ArrayLike<number>): Float64Array {
  const last = times_s.length - 1;
  if (last < 1) return new Float64Array(times_s.length).fill(1);
  const gap = (i: number) => times_s[i + 1] - times_s[i];
  return Float64Array.from({ length: last + 1 }, (_, i) => (gap(Math.max(0, i - 1)) + gap(Math.min(last - 1, i))) / 2);
}

function weighted(values: ArrayLike<number>, weights: Float64Array, of: (value: number) => number): number {
  let [sum, whole] = [0, 0];
  for (let i = 0; i < values.length; i++) {
    sum += weights[i] * of(values[i]);
    whole += weights[i];
  }
  return sum / whole;
}

/** Computes the mean up-crossing period; each crossing is interpolated linearly between two records. */
function upCrossingPeriod(times_s: ArrayLike<number>, values: ArrayLike<number>, mean: number): number {
  const crossings: number[] = [];
  for (let i = 0; i + 1 < values.length; i++) {
    const [before, after] = [values[i] - mean, values[i + 1] - mean];
    if (before < 0 && after >= 0) crossings.push(times_s[i] - (before * (times_s[i + 1] - times_s[i])) / (after - before));
  }
  if (crossings.length < FEWEST_CROSSINGS) return NaN;
  return (crossings[crossings.length - 1] - crossings[0]) / (crossings.length - 1);
}
