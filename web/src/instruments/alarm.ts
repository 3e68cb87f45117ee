const KEY = "kingpost.alarm";
/** Of the alarm's tone, Hz and s: three short beeps. */
const PITCH_HZ = 880;
const BEEP_S = 0.14;
const EVERY_S = 0.24;
const BEEPS = 3;

/** A sound for a limit that is exceeded; it can be muted, and stays so. */
export class Alarm {
  private context: AudioContext | null = null;

  /** Where storage is denied, it sounds. */
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
      // It holds for this page only where nothing can be kept.
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
