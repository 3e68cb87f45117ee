import type { Change } from "../engine/changes";
import type { EngineClient } from "../engine/client";
import { asFault } from "../engine/engine";
import type { Fault, Value, Values } from "../engine/engine";
import { isOfEngine } from "../engine/faults";
import type { Frame } from "../engine/messages";
import type { Listener, Run, Source, Status } from "./run";
import { faultOfSaving, savedFile, type SavedFile } from "./saved";
import { Opening, type Player } from "./session/opening";
import { Rewinding } from "./session/rewinding";
import { SessionState } from "./session/state";
import { Steering } from "./session/steering";

export type { Listener, Run, Status } from "./run";

/** Plays the open scenario: resets it, runs it, goes back to earlier moments, and sets its values and inputs. */
export class Session implements Player {
  /** Simulated time over wall time; infinite for as fast as possible. */
  speed = 1;
  private readonly state = new SessionState();
  private readonly opening: Opening;
  private readonly rewinding: Rewinding;
  private readonly steering: Steering;
  private advancing = false;
  /** Time at which a run as fast as possible pauses, s. */
  private until_s = Infinity;

  constructor(private readonly client: EngineClient) {
    this.opening = new Opening(this.state, client, this);
    this.rewinding = new Rewinding(this.state, this.opening);
    this.steering = new Steering(this.state, this.opening, this.rewinding);
  }

  get run(): Run | null {
    return this.state.run;
  }

  get source(): Source | null {
    return this.state.source;
  }

  get status(): Status {
    return this.state.status;
  }

  /** The last fault, until it is dismissed or something opens. */
  get fault(): Fault | null {
    return this.state.fault;
  }

  /** The moment that is shown. */
  get shown(): SessionState["shown"] {
    return this.state.shown;
  }

  /** The values of the controls. */
  get values(): SessionState["values"] {
    return this.state.values;
  }

  listen(listener: Listener): void {
    this.state.listen(listener);
  }

  report(fault: Fault): void {
    this.state.report(fault);
  }

  dismissFault(): void {
    this.state.dismissFault();
  }

  /** Reports that no scenario can be opened. */
  beEmpty(fault: Fault): void {
    if (this.opening.due) this.opening.intend(null);
    this.state.become("empty");
    this.state.report(fault);
  }

  /** Opens another scenario, which may still be loading; if it cannot be read, the present run stays. */
  open(source: Source | Promise<Source>, overrides: Values): Promise<boolean> {
    return this.opening.open(source, overrides);
  }

  /** Resets the run, with the values of the controls. */
  reset(): Promise<void> {
    return this.opening.reset();
  }

  /** Resets the run; if it was running, it runs again. */
  restart(): void {
    this.opening.restart();
  }

  /** Whether a request to the engine is not answered, or an opening or reset waits. */
  get isWaiting(): boolean {
    return this.opening.isWaiting;
  }

  /** Whether the session runs, or will run when the present reset is done. */
  get isGoing(): boolean {
    return this.status === "running" || this.status === "stepping" || this.opening.due === "start";
  }

  /**
   * Starts the run; if an earlier moment is shown, the run branches from it. A scenario that is still being opened starts
   * when it is open.
   */
  start(): void {
    this.until_s = Infinity;
    this.go();
  }

  /** Starts the run; the time at which it pauses stays. */
  go(): void {
    if (this.shown.isBack) void this.rewinding.branch();
    if (this.opening.turns.isBusy || this.status === "loading") this.opening.intend("start");
    else if (this.status === "idle" || this.status === "paused") this.state.become("running");
  }

  /** Runs as fast as possible to a time, and pauses there. */
  runTo(time_s: number): void {
    this.until_s = time_s;
    this.go();
  }

  pause(): void {
    if (this.opening.due) this.opening.intend(null);
    if (this.status === "running" || this.status === "stepping") this.state.become("paused");
  }

  /** Pauses, and shows the recorded moment nearest to a time. */
  scrub(time_s: number): void {
    if (this.rewinding.isUnderWay) return;
    this.pause();
    this.state.look(time_s);
  }

  /** Advances by one recording interval. */
  async step(): Promise<void> {
    if (!this.run || this.status === "stepping" || (this.status === "stopped" && !this.shown.isBack)) return;
    if (this.shown.isBack) void this.rewinding.branch();
    if (this.opening.turns.isBusy) return this.opening.intend("step");
    this.state.become("paused");
    let frame = await this.take(this.client.step());
    if (frame?.isPart && this.status === "paused") this.state.become("stepping");
    // A pause or a reset may come before the engine's answer.
    const isOn = () => this.status === "stepping";
    while (frame?.isPart && isOn()) frame = await this.take(this.client.step());
    if (isOn()) this.state.become("paused");
  }

  /** Advances a run by one frame, `wall_s` after the previous one; sends no request while an answer is expected. */
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
      const frame = await this.opening.asked(answer);
      if (!frame || !run || run !== this.run) return null;
      this.show(run, frame);
      return frame;
    } catch (fault) {
      if (run === this.run && !isOfEngine(fault)) {
        this.state.become("stopped");
        this.report(asFault(fault));
      }
      return null;
    }
  }

  private show(run: Run, frame: Frame): void {
    if (frame.changes.length > 0) this.steering.follow(run, frame.changes);
    this.shown.recording?.add(frame, this.values.inForce);
    this.state.emit((listener) => listener.advanced?.(run, frame));
    if (!this.shown.isBack) this.state.tellMoment();
    if (!frame.fault) return;
    this.state.become("stopped");
    this.report(frame.fault);
  }

  /**
   * Sets a value. At the start it acts at once; during a run a live value acts at once, and any other value restarts a
   * run that goes, and waits for the reset of a run that is paused.
   */
  set(name: string, value: Value): void {
    this.steering.set(name, value);
  }

  /** Returns the value that a control shows. */
  value(name: string): Value | undefined {
    return this.values.shown(name);
  }

  /** Returns the names of the values that wait for a reset. */
  pending(): string[] {
    return this.values.pending();
  }

  /** Sets an input, which acts from the moment that is shown. */
  setInput(name: string, value: number): Promise<void> {
    return this.steering.setInput(name, value);
  }

  /** Returns the value of an input; the new value while it is being sent. */
  input(name: string): number {
    return this.steering.input(name);
  }

  /** Drops values and inputs that wait to be sent: they belong to the present run. */
  dropSteering(): void {
    this.steering.drop();
  }

  /** Returns the changes made so far in the present run. */
  changes(): Promise<readonly Change[]> {
    return this.opening.asked(this.client.changes());
  }

  /** Returns the state of the present run, for another engine. */
  snapshot(): Promise<Uint8Array> {
    return this.opening.asked(this.client.snapshot());
  }

  /** Returns the present run as a scenario file; null, with a report, if this is not possible. */
  async save(): Promise<SavedFile | null> {
    try {
      const { source } = this;
      const replay = await this.opening.asked(this.client.replay());
      return source && (await savedFile(source.file, replay, this.pending()));
    } catch (fault) {
      this.state.reportOfRun(faultOfSaving(asFault(fault)));
      return null;
    }
  }

  /** Returns the present run as a resolved scenario in JSON, for exported files; null if this is not possible. */
  async resolved(): Promise<string | null> {
    return this.opening.asked(this.client.replay()).then(
      ({ scenario }) => scenario,
      () => null,
    );
  }
}
