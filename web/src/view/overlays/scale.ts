import type { Load } from "./forces";

/**
 * Length of the longest arrow, relative to the size of the model, and factor by which it may grow before the scale
 * changes.
 */
const LONGEST = 0.4;
const GROWN = 1.5;

/** Scale of the arrows, m in the picture per N; it changes only if an arrow would be too long. */
export class ArrowScale {
  private m_per_unit = 0;
  /** Whether the scale stays. */
  isHeld = false;

  reset(): void {
    this.m_per_unit = 0;
  }

  /** Returns the scale for these loads in a model of this size, m. */
  of(loads: readonly Load[], size: number): number {
    const most = Math.max(0, ...loads.map(({ vector }) => Math.hypot(...vector)));
    if (most === 0 || (this.isHeld && this.m_per_unit > 0)) return this.m_per_unit;
    if (this.m_per_unit === 0 || most * this.m_per_unit > GROWN * LONGEST * size) this.m_per_unit = (LONGEST * size) / most;
    return this.m_per_unit;
  }
}

/** Returns a round number whose bar has at most a given length: 1, 2 or 5 times a power of ten. */
export function barOf(px_per_unit: number, most_px: number): { value: number; px: number } | null {
  if (!(px_per_unit > 0) || !Number.isFinite(px_per_unit)) return null;
  const most = most_px / px_per_unit;
  const power = 10 ** Math.floor(Math.log10(most));
  const value = [5, 2, 1].map((part) => part * power).find((one) => one <= most) ?? power;
  return { value, px: value * px_per_unit };
}

const PREFIXES = [["G", 1e9], ["M", 1e6], ["k", 1e3], ["", 1]] as const;

/** Formats a number with its unit, for example `200 kN`. */
export function written(value: number, unit: string): string {
  const [prefix, factor] = PREFIXES.find(([, one]) => value >= one) ?? ["", 1];
  return `${Number((value / factor).toPrecision(3))} ${prefix}${unit}`;
}
