import type { Run, Source } from "../app/run";
import type { Session } from "../app/session";
import type { Change } from "../engine/changes";
import { digestOf } from "../engine/digest";
import type { Moment } from "../app/recording/recording";
import type { SharedMoment, SharedRun, SharedScenario } from "./shared_run";

/**
 * Pauses the present run and returns it as the content of a link, at the moment that is shown. Null if no scenario is
 * open.
 */
export async function sharedRun(session: Session): Promise<SharedRun | null> {
  session.pause();
  const changes = await session.changes();
  const { run, source, shown, values } = session;
  const { moment } = shown;
  if (!run || !source || !moment) return null;
  return { scenario: scenarioOf(source, run), values: values.begun, changes: changes.filter(isBy(moment)), moment: momentOf(moment) };
}

/** Returns a test for changes that a link contains: those up to the moment that is shown. */
function isBy(moment: Moment): (change: Change) => boolean {
  return ({ time_s }) => time_s <= moment.time_s;
}

/**
 * Returns the scenario for a link: a scenario of the gallery by its name, because every copy of the app has its text.
 */
function scenarioOf({ gallery, file, text, opened }: Source, { digest }: Run): SharedScenario {
  return gallery === undefined ? { file, text, opened: opened ?? {} } : { gallery, digest };
}

function momentOf({ time_s, row }: Moment): SharedMoment | null {
  return time_s > 0 ? { time_s, digest: digestOf(row) } : null;
}

/**
 * Whether the present run has, at the link's moment, the same numbers as the link; null at any other moment, or if the
 * values or changes differ from those of the link.
 */
export async function isSame(session: Session, link: SharedRun): Promise<boolean | null> {
  const { moment } = session.shown;
  if (!moment || moment.time_s !== link.moment?.time_s) return null;
  const made = await session.changes();
  const isBefore = (change: Change) => change.time_s < moment.time_s;
  const [here, there] = [{ values: session.values.begun, changes: made }, link].map(({ values, changes }) => JSON.stringify([values, changes.filter(isBefore)]));
  return here === there ? digestOf(moment.row) === link.moment.digest : null;
}
