import type { Change } from "./changes";
import type { Channel, DrawnLine, Equations, Fault, Hydrostatics, InputInfo, JointAxis, ModelInfo, Settings, Value, Values, Warning } from "./engine";
import type { Surface } from "./surface";

export interface OpenRequest {
  kind: "open";
  text: string;
  file: string;
  overrides: Values;
  /** Texts of the files that were opened with it, by name; null for a scenario of the gallery. */
  opened: Record<string, string> | null;
  /** To be made at their times. */
  changes: readonly Change[];
  /** Address of the folder with the files that the gallery's scenarios name. */
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

/** A lever that was set by hand. */
export interface LeverMove {
  time_s: number;
  input: string;
  value: number;
}

/** A state of the engine to continue from. */
export interface Snapshot {
  time_s: number;
  bytes: Uint8Array;
  /** Whether a parameter was set just before: none is set between two keyframes. */
  isChange: boolean;
}

/** The results of a stretch of simulation. */
export interface Frame {
  /** One row for each recording time of the stretch, one after another, each as wide as `row`. */
  rows: Float64Array;
  /** Poses and points of lines at the same times, one after another. */
  row_poses: Float64Array;
  row_line_points: Float64Array;
  /** States on the way, from time to time and after each set parameter. */
  keyframes: Snapshot[];
  /** Changes from a link that were made before the first of them. */
  changes: Change[];
  /** The row now, on a recording time or not. */
  row: Float64Array;
  /** Per body x y z qw qx qy qz, world frame. */
  poses: Float64Array;
  /** The points of the lines, one line's after another's: x y z, metres, world frame. */
  line_points: Float64Array;
  /** The sea around, where a hull is in it. */
  surface: Surface | null;
  /** Warnings from the rows so far. */
  warnings: Warning[];
  /** Events of the run so far, and inputs set by hand. */
  events: Warning[];
  /** Whether the requested recording time is not reached yet: one frame did not have enough time. */
  isPart: boolean;
  /** The reason why the run cannot go on. */
  fault: Fault | null;
}

export interface Opened {
  model: ModelInfo;
  lines: DrawnLine[];
  settings: Settings;
  channels: Channel[];
  inputs: InputInfo[];
  joint_axes: JointAxis[];
  /** The parameter or field that switches the scenario's timeline off. */
  timeline_switch: string;
  /** Digest of the scenario's text and of all its files. */
  digest: string;
  frame: Frame;
}

/** The run at the time to which it was brought back. */
export interface Restored {
  inputs: InputInfo[];
  frame: Frame;
}

/** A run as a scenario, with values set and levers moved by hand. */
export interface Replay {
  /** Resolved, as JSON, for a run of its own. */
  scenario: string;
  /** Present time of the run. */
  time_s: number;
  integrator: string;
  /** Number of lever moves by hand. */
  moves: number;
  /** Parameters set during the run: the scenario has their last values from the start. */
  parameters: { time_s: number; parameter: string }[];
  /** Its files that are not in the gallery. */
  files: string[];
}

export interface Replies {
  open: Opened;
  /** Null if no step was due and the run has no fault. */
  advance: Frame | null;
  step: Frame;
  hydrostatics: Hydrostatics;
  equations: Equations;
  /** Time at which it acts, s. */
  input: number;
  parameter: null;
  replay: Replay;
  changes: readonly Change[];
  snapshot: Uint8Array;
  restore: Restored;
}

/** Everything that goes to the worker. */
export type ToWorker = { id: number; request: Request } | { isThere: true };

/** A sign of life between the answers. */
export type FromWorker = Reply | { isAlive: true };

export type Reply = { id: number; value: unknown } | { id: number; fault: Fault };
