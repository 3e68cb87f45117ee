const KEY = "kingpost.alarm";
/** Frequency, Hz, and times, s, of the alarm: three short beeps. */
const PITCH_HZ = 880;
const BEEP_S = 0.14;
const EVERY_S = 0.24;
const BEEPS = 3;

/** A sound when a limit is exceeded; it can be muted, which is remembered. */
export class Alarm {
  private context: AudioContext | null = null;

  /** Without storage it is not muted. */
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
      // Without storage it holds for this page only.
    }
  }

  /** Browsers give no sound before the person has touched the page. */
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
