/** Runs tasks one after another, so that an answer cannot belong to another scenario. */
export class Turns {
  private last: Promise<unknown> = Promise.resolve();
  private left = 0;

  /** `through` is called when no task is left. */
  constructor(private readonly through: () => void) {}

  get isBusy(): boolean {
    return this.left > 0;
  }

  /** Resolves when no task is left. */
  async over(): Promise<void> {
    while (this.isBusy) await this.last;
  }

  take<T>(work: () => Promise<T>): Promise<T> {
    this.left += 1;
    const result = this.last.then(work).finally(() => {
      this.left -= 1;
      if (this.left === 0) this.through();
    });
    this.last = result.catch(() => undefined);
    return result;
  }
}

/** Sends values one after another; if several values of one name wait, only the last is sent. */
export class Latest<T> {
  private readonly waiting = new Map<string, T>();

  constructor(private readonly handOn: (name: string, value: T) => Promise<void>) {}

  async set(name: string, value: T): Promise<void> {
    const isUnderWay = this.waiting.size > 0;
    this.waiting.set(name, value);
    if (isUnderWay) return;
    for (let next = this.waiting.entries().next(); !next.done; next = this.waiting.entries().next()) {
      const [due, given] = next.value;
      await this.handOn(due, given);
      if (this.waiting.get(due) === given) this.waiting.delete(due);
    }
  }

  /** Returns the value of a name that is being sent; undefined if there is none. */
  due(name: string): T | undefined {
    return this.waiting.get(name);
  }

  clear(): void {
    this.waiting.clear();
  }
}
