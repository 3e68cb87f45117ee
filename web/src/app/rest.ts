/**
 * Number of successive frames without a change after which the page is at rest: the browser reports a new size or theme
 * of the page at its next frame, and the frame after that draws it.
 */
const FRAMES = 3;

/** Waits until the page shows everything that was requested, for tests and pictures. */
export class Rest {
  private readonly waiting: { left: number; tell: () => void }[] = [];

  /** Counts a frame; `isStill`: it drew nothing new, and no task waits. */
  frame(isStill: boolean): void {
    for (const one of this.waiting) one.left = isStill ? one.left - 1 : FRAMES;
    while (this.waiting.length > 0 && this.waiting[0].left <= 0) this.waiting.shift()!.tell();
  }

  reached(): Promise<void> {
    return new Promise((tell) => this.waiting.push({ left: FRAMES, tell }));
  }
}
