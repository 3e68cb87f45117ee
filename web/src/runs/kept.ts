import { posesBetween } from "../app/recording/between";
import type { Recorded, Recording } from "../app/recording/recording";
import { TIME_SLACK_S } from "../app/recording/recording";
import { indexAt } from "../app/recording/series";
import type { Run } from "../app/run";
import { linesOf } from "../plots/lines";
import type { Line } from "../plots/lines";

/** Description of a run that outlives it: its model without the meshes of hulls, and its columns. */
export interface Facts extends Pick<Run, "model" | "channels" | "columns"> {
  /** Stem of the names of its files. */
  stem: string;
  /** Lines that plots have asked for, by their ids. */
  lines: Map<string, Line | undefined>;
  /** Approximate memory, bytes. */
  bytes: number;
}

/** Colours of the theme for kept runs; the first ones are seldom those of lines of the present run. */
export const RUN_COLOURS = ["line-5", "line-7", "line-6", "line-4", "line-8", "roll", "pitch", "yaw"];

/** A run that is kept: its recorded rows, which it may share with other runs, and how the page shows it. */
export class KeptRun {
  rows: readonly Recorded[];
  readonly events: Recording["events"];
  isShown = true;
  private readonly matched = new WeakMap<Run["model"], number[]>();

  constructor(
    /** Letter that stands for the run in plots. */
    readonly mark: string,
    public name: string,
    public colour: string,
    readonly facts: Facts,
    recording: Pick<Recording, "rows" | "events">,
  ) {
    this.rows = [...recording.rows.items];
    this.events = recording.events;
  }

  get start_s(): number {
    return this.rows[0].time_s;
  }

  get end_s(): number {
    return this.rows[this.rows.length - 1].time_s;
  }

  /** Returns the line of the run with this id; undefined if the run has no such column. */
  line(id: string): Line | undefined {
    const { channels, lines, model } = this.facts;
    if (!lines.has(id)) lines.set(id, linesOf(model, channels).find((line) => line.id === id));
    return lines.get(id);
  }

  /** Whether the run has a body of a model, with its name and shape. */
  hasBodyOf(model: Run["model"]): boolean {
    return this.bodiesOf(model).some((place) => place >= 0);
  }

  /** Returns the places in this run of the bodies of a model; -1 for a body that is another here. */
  private bodiesOf(model: Run["model"]): number[] {
    // Every picture with a ghost asks for them.
    const known = this.matched.get(model);
    if (known) return known;
    const shapeOf = ({ shape }: Run["model"]["bodies"][number]) => JSON.stringify(shape);
    const own = this.facts.model.bodies;
    const places = model.bodies.map((body) => own.findIndex((one) => one.name === body.name && shapeOf(one) === shapeOf(body)));
    this.matched.set(model, places);
    return places;
  }

  /**
   * Returns the rows before and after a time, and the share of the second; a time that is recorded gives its row twice.
   * Null outside the recorded time.
   */
  around(time_s: number): { from: Recorded; to: Recorded; share: number } | null {
    const at = indexAt(this.rows, time_s + TIME_SLACK_S);
    const from = this.rows[at];
    if (!from || time_s > this.end_s + TIME_SLACK_S) return null;
    const to = this.rows[at + 1];
    if (!to || time_s - from.time_s <= TIME_SLACK_S) return { from, to: from, share: 0 };
    return { from, to, share: (time_s - from.time_s) / (to.time_s - from.time_s) };
  }

  /** Returns the poses of the bodies of a model at a time, NaN for those that are others; null outside the recorded time. */
  posesAt(time_s: number, model: Run["model"]): Float64Array | null {
    const found = this.around(time_s);
    if (!found) return null;
    const { from, to, share } = found;
    const poses = share === 0 ? from.poses : posesBetween(from.poses, to.poses, share);
    const own = this.bodiesOf(model);
    return Float64Array.from({ length: 7 * own.length }, (_, i) => poses[7 * own[Math.floor(i / 7)] + (i % 7)] ?? NaN);
  }
}
