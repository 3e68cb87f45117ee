import type { Change } from "../../engine/changes";
import type { Fault, Value } from "../../engine/engine";
import type { LeverMove } from "../../engine/messages";
import { faultOfControl } from "../faults";
import type { Run } from "../run";
import { Latest } from "../turns";
import { isLive } from "../values";
import type { Opening } from "./opening";
import type { Rewinding } from "./rewinding";
import type { SessionState } from "./state";

/** Sets parameters and levers of the present run, by hand or when the run repeats the changes of a link. */
export class Steering {
  /** Live values that wait to be sent to the engine. */
  private readonly live = new Latest<Value>((name, value) => this.setLive(name, value));
  private readonly levers = new Latest<number>((name, value) => this.moveLever(name, value));

  constructor(
    private readonly state: SessionState,
    private readonly opening: Opening,
    private readonly rewinding: Rewinding,
  ) {}

  /**
   * Sets a value. At the start the scenario is opened again with it. During a run a live value is set in the engine,
   * and the picture shows its effect at the next step; any other value restarts a run that goes, and waits for the reset
   * of a run that is paused.
   */
  set(name: string, value: Value): void {
    const { run, status, values } = this.state;
    values.want(name, value);
    this.state.emit((listener) => listener.valuesChanged?.());
    if (status === "idle") void this.opening.reopen();
    else if (run && isLive(run.model, name)) void this.live.set(name, value);
    else if (status === "running" && values.pending().includes(name)) this.opening.restart();
  }

  /** Sends a live value to the engine; a refused value waits for the reset. */
  private async setLive(name: string, value: Value): Promise<void> {
    if (!(await this.rewinding.isReady()) || this.state.values.inForce[name] === value) return;
    const { run } = this.state;
    await this.opening.asked(this.opening.client.parameter(name, value)).then(
      (time_s) => {
        if (run === this.state.run) {
          this.state.values.apply(name, value);
          this.state.shown.recording?.note({ time_s, parameter: name, value });
        }
        this.state.emit((listener) => listener.steered?.());
      },
      (fault: Fault) => this.state.reportOfRun(faultOfControl(fault, run?.model.parameters ?? [])),
    );
    this.state.emit((listener) => listener.valuesChanged?.());
  }

  /** Sets an input, which acts from the moment that is shown. */
  setInput(name: string, value: number): Promise<void> {
    return this.levers.set(name, value);
  }

  /** Returns the value of an input; the new value while it is being sent. */
  input(name: string): number {
    return this.levers.due(name) ?? this.state.run?.inputs.find((input) => input.name === name)?.value ?? 0;
  }

  /** Sends a lever's value to the engine; during a reset it waits for the new run. */
  private async moveLever(name: string, value: number): Promise<void> {
    if (!(await this.rewinding.isReady())) return;
    const { run } = this.state;
    await this.opening.asked(this.opening.client.input(name, value)).then(
      (time_s) => {
        if (!run || run !== this.state.run) return;
        this.noteMove(run, { time_s, input: name, value: value === 0 ? 0 : value });
        this.state.emit((listener) => listener.inputsChanged?.(run));
        this.state.emit((listener) => listener.steered?.());
      },
      (fault: Fault) => run === this.state.run && this.state.reportOfRun(fault),
    );
  }

  private noteMove(run: Run, move: LeverMove): void {
    this.state.shown.recording?.note(move);
    run.inputs = run.inputs.map((input) => (input.name === move.input ? { ...input, value: move.value } : input));
  }

  /** Records the changes of a link that the run has repeated. */
  follow(run: Run, changes: readonly Change[]): void {
    for (const change of changes) {
      if ("parameter" in change) {
        this.state.values.follow(change.parameter, change.value);
        this.state.shown.recording?.note(change);
      } else this.noteMove(run, change);
    }
    this.state.emit((listener) => listener.inputsChanged?.(run));
    this.state.emit((listener) => listener.followed?.(run));
    this.state.emit((listener) => listener.valuesChanged?.());
  }

  /** Drops values and inputs that wait to be sent: they belong to the present run. */
  drop(): void {
    this.live.clear();
    this.levers.clear();
  }
}
