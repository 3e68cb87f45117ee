/** What a stretch of a record comes to, as `kingpost statistics` defines it. */
export interface Statistics {
  mean: number;
  /** About the mean. */
  standard_deviation: number;
  minimum: number;
  maximum: number;
  /** Four deviations, crest to trough: of a wave elevation its Hs. */
  significant_double_amplitude: number;
  /** Mean time between up-crossings of the mean, s; NaN where there are fewer than two. */
  zero_up_crossing_period: number;
}

/** Up-crossings that a mean period needs. */
const FEWEST_CROSSINGS = 2;

/** Of values at these times; where rows lie unevenly, as thinned ones do, each counts as long as it stands. */
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

/** How long each record stands: half of the way to either neighbour, as far on both sides at the ends. Even records weigh the same. */
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

/** Each crossing is found on the line between two records. */
function upCrossingPeriod(times_s: ArrayLike<number>, values: ArrayLike<number>, mean: number): number {
  const crossings: number[] = [];
  for (let i = 0; i + 1 < values.length; i++) {
    const [before, after] = [values[i] - mean, values[i + 1] - mean];
    if (before < 0 && after >= 0) crossings.push(times_s[i] - (before * (times_s[i + 1] - times_s[i])) / (after - before));
  }
  if (crossings.length < FEWEST_CROSSINGS) return NaN;
  return (crossings[crossings.length - 1] - crossings[0]) / (crossings.length - 1);
}
