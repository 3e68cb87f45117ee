import type { Value } from "./engine";

/** A lever or a live parameter that was set during a run, at the end of a step. */
export type Change = { time_s: number; input: string; value: number } | { time_s: number; parameter: string; value: Value };

/** Changes made so far in a run, and changes of a link that the run has still to repeat. */
export class Changes {
  private all: Change[] = [];

  constructor(
    private due: readonly Change[],
    private readonly step_s: number,
  ) {}

  get made(): readonly Change[] {
    return this.all;
  }

  /**
   * Records a change. If one lever is moved several times between two steps, only the last move counts, and a repeated
   * move counts once. Every change of a parameter counts, because each adds energy.
   */
  make(change: Change): void {
    if ("input" in change && this.all.some((one) => "input" in one && one.time_s === change.time_s && one.input === change.input && one.value === change.value)) return;
    const last = this.all.at(-1);
    const isSame = last && "input" in last && "input" in change && last.input === change.input && last.time_s === change.time_s;
    if (isSame) this.all.pop();
    this.all.push(change);
  }

  /** Removes and returns the changes that are due after this number of steps. */
  takeDue(steps: number): Change[] {
    const now = this.due.filter((change) => this.stepOf(change) <= steps);
    if (now.length > 0) this.due = this.due.slice(now.length);
    return now;
  }

  /** Number of steps to the next change that is not yet due; infinite if there is none. */
  toNext(steps: number): number {
    const next = this.due.find((change) => this.stepOf(change) > steps);
    return next ? this.stepOf(next) - steps : Infinity;
  }

  /** Drops the changes that were still to be repeated: from now on the user steers. */
  dropDue(): void {
    this.due = [];
  }

  /** Drops the changes after a step to which the run went back. */
  dropAfter(steps: number): void {
    this.all = this.all.filter((change) => this.stepOf(change) <= steps);
    this.dropDue();
  }

  /**
   * Takes the changes before the state of this step as made: the run continues from the state in another engine, and
   * makes the later ones. `isSet` if the state includes the parameters that were set at its step.
   */
  skipTo(steps: number, isSet: boolean): void {
    const isMade = (change: Change) => this.stepOf(change) < steps || (isSet && "parameter" in change && this.stepOf(change) === steps);
    this.due.filter(isMade).forEach((change) => this.make(change));
    this.due = this.due.filter((change) => !isMade(change));
  }

  private stepOf({ time_s }: Change): number {
    return Math.round(time_s / this.step_s);
  }
}
