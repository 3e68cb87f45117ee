/** Pieces of work that wait for a pause or are under way. */
let due = 0;

/** Whether no such work is left. */
export const isCalm = () => due === 0;

/** Does its work after a pause of what asks for it: another request begins the pause again. */
export class Calm {
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(
    private readonly pause_ms: number,
    private readonly work: () => unknown,
  ) {}

  ask(): void {
    this.cancel();
    due += 1;
    this.timer = setTimeout(() => void this.begin(), this.pause_ms);
  }

  cancel(): void {
    if (this.timer === undefined) return;
    clearTimeout(this.timer);
    this.timer = undefined;
    due -= 1;
  }

  private async begin(): Promise<void> {
    this.timer = undefined;
    try {
      await this.work();
    } finally {
      due -= 1;
    }
  }
}
