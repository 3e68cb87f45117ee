/** Share of the items that is never thinned: the newest ones. */
const UNTOUCHED = 1 / 4;
/** Share of the items that is considered for thinning: those with the closest neighbours. Half of them are dropped. */
const CLOSEST = 1 / 4;

/**
 * Items in order of time, at most `capacity`. When that number is exceeded, every second one of the items that are
 * closest together is dropped; the first item and the newest quarter stay. A long run is thus kept from start to end,
 * and its older part is coarser.
 */
export class Series<T extends { time_s: number }> {
  private all: T[] = [];

  constructor(
    readonly capacity: number,
    private readonly mayGo: (item: T) => boolean = () => true,
  ) {}

  get items(): readonly T[] {
    return this.all;
  }

  get last(): T | undefined {
    return this.all.at(-1);
  }

  push(item: T): void {
    this.all.push(item);
    if (this.all.length > this.capacity) this.thin();
  }

  /** Removes one item, counted from the end. */
  dropFromEnd(place: number): void {
    this.all.splice(this.all.length - place, 1);
  }

  dropAfter(time_s: number): void {
    this.all.length = this.indexAt(time_s) + 1;
  }

  /** Index of the last item at or before a time; -1 if there is none. */
  indexAt(time_s: number): number {
    return indexAt(this.all, time_s);
  }

  /** Returns the items before and after a time; beyond the last item, that item twice. */
  around(time_s: number): [T, T] {
    const before = Math.max(0, this.indexAt(time_s));
    return [this.all[before], this.all[Math.min(before + 1, this.all.length - 1)]];
  }

  private thin(): void {
    const kept = withoutClosest(this.all, Math.floor((1 - UNTOUCHED) * this.all.length), CLOSEST, this.mayGo);
    // If the items that must stay are too many, the oldest are dropped.
    this.all = kept.slice(Math.max(0, kept.length - this.capacity));
  }
}

/** Returns the index of the last item at or before a time; -1 if there is none. */
export function indexAt(items: readonly { time_s: number }[], time_s: number): number {
  let [low, high] = [0, items.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (items[middle].time_s <= time_s) low = middle + 1;
    else high = middle;
  }
  return low - 1;
}

/**
 * Returns items without every second one of those before place `older` that are closest together, which are a `share`
 * of all; the first item stays.
 */
export function withoutClosest<T extends { time_s: number }>(items: readonly T[], older: number, share: number, mayGo: (item: T) => boolean = () => true): T[] {
  const gap = (i: number) => items[i + 1].time_s - items[i - 1].time_s;
  const gaps: number[] = [];
  for (let i = 1; i < older; i++) if (mayGo(items[i])) gaps.push(gap(i));
  gaps.sort((a, b) => a - b);
  const widest = (gaps[Math.min(gaps.length - 1, Math.floor(share * items.length))] ?? -Infinity) * (1 + 1e-9);
  let isKept = true;
  const goes = (i: number) => i > 0 && i < older && isKept && mayGo(items[i]) && gap(i) <= widest;
  // The neighbours of a dropped item are kept.
  return items.filter((_, i) => (isKept = !goes(i)));
}
