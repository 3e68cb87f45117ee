/** Weight of the newest frame in the running mean of the interval between frames. */
const NEWEST = 0.2;

/**
 * Time of the drawn picture during a run. It advances evenly with the display, one frame behind the engine, so that the
 * picture is interpolated between two poses. A scenario with steps of 50 ms then moves as smoothly as one with steps of
 * 1 ms.
 */
export class Playback {
  /** Time of the drawn picture, s. */
  private time_s = 0;
  private newest_s = 0;
  /** Rate of the drawn time over wall time. */
  private rate = 0;
  /** Wall times, s: of the newest frame, of the last picture, and the mean interval between frames. */
  private heard_s = 0;
  private drawn_s = 0;
  private gap_s = NaN;

  /** Starts at this time, for a run that starts or continues. */
  begin(time_s: number, wall_s: number): void {
    [this.time_s, this.newest_s, this.heard_s, this.drawn_s] = [time_s, time_s, wall_s, wall_s];
    [this.rate, this.gap_s] = [0, NaN];
  }

  /** Takes the time of a new frame of the engine; the drawn time reaches it when the next frame is expected. */
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
