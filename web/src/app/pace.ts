/** How long the mean is taken over, s of wall time. */
const WINDOW_S = 2;
/** Below this share of the speed that was asked for a run counts as slow. */
const SLOW = 0.9;

/** How fast a run goes: simulated over wall time, of all that passed on the wall, whatever came of it. */
export class Pace {
  /** Wall and simulated times, s, oldest first. */
  private readonly seen: [number, number][] = [];

  /** A run begins, goes on or has another speed: nothing before it counts. */
  begin(): void {
    this.seen.length = 0;
  }

  see(wall_s: number, time_s: number): void {
    this.seen.push([wall_s, time_s]);
    while (this.seen.length > 2 && wall_s - this.seen[1][0] >= WINDOW_S) this.seen.shift();
  }

  /** NaN until there is enough to say. */
  get factor(): number {
    if (this.seen.length < 2) return NaN;
    const [[fromWall, from], [wall, time]] = [this.seen[0], this.seen[this.seen.length - 1]];
    return wall - fromWall >= WINDOW_S / 2 ? (time - from) / (wall - fromWall) : NaN;
  }

  /** Where no speed is asked for, none is slow. */
  isSlow(asked: number): boolean {
    return Number.isFinite(asked) && this.factor < SLOW * asked;
  }
}
