import type { Moment } from "../app/recording/recording";
import type { Run, Session } from "../app/session";
import type { TaskInfo } from "../engine/engine";
import type { Happened } from "../engine/messages";
import { texts } from "../texts";
import { byId, make, setText } from "../ui/dom";
import type { LimitTrack } from "./limits";

/** The element of the task in the table of events, its column of the present stage, and the event of its end. */
const TASK = "task";
const STAGE = "task.operation_step";
const ENDS = "operation_ends";

/** State of a task: under way in a stage, counted from 1; done; or failed, because a limit was exceeded before. */
export type Outcome =
  | { state: "under_way"; stage: number }
  | { state: "done"; time_s: number }
  | { state: "failed"; time_s: number; limit: string };

/** Returns the outcome of a task at a time. A limit with a percentile is judged over the whole run, and does not count. */
export function outcomeAt(time_s: number, stage: number, events: readonly Happened[], tracks: readonly LimitTrack[]): Outcome {
  const end = events.find((event) => event.code === ENDS && event.name === TASK && event.time_s <= time_s);
  const until_s = end?.time_s ?? time_s;
  const exceeded = tracks.flatMap((track) => {
    const first_s = track.firstExceeded();
    return first_s === null || first_s > until_s ? [] : [{ time_s: first_s, limit: track.limit.name }];
  });
  if (exceeded.length > 0) return { state: "failed", ...exceeded.reduce((first, one) => (one.time_s < first.time_s ? one : first)) };
  return end ? { state: "done", time_s: end.time_s } : { state: "under_way", stage: Math.max(1, stage) };
}

/** The task of the scenario on the picture: its present stage, and its result. The whole task opens below. */
export class TaskCard {
  private readonly element = byId("task", HTMLDetailsElement);
  private readonly summary = make("summary", {});
  private readonly said = make("p", { class: "visually-hidden", role: "status" });
  private task: TaskInfo | null = null;
  private stages: HTMLElement[] = [];

  constructor(private readonly session: Session) {
    this.element.after(this.said);
  }

  open({ model }: Run): void {
    this.task = model.task;
    this.element.hidden = this.task === null;
    if (!this.task) return;
    this.stages = this.task.stages.map(({ name }) => make("li", {}, name));
    const rest = [make("p", { lang: "en" }, this.task.text), make("ol", { lang: "en" }, ...this.stages)];
    this.element.replaceChildren(this.summary, ...rest);
  }

  show({ columns }: Run, { time_s, row }: Moment, tracks: readonly LimitTrack[]): void {
    if (!this.task) return;
    const { stages } = this.task;
    const outcome = outcomeAt(time_s, columns.read(row, STAGE), this.session.shown.recording?.events ?? [], tracks);
    setText(this.summary, wordsOf(outcome, stages.map(({ name }) => name)));
    if (this.element.dataset.state !== outcome.state && outcome.state !== "under_way") setText(this.said, this.summary.textContent!);
    this.element.dataset.state = outcome.state;
    const stage = outcome.state === "done" ? stages.length + 1 : columns.read(row, STAGE);
    this.stages.forEach((element, i) => element.classList.toggle("is-done", i + 1 < stage));
  }
}

function wordsOf(outcome: Outcome, stages: readonly string[]): string {
  const words = texts.instruments.task;
  if (outcome.state === "done") return words.done(outcome.time_s.toFixed(1));
  if (outcome.state === "failed") return words.failed(outcome.limit.replaceAll("_", " "), outcome.time_s.toFixed(1));
  const at = Math.min(outcome.stage, stages.length);
  return words.stage(at, stages.length, stages[at - 1]);
}
