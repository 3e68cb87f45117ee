import type { Change } from "../engine/changes";
import type { Value, Values } from "../engine/engine";

/** Moment of a run, with a digest of its row of results. */
export interface SharedMoment {
  time_s: number;
  digest: string;
}

/** A scenario by its name in the gallery with a digest of its files, or by its texts. */
export type SharedScenario = { gallery: string; digest: string } | { file: string; text: string; opened: Record<string, string> };

/** Content of a link: the initial values of a run, its changes with their times, and the moment that was shown. */
export interface SharedRun {
  scenario: SharedScenario;
  values: Values;
  changes: readonly Change[];
  moment: SharedMoment | null;
}

/** Checks the content of a link, which anyone can write; null if it is not valid. */
export function sharedRunOf(given: unknown): SharedRun | null {
  if (!isRecord(given)) return null;
  const { scenario, values, changes, moment } = given;
  const isWhole = isScenario(scenario) && isRecordOf(values, isValue) && isList(changes, isChange) && (moment === null || isMoment(moment));
  return isWhole && isInOrder(changes) ? { scenario, values, changes, moment } : null;
}

function isScenario(given: unknown): given is SharedScenario {
  if (!isRecord(given)) return false;
  if ("gallery" in given) return isText(given.gallery) && isText(given.digest);
  return isText(given.file) && isText(given.text) && isRecordOf(given.opened, isText);
}

function isChange(given: unknown): given is Change {
  if (!isRecord(given) || !isTime(given.time_s)) return false;
  if ("input" in given) return isText(given.input) && isNumber(given.value);
  return isText(given.parameter) && isValue(given.value);
}

function isMoment(given: unknown): given is SharedMoment {
  return isRecord(given) && isTime(given.time_s) && isText(given.digest);
}

function isInOrder(changes: readonly Change[]): boolean {
  return changes.every(({ time_s }, i) => i === 0 || changes[i - 1].time_s <= time_s);
}

const isText = (given: unknown): given is string => typeof given === "string";
const isNumber = (given: unknown): given is number => Number.isFinite(given);
const isTime = (given: unknown): given is number => isNumber(given) && given >= 0;
const isValue = (given: unknown): given is Value => typeof given === "boolean" || isText(given) || isNumber(given);
const isRecord = (given: unknown): given is Record<string, unknown> => typeof given === "object" && given !== null && !Array.isArray(given);
const isRecordOf = <T>(given: unknown, is: (one: unknown) => one is T): given is Record<string, T> => isRecord(given) && Object.values(given).every(is);
const isList = <T>(given: unknown, is: (one: unknown) => one is T): given is T[] => Array.isArray(given) && given.every(is);
