import type { EngineInSeas } from "../forecast/sea";

/** Regular waves that make up a sea: frequencies, rad/s, and amplitudes, m. */
export interface Waves {
  omega: number[];
  amplitude_m: number[];
}

/** Spectral density of a sea over the wave period, relative to its largest value, and its peak period. */
export interface SeaSpectrum {
  period_s: number[];
  density: number[];
  peak_s: number;
}

/** A time after any ramp, s, and an interval in which no wave of the sea makes half a turn, s. */
const AT_S = 1000;
const LAPSE_S = 0.05;

/**
 * Returns the waves of an engine's sea. The rate of a wave's phase gives its frequency; the spectra give its amplitude.
 */
export function wavesOf(engine: Pick<EngineInSeas, "wave_phasors">, amplitude_m: ArrayLike<number>): Waves {
  const [now, then] = [AT_S, AT_S + LAPSE_S].map((time_s) => engine.wave_phasors(0, 0, time_s));
  const count = amplitude_m.length;
  const angle = (of: Float64Array, k: number) => Math.atan2(of[count + k], of[k]);
  const turned = (k: number) => Math.abs(Math.atan2(Math.sin(angle(then, k) - angle(now, k)), Math.cos(angle(then, k) - angle(now, k))));
  const waves: Waves = { omega: [], amplitude_m: [] };
  for (let k = 0; k < count; k++) {
    const omega = turned(k) / LAPSE_S;
    if (!(amplitude_m[k] > 0) || !(omega > 0)) continue;
    waves.omega.push(omega);
    waves.amplitude_m.push(amplitude_m[k]);
  }
  return waves;
}

/**
 * Standard deviation by which each wave is spread, relative to its frequency: the density of a few hundred waves is
 * then smooth.
 */
const SPREAD = 0.05;
/** Distance beyond the lowest and the highest frequency that the spectrum covers, in standard deviations. */
const REACH = 3;
const POINTS = 160;

/**
 * Returns the spectrum S(omega) of regular waves, over the period. The energy a^2/2 of each wave is spread by a normal
 * distribution over the logarithm of the frequency, in which the returned periods are evenly spaced. Null for calm
 * water.
 */
export function spectrumOf({ omega, amplitude_m }: Waves): SeaSpectrum | null {
  if (omega.length === 0) return null;
  const [low, high] = [Math.min(...omega), Math.max(...omega)].map(Math.log);
  const [from, to] = [low - REACH * SPREAD, high + REACH * SPREAD];
  const at = Array.from({ length: POINTS }, (_, i) => Math.exp(to + ((from - to) * i) / (POINTS - 1)));
  const density = at.map((one) => omega.reduce((sum, other, k) => sum + 0.5 * amplitude_m[k] ** 2 * Math.exp(-0.5 * (Math.log(one / other) / SPREAD) ** 2), 0) / one);
  const largest = Math.max(...density);
  const peak = density.indexOf(largest);
  return { period_s: at.map((one) => (2 * Math.PI) / one), density: density.map((one) => one / largest), peak_s: (2 * Math.PI) / at[peak] };
}
