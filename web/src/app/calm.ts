/** Pieces of work that wait for a pause or are under way. */
let due = 0;

/** Whether any such work is left. */
export const isCalm = () => due === 0;

/** Does its work after a pause of what asks for it: another request begins the pause again. */
export class Calm {
  private timer = 0;

  constructor(
    private readonly pause_ms: number,
    private readonly work: () => unknown,
  ) {}

  ask(): void {
    this.cancel();
    due += 1;
    this.timer = window.setTimeout(() => void this.begin(), this.pause_ms);
  }

  cancel(): void {
    if (this.timer === 0) return;
    clearTimeout(this.timer);
    this.timer = 0;
    due -= 1;
  }

  private async begin(): Promise<void> {
    this.timer = 0;
    try {
      await this.work();
    } finally {
      due -= 1;
    }
  }
}
