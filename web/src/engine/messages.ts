import type { Change } from "./changes";
import type { Channel, DrawnLine, Equations, Fault, Hydrostatics, InputInfo, JointAxis, ModelInfo, Settings, Value, Values, Warning } from "./engine";
import type { Surface } from "./surface";

export interface OpenRequest {
  kind: "open";
  text: string;
  file: string;
  overrides: Values;
  /** Texts of the files that were opened with it, by their names; null for a scenario of the gallery. */
  opened: Record<string, string> | null;
  /** To be made at their times. */
  changes: readonly Change[];
  /** Address of the folder that has the files that the gallery's scenarios name. */
  folder: string;
}

export type Request =
  | OpenRequest
  | { kind: "advance"; wall_s: number; speed: number; until_s: number }
  | { kind: "step" }
  | { kind: "hydrostatics"; without: readonly string[] | null }
  | { kind: "equations" }
  | { kind: "input"; name: string; value: number }
  | { kind: "replay" }
  | { kind: "changes" }
  | { kind: "snapshot" }
  | { kind: "restore"; snapshot: Uint8Array; moves: LeverMove[] }
  | { kind: "parameter"; name: string; value: Value };

/** A lever that a hand set. */
export interface LeverMove {
  time_s: number;
  input: string;
  value: number;
}

/** A state of the engine to go on from. */
export interface Snapshot {
  time_s: number;
  bytes: Uint8Array;
  /** Whether a parameter was set just before: none is set between one of these and the next. */
  isChange: boolean;
}

/** What a stretch of simulation produced. */
export interface Frame {
  /** Rows at the recording times passed, one after another, each as wide as `row`. */
  rows: Float64Array;
  /** Poses and points of lines at the same times, one after another. */
  row_poses: Float64Array;
  row_line_points: Float64Array;
  /** States passed, now and then and wherever a parameter was set. */
  keyframes: Snapshot[];
  /** What was set again before the first of them, as a link says. */
  changes: Change[];
  /** The row now, on a recording time or not. */
  row: Float64Array;
  /** Per body x y z qw qx qy qz, world frame. */
  poses: Float64Array;
  /** The points of the lines, one line's after another's: x y z, metres, world frame. */
  line_points: Float64Array;
  /** The sea around, where a hull is in it. */
  surface: Surface | null;
  /** What a person should know of the rows so far. */
  warnings: Warning[];
  /** What happened in the run so far, and what a hand set. */
  events: Warning[];
  /** Whether the recording time that was asked for lies further on: there is more to compute than one frame has time for. */
  isPart: boolean;
  /** Why the run cannot go on. */
  fault: Fault | null;
}

export interface Opened {
  model: ModelInfo;
  lines: DrawnLine[];
  settings: Settings;
  channels: Channel[];
  inputs: InputInfo[];
  joint_axes: JointAxis[];
  /** What is set to switch the scenario's timeline off. */
  timeline_switch: string;
  /** Of the scenario's text and of all files that it stands on. */
  digest: string;
  frame: Frame;
}

/** The run as it stands where it was brought back to. */
export interface Restored {
  inputs: InputInfo[];
  frame: Frame;
}

/** A run as a scenario: what was set and driven by hand in it. */
export interface Replay {
  /** Resolved, as JSON, for a run of its own. */
  scenario: string;
  /** How far the run is. */
  time_s: number;
  integrator: string;
  /** How often a hand set a lever. */
  moves: number;
  /** Set under way: the scenario has their last values from the start. */
  parameters: { time_s: number; parameter: string }[];
  /** Files that it names beside those of the gallery. */
  files: string[];
}

export interface Replies {
  open: Opened;
  /** Null where no step was due: nothing is other than it was. */
  advance: Frame | null;
  step: Frame;
  hydrostatics: Hydrostatics;
  equations: Equations;
  /** When it acts, s. */
  input: number;
  parameter: null;
  replay: Replay;
  changes: readonly Change[];
  snapshot: Uint8Array;
  restore: Restored;
}

/** Everything that goes to the worker. */
export type ToWorker = { id: number; request: Request } | { isThere: true };

/** A sign of life beside the answers. */
export type FromWorker = Reply | { isAlive: true };

export type Reply = { id: number; value: unknown } | { id: number; fault: Fault };
