/** Averaging time of the pace, s of wall time. */
const WINDOW_S = 2;
/** Share of the chosen speed below which a run counts as slow. */
const SLOW = 0.9;

/** Speed of a run: simulated time over wall time, idle time included. */
export class Pace {
  /** Wall and simulated times, s, oldest first. */
  private readonly seen: [number, number][] = [];

  /** Forgets the earlier times when a run starts, continues or changes its speed. */
  begin(): void {
    this.seen.length = 0;
  }

  see(wall_s: number, time_s: number): void {
    this.seen.push([wall_s, time_s]);
    while (this.seen.length > 2 && wall_s - this.seen[1][0] >= WINDOW_S) this.seen.shift();
  }

  /** Simulated time over wall time; NaN until there is enough data. */
  get factor(): number {
    if (this.seen.length < 2) return NaN;
    const [[fromWall, from], [wall, time]] = [this.seen[0], this.seen[this.seen.length - 1]];
    return wall - fromWall >= WINDOW_S / 2 ? (time - from) / (wall - fromWall) : NaN;
  }

  /** Whether the run is slower than the chosen speed; false if the speed is as fast as possible. */
  isSlow(asked: number): boolean {
    return Number.isFinite(asked) && this.factor < SLOW * asked;
  }
}
