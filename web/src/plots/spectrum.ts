/** A one-sided spectral density over the angular frequency: its integral is the variance. */
export interface Spectrum {
  /** Frequencies, rad/s, evenly spaced from 0. */
  omega: Float64Array;
  /** Unit of the values squared, times s/rad. */
  density: Float64Array;
  /** Frequency spacing, rad/s: 2 pi over the length of a segment. */
  resolution: number;
  segments: number;
}

/** Records whose steps differ by more than this share are not evenly spaced. */
const EVEN = 1e-6;
/** Fewest records of a segment. */
const SHORTEST = 8;

/** Transforms a sequence of real numbers whose length is a power of two: re, im of the frequencies from 0 to the Nyquist frequency. */
export type Transform = (values: Float64Array) => ArrayLike<number>;

/** The library is loaded with the first spectrum. */
export async function loadTransform(): Promise<(length: number) => Transform> {
  const { default: FFT } = await import("fft.js");
  return (length) => {
    const fft = new FFT(length);
    const lines = fft.createComplexArray();
    return (values) => (fft.realTransform(lines, values), lines);
  };
}

/** The evenly spaced records up to the last one, or to the one before if a run ended off the grid: [from, to). */
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

/** Records of a segment: a power of two, so that at least `parts` fit into the record; 0 if it is too short. */
export function segmentLength(records: number, parts: number): number {
  const length = 2 ** Math.floor(Math.log2(Math.max(1, records / parts)));
  return length >= SHORTEST ? length : 0;
}

/**
 * By Welch's method, as `kingpost.statistics.spectrum`: segments of the record less its mean that overlap by half, each under a Hann
 * window; their squares averaged and divided by the mean square of the window (Welch, IEEE Trans. Audio Electroacoust. 15(2), 1967).
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
  // All lines but the first and the last stand for two sides.
  for (let k = 0; k < density.length; k++) density[k] *= scale * (k === 0 || 2 * k === length ? 1 : 2);
  const resolution = (2 * Math.PI) / (length * step_s);
  return { omega: Float64Array.from(density, (_, k) => k * resolution), density, resolution, segments };
}

/** Periodic, so that windows that overlap by half add up evenly. */
function hann(length: number): Float64Array {
  return Float64Array.from({ length }, (_, i) => 0.5 - 0.5 * Math.cos((2 * Math.PI * i) / length));
}

/** Index of the largest density, except at 0, which contains the drift. */
export function peakOf({ density }: Spectrum): number {
  return density.reduce((best, value, k) => (k > 0 && value > density[best] ? k : best), 1);
}

/** Fewest periods of a peak in a segment: nearer to 0 it merges with the drift, since a Hann window is four lines wide. */
const FEWEST_PERIODS = 3;

/** Whether the segments are long enough for the largest density to be a motion rather than the drift. */
export function isResolved(spectrum: Spectrum): boolean {
  return peakOf(spectrum) >= FEWEST_PERIODS;
}

/** Spectra of columns by at most this many parts of the record, and by fewer where the segments are too short for a peak. */
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

/** Number of frequencies from 0 that contain this share of the variance. */
export function linesThatHold({ density }: Spectrum, share: number): number {
  const whole = density.reduce((sum, value) => sum + value, 0);
  let [sum, k] = [0, 0];
  while (k < density.length && sum < share * whole) sum += density[k++];
  return k;
}
