import { answer } from "../engine/answers";
import type { Engine } from "../engine/engine";
import { Conditioned } from "./conditioned";
import type { Past } from "./messages";
import { Random } from "./random";

/** An engine whose waves can be replaced. */
export interface EngineInSeas extends Engine {
  /** Amplitudes and phases of the regular waves that make up the sea, m and rad. */
  wave_amplitudes_m(): Float64Array;
  wave_phases_rad(): Float64Array;
  /** Complex elevation of each wave at a position and a time: all real parts, then all imaginary parts. */
  wave_phasors(x_m: number, y_m: number, time_s: number): Float64Array;
  set_waves(amplitudes_m: Float64Array, phases_rad: Float64Array): void;
}

/** Standard deviation of the noise of a measured wave, over the significant wave height. */
export const NOISE = 0.02;
/** Seed of the noise; it differs from the seeds of the futures. */
const NOISE_SEED = 0x5ea;

/**
 * Possible seas, given the spectrum of the present sea and the measurements of a sensor at the ship. The elevation is
 * the sum of a_i Re{z_i e^(i q_i)}, with amplitudes a_i from the spectrum and unknown complex normal z_i, E|z_i|^2 = 1.
 * Only the sensor uses the amplitudes and phases of the run's own waves.
 */
export class SeasAhead {
  readonly waves: number;
  private readonly own: { amplitudes_m: Float64Array; phases_rad: Float64Array };

  constructor(
    private readonly engine: EngineInSeas,
    private readonly expected_m: Float64Array,
    private readonly relativeNoise = NOISE,
  ) {
    this.own = { amplitudes_m: engine.wave_amplitudes_m(), phases_rad: engine.wave_phases_rad() };
    this.waves = expected_m.length;
  }

  /** Significant wave height, m. */
  get height_m(): number {
    return 4 * Math.sqrt(this.expected_m.reduce((sum, a) => sum + (a * a) / 2, 0));
  }

  /** Returns the distribution of the waves given the measurements. */
  after(past: Past): Conditioned {
    const noise = this.relativeNoise * this.height_m;
    const values = this.measure(past, noise);
    this.engine.set_waves(this.expected_m, new Float64Array(this.waves));
    const rows = new Float64Array(2 * this.waves * values.length);
    values.forEach((_, i) => rows.set(this.row(past, i), 2 * this.waves * i));
    return new Conditioned(2 * this.waves, { rows, values, noise });
  }

  /** Replaces the engine's waves by a sample of this distribution. */
  enter(known: Conditioned, random: Random): void {
    const z = known.draw(random);
    const [amplitudes_m, phases_rad] = [new Float64Array(this.waves), new Float64Array(this.waves)];
    for (let i = 0; i < this.waves; i++) {
      amplitudes_m[i] = this.expected_m[i] * Math.hypot(z[2 * i], z[2 * i + 1]) * Math.SQRT1_2;
      phases_rad[i] = Math.atan2(z[2 * i + 1], z[2 * i]);
    }
    this.engine.set_waves(amplitudes_m, phases_rad);
  }

  /**
   * Returns the readings of the sensor: the elevation in the sea of the run, with noise; a repeated reading at one time
   * is equal.
   */
  private measure({ time_s, x_m, y_m }: Past, noise: number): Float64Array {
    this.engine.set_waves(this.own.amplitudes_m, this.own.phases_rad);
    return time_s.map((time, i) => {
      const real = this.engine.wave_phasors(x_m[i], y_m[i], time).subarray(0, this.waves);
      return real.reduce((sum, part) => sum + part, 0) + noise * new Random(NOISE_SEED + Math.round(1e3 * time)).normal();
    });
  }

  /** Returns the coefficients of the elevation with respect to the real and imaginary parts of each z. */
  private row({ time_s, x_m, y_m }: Past, i: number): Float64Array {
    const phasors = this.engine.wave_phasors(x_m[i], y_m[i], time_s[i]);
    const row = new Float64Array(2 * this.waves);
    for (let k = 0; k < this.waves; k++) {
      row[2 * k] = Math.SQRT1_2 * phasors[k];
      row[2 * k + 1] = -Math.SQRT1_2 * phasors[this.waves + k];
    }
    return row;
  }
}

/**
 * Returns the amplitudes of the waves of the engine's sea according to the spectra, m. If the amplitudes of the run are
 * random, another engine is opened to compute them.
 */
export function expectedAmplitudes(engine: EngineInSeas, open: (resolved: string) => EngineInSeas): Float64Array {
  const resolved = answer(engine, "resolved_json");
  let isDrawn = false;
  for (const system of Object.values(resolved.sea?.waves ?? {})) {
    for (const { realisation } of Object.values(system)) {
      if (realisation?.amplitudes !== "random") continue;
      realisation.amplitudes = "deterministic";
      isDrawn = true;
    }
  }
  if (!isDrawn) return engine.wave_amplitudes_m();
  const other = open(JSON.stringify(resolved));
  const amplitudes_m = other.wave_amplitudes_m();
  other.free();
  return amplitudes_m;
}
