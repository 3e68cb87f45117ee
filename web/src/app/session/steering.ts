import type { Change } from "../../engine/changes";
import type { Fault, Value } from "../../engine/engine";
import type { LeverMove } from "../../engine/messages";
import { faultOfControl } from "../faults";
import type { Run } from "../run";
import { Latest } from "../turns";
import { isLive } from "../values";
import { GoingBack } from "./going_back";

/** Sets parameters and levers of the present run, by hand or when the run repeats the changes of a link. */
export abstract class Steering extends GoingBack {
  /** Live values that were sent to the engine. */
  private readonly live = new Latest<Value>((name, value) => this.setLive(name, value));
  private readonly levers = new Latest<number>((name, value) => this.moveLever(name, value));

  /** Sets a value. At the start it acts at once; during a run a live value acts at once, and any other waits for the reset. */
  set(name: string, value: Value): void {
    this.values.want(name, value);
    this.emit((listener) => listener.valuesChanged?.());
    if (this.status === "idle") void this.reopen();
    else if (this.run && isLive(this.run.model, name)) void this.live.set(name, value);
  }

  /** A live value that is refused waits for the reset. */
  private async setLive(name: string, value: Value): Promise<void> {
    if (!(await this.isReady()) || this.values.inForce[name] === value) return;
    const { run } = this;
    await this.asked(this.client.parameter(name, value)).then(
      () => {
        if (run === this.run) this.values.apply(name, value);
        this.emit((listener) => listener.steered?.());
      },
      (fault: Fault) => this.reportOfRun(faultOfControl(fault, run?.model.parameters ?? [])),
    );
    this.emit((listener) => listener.valuesChanged?.());
  }

  /** Sets an input from the moment that is shown. */
  setInput(name: string, value: number): Promise<void> {
    return this.levers.set(name, value);
  }

  /** The value of an input, or the value that was just sent. */
  input(name: string): number {
    return this.levers.due(name) ?? this.run?.inputs.find((input) => input.name === name)?.value ?? 0;
  }

  /** Values for a run that a reset replaces are sent to the new run. */
  private async moveLever(name: string, value: number): Promise<void> {
    if (!(await this.isReady())) return;
    const { run } = this;
    await this.asked(this.client.input(name, value)).then(
      (time_s) => {
        if (!run || run !== this.run) return;
        this.noteMove(run, { time_s, input: name, value: value === 0 ? 0 : value });
        this.emit((listener) => listener.inputsChanged?.(run));
        this.emit((listener) => listener.steered?.());
      },
      (fault: Fault) => run === this.run && this.reportOfRun(fault),
    );
  }

  private noteMove(run: Run, move: LeverMove): void {
    this.shown.recording?.noteMove(move);
    run.inputs = run.inputs.map((input) => (input.name === move.input ? { ...input, value: move.value } : input));
  }

  /** The run has repeated these changes. */
  protected follow(run: Run, changes: readonly Change[]): void {
    for (const change of changes) {
      if ("parameter" in change) this.values.follow(change.parameter, change.value);
      else this.noteMove(run, change);
    }
    this.emit((listener) => listener.inputsChanged?.(run));
    this.emit((listener) => listener.followed?.(run));
    this.emit((listener) => listener.valuesChanged?.());
  }

  /** The value that a control shows. */
  value(name: string): Value | undefined {
    return this.values.shown(name);
  }

  /** The changes of the present run so far. */
  changes(): Promise<readonly Change[]> {
    return this.asked(this.client.changes());
  }

  /** Names of the values that wait for a reset. */
  pending(): string[] {
    return this.values.pending();
  }

  protected dropSteering(): void {
    this.live.clear();
    this.levers.clear();
  }
}
