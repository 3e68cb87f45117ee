/** Unit in which angles are displayed. */
export type Angle = "deg" | "rad";

/** Displayed unit of an SI unit. */
export interface ShownUnit {
  unit: string;
  /** Factor from the SI unit to the displayed unit. */
  scale: number;
  /** Number of decimals, unless the numbers are small. */
  decimals: number;
}

const DEGREES_PER_RADIAN = 180 / Math.PI;
/** Units that are displayed in thousands, as in pictures of `kingpost plot`. */
const BY_THE_THOUSAND = ["N", "N m", "J", "W"];
const DECIMALS = { deg: 2, rad: 5, thousand: 2, other: 4 };
/** Smallest number of digits of the largest visible number; small numbers get more decimals. */
const DIGITS = 3;
const MOST_DECIMALS = 9;

export function shownUnit(si: string, angle: Angle): ShownUnit {
  if (/^rad\b/.test(si)) {
    if (angle === "rad") return { unit: pretty(si), scale: 1, decimals: DECIMALS.rad };
    return { unit: pretty(si).replace("rad", "°"), scale: DEGREES_PER_RADIAN, decimals: DECIMALS.deg };
  }
  if (BY_THE_THOUSAND.includes(si)) return { unit: `k${si}`, scale: 1e-3, decimals: DECIMALS.thousand };
  return { unit: si === "1" ? "" : pretty(si), scale: 1, decimals: DECIMALS.other };
}

/** Returns a unit with superscripts for powers. */
function pretty(unit: string): string {
  return unit.replaceAll("^2", "²").replaceAll("^3", "³");
}

/** Returns the number of decimals for numbers up to a magnitude; small numbers get more. */
export function decimalsFor({ decimals }: ShownUnit, largest: number): number {
  if (!(largest > 0) || !Number.isFinite(largest)) return decimals;
  const needed = DIGITS - 1 - Math.floor(Math.log10(largest));
  return Math.min(MOST_DECIMALS, Math.max(decimals, needed));
}
