/** A motion that swings, as the engine finds it about rest. */
export interface NaturalMode {
  /** The one that moves most in it. */
  coordinate: string;
  period_s: number;
  damping_ratio: number;
}

/** The modes at one value of what is varied. */
export interface ModesAt {
  value: number;
  modes: readonly NaturalMode[];
}

/** A place of a line: a value, and the mode that it has there. */
export interface Place extends NaturalMode {
  value: number;
}

/** One mode over the values, in order of these. */
export interface PeriodLine {
  coordinate: string;
  places: Place[];
}

/** Longer ones are of station keeping, shorter ones of ropes and frames: no sea meets them, s. */
const PERIODS_S = { least: 1.5, most: 40 };
/** From one value to the next a period changes by no more than this factor; else it is another mode. */
const MOST_CHANGE = 1.5;

/** Modes of the same coordinate that are nearest to each other from value to value, as lines. */
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
  return lines;
}

function nearest(lines: readonly PeriodLine[], period_s: number): PeriodLine | null {
  const away = ({ places }: PeriodLine) => Math.abs(Math.log(places[places.length - 1].period_s / period_s));
  const best = lines.reduce<PeriodLine | null>((so, line) => (so && away(so) <= away(line) ? so : line), null);
  return best && away(best) <= Math.log(MOST_CHANGE) ? best : null;
}

/** Where lines pass a period, between two values on the straight line from one to the other; in order of the values. */
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

/** The place at which a period comes nearest to another, by their ratio; null where there is no line. */
export function closest(lines: readonly PeriodLine[], period_s: number): Place | null {
  const away = (place: Place) => Math.abs(Math.log(place.period_s / period_s));
  return lines.flatMap(({ places }) => places).reduce<Place | null>((so, place) => (so && away(so) <= away(place) ? so : place), null);
}

/** So many values over a range, evenly, in an order in which each halves a gap: a rough picture comes first. */
export function valuesOver([low, high]: readonly [number, number], count: number): number[] {
  const order = [0, count - 1];
  for (let gap = 2 ** Math.ceil(Math.log2(count)); gap >= 1; gap /= 2) {
    for (let k = gap; k < count; k += gap) if (!order.includes(k)) order.push(k);
  }
  return order.map((k) => Number((low + ((high - low) * k) / (count - 1)).toPrecision(6)));
}
