import type { EngineClient } from "../../engine/client";
import { asFault } from "../../engine/engine";
import type { Fault, Values } from "../../engine/engine";
import { isOfEngine } from "../../engine/faults";
import type { Opened } from "../../engine/messages";
import { faultOfControl, faultOfLostRun, faultOfResumedRun } from "../faults";
import { Recording } from "../recording/recording";
import { resume } from "../recording/resume";
import { runOf } from "../run";
import type { Run, Source } from "../run";
import { Turns } from "../turns";
import type { SessionState } from "./state";

/** Part of the session that an opening uses. */
export interface Player {
  /** Whether the session runs, or will run when the present reset is done. */
  readonly isGoing: boolean;
  /** Starts the run; a goal of the run stays. */
  go(): void;
  pause(): void;
  step(): Promise<void>;
  /** Drops values and inputs that wait to be sent: they belong to the present run. */
  dropSteering(): void;
}

/** Opens scenarios, resets the present run, and continues it in another engine if its engine has died. */
export class Opening {
  /** Queue of openings and resets. */
  readonly turns = new Turns(() => this.goOn());
  /** A request during an opening or reset, to be carried out after it. */
  due: "start" | "step" | null = null;
  private resetDue = false;
  private isRecovering = false;
  /** The run that a new engine continued last, and the time of that, s. */
  private last: { run: Run; time_s: number } | null = null;

  constructor(
    private readonly state: SessionState,
    readonly client: EngineClient,
    private readonly player: Player,
  ) {}

  /** Whether a request to the engine is not answered, or an opening or reset waits. */
  get isWaiting(): boolean {
    return this.turns.isBusy || this.client.isAsked;
  }

  /** Opens another scenario, which may still be loading; if it cannot be read, the present run stays. */
  open(asked: Source | Promise<Source>, overrides: Values): Promise<boolean> {
    // Before the first scenario there is no run to pause, and a request to start is for this one.
    if (this.state.status !== "loading") this.player.pause();
    this.player.dropSteering();
    const loaded = Promise.resolve(asked).catch(asFault);
    return this.turns.take(async () => {
      const source = await loaded;
      try {
        if ("kind" in source) throw source;
        this.accept(await this.read(source, overrides), { ...overrides }, source);
        return true;
      } catch (fault) {
        if (this.due) this.intend(null);
        if ("kind" in source) this.state.report(source);
        else this.refuseOpening(source, overrides, asFault(fault));
        return false;
      }
    });
  }

  /** Reads a scenario; if the engine of the present run has died, a new engine reads it. */
  private async read({ text, file, opened, changes, folder }: Source, overrides: Values): Promise<Opened> {
    const answer = () => this.client.open(text, file, overrides, opened ?? null, changes, folder);
    return answer().catch((fault: Fault) => {
      if (!this.state.run || !isOfEngine(fault)) throw fault;
      return answer();
    });
  }

  /** Remembers a scenario that could not be loaded, so that Reset tries again. */
  private refuseOpening(source: Source, overrides: Values, fault: Fault): void {
    if (!this.state.run) {
      if (isOfEngine(fault) || fault.kind === "network") [this.state.source, this.state.values.wanted] = [source, { ...overrides }];
      this.state.become("empty");
    } else if (isOfEngine(fault)) void this.recover(fault);
    this.state.report(fault);
  }

  /** Resets the run, with the values of the controls. */
  reset(): Promise<void> {
    this.player.pause();
    return this.reopen();
  }

  /** Resets the run; if it was running, it runs again. */
  restart(): void {
    const { isGoing } = this.player;
    void this.reset();
    if (isGoing) this.player.go();
  }

