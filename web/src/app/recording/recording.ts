import type { Change } from "../../engine/changes";
import type { Columns } from "../../engine/columns";
import type { Values, Warning } from "../../engine/engine";
import type { Frame, Happened, LeverMove, Snapshot } from "../../engine/messages";
import type { Surface } from "../../engine/surface";
import { between, posesBetween, shareOf, surfaceBetween } from "./between";
import { Noted } from "./noted";
import { Series } from "./series";

/** Memory limit of a recording, bytes; half an hour of a ship in waves exceeds it, and the older part is thinned. */
export const DEPTH = { rows: 48e6, pictures: 40e6, keyframes: 8e6 };
/**
 * Number of the newest pictures that are kept even if they are close together: the drawn picture is slightly older than
 * the newest.
 */
const NEWEST_PICTURES = 3;
/** Times that differ by less than this count as one, s. */
export const TIME_SLACK_S = 1e-6;
/** Approximate memory of an object in addition to its arrays, bytes. */
export const OVERHEAD = 300;

interface Picture {
  time_s: number;
  /** Poses x y z qw qx qy qz for each body, world frame. */
  poses: Float64Array;
  line_points: Float64Array;
}

interface PictureAtSea extends Picture {
  surface: Surface | null;
}

/** The data of a recording time. */
export interface Recorded extends Picture {
  row: Float64Array;
}

/** All data of one time that the page shows. */
export interface Moment extends PictureAtSea {
  /** The engine's row at this time, or at the recording time before it. */
  row: Float64Array;
}

/** State from which a run can continue, with the parameters of the run at that time. */
export interface Keyframe extends Snapshot {
  values: Values;
}

/**
 * Recording of a run: rows and poses at every recording time, the sea about as often, states from which the run can
 * continue, and events.
 */
export class Recording {
  readonly rows: Series<Recorded>;
  private readonly pictures: Series<PictureAtSea>;
  private readonly keyframes: Series<Keyframe>;
  private readonly told = { warnings: new Noted<Warning>(), events: new Noted<Happened>() };
  private made: Change[] = [];
  private merged: { from: (readonly Happened[])[]; marks: readonly Happened[] } = { from: [], marks: [] };
  /** The newest moment; its time need not be a recording time. */
  now: Moment;

  constructor(
    private readonly columns: Columns,
    private readonly interval_s: number,
    frame: Frame,
    values: Values,
  ) {
    const { row, poses, line_points, surface, keyframes } = frame;
    const pose_bytes = 8 * (poses.length + line_points.length) + OVERHEAD;
    const surface_bytes = surface ? 4 * surface.elevation_m.length + OVERHEAD : 0;
    const places = (bytes: number, each: number) => Math.max(16, Math.floor(bytes / each));
    this.rows = new Series(places(DEPTH.rows, 8 * row.length + pose_bytes));
    this.pictures = new Series(places(DEPTH.pictures, pose_bytes + surface_bytes));
    this.keyframes = new Series(places(DEPTH.keyframes, (keyframes[0]?.bytes.length ?? 0) + OVERHEAD), ({ isChange }) => !isChange);
    this.now = this.momentOf(frame);
    this.add(frame, values);
  }

  /** Adds the results of a stretch of simulation, and its parameters. */
  add(frame: Frame, values: Values): void {
    const { row, poses, line_points, surface } = frame;
    const part = (all: Float64Array, of: Float64Array, i: number) => all.slice(i * of.length, (i + 1) * of.length);
    for (let i = 0; i * row.length < frame.rows.length; i++) {
      const one = part(frame.rows, row, i);
      const picture = { poses: part(frame.row_poses, poses, i), line_points: part(frame.row_line_points, line_points, i) };
      this.rows.push({ time_s: this.timeOf(one), row: one, ...picture });
    }
    for (const keyframe of frame.keyframes) this.keyframes.push({ ...keyframe, values });
    this.told.warnings.hear(frame.warnings);
    this.told.events.hear(frame.events);
    this.now = this.momentOf(frame);
    this.keepPicture({ time_s: this.now.time_s, poses, line_points, surface: surface && inShort(surface) });
  }

  /** Keeps a picture; older pictures are at least one recording interval apart. */
  private keepPicture(picture: PictureAtSea): void {
    const { items } = this.pictures;
    const [before, one] = items.slice(-NEWEST_PICTURES - 1);
    const isFull = items.length > NEWEST_PICTURES;
    if (isFull && one.time_s - before.time_s < this.interval_s * (1 - 1e-9)) this.pictures.dropFromEnd(NEWEST_PICTURES);
    this.pictures.push(picture);
  }

  get start_s(): number {
    return this.rows.items[0].time_s;
  }

