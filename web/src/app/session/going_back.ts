import type { Fault } from "../../engine/engine";
import type { Recording } from "../recording/recording";
import { rewind } from "../recording/rewind";
import type { Run } from "../run";
import { Opening } from "./opening";

/** Shows earlier moments of the present run, and brings the run back to one of them. */
export abstract class GoingBack extends Opening {
  private branching: Promise<void> | null = null;

  /** Pauses, and shows the recorded moment nearest to a time. */
  scrub(time_s: number): void {
    if (this.branching) return;
    this.pause();
    this.look(time_s);
  }

  /** Brings the run back to the moment that is shown and drops everything later. */
  protected branch(): Promise<void> {
    const { run, shown } = this;
    const { time_s } = shown;
    this.branching ??= this.turns
      .take(async () => {
        if (run && run === this.run && shown.recording) await this.goBack(run, shown.recording, time_s);
      })
      .finally(() => (this.branching = null));
    return this.branching;
  }

  /** Makes sure that inputs act from the moment that is shown; false if the run cannot be brought there. */
  private async isAtCursor(): Promise<boolean> {
    if (this.shown.isBack) await this.branch();
    return !this.shown.isBack;
  }

  /** Waits for pending work; false if another scenario is open then, or the run cannot be brought to the moment that is shown. */
  protected async isReady(): Promise<boolean> {
    const { source } = this;
    do {
      await this.turns.over();
      if (source !== this.source || !(await this.isAtCursor())) return false;
    } while (this.turns.isBusy);
    return true;
  }

  private async goBack(run: Run, recording: Recording, time_s: number): Promise<void> {
    const { values } = this;
    try {
      const restored = rewind(this.client, recording, time_s, values.inForce, (name, value) => values.goBack(name, value));
      const { inputs, frame } = await this.asked(restored);
      run.inputs = inputs;
      recording.dropAfter(frame);
    } catch (fault) {
      this.due = null;
      return this.reportOfRun(fault as Fault);
    }
    this.shown.follow();
    if (this.status === "stopped") this.dismissFault();
    this.become("paused");
    this.emit((listener) => listener.branched?.(run));
    this.emit((listener) => listener.valuesChanged?.());
    this.tellMoment();
  }
}
