import type { EngineClient } from "../../engine/client";
import type { Fault, Values } from "../../engine/engine";
import { isOfEngine } from "../../engine/faults";
import type { Opened } from "../../engine/messages";
import { faultOfControl, faultOfLostRun } from "../faults";
import { Recording } from "../recording/recording";
import { runOf } from "../run";
import type { Source } from "../run";
import { Turns } from "../turns";
import { SetValues } from "../values";
import { Told } from "./told";

/** Opens scenarios, resets the present run, and starts it again if its engine has died. */
export abstract class Opening extends Told {
  readonly values = new SetValues();
  /** The scenario that Reset opens. */
  source: Source | null = null;
  /** Number of pending openings and resets. */
  protected readonly turns = new Turns(() => this.goOn());
  /** A request during an opening or reset, to be carried out after it. */
  protected due: "start" | "step" | null = null;
  private resetDue = false;
  private isRecovering = false;

  constructor(protected readonly client: EngineClient) {
    super();
  }

  /** Whether something that was asked of the engine, or waits for its turn, is not done. */
  get isWaiting(): boolean {
    return this.turns.isBusy || this.client.isAsked;
  }

  /** Whether it runs, or will run when the present reset is done. */
  abstract get isGoing(): boolean;
  abstract start(): void;
  abstract pause(): void;
  abstract step(): Promise<void>;
  /** Messages already sent to the engine are not meant for another run. */
  protected abstract dropSteering(): void;

  /** Opens another scenario; if it cannot be read, the present run stays. */
  open(source: Source, overrides: Values): Promise<boolean> {
    this.pause();
    this.dropSteering();
    return this.turns.take(async () => {
      try {
        this.accept(await this.read(source, overrides), { ...overrides }, source);
        return true;
      } catch (fault) {
        this.due = null;
        this.refuseOpening(source, overrides, fault as Fault);
        return false;
      }
    });
  }

  /** If the engine of the present run has died, another engine is asked. */
  private async read({ text, file, opened, changes }: Source, overrides: Values): Promise<Opened> {
    const answer = () => this.client.open(text, file, overrides, opened ?? null, changes);
    return answer().catch((fault: Fault) => {
      if (!this.run || !isOfEngine(fault)) throw fault;
      return answer();
    });
  }

  /** Remembers a scenario that could not be loaded, so that Reset tries again. */
  private refuseOpening(source: Source, overrides: Values, fault: Fault): void {
    if (!this.run) {
      if (isOfEngine(fault) || fault.kind === "network") [this.source, this.values.wanted] = [source, { ...overrides }];
      this.become("empty");
    } else if (isOfEngine(fault)) void this.recover(fault);
    this.report(fault);
  }

  /** Resets the run, with the values of the controls. */
  reset(): Promise<void> {
    this.pause();
    return this.reopen();
  }

  /** Like a reset, but a running run goes on. */
  restart(): void {
    const { isGoing } = this;
    void this.reset();
    if (isGoing) this.start();
  }

  /** Several calls at once count as one. */
  protected async reopen(): Promise<void> {
    if (this.resetDue) return;
    this.resetDue = true;
    await this.turns.take(async () => {
      this.resetDue = false;
      if (!this.source) return;
      const overrides = { ...this.values.forStart() };
      try {
        this.accept(await this.read(this.source, overrides), overrides, this.run ? null : this.source);
      } catch (fault) {
        this.refuse(overrides, fault as Fault);
      }
    });
  }

  private accept(opened: Opened, overrides: Values, source: Source | null): void {
    const run = runOf(opened);
    this.run = run;
    this.values.begin(opened, overrides);
    const interval_s = Math.max(run.model.record_every_s, run.model.step_s);
    this.shown.begin(new Recording(run.columns, interval_s, opened.frame, this.values.inForce));
    if (source) {
      this.source = source;
      this.values.wanted = { ...overrides };
    }
    this.dismissFault();
    this.emit((listener) => listener.opened?.(run, opened.frame, source !== null));
    this.become("idle");
    this.emit((listener) => listener.valuesChanged?.());
  }

  /** The engine has refused a value: the controls go back to the values of the present run. */
  private refuse(tried: Values, fault: Fault): void {
    if (this.due) this.intend(null);
    if (isOfEngine(fault)) {
      this.become(this.run ? "stopped" : "empty");
      return this.report(fault);
    }
    this.values.giveUp(tried);
    this.report(faultOfControl(fault, this.run?.model.parameters ?? []));
    this.emit((listener) => listener.valuesChanged?.());
  }

  /** The engine's answer to a request about the present run; if the engine has died, the run starts again in another one. */
  protected async asked<T>(answer: Promise<T>): Promise<T> {
    return answer.catch((fault: unknown) => {
      if (isOfEngine(fault)) void this.recover(fault as Fault);
      throw fault;
    });
  }

  private async recover(fault: Fault): Promise<void> {
    if (this.isRecovering) return;
    this.isRecovering = true;
    this.pause();
    this.dropSteering();
    const { run } = this;
    await this.reopen();
    // Values that waited for a reset may have been refused.
    if (run === this.run && this.status !== "stopped") await this.reopen();
    this.isRecovering = false;
    if (run !== this.run) this.report(faultOfLostRun(fault));
  }

  protected intend(due: "start" | "step" | null): void {
    this.due = due;
    this.emit((listener) => listener.statusChanged?.(this.status));
  }

  private goOn(): void {
    const { due } = this;
    if (due) this.intend(null);
    if (due === "start") this.start();
    if (due === "step") void this.step();
  }
}
