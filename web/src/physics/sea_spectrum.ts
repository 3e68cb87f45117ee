import type { EngineInSeas } from "../forecast/sea";

/** The regular waves that make up a sea: rad/s and m. */
export interface Waves {
  omega: number[];
  amplitude_m: number[];
}

/** The spectral density of a sea over the wave period, relative to its largest; and its peak. */
export interface SeaSpectrum {
  period_s: number[];
  density: number[];
  peak_s: number;
}

/** A time after any ramp, and an interval in which no wave of the sea makes half a turn, s. */
const AT_S = 1000;
const LAPSE_S = 0.05;

/** The waves of an engine's sea: the rate of its phase gives each frequency, and the spectra give its amplitude. */
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

/** Width over which each wave is spread, relative to its frequency: the density of a few hundred waves is then smooth. */
const SPREAD = 0.05;
/** The spread ends at this multiple of its width. */
const REACH = 3;
const POINTS = 160;

/**
 * S(omega) of a sea of regular waves. The a^2/2 of each wave is spread by a normal distribution over the logarithm of the frequency, in
 * which the returned periods are evenly spaced. Null for calm water.
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
