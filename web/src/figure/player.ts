import type { Session } from "../app/session";
import type { Value } from "../engine/engine";
import type { FromFigure, Settable } from "./protocol";
import { words } from "./words";

/** Plays the run of a figure: reaches a time, sets values, and reports what has changed to the page. */
export class Player {
  /** Time to reach, s. */
  private goal_s: number | null = null;
  /** Time at the last picture, s. */
  private before_s = 0;
  private told = { time_s: NaN, isPlaying: false, poses: null as unknown };
  private values: Map<string, Value>;

  constructor(
    private readonly session: Session,
    private readonly tell: (message: FromFigure) => void,
    /** Called when the run starts to play. */
    private readonly started: () => void,
  ) {
    this.values = new Map(settableIn(session).map(({ name, value }) => [name, value]));
    session.listen({
      valuesChanged: () => this.tellValues(),
      inputsChanged: () => this.tellValues(),
      branched: () => this.tellValues(),
      faulted: (fault) => fault && tell({ kind: "error", code: fault.kind, message: fault.message }),
    });
  }

  get isPlaying(): boolean {
    return this.goal_s === null && this.session.isGoing;
  }

  play(): void {
    const { session } = this;
    this.goal_s = null;
    if (session.status === "stopped" && !session.shown.isBack) void session.reset();
    session.start();
    this.started();
  }

  pause(): void {
    this.goal_s = null;
    this.session.pause();
  }

  /** Shows the start of the run. */
  again(): void {
    this.goal_s = null;
    void this.session.reset();
  }

  /** Shows a time: a recorded one at once, a later one when the run has reached it. */
  goTo(time_s: number): void {
    this.session.pause();
    this.goal_s = time_s;
  }

  /**
   * Sets a parameter, an input, or a field by its path. A value that takes effect at the start of a run restarts the
   * run, which then plays on, or goes to the time that was shown.
   */
  set(name: string, value: Value): void {
    const { run } = this.session;
    if (!run) return;
    if (run.inputs.some((input) => input.name === name && !input.signal)) return this.setInput(name, value);
    if (!run.model.parameters.some((one) => one.name === name) && !name.includes(".")) {
      const allowed = settableIn(this.session).map((one) => one.name).join(", ");
      return this.tell({ kind: "error", code: "name", message: words.unknown(name, allowed) });
    }
    this.session.set(name, value);
    if (this.session.status !== "idle" && this.session.pending().includes(name) && !this.isLive(name)) this.restart();
  }

  private isLive(name: string): boolean {
    const { parameters, live_settings } = this.session.run!.model;
    return live_settings.includes(name) || parameters.some((one) => one.name === name && one.live);
  }

  private setInput(name: string, value: Value): void {
    if (typeof value === "number") return void this.session.setInput(name, value);
    this.tell({ kind: "error", code: "value", message: words.no_number(name, String(value)) });
  }

  private restart(): void {
    const { isPlaying, session } = this;
    const time_s = this.goal_s ?? session.shown.time_s;
    void session.reset();
    if (isPlaying) session.start();
    else if (time_s > 0) this.goal_s = time_s;
  }

  /** Takes the next step towards the time to reach, and reports the moment that is shown; called for each picture. */
  tick(): void {
    this.approach();
    this.stopAtEnd();
    this.tellState();
  }

  private approach(): void {
    const { goal_s, session } = this;
    const { run, shown } = session;
    if (goal_s === null || !run || !shown.recording || session.isWaiting || session.isGoing) return;
    const { step_s } = run.model;
    const newest_s = shown.recording.now.time_s;
    const aim_s = Math.round(goal_s / step_s) * step_s;
    if (aim_s <= newest_s + step_s / 2 || session.status === "stopped") {
      this.goal_s = null;
      session.scrub(Math.min(aim_s, newest_s));
    } else {
      if (shown.isBack) session.scrub(newest_s);
      session.runTo(aim_s);
    }
  }

  /** Pauses once at the scenario's duration; the reader can play on from there. */
  private stopAtEnd(): void {
    const { run, shown } = this.session;
    const now_s = shown.recording?.now.time_s ?? 0;
    const end_s = run?.model.duration_s ?? Infinity;
    if (this.isPlaying && this.before_s < end_s && now_s >= end_s) this.session.pause();
    this.before_s = now_s;
  }

  private tellState(): void {
    const { isPlaying, session } = this;
    const { moment } = session.shown;
    if (!moment) return;
    const { time_s, poses, row } = moment;
    const { told } = this;
    if (told.time_s === time_s && told.isPlaying === isPlaying && told.poses === poses) return;
    this.told = { time_s, isPlaying, poses };
    this.tell({ kind: "state", time_s, isPlaying, row: Float64Array.from(row) });
  }

  private tellValues(): void {
    for (const { name, value } of settableIn(this.session)) {
      const before = this.values.get(name);
      this.values.set(name, value);
      if (before !== undefined && before !== value) this.tell({ kind: "changed", name, value });
    }
  }
}

/** Returns the parameters of the run and its inputs that are set by hand. */
export function settableIn(session: Session): Settable[] {
  const { run } = session;
  if (!run) return [];
  const parameters = run.model.parameters.map(({ name, label, unit, value, range, choices }): Settable => {
    return { name, label, unit, value: session.value(name) ?? value, range: range && [range[0], range[1]], choices };
  });
  const inputs = run.inputs.filter(({ signal }) => !signal).map(({ name, unit, value, lower, upper }): Settable => {
    return { name, label: name.replaceAll("_", " "), unit, value, range: Number.isFinite(lower) && Number.isFinite(upper) ? [lower, upper] : null, choices: null };
  });
  return [...parameters, ...inputs];
}
