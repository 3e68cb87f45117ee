/** An oscillating mode about equilibrium, as the engine computes it. */
export interface NaturalMode {
  /** Coordinate with the largest amplitude in the mode. */
  coordinate: string;
  period_s: number;
  damping_ratio: number;
}

/** Modes at one value of the varied parameter. */
export interface ModesAt {
  value: number;
  modes: readonly NaturalMode[];
}

/** Point of a line: a value of the parameter with a mode. */
export interface Place extends NaturalMode {
  value: number;
}

/** One mode at the values of the parameter, in ascending order. */
export interface PeriodLine {
  coordinate: string;
  /** Number of the line among those of its coordinate, from 1; left out if it is the only one. */
  number?: number;
  places: Place[];
}

/**
 * Range of periods, s: longer periods belong to station keeping, shorter ones to ropes and frames, and no sea has them.
 */
const PERIODS_S = { least: 1.5, most: 40 };
/** Largest ratio of the periods at neighbouring values within one mode. */
const MOST_CHANGE = 1.5;

/** Joins modes into lines: from value to value, the nearest modes of the same coordinate. */
export function linesOf(found: readonly ModesAt[]): PeriodLine[] {
  const lines: PeriodLine[] = [];
  for (const { value, modes } of [...found].sort((a, b) => a.value - b.value)) {
    const open = new Set(lines);
    for (const mode of modes.filter(({ period_s }) => period_s >= PERIODS_S.least && period_s <= PERIODS_S.most)) {
      const line = nearest([...open].filter(({ coordinate }) => coordinate === mode.coordinate), mode.period_s);
      if (line) {
        open.delete(line);
        line.places.push({ ...mode, value });
      } else lines.push({ coordinate: mode.coordinate, places: [{ ...mode, value }] });
    }
  }
  for (const line of lines) {
    const alike = lines.filter(({ coordinate }) => coordinate === line.coordinate);
    if (alike.length > 1) line.number = alike.indexOf(line) + 1;
  }
  return lines;
}

function nearest(lines: readonly PeriodLine[], period_s: number): PeriodLine | null {
  const away = ({ places }: PeriodLine) => Math.abs(Math.log(places[places.length - 1].period_s / period_s));
  const best = lines.reduce<PeriodLine | null>((so, line) => (so && away(so) <= away(line) ? so : line), null);
  return best && away(best) <= Math.log(MOST_CHANGE) ? best : null;
}

/**
 * Returns the points at which lines cross a period, interpolated linearly between two values, in order of the values.
 */
export function crossings(lines: readonly PeriodLine[], period_s: number): Place[] {
  const found = lines.flatMap(({ places }) =>
    places.flatMap((to, k): Place[] => {
      const from = places[k - 1];
      if (to.period_s === period_s) return [to];
      if (!from || (from.period_s - period_s) * (to.period_s - period_s) >= 0) return [];
      const share = (period_s - from.period_s) / (to.period_s - from.period_s);
      const between = (a: number, b: number) => a + share * (b - a);
      return [{ coordinate: to.coordinate, value: between(from.value, to.value), period_s, damping_ratio: between(from.damping_ratio, to.damping_ratio) }];
    }),
  );
  return found.sort((a, b) => a.value - b.value);
}

/** Returns the point whose period is nearest to another period, by their ratio; null if there is no line. */
export function closest(lines: readonly PeriodLine[], period_s: number): Place | null {
  const away = (place: Place) => Math.abs(Math.log(place.period_s / period_s));
  return lines.flatMap(({ places }) => places).reduce<Place | null>((so, place) => (so && away(so) <= away(place) ? so : place), null);
}

/**
 * Returns evenly spaced values over a range. Each value halves a gap between earlier ones, so that a rough picture
 * comes first.
 */
export function valuesOver([low, high]: readonly [number, number], count: number): number[] {
  const order = [0, count - 1];
  for (let gap = 2 ** Math.ceil(Math.log2(count)); gap >= 1; gap /= 2) {
    for (let k = gap; k < count; k += gap) if (!order.includes(k)) order.push(k);
  }
  return order.map((k) => Number((low + ((high - low) * k) / (count - 1)).toPrecision(6)));
}
