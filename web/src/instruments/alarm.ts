const KEY = "kingpost.alarm";
/** Frequency, Hz, and durations, s, of the alarm: three short beeps. */
const PITCH_HZ = 880;
const BEEP_S = 0.14;
const EVERY_S = 0.24;
const BEEPS = 3;

/** Sound for an exceeded limit; the choice to mute it is stored. */
export class Alarm {
  private context: AudioContext | null = null;

  /** Whether the alarm is muted; it is not if storage is denied. */
  get isMuted(): boolean {
    try {
      return localStorage.getItem(KEY) === "muted";
    } catch {
      return false;
    }
  }

  mute(isMuted: boolean): void {
    try {
      localStorage.setItem(KEY, isMuted ? "muted" : "on");
    } catch {
      // Without storage, the choice is valid for this page only.
    }
  }

  /** Sounds the alarm. A browser plays no sound before the user has touched the page. */
  sound(): void {
    if (this.isMuted || !navigator.userActivation?.hasBeenActive) return;
    this.context ??= new AudioContext();
    const { context } = this;
    for (let k = 0; k < BEEPS; k++) beep(context, context.currentTime + k * EVERY_S);
  }
}

function beep(context: AudioContext, from_s: number): void {
  const tone = new OscillatorNode(context, { type: "triangle", frequency: PITCH_HZ });
  const volume = new GainNode(context, { gain: 0 });
  volume.gain.setTargetAtTime(0.2, from_s, 0.01);
  volume.gain.setTargetAtTime(0, from_s + BEEP_S, 0.02);
  tone.connect(volume).connect(context.destination);
  tone.start(from_s);
  tone.stop(from_s + 2 * BEEP_S);
}
