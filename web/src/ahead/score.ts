import type { ModelInfo } from "../engine/engine";
import type { Columns } from "../engine/columns";
import { LEVELS } from "./quantiles";
import type { Outlook } from "./outlook";

/** How much of what came to pass an outlook's widest band held. */
export interface Score {
  held: number;
  of: number;
}

/** Minutes of the recording by which futures are judged, at most. */
const MOST_MINUTES = 6;
const MINUTE_S = 60;

/** How outlooks of each whole minute of the recording did: each is made once. */
export class TrackRecord {
  private readonly minutes = new Map<number, Score | null>();

  /** Starts of the whole minutes before a time that have not been judged, s, the newest first. */
  due(now_s: number): number[] {
    const whole = Math.floor(now_s / MINUTE_S + 1e-9);
    const newest = Array.from({ length: Math.min(MOST_MINUTES, whole) }, (_, back) => (whole - 1 - back) * MINUTE_S);
    return newest.filter((start_s) => !this.minutes.has(start_s));
  }

  /** Null where a minute cannot be judged. */
  add(start_s: number, score: Score | null): void {
    this.minutes.set(start_s, score);
  }

  /** What came after is no more. */
  dropAfter(time_s: number): void {
    for (const start_s of this.minutes.keys()) if (start_s + MINUTE_S > time_s + 1e-9) this.minutes.delete(start_s);
  }

  /** Of the newest minutes together. */
  get newest(): Score & { minutes: number } {
    const judged = [...this.minutes].sort(([a], [b]) => b - a).flatMap(([, score]) => (score ? [score] : []));
    const counted = judged.slice(0, MOST_MINUTES);
    const sum = (of: keyof Score) => counted.reduce((total, score) => total + score[of], 0);
    return { held: sum("held"), of: sum("of"), minutes: counted.length };
  }
}

type Model = Pick<ModelInfo, "bodies" | "joints">;

/** Bodies that carry no other and are free in their joints: what hangs at the end of a crane. */
export function loads({ bodies, joints }: Model): number[] {
  const carriers = new Set(bodies.map(({ parent }) => parent));
  const isFree = (name: string) => joints.some(({ body, free_coordinates }) => body === name && free_coordinates.length > 0);
  return bodies.flatMap(({ name, floats }, i) => (floats || carriers.has(name) || !isFree(name) ? [] : [i]));
}

/** The columns of the place of a body. */
export function placeOf({ bodies }: Model, body: number, columns: Columns): number[] {
  return ["x", "y", "z"].map((axis) => columns.at(`${bodies[body].name}.position.${axis}`));
}

/** Columns by which outlooks are judged: heave, roll and pitch of what floats, and the places of its loads. */
export function judgedColumns(model: Model, columns: Columns): number[] {
  const afloat = model.bodies.filter(({ floats }) => floats).flatMap(({ name }) => [`${name}.position.z`, `${name}.roll`, `${name}.pitch`]);
  const hanging = loads(model).flatMap((body) => placeOf(model, body, columns));
  return [...afloat.map((name) => columns.at(name)), ...hanging].filter((place) => place >= 0);
}

/**
 * Of the values that came to pass after its start those within the band from 5 to 95 %. `rowAt` gives the row of a time,
 * where one was recorded.
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
      // The fan has half the digits.
      const value = Math.fround(row[place]);
      if (value >= low[k] && value <= high[k]) score.held += 1;
    });
  }
  return score;
}
