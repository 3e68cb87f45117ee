import type { ModelInfo } from "../engine/engine";
import type { Columns } from "../engine/columns";
import { LEVELS } from "./quantiles";
import type { Outlook } from "./outlook";

/** Number of recorded values inside the widest band of a forecast, and number of all compared values. */
export interface Score {
  held: number;
  of: number;
}

/** Largest number of minutes of the recording by which the forecast is judged. */
const MOST_MINUTES = 6;
const MINUTE_S = 60;

/** Scores of the forecasts of each whole minute of the recording; each is computed once. */
export class TrackRecord {
  private readonly minutes = new Map<number, Score | null>();

  /** Returns the start times of whole minutes before a time that are not yet judged, s, the newest first. */
  due(now_s: number): number[] {
    const whole = Math.floor(now_s / MINUTE_S + 1e-9);
    const newest = Array.from({ length: Math.min(MOST_MINUTES, whole) }, (_, back) => (whole - 1 - back) * MINUTE_S);
    return newest.filter((start_s) => !this.minutes.has(start_s));
  }

  /** Adds the score of a minute; null if the minute cannot be judged. */
  add(start_s: number, score: Score | null): void {
    this.minutes.set(start_s, score);
  }

  /** Drops the scores of minutes that end after a time. */
  dropAfter(time_s: number): void {
    for (const start_s of this.minutes.keys()) if (start_s + MINUTE_S > time_s + 1e-9) this.minutes.delete(start_s);
  }

  /** Sum of the scores of the newest minutes. */
  get newest(): Score & { minutes: number } {
    const judged = [...this.minutes].sort(([a], [b]) => b - a).flatMap(([, score]) => (score ? [score] : []));
    const counted = judged.slice(0, MOST_MINUTES);
    const sum = (of: keyof Score) => counted.reduce((total, score) => total + score[of], 0);
    return { held: sum("held"), of: sum("of"), minutes: counted.length };
  }
}

type Model = Pick<ModelInfo, "bodies" | "joints">;

/** Returns the bodies that carry no other body and are free in their joints, such as a load on a crane. */
export function loads({ bodies, joints }: Model): number[] {
  const carriers = new Set(bodies.map(({ parent }) => parent));
  const isFree = (name: string) => joints.some(({ body, free_coordinates }) => body === name && free_coordinates.length > 0);
  return bodies.flatMap(({ name, floats }, i) => (floats || carriers.has(name) || !isFree(name) ? [] : [i]));
}

/** Returns the columns of a body's position. */
export function placeOf({ bodies }: Model, body: number, columns: Columns): number[] {
  return ["x", "y", "z"].map((axis) => columns.at(`${bodies[body].name}.position.${axis}`));
}

/**
 * Returns the columns by which forecasts are judged: heave, roll and pitch of floating bodies, and positions of loads.
 */
export function judgedColumns(model: Model, columns: Columns): number[] {
  const afloat = model.bodies.filter(({ floats }) => floats).flatMap(({ name }) => [`${name}.position.z`, `${name}.roll`, `${name}.pitch`]);
  const hanging = loads(model).flatMap((body) => placeOf(model, body, columns));
  return [...afloat.map((name) => columns.at(name)), ...hanging].filter((place) => place >= 0);
}

/**
 * Counts the recorded values after the start of a forecast that lie in its band from 5 to 95 %. `rowAt` returns the row
 * recorded at a time, or null.
 */
export function scoreOf(outlook: Outlook, places: readonly number[], rowAt: (time_s: number) => ArrayLike<number> | null): Score {
  const score = { held: 0, of: 0 };
  const rows = Array.from({ length: outlook.length }, (_, k) => (k > 0 ? rowAt(outlook.timeAt(k)) : null));
  for (const place of places) {
    const fan = outlook.fan([place]);
    const [low, high] = [fan[0], fan[LEVELS.length - 1]];
    rows.forEach((row, k) => {
      if (!row) return;
      score.of += 1;
      // The values of the fan have single precision.
      const value = Math.fround(row[place]);
      if (value >= low[k] && value <= high[k]) score.held += 1;
    });
  }
  return score;
}
