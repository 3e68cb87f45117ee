import type { Fault } from "../engine/engine";
import { isOfEngine } from "../engine/faults";
import type { Frame } from "../engine/messages";
import type { Run } from "./run";
import { faultOfSaving, savedFile, type SavedFile } from "./saved";
import { Steering } from "./session/steering";

export type { Listener, Run, Status } from "./run";

/** The state of the page: scenario, values, state of the run, and the moment that is shown. */
export class Session extends Steering {
  /** Simulated time over wall time; infinite for as fast as possible. */
  speed = 1;
  private advancing = false;
  /** Time at which a run at full speed pauses. */
  private until_s = Infinity;

  /** Whether it runs, or will run when the present reset is done. */
  get isGoing(): boolean {
    return this.status === "running" || this.status === "stepping" || this.due === "start";
  }

  /** Starts the run; from an earlier moment it branches. */
  start(): void {
    this.until_s = Infinity;
    if (this.shown.isBack) void this.branch();
    if (this.turns.isBusy) this.intend("start");
    else if (this.status === "idle" || this.status === "paused") this.become("running");
  }

  /** Runs at full speed to a time, and pauses there. */
  runTo(time_s: number): void {
    this.start();
    this.until_s = time_s;
  }

  pause(): void {
    if (this.due) this.intend(null);
    if (this.status === "running" || this.status === "stepping") this.become("paused");
  }

  /** Advances by one recording interval. */
  async step(): Promise<void> {
    if (!this.run || this.status === "stepping" || (this.status === "stopped" && !this.shown.isBack)) return;
    if (this.shown.isBack) void this.branch();
    if (this.turns.isBusy) return this.intend("step");
    this.become("paused");
    let frame = await this.take(this.client.step());
    if (frame?.isPart && this.status === "paused") this.become("stepping");
    // A pause or a reset may come before the answer.
    const isOn = () => this.status === "stepping";
    while (frame?.isPart && isOn()) frame = await this.take(this.client.step());
    if (isOn()) this.become("paused");
  }

  /** One frame of a run, `wall_s` after the previous one; sends no request while it waits for an answer. */
  async advance(wall_s: number): Promise<void> {
    if (this.status !== "running" || this.advancing) return;
    this.advancing = true;
    const { until_s } = this;
    await this.take(this.client.advance(wall_s, until_s < Infinity ? Infinity : this.speed, until_s));
    if (until_s === this.until_s && this.isPast(until_s)) this.pause();
    this.advancing = false;
  }

  private isPast(time_s: number): boolean {
    const { run, shown } = this;
    return run !== null && shown.recording !== null && shown.recording.now.time_s > time_s - run.model.step_s / 2;
  }

  private async take(answer: Promise<Frame | null>): Promise<Frame | null> {
    const run = this.run;
    try {
      const frame = await this.asked(answer);
      if (!frame || !run || run !== this.run) return null;
      this.show(run, frame);
      return frame;
    } catch (fault) {
      if (run === this.run && !isOfEngine(fault)) {
        this.become("stopped");
        this.report(fault as Fault);
      }
      return null;
    }
  }

  private show(run: Run, frame: Frame): void {
    if (frame.changes.length > 0) this.follow(run, frame.changes);
    this.shown.recording?.add(frame, this.values.inForce);
    this.emit((listener) => listener.advanced?.(run, frame));
    if (!this.shown.isBack) this.tellMoment();
    if (!frame.fault) return;
    this.become("stopped");
    this.report(frame.fault);
  }

  /** The state of the present run, for another engine. */
  snapshot(): Promise<Uint8Array> {
    return this.asked(this.client.snapshot());
  }

  /** The present run as a scenario file; null, with a report, if that is impossible. */
  async save(): Promise<SavedFile | null> {
    try {
      const { source } = this;
      const replay = await this.asked(this.client.replay());
      return source && savedFile(source.file, replay, this.pending());
    } catch (fault) {
      this.reportOfRun(faultOfSaving(fault as Fault));
      return null;
    }
  }

  /** The present run as a scenario in JSON, for exported files; null if that is impossible. */
  async resolved(): Promise<string | null> {
    return this.asked(this.client.replay()).then(
      ({ scenario }) => scenario,
      () => null,
    );
  }

  /** Reports that there is nothing to open. */
  beEmpty(fault: Fault): void {
    this.become("empty");
    this.report(fault);
  }
}
