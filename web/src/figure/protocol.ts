/**
 * Messages between a figure and the page that embeds it. Both sides read them with the functions below: a message of
 * another form or version is refused.
 */

import type { Value } from "../engine/engine";

/** Version of the messages; both sides refuse another one. */
export const VERSION = 1;
/** Largest length of a text in a message, characters, and largest number of entries in a list. */
const LONGEST = 10_000;
const MOST = 10_000;

/** Message to the figure. */
export type ToFigure =
  /** First message: the figure answers only to the page that sent it. */
  | { kind: "hello" }
  | { kind: "wake" }
  | { kind: "set"; name: string; value: Value }
  | { kind: "time"; time_s: number }
  | { kind: "camera"; camera: string }
  | { kind: "play" }
  | { kind: "pause" };

/** A parameter of the scenario or an input set by hand. */
export interface Settable {
  name: string;
  label: string;
  unit: string;
  value: Value;
  /** Smallest and largest allowed value; null if there are none. */
  range: [number, number] | null;
  /** Allowed texts; null for other kinds. */
  choices: string[] | null;
}

/** Message from the figure. */
export type FromFigure =
  /** Answer to `hello`. */
  | { kind: "here" }
  /** A scenario is open. */
  | { kind: "ready"; title: string; duration_s: number; columns: string[]; settable: Settable[] }
  /** Another moment is shown, or the run has started or paused; `row` holds the values of `columns`. */
  | { kind: "state"; time_s: number; isPlaying: boolean; row: Float64Array }
  | { kind: "changed"; name: string; value: Value }
  /** Height at which everything is visible, pixels. */
  | { kind: "height"; height_px: number }
  | { kind: "error"; code: string; message: string };

type Sent<Message> = Message & { kingpost: number };

/** Puts the version into a message. */
export function sent<Message extends ToFigure | FromFigure>(message: Message): Sent<Message> {
  return { ...message, kingpost: VERSION };
}

/** Reads a message to the figure; null if it is not valid. */
export function toFigureOf(data: unknown): ToFigure | null {
  if (!isOurs(data)) return null;
  const { kind, name, value, time_s, camera } = data;
  switch (kind) {
    case "hello":
    case "wake":
    case "play":
    case "pause":
      return { kind };
    case "set":
      return isText(name) && name !== "" && isValue(value) ? { kind, name, value } : null;
    case "time":
      return isNumber(time_s) && time_s >= 0 ? { kind, time_s } : null;
    case "camera":
      return isText(camera) ? { kind, camera } : null;
    default:
      return null;
  }
}

/** Reads a message from the figure; null if it is not valid. */
export function fromFigureOf(data: unknown): FromFigure | null {
  if (!isOurs(data)) return null;
  const { kind, name, value, time_s, isPlaying, row, title, duration_s, columns, settable, height_px, code, message } = data;
  switch (kind) {
    case "here":
      return { kind };
    case "ready":
      return isText(title) && isNumber(duration_s) && isList(columns, isText) && isList(settable, isSettable) ? { kind, title, duration_s, columns, settable } : null;
    case "state":
      return isNumber(time_s) && typeof isPlaying === "boolean" && row instanceof Float64Array ? { kind, time_s, isPlaying, row } : null;
    case "changed":
      return isText(name) && isValue(value) ? { kind, name, value } : null;
    case "height":
      return isNumber(height_px) && height_px > 0 ? { kind, height_px } : null;
    case "error":
      return isText(code) && isText(message) ? { kind, code, message } : null;
    default:
      return null;
  }
}

/** Whether a message claims to be of this protocol, in this version or in another. */
export function isClaimed(data: unknown): boolean {
  return isRecord(data) && "kingpost" in data;
}

function isOurs(data: unknown): data is Record<string, unknown> {
  return isRecord(data) && data.kingpost === VERSION;
}

function isSettable(given: unknown): given is Settable {
  if (!isRecord(given)) return false;
  const { name, label, unit, value, range, choices } = given;
  const isRange = range === null || (isList(range, isNumber) && range.length === 2);
  return isText(name) && isText(label) && isText(unit) && isValue(value) && isRange && (choices === null || isList(choices, isText));
}

const isRecord = (given: unknown): given is Record<string, unknown> => typeof given === "object" && given !== null && !Array.isArray(given);
const isText = (given: unknown): given is string => typeof given === "string" && given.length <= LONGEST;
const isNumber = (given: unknown): given is number => typeof given === "number" && Number.isFinite(given);
const isValue = (given: unknown): given is Value => typeof given === "boolean" || isText(given) || isNumber(given);
const isList = <T>(given: unknown, is: (one: unknown) => one is T): given is T[] => Array.isArray(given) && given.length <= MOST && given.every(is);
