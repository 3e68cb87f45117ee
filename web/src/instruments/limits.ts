import type { LimitInfo } from "../engine/engine";

/**
 * ok: within the bounds; near: within the bounds, but close to one; exceeded: beyond a bound; waiting: the limit does
 * not count yet.
 */
export type LimitState = "ok" | "near" | "exceeded" | "waiting";

/**
 * Distance to a bound below which a value is near it, as a share of the bound, or of half the span between two bounds.
 */
const NEAR = 0.1;

/** Worst value of a run, nearest to a bound or farthest beyond it, in the unit of the limit, and its time. */
export interface Worst {
  time_s: number;
  value: number;
}

/** Returns the distance of a value to the nearest bound; negative beyond a bound, and for NaN. */
export function marginOf({ at_least, at_most }: LimitInfo, value: number): number {
  if (Number.isNaN(value)) return -Infinity;
  return Math.min(at_most === null ? Infinity : at_most - value, at_least === null ? Infinity : value - at_least);
}

/** Share of an allowed number of rows by which it is rounded: 1 % of 100 rows is one row. */
const ROUNDING = 1e-12;

/**
 * A limit, with the worst value up to each time of a run: the list grows only when a value is worse than all before. A limit with
 * a percentile has all values, and its worst one is that after the allowed share of them.
 */
export class LimitTrack {
  private worsts: Worst[] = [];
  /** Worst value of a limit with a percentile, at the time and the number of values for which it was sorted. */
  private sorted: { time_s: number; count: number; worst: Worst | null } | null = null;
  /** Largest magnitude of a value so far: the scale for a bound of zero. */
  private size = 0;

  /** `place` is that of the limit's column in a row, `stepPlace` that of the operation's present step, -1 without one. */
  constructor(
    readonly limit: LimitInfo,
    private readonly place: number,
    private readonly stepPlace = -1,
  ) {}

  /** Whether the limit applies to a row: by its time, and by the step of the operation. */
  appliesTo(time_s: number, row: ArrayLike<number>): boolean {
    const { from_s, until_s, steps } = this.limit;
    if (time_s < from_s || time_s > (until_s ?? Infinity)) return false;
    return steps.length === 0 || (this.stepPlace >= 0 && steps.includes(row[this.stepPlace]));
  }

  /** Returns the value in a row, in the unit of the limit. */
  valueIn(row: ArrayLike<number>): number {
    return row[this.place] / this.limit.unit_si;
  }

  /** Updates the worst value with one recorded row. */
  see(time_s: number, row: ArrayLike<number>): void {
    const value = this.valueIn(row);
    if (Math.abs(value) > this.size) this.size = Math.abs(value);
    if (!this.appliesTo(time_s, row)) return;
    const last = this.worsts.at(-1);
    if (!last || this.isOfShare || marginOf(this.limit, value) < marginOf(this.limit, last.value)) this.worsts.push({ time_s, value });
  }

  /** Drops the values after a time from which the run continues. */
  dropAfter(time_s: number): void {
    this.worsts = this.worsts.filter((worst) => worst.time_s <= time_s);
    this.sorted = null;
  }

  /** Returns the worst value since the limit applies, up to a time; null if there is none. */
  worstUntil(time_s: number): Worst | null {
    if (this.isOfShare) return this.worstOfShare(time_s);
    let at = this.worsts.length - 1;
    while (at >= 0 && this.worsts[at].time_s > time_s) at -= 1;
    return this.worsts[at] ?? null;
  }

  /** Returns the time at which a bound was first exceeded; null if none was, or if the limit has a percentile. */
  firstExceeded(): number | null {
    if (this.isOfShare) return null;
    return this.worsts.find(({ value }) => marginOf(this.limit, value) < 0)?.time_s ?? null;
  }

  state(time_s: number, row: ArrayLike<number>): LimitState {
    if (!this.appliesTo(time_s, row)) return "waiting";
    const value = (this.isOfShare ? this.worstUntil(time_s)?.value : undefined) ?? this.valueIn(row);
    const margin = marginOf(this.limit, value);
    if (margin < 0) return "exceeded";
    return margin < NEAR * this.scale() ? "near" : "ok";
  }

  /** Returns the distance of the value in a row to the nearest bound as a share of the scale; negative beyond a bound. */
  roomIn(row: ArrayLike<number>): number {
    return marginOf(this.limit, this.valueIn(row)) / this.scale();
  }

  /** Returns the bound that is nearest to a value. */
  boundNear(value: number): number {
    const { at_least, at_most } = this.limit;
    if (at_most === null || at_least === null) return at_most ?? at_least ?? NaN;
    return at_most - value < value - at_least ? at_most : at_least;
  }

  /** Returns the ends of a bar that shows the bounds and all values so far. */
  range(): [number, number] {
    const { at_least, at_most } = this.limit;
    const room = 0.25 * this.scale();
    const low = at_least === null ? Math.min(0, ...this.seen()) : Math.min(at_least - room, ...this.seen());
    const high = at_most === null ? Math.max(low + 3 * this.scale(), ...this.seen()) : Math.max(at_most + room, ...this.seen());
    return [low, high];
  }

  /** Whether a share of the rows may be beyond a bound. */
  private get isOfShare(): boolean {
    return this.limit.percentile < 100;
  }

  /** The worst value is asked for several times in a picture, and sorted once. */
  private worstOfShare(time_s: number): Worst | null {
    const { sorted, worsts } = this;
    if (sorted?.time_s === time_s && sorted.count === worsts.length) return sorted.worst;
    const seen = worsts.filter((one) => one.time_s <= time_s);
    const allowed = Math.floor((1 - this.limit.percentile / 100) * seen.length * (1 + ROUNDING));
    const byMargin = seen.sort((a, b) => marginOf(this.limit, a.value) - marginOf(this.limit, b.value));
    const worst = byMargin[Math.min(allowed, seen.length - 1)] ?? null;
    this.sorted = { time_s, count: worsts.length, worst };
    return worst;
  }

  private seen(): number[] {
    return this.worsts.slice(-1).map(({ value }) => value).filter(Number.isFinite);
  }

  /** Returns the scale of a margin: half the span, or the bound; if the bound is zero, the largest value so far. */
  private scale(): number {
    const { at_least, at_most } = this.limit;
    if (at_least !== null && at_most !== null) return (at_most - at_least) / 2;
    return Math.abs(at_most ?? at_least ?? 0) || this.size || 1;
  }
}

/** Returns the worst of several states. */
export function gravest(states: readonly LimitState[]): LimitState {
  const order: LimitState[] = ["exceeded", "near", "ok"];
  return order.find((state) => states.includes(state)) ?? "waiting";
}
