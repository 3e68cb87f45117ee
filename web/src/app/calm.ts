/** Number of tasks that wait for their pause or are in progress. */
let due = 0;

/** Whether no task waits for its pause or is in progress. */
export const isCalm = () => due === 0;

/** Does a task after a pause that starts with the request; another request starts the pause again. */
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
