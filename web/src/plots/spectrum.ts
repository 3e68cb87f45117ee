/** One-sided spectral density over the angular frequency; its integral is the variance. */
export interface Spectrum {
  /** Frequencies, rad/s, evenly spaced from 0. */
  omega: Float64Array;
  /** Spectral density, in the squared unit of the values times s/rad. */
  density: Float64Array;
  /** Frequency resolution, rad/s: 2 pi over the duration of a segment. */
  resolution: number;
  segments: number;
}

/** Largest relative difference of the steps of evenly spaced records. */
const EVEN = 1e-6;
/** Smallest number of records in a segment. */
const SHORTEST = 8;

/**
 * Transforms a sequence of real numbers whose length is a power of two; returns re, im of each frequency from 0 to the
 * Nyquist frequency.
 */
export type Transform = (values: Float64Array) => ArrayLike<number>;

/** Loads the library for Fourier transforms, with the first spectrum. */
export async function loadTransform(): Promise<(length: number) => Transform> {
  const { default: FFT } = await import("fft.js");
  return (length) => {
    const fft = new FFT(length);
    const lines = fft.createComplexArray();
    return (values) => (fft.realTransform(lines, values), lines);
  };
}

/**
 * Returns the range [from, to) of evenly spaced records that ends at the last record, or at the one before if the run
 * ended off the grid.
 */
export function evenEnd(times_s: ArrayLike<number>): [number, number] {
  const gap = (i: number) => times_s[i] - times_s[i - 1];
  const isEven = (i: number, step_s: number) => Math.abs(gap(i) - step_s) <= EVEN * step_s;
  let to = times_s.length;
  if (to > 2 && !isEven(to - 1, gap(to - 2))) to -= 1;
  if (to < 2) return [0, to];
  const step_s = gap(to - 1);
  let from = to - 1;
  while (from > 0 && isEven(from, step_s)) from -= 1;
  return [from, to];
}

/**
 * Returns the number of records in a segment: a power of two, such that at least `parts` segments fit into the record;
 * 0 if the record is too short.
 */
export function segmentLength(records: number, parts: number): number {
  const length = 2 ** Math.floor(Math.log2(Math.max(1, records / parts)));
  return length >= SHORTEST ? length : 0;
}

/**
 * Computes a spectrum by Welch's method, as `kingpost.statistics.spectrum`: the record less its mean is divided into
 * segments that overlap by half, each under a Hann window; their squared transforms are averaged and divided by the
 * mean square of the window (Welch, IEEE Trans. Audio Electroacoust. 15(2), 1967).
 */
export function welch(values: ArrayLike<number>, step_s: number, length: number, transformOf: (length: number) => Transform): Spectrum {
  const window = hann(length);
  const transform = transformOf(length);
  const mean = Array.from(values).reduce((sum, value) => sum + value, 0) / values.length;
  const density = new Float64Array(length / 2 + 1);
  const segment = new Float64Array(length);
  let segments = 0;
  for (let start = 0; start + length <= values.length; start += length / 2) {
    for (let i = 0; i < length; i++) segment[i] = (values[start + i] - mean) * window[i];
    const lines = transform(segment);
    for (let k = 0; k < density.length; k++) density[k] += lines[2 * k] ** 2 + lines[2 * k + 1] ** 2;
    segments += 1;
  }
  const square = window.reduce((sum, one) => sum + one * one, 0);
  const scale = step_s / square / (2 * Math.PI * segments);
  // All frequencies except the first and the last also stand for their negative.
  for (let k = 0; k < density.length; k++) density[k] *= scale * (k === 0 || 2 * k === length ? 1 : 2);
  const resolution = (2 * Math.PI) / (length * step_s);
  return { omega: Float64Array.from(density, (_, k) => k * resolution), density, resolution, segments };
}

/** Returns a periodic Hann window: windows that overlap by half add up to a constant. */
function hann(length: number): Float64Array {
  return Float64Array.from({ length }, (_, i) => 0.5 - 0.5 * Math.cos((2 * Math.PI * i) / length));
}

/** Returns the index of the largest density, except at frequency 0, which contains the drift. */
export function peakOf({ density }: Spectrum): number {
  return density.reduce((best, value, k) => (k > 0 && value > density[best] ? k : best), 1);
}

/**
 * Smallest number of periods of a peak in a segment: with fewer it merges with the drift, because the peak of a Hann
 * window is four frequencies wide.
 */
const FEWEST_PERIODS = 3;

/** Whether the segments are long enough for the largest density to be a motion and not the drift. */
export function isResolved(spectrum: Spectrum): boolean {
  return peakOf(spectrum) >= FEWEST_PERIODS;
}

/**
 * Computes spectra of columns with at most this number of segments; with fewer if the segments are too short for a
 * peak.
 */
export function spectraOf(
  columns: readonly ArrayLike<number>[],
  step_s: number,
  parts: number,
  transformOf: (length: number) => Transform,
): Spectrum[] {
  const records = columns[0]?.length ?? 0;
  for (let least = parts; ; least /= 2) {
    const length = segmentLength(records, Math.max(1, least));
    if (length === 0 && least <= 1) return [];
    const found = length === 0 ? [] : columns.map((values) => welch(values, step_s, length, transformOf));
    if (least <= 1 || (found.length > 0 && found.every((one) => isResolved(one) || isStill(one)))) return found;
  }
}

function isStill({ density }: Spectrum): boolean {
  return density.every((value) => value === 0);
}

/** Returns the number of frequencies from 0 on that contain this share of the variance. */
export function linesThatHold({ density }: Spectrum, share: number): number {
  const whole = density.reduce((sum, value) => sum + value, 0);
  let [sum, k] = [0, 0];
  while (k < density.length && sum < share * whole) sum += density[k++];
  return k;
}