  /** Opens the present scenario again with the values of the controls; several calls at the same time count as one. */
  async reopen(): Promise<void> {
    if (this.resetDue) return;
    this.resetDue = true;
    await this.turns.take(async () => {
      this.resetDue = false;
      if (!this.state.source) return;
      const overrides = { ...this.state.values.forStart() };
      try {
        this.accept(await this.read(this.state.source, overrides), overrides, this.state.run ? null : this.state.source);
      } catch (fault) {
        this.refuse(overrides, asFault(fault));
      }
    });
  }

  private accept(opened: Opened, overrides: Values, source: Source | null): void {
    const { run: last, shown } = this.state;
    if (last && shown.recording) this.state.emit((listener) => listener.leaves?.(last, shown.recording!, null));
    const run = runOf(opened);
    this.state.run = run;
    this.state.values.begin(opened, overrides);
    const interval_s = Math.max(run.model.record_every_s, run.model.step_s);
    this.state.shown.begin(new Recording(run.columns, interval_s, opened.frame, this.state.values.inForce));
    if (source) {
      this.state.source = source;
      this.state.values.wanted = { ...overrides };
    }
    this.state.dismissFault();
    this.state.emit((listener) => listener.opened?.(run, opened.frame, source !== null));
    this.state.become("idle");
    this.state.emit((listener) => listener.valuesChanged?.());
  }

  /** Handles a value that the engine has refused: the controls return to the values of the present run. */
  private refuse(tried: Values, fault: Fault): void {
    if (this.due) this.intend(null);
    if (isOfEngine(fault)) {
      this.state.become(this.state.run ? "stopped" : "empty");
      return this.state.report(fault);
    }
    this.state.values.giveUp(tried);
    this.state.report(faultOfControl(fault, this.state.run?.model.parameters ?? []));
    this.state.emit((listener) => listener.valuesChanged?.());
  }

  /**
   * Waits for the engine's answer to a request about the present run; if the engine has died, the run starts again in a
   * new engine.
   */
  async asked<T>(answer: Promise<T>): Promise<T> {
    return answer.catch((fault: unknown) => {
      if (isOfEngine(fault)) void this.recover(fault);
      throw fault;
    });
  }

  private async recover(fault: Fault): Promise<void> {
    if (this.isRecovering) return;
    this.isRecovering = true;
    const goes = this.player.isGoing && this.state.status !== "stepping";
    this.player.pause();
    this.player.dropSteering();
    const { run } = this.state;
    if (await this.resumed(fault)) {
      this.isRecovering = false;
      if (goes) this.player.go();
      return;
    }
    await this.reopen();
    // The values that waited for a reset may have been refused; the controls now have the values of the present run.
    if (run === this.state.run && this.state.status !== "stopped") await this.reopen();
    this.isRecovering = false;
    if (run !== this.state.run) this.state.report(faultOfLostRun(fault));
  }

  /** Continues the present run in a new engine from its last keyframe, and reports that; false if this fails. */
  private async resumed(fault: Fault): Promise<boolean> {
    const { run, source } = this.state;
    const { recording } = this.state.shown;
    if (!run || !source || !recording) return false;
    const { time_s } = recording.now;
    // A second engine that ends at the same moment would be followed by a third.
    if (this.last?.run === run && time_s <= this.last.time_s) return false;
    this.last = { run, time_s };
    return this.turns.take(async () => {
      if (run !== this.state.run) return true;
      try {
        const { inputs, frame } = await resume(this.client, recording, source, this.state.values.begun);
        run.inputs = inputs;
        recording.dropAfter(frame);
      } catch {
        return false;
      }
      this.state.emit((listener) => listener.inputsChanged?.(run));
      this.state.emit((listener) => listener.valuesChanged?.());
      this.state.report(faultOfResumedRun(fault, recording.now.time_s));
      return true;
    });
  }

  intend(due: "start" | "step" | null): void {
    this.due = due;
    this.state.emit((listener) => listener.statusChanged?.(this.state.status));
  }

  private goOn(): void {
    const { due } = this;
    if (due) this.intend(null);
    if (due === "start") this.player.go();
    if (due === "step") void this.player.step();
  }
}
