import type { Change } from "../../engine/changes";
import type { Fault, Value } from "../../engine/engine";
import type { LeverMove } from "../../engine/messages";
import { faultOfControl } from "../faults";
import type { Run } from "../run";
import { Latest } from "../turns";
import { isLive } from "../values";
import { GoingBack } from "./going_back";

/** Sets parameters and levers of the run in hand, by a hand or as the run does it again by itself. */
export abstract class Steering extends GoingBack {
  /** Live values on their way to the engine. */
  private readonly live = new Latest<Value>((name, value) => this.setLive(name, value));
  private readonly levers = new Latest<number>((name, value) => this.moveLever(name, value));

  /** Sets a value; at the start the picture follows at once, under way a live one does, and another waits for the reset. */
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

  /** Acts from the moment that is shown on. */
  setInput(name: string, value: number): Promise<void> {
    return this.levers.set(name, value);
  }

  /** What an input is set to, or will be at once. */
  input(name: string): number {
    return this.levers.due(name) ?? this.run?.inputs.find((input) => input.name === name)?.value ?? 0;
  }

  /** What was meant for a run that a reset replaces is meant for the new one. */
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

  /** The run set these again by itself. */
  protected follow(run: Run, changes: readonly Change[]): void {
    for (const change of changes) {
      if ("parameter" in change) this.values.follow(change.parameter, change.value);
      else this.noteMove(run, change);
    }
    this.emit((listener) => listener.inputsChanged?.(run));
    this.emit((listener) => listener.followed?.(run));
    this.emit((listener) => listener.valuesChanged?.());
  }

  /** What a control shows. */
  value(name: string): Value | undefined {
    return this.values.shown(name);
  }

  /** What was set in the run in hand so far. */
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
