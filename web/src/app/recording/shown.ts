import { Recording, type Moment } from "./recording";

/**
 * The recording of the present run, and the time in it that is shown: the newest time, until the user chooses an
 * earlier one.
 */
export class Shown {
  recording: Recording | null = null;
  private back_s: number | null = null;

  begin(recording: Recording): void {
    this.recording = recording;
    this.follow();
  }

  follow(): void {
    this.back_s = null;
  }

  /** Shows the recorded time nearest to a time. */
  moveTo(time_s: number): void {
    const { recording } = this;
    if (!recording) return;
    const nearest_s = recording.nearest(time_s);
    this.back_s = nearest_s < recording.now.time_s ? nearest_s : null;
  }

  get time_s(): number {
    return this.back_s ?? this.recording?.now.time_s ?? 0;
  }

  /** Whether an earlier moment than the newest is shown. */
  get isBack(): boolean {
    return this.back_s !== null;
  }

  get moment(): Moment | null {
    return this.recording?.at(this.time_s) ?? null;
  }
}
