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
    let [low, high] = [0, this.all.length];
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.all[middle].time_s <= time_s) low = middle + 1;
      else high = middle;
    }
    return low - 1;
  }

  /** Returns the items before and after a time; beyond the last item, that item twice. */
  around(time_s: number): [T, T] {
    const before = Math.max(0, this.indexAt(time_s));
    return [this.all[before], this.all[Math.min(before + 1, this.all.length - 1)]];
  }

  private thin(): void {
    const older = Math.floor((1 - UNTOUCHED) * this.all.length);
    const gap = (i: number) => this.all[i + 1].time_s - this.all[i - 1].time_s;
    const gaps: number[] = [];
    for (let i = 1; i < older; i++) if (this.mayGo(this.all[i])) gaps.push(gap(i));
    gaps.sort((a, b) => a - b);
    const widest = (gaps[Math.min(gaps.length - 1, Math.floor(CLOSEST * this.all.length))] ?? -Infinity) * (1 + 1e-9);
    let isKept = true;
    const goes = (i: number) => i > 0 && i < older && isKept && this.mayGo(this.all[i]) && gap(i) <= widest;
    // The neighbours of a dropped item are kept.
    const kept = this.all.filter((_, i) => (isKept = !goes(i)));
    // If the items that must stay are too many, the oldest are dropped.
    this.all = kept.slice(Math.max(0, kept.length - this.capacity));
  }
}
