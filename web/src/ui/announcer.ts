import { fixed } from "../app/format";
import type { Session } from "../app/session";
import { texts } from "../texts";
import { byId, setText } from "./dom";

/** Pause after the last change before an announcement, ms: many presses of Step give one announcement. */
const CALM_MS = 400;

/** Announces the state of the run to screen readers. */
export function announce(session: Session): void {
  const region = byId("announcer");
  let timer = 0;
  const soon = (): void => {
    clearTimeout(timer);
    timer = window.setTimeout(() => setText(region, wordsOf(session)), CALM_MS);
  };
  session.listen({
    opened: soon,
    statusChanged: soon,
    valuesChanged: soon,
    // For an earlier moment the time slider announces itself.
    moved: () => session.status !== "running" && !session.shown.isBack && soon(),
  });
}

/** Describes the state, without numbers that change during a run. */
function wordsOf(session: Session): string {
  const { run, status, shown } = session;
  const { moment } = shown;
  const time = run && moment ? `${fixed(run.columns.read(moment.row, "time"), 2)} s` : "";
  const say = texts.announcer;
  const words: Record<typeof status, string> = {
    ...say,
    idle: say.idle(run?.model.title ?? ""),
    paused: say.paused(time),
    stopped: say.stopped(time),
  };
  if (shown.isBack) return say.back(time, fixed(shown.recording!.now.time_s, 2));
  return `${words[status]} ${byId("hint").textContent}`.trimEnd();
}
