import type { Value } from "./engine";

/** A lever or a live parameter that was set in a run, at the end of a step. */
export type Change = { time_s: number; input: string; value: number } | { time_s: number; parameter: string; value: Value };

/** Changes made in a run so far, and those that a link says are to be made again. */
export class Changes {
  private all: Change[] = [];

  constructor(
    private due: readonly Change[],
    private readonly step_s: number,
  ) {}

  get made(): readonly Change[] {
    return this.all;
  }

  /** Records a change. Of several moves of one lever between two steps only the last counts, and a repeated move counts once. A parameter
   * books energy each time. */
  make(change: Change): void {
    if ("input" in change && this.all.some((one) => "input" in one && one.time_s === change.time_s && one.input === change.input && one.value === change.value)) return;
    const last = this.all.at(-1);
    const isSame = last && "input" in last && "input" in change && last.input === change.input && last.time_s === change.time_s;
    if (isSame) this.all.pop();
    this.all.push(change);
  }

  /** Removes and returns the changes that are due after a number of steps. */
  takeDue(steps: number): Change[] {
    const now = this.due.filter((change) => this.stepOf(change) <= steps);
    if (now.length > 0) this.due = this.due.slice(now.length);
    return now;
  }

  /** Steps until the next later change; infinite if there is none. */
  toNext(steps: number): number {
    const next = this.due.find((change) => this.stepOf(change) > steps);
    return next ? this.stepOf(next) - steps : Infinity;
  }

  /** Manual control: no change is repeated any more. */
  dropDue(): void {
    this.due = [];
  }

  /** The run went back to this step. */
  dropAfter(steps: number): void {
    this.all = this.all.filter((change) => this.stepOf(change) <= steps);
    this.dropDue();
  }

  private stepOf({ time_s }: Change): number {
    return Math.round(time_s / this.step_s);
  }
}
