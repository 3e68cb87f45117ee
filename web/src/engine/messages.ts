import type { Change } from "./changes";
import type { Channel, DrawnLine, Equations, Fault, Hydrostatics, InputInfo, JointAxis, ModelInfo, Settings, Value, Values, Warning } from "./engine";
import type { Surface } from "./surface";

export interface OpenRequest {
  kind: "open";
  text: string;
  file: string;
  overrides: Values;
  /** Texts of the files that were opened with the scenario, by name; null for a scenario of the gallery. */
  opened: Record<string, string> | null;
  /** Changes to make at their times. */
  changes: readonly Change[];
  /** Address of the folder with the files that the gallery's scenarios name. */
  folder: string;
  /** Address of the folder with the files that this scenario names; left out for the gallery's folder. */
  beside?: string;
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
  | { kind: "resume"; keyframe: Snapshot }
  | { kind: "parameter"; name: string; value: Value };

/** An event or a lever move, in the form of a warning. */
export interface Happened {
  time_s: number;
  code: string;
  name: string;
  text: string;
}

/** A move of a lever by hand. */
export interface LeverMove {
  time_s: number;
  input: string;
  value: number;
}

/** State of the engine from which a run can continue. */
export interface Snapshot {
  time_s: number;
  bytes: Uint8Array;
  /** Whether a parameter was set just before this state: between two keyframes no parameter is set. */
  isChange: boolean;
}

/** Results of a stretch of simulation. */
export interface Frame {
  /** Rows of the recording times of the stretch, one after another, each as long as `row`. */
  rows: Float64Array;
  /** Poses and points of lines at the times of `rows`, one after another. */
  row_poses: Float64Array;
  row_line_points: Float64Array;
  /** States during the stretch, at intervals and after each parameter that was set. */
  keyframes: Snapshot[];
  /** Changes of a link that the run made before the first step of the stretch. */
  changes: Change[];
  /** The row at the end of the stretch; its time need not be a recording time. */
  row: Float64Array;
  /** Poses x y z qw qx qy qz for each body, world frame. */
  poses: Float64Array;
  /** Points of the lines, line by line: x y z, m, world frame. */
  line_points: Float64Array;
  /** Surface of the sea around the ship; null if there is no ship in a sea. */
  surface: Surface | null;
  /** Warnings from the rows so far. */
  warnings: Warning[];
  /** Events of the run so far, and inputs set by hand. */
  events: Happened[];
  /** Whether the requested recording time is not yet reached, because the time budget of a frame was used up. */
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

/** Inputs and frame of a run at the time to which it was brought back. */
export interface Restored {
  inputs: InputInfo[];
  frame: Frame;
}

/** A run as a scenario, with the values that were set and the levers that were moved by hand. */
export interface Replay {
  /** The resolved scenario in JSON. */
  scenario: string;
  /** Present time of the run, s. */
  time_s: number;
  integrator: string;
  /** Number of lever moves by hand. */
  moves: number;
  /** Parameters set during the run: the scenario has their last values from the start on. */
  parameters: { time_s: number; parameter: string }[];
  /** Number of changes that an engine made which has ended: the scenario does not hold them. */
  lost: number;
  /** Files of the scenario that are not in the gallery. */
  files: string[];
}

export interface Replies {
  open: Opened;
  /** Null if no step was due and the run has no fault. */
  advance: Frame | null;
  step: Frame;
  hydrostatics: Hydrostatics;
  equations: Equations;
  /** Time at which the input acts, s. */
  input: number;
  /** Time at which the parameter acts, s. */
  parameter: number;
  replay: Replay;
  changes: readonly Change[];
  snapshot: Uint8Array;
  restore: Restored;
  resume: Restored;
}

/** Everything that goes to the worker. */
export type ToWorker = { id: number; request: Request } | { isThere: true } | { lifeline: string };

/** An answer, a sign of life between answers, or the message that the worker holds its lifeline. */
export type FromWorker = Reply | { isAlive: true } | { holds: string };

export type Reply = { id: number; value: unknown } | { id: number; fault: Fault };
