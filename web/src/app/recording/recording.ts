import type { Columns } from "../../engine/columns";
import type { Values, Warning } from "../../engine/engine";
import type { Frame, LeverMove, Snapshot } from "../../engine/messages";
import type { Surface } from "../../engine/surface";
import { between, posesBetween } from "./between";
import { Noted } from "./noted";
import { Series } from "./series";

/** What a recording may take, bytes; a ship in waves over half an hour has more, and its older part is thinned. */
export const DEPTH = { rows: 48e6, pictures: 40e6, keyframes: 8e6 };
/** Pictures that are kept however close they are: the one that is drawn lags behind the newest. */
const NEWEST_PICTURES = 3;
/** Times that are closer are one, s. */
const TIME_SLACK_S = 1e-6;
/** Of an object beside its numbers, bytes, about. */
const OVERHEAD = 300;

interface Picture {
  time_s: number;
  /** Per body x y z qw qx qy qz, world frame. */
  poses: Float64Array;
  line_points: Float64Array;
}

interface PictureAtSea extends Picture {
  surface: Surface | null;
}

/** What is recorded at a recording time. */
export interface Recorded extends Picture {
  row: Float64Array;
}

/** All that the page shows of one time. */
export interface Moment extends PictureAtSea {
  /** The engine's own, of this time or of the recording time before it. */
  row: Float64Array;
}

/** A state to go on from, with the parameters that the run had there. */
export interface Keyframe extends Snapshot {
  values: Values;
}

/** A run as it was: rows and poses of every recording time, the sea about as often, states to go on from, and what happened. */
export class Recording {
  readonly rows: Series<Recorded>;
  private readonly pictures: Series<PictureAtSea>;
  private readonly keyframes: Series<Keyframe>;
  private readonly told = { warnings: new Noted(), events: new Noted() };
  private moves: LeverMove[] = [];
  private merged: { from: (readonly Warning[])[]; marks: readonly Warning[] } = { from: [], marks: [] };
  /** The newest, on a recording time or not. */
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

  /** What a stretch of simulation produced, and the parameters that it had. */
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

  /** Older pictures lie a recorded interval apart at least. */
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

  /** What the engine warned of. */
  get warnings(): readonly Warning[] {
    return this.told.warnings.all;
  }

  /** What happened, and what a hand set. */
  get events(): readonly Warning[] {
    return this.told.events.all;
  }

  /** What happened, warnings among it, in order of time. */
  get marks(): readonly Warning[] {
    const from = [this.told.warnings.all, this.told.events.all];
    // Asked for with every picture: put together where there is something new.
    if (from.some((list, i) => list !== this.merged.from[i])) {
      this.merged = { from, marks: from.flat().sort((a, b) => a.time_s - b.time_s) };
    }
    return this.merged.marks;
  }

  /** The moment at a time: the row is that of the recording time at or before it, bodies and sea are in between. */
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

  /** The recorded time that is nearest, or now. */
  nearest(time_s: number): number {
    const [before, after] = this.rows.around(time_s);
    const times = [before.time_s, after.time_s, this.now.time_s];
    return times.reduce((so, one) => (Math.abs(one - time_s) < Math.abs(so - time_s) ? one : so));
  }

  /** The recorded time so many records on or back, as far as there are any. */
  beside(time_s: number, records: number): number {
    const { items } = this.rows;
    const before = this.rows.indexAt(time_s);
    const isBetween = before >= 0 && items[before].time_s < time_s;
    const at = before + records + (isBetween && records < 0 ? 1 : 0);
    if (at >= items.length) return this.now.time_s;
    return items[Math.max(0, at)].time_s;
  }

  /** The last state at or before a time; undefined where the recording has lost it. */
  keyframeAt(time_s: number): Keyframe | undefined {
    return this.keyframes.items[this.keyframes.indexAt(time_s)];
  }

  /** A hand set a lever. */
  noteMove(move: LeverMove): void {
    this.moves.push(move);
  }

  /** Moves of levers from a time to another, those at both among them. */
  movesBetween(from_s: number, to_s: number): LeverMove[] {
    return this.moves.filter(({ time_s }) => time_s >= from_s && time_s <= to_s);
  }

  /** What was recorded at a time; null where nothing was. */
  rowAt(time_s: number): Float64Array | null {
    const near = this.rows.around(time_s + TIME_SLACK_S)[0];
    return Math.abs(near.time_s - time_s) <= TIME_SLACK_S ? near.row : null;
  }

  /** Whether a hand set something between two times. */
  isSteeredBetween(from_s: number, to_s: number): boolean {
    const isBetween = ({ time_s }: { time_s: number }) => time_s >= from_s && time_s < to_s;
    return this.moves.some(isBetween) || this.keyframes.items.some((one) => one.isChange && isBetween(one));
  }

  /** The run goes on from here: what came after is forgotten. */
  dropAfter(frame: Frame): void {
    this.now = this.momentOf(frame);
    const { time_s } = this.now;
    for (const series of [this.rows, this.pictures, this.keyframes]) series.dropAfter(time_s);
    this.moves = this.moves.filter((move) => move.time_s <= time_s);
    for (const told of Object.values(this.told)) told.dropAfter(time_s);
  }

  timeOf(row: ArrayLike<number>): number {
    return this.columns.read(row, "time");
  }

  private momentOf({ row, poses, line_points, surface }: Frame): Moment {
    return { time_s: this.timeOf(row), row, poses, line_points, surface };
  }
}

/** For a picture, half the digits do. */
function inShort({ x_m, y_m, elevation_m }: Surface): Surface {
  return { x_m, y_m, elevation_m: Float32Array.from(elevation_m) };
}

function shareOf(from: { time_s: number }, to: { time_s: number }, time_s: number): number {
  const length_s = to.time_s - from.time_s;
  return length_s > 0 ? Math.min(1, Math.max(0, (time_s - from.time_s) / length_s)) : 0;
}

/** The lines go along with the ship in steps: between two grids there is nothing, and the first stands. */
function surfaceBetween(from: PictureAtSea, to: PictureAtSea, time_s: number): Surface | null {
  const share = shareOf(from, to, time_s);
  const [a, b] = [from.surface, to.surface];
  if (!a || !b || share === 0 || a.x_m[0] !== b.x_m[0] || a.y_m[0] !== b.y_m[0]) return a;
  const elevation_m = new Float32Array(a.elevation_m.length);
  for (let i = 0; i < elevation_m.length; i++) elevation_m[i] = a.elevation_m[i] + share * (b.elevation_m[i] - a.elevation_m[i]);
  return { ...a, elevation_m };
}
