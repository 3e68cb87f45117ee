import type { Fault } from "../engine/engine";
import { isOfEngine } from "../engine/faults";
import type { Frame } from "../engine/messages";
import type { Run } from "./run";
import { faultOfSaving, savedFile, type SavedFile } from "./saved";
import { Steering } from "./session/steering";

export type { Listener, Run, Status } from "./run";

/** The one state of the page: which scenario, which values, where the run stands, and which moment of it is shown. */
export class Session extends Steering {
  /** Over wall time; infinite for as fast as it goes. */
  speed = 1;
  private advancing = false;
  /** Where a run as fast as it goes pauses. */
  private until_s = Infinity;

  /** Whether it runs, or will as soon as a reset under way is through. */
  get isGoing(): boolean {
    return this.status === "running" || this.status === "stepping" || this.due === "start";
  }

  /** From an earlier moment that is shown the run branches. */
  start(): void {
    this.until_s = Infinity;
    if (this.shown.isBack) void this.branch();
    if (this.turns.isBusy) this.intend("start");
    else if (this.status === "idle" || this.status === "paused") this.become("running");
  }

  /** As fast as it goes, to a time at which it pauses. */
  runTo(time_s: number): void {
    this.start();
    this.until_s = time_s;
  }

  pause(): void {
    if (this.due) this.intend(null);
    if (this.status === "running" || this.status === "stepping") this.become("paused");
  }

  /** One recording interval. */
  async step(): Promise<void> {
    if (!this.run || this.status === "stepping" || (this.status === "stopped" && !this.shown.isBack)) return;
    if (this.shown.isBack) void this.branch();
    if (this.turns.isBusy) return this.intend("step");
    this.become("paused");
    let frame = await this.take(this.client.step());
    if (frame?.isPart && this.status === "paused") this.become("stepping");
    // A pause or a reset may come while an answer is due.
    const isOn = () => this.status === "stepping";
    while (frame?.isPart && isOn()) frame = await this.take(this.client.step());
    if (isOn()) this.become("paused");
  }

  /** One frame of a run, `wall_s` after the one before; asks nothing while an answer is due. */
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

  /** The state of the run in hand, for another engine. */
  snapshot(): Promise<Uint8Array> {
    return this.asked(this.client.snapshot());
  }

  /** The run in hand as a scenario file; null where it cannot be one, which is reported. */
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

  /** The run in hand as a scenario in JSON, for what is written of it; null where it cannot be one. */
  async resolved(): Promise<string | null> {
    return this.asked(this.client.replay()).then(
      ({ scenario }) => scenario,
      () => null,
    );
  }

  /** There is nothing to open. */
  beEmpty(fault: Fault): void {
    this.become("empty");
    this.report(fault);
  }
}
