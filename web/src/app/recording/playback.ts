/** How much of what is known of the pace of frames a new one makes up. */
const NEWEST = 0.2;

/**
 * The time that is drawn while a run goes: it moves with the display, one frame of the engine behind the newest, so that
 * there is a pose on either side of it. A scenario with steps of 50 ms moves as smoothly as one with steps of 1 ms.
 */
export class Playback {
  /** Drawn, s. */
  private time_s = 0;
  private newest_s = 0;
  /** Rate of drawn time over wall time. */
  private rate = 0;
  /** Wall times, s: of the newest frame, of the last picture, and from frame to frame. */
  private heard_s = 0;
  private drawn_s = 0;
  private gap_s = NaN;

  /** The run goes on from here. */
  begin(time_s: number, wall_s: number): void {
    [this.time_s, this.newest_s, this.heard_s, this.drawn_s] = [time_s, time_s, wall_s, wall_s];
    [this.rate, this.gap_s] = [0, NaN];
  }

  /** A frame came; it is to be reached when the next is due. */
  hear(time_s: number, wall_s: number): void {
    const gap_s = Math.max(wall_s - this.heard_s, 1e-3);
    this.gap_s = Number.isNaN(this.gap_s) ? gap_s : this.gap_s + NEWEST * (gap_s - this.gap_s);
    this.at(wall_s);
    [this.newest_s, this.heard_s] = [time_s, wall_s];
    this.rate = (time_s - this.time_s) / this.gap_s;
  }

  /** Returns the time to draw at a wall time, s. */
  at(wall_s: number): number {
    this.time_s = Math.min(this.newest_s, this.time_s + this.rate * (wall_s - this.drawn_s));
    this.drawn_s = wall_s;
    return this.time_s;
  }
}
