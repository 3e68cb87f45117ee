import { asFault } from "../../engine/engine";
import type { Recording } from "../recording/recording";
import { rewind } from "../recording/rewind";
import type { Run } from "../run";
import type { Opening } from "./opening";
import type { SessionState } from "./state";

/** Brings the present run back to the earlier moment that is shown. */
export class Rewinding {
  private branching: Promise<void> | null = null;

  constructor(
    private readonly state: SessionState,
    private readonly opening: Opening,
  ) {}

  /** Whether the run is being brought back. */
  get isUnderWay(): boolean {
    return this.branching !== null;
  }

  /** Brings the run back to the moment that is shown; everything later leaves its recording. */
  branch(): Promise<void> {
    const { run, shown } = this.state;
    const { time_s } = shown;
    this.branching ??= this.opening.turns
      .take(async () => {
        if (run && run === this.state.run && shown.recording) await this.goBack(run, shown.recording, time_s);
      })
      .finally(() => (this.branching = null));
    return this.branching;
  }

  /** Brings the run to the moment that is shown, where inputs then act; false if this fails. */
  private async isAtCursor(): Promise<boolean> {
    if (this.state.shown.isBack) await this.branch();
    return !this.state.shown.isBack;
  }

  /**
   * Waits for openings and resets; false if another scenario is then open, or if the run cannot be brought to the
   * moment that is shown.
   */
  async isReady(): Promise<boolean> {
    const { source } = this.state;
    do {
      await this.opening.turns.over();
      if (source !== this.state.source || !(await this.isAtCursor())) return false;
    } while (this.opening.turns.isBusy);
    return true;
  }

  private async goBack(run: Run, recording: Recording, time_s: number): Promise<void> {
    const { values } = this.state;
    try {
      const restored = rewind(this.opening.client, recording, time_s, values.inForce, (name, value) => values.goBack(name, value));
      const { inputs, frame } = await this.opening.asked(restored);
      run.inputs = inputs;
      this.state.emit((listener) => listener.leaves?.(run, recording, recording.timeOf(frame.row)));
      recording.dropAfter(frame);
    } catch (fault) {
      this.opening.due = null;
      return this.state.reportOfRun(asFault(fault));
    }
    this.state.shown.follow();
    if (this.state.status === "stopped") this.state.dismissFault();
    this.state.become("paused");
    this.state.emit((listener) => listener.branched?.(run));
    this.state.emit((listener) => listener.valuesChanged?.());
    this.state.tellMoment();
  }
}
