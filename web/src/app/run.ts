import type { Change } from "../engine/changes";
import { Columns } from "../engine/columns";
import type { Channel, DrawnLine, Fault, InputInfo, JointAxis, ModelInfo } from "../engine/engine";
import type { Frame, Opened } from "../engine/messages";
import { Accuracy } from "./accuracy";
import type { Moment } from "./recording/recording";

/**
 * empty: nothing could be opened; idle: at the start; stepping: in the middle of a long Step; stopped: the run cannot go on.
 */
export type Status = "loading" | "empty" | "idle" | "stepping" | "running" | "paused" | "stopped";

/** An opened scenario, with all that follows from its channels. */
export interface Run {
  model: ModelInfo;
  lines: DrawnLine[];
  channels: Channel[];
  columns: Columns;
  /** Inputs that a hand may set: levers and set-points. */
  inputs: InputInfo[];
  jointAxes: JointAxis[];
  /** The parameter or field that switches the scenario's timeline off. */
  timelineSwitch: string;
  /** Digest of the scenario's text and of all its files. */
  digest: string;
  accuracy: Accuracy;
}

/** A scenario to hand to the engine. */
export interface Source {
  text: string;
  file: string;
  /** Texts of the files that were opened with it, by name; left out for a scenario of the gallery. */
  opened?: Record<string, string>;
  /** Its name in the gallery, if it is from there. */
  gallery?: string;
  /** Changes of a run that a link holds; a run of the link makes them again. */
  changes?: readonly Change[];
}

export interface Listener {
  /** A scenario was opened or reset. */
  opened?(run: Run, frame: Frame, isAnother: boolean): void;
  advanced?(run: Run, frame: Frame): void;
  /** Another moment is shown: a newer one, or a chosen one. */
  moved?(run: Run, moment: Moment): void;
  /** An input of the run has changed. */
  inputsChanged?(run: Run): void;
  /** The run continues from an earlier moment: everything later is gone. */
  branched?(run: Run): void;
  /** Something was set by hand during the run: its future changes. */
  steered?(): void;
  /** The run has repeated lever moves of a link. */
  followed?(run: Run): void;
  statusChanged?(status: Status): void;
  valuesChanged?(): void;
  faulted?(fault: Fault | null): void;
}

export function runOf({ model, lines, channels, inputs, joint_axes, timeline_switch, digest }: Opened): Run {
  const columns = new Columns(channels);
  return { model, lines, channels, columns, inputs, jointAxes: joint_axes, timelineSwitch: timeline_switch, digest, accuracy: new Accuracy(columns) };
}