  /** Warnings of the engine. */
  get warnings(): readonly Warning[] {
    return this.told.warnings.all;
  }

  /** Events, and inputs set by hand. */
  get events(): readonly Happened[] {
    return this.told.events.all;
  }

  /** Events and warnings, in order of time. */
  get marks(): readonly Happened[] {
    const from: (readonly Happened[])[] = [this.told.warnings.all, this.told.events.all];
    // Every picture reads this list: it is rebuilt only if there is something new.
    if (from.some((list, i) => list !== this.merged.from[i])) {
      this.merged = { from, marks: from.flat().sort((a, b) => a.time_s - b.time_s) };
    }
    return this.merged.marks;
  }

  /** Returns the moment at a time: the row of the recording time at or before it; bodies and sea are interpolated. */
  at(time_s: number): Moment {
    if (time_s >= this.now.time_s) return this.now;
    const { row } = this.rows.around(time_s)[0];
    const [rows, pictures] = [this.rows.around(time_s), this.pictures.around(time_s)];
    const from: Picture = pictures[0].time_s > rows[0].time_s && pictures[0].time_s <= time_s ? pictures[0] : rows[0];
    const isNext = pictures[1].time_s > time_s && (pictures[1].time_s < rows[1].time_s || rows[1].time_s <= time_s);
    const to: Picture = isNext ? pictures[1] : rows[1];
    const share = shareOf(from, to, time_s);
    const surface = surfaceBetween(...pictures, time_s);
    if (share === 0) return { time_s, row, poses: from.poses, line_points: from.line_points, surface };
    const line_points = between(from.line_points, to.line_points, share);
    return { time_s, row, poses: posesBetween(from.poses, to.poses, share), line_points, surface };
  }

  /** Returns the recorded time nearest to a time; it may be the newest moment. */
  nearest(time_s: number): number {
    const [before, after] = this.rows.around(time_s);
    const times = [before.time_s, after.time_s, this.now.time_s];
    return times.reduce((so, one) => (Math.abs(one - time_s) < Math.abs(so - time_s) ? one : so));
  }

  /** Returns the recorded time that is a number of records later or earlier, within the recording. */
  beside(time_s: number, records: number): number {
    const { items } = this.rows;
    const before = this.rows.indexAt(time_s);
    const isBetween = before >= 0 && items[before].time_s < time_s;
    const at = before + records + (isBetween && records < 0 ? 1 : 0);
    if (at >= items.length) return this.now.time_s;
    return items[Math.max(0, at)].time_s;
  }

  /** Returns the last state at or before a time; undefined if the recording has dropped it. */
  keyframeAt(time_s: number): Keyframe | undefined {
    return this.keyframes.items[this.keyframes.indexAt(time_s)];
  }

  /** Records a lever move or a parameter that was set. */
  note(change: Change): void {
    this.made.push(change);
  }

  /** Lever moves and parameters that were set, in order. */
  get changes(): readonly Change[] {
    return this.made;
  }

  private get moves(): LeverMove[] {
    return this.made.filter((change) => "input" in change);
  }

  /** Lever moves between two times, both included. */
  movesBetween(from_s: number, to_s: number): LeverMove[] {
    return this.moves.filter(({ time_s }) => time_s >= from_s && time_s <= to_s);
  }

  /** Returns the row recorded at a time; null if there is none. */
  rowAt(time_s: number): Float64Array | null {
    const near = this.rows.around(time_s + TIME_SLACK_S)[0];
    return Math.abs(near.time_s - time_s) <= TIME_SLACK_S ? near.row : null;
  }

  /** Whether something was set by hand between two times. */
  isSteeredBetween(from_s: number, to_s: number): boolean {
    const isBetween = ({ time_s }: { time_s: number }) => time_s >= from_s && time_s < to_s;
    return this.moves.some(isBetween) || this.keyframes.items.some((one) => one.isChange && isBetween(one));
  }

  /** Drops all records after a frame from which the run continues. */
  dropAfter(frame: Frame): void {
    this.now = this.momentOf(frame);
    const { time_s } = this.now;
    for (const series of [this.rows, this.pictures, this.keyframes]) series.dropAfter(time_s);
    this.made = this.made.filter((change) => change.time_s <= time_s);
    for (const told of Object.values(this.told)) told.dropAfter(time_s);
  }

  timeOf(row: ArrayLike<number>): number {
    return this.columns.read(row, "time");
  }

  private momentOf({ row, poses, line_points, surface }: Frame): Moment {
    return { time_s: this.timeOf(row), row, poses, line_points, surface };
  }
}

/** Converts the surface to single precision, which is enough for a picture. */
function inShort(surface: Surface): Surface {
  return { ...surface, elevation_m: Float32Array.from(surface.elevation_m) };
}
