/** Frames without anything new: the browser tells of another size or theme of the page at its next frame, and the one after draws it. */
const FRAMES = 3;

/** Says when the page shows all that was asked of it, for tests and pictures. */
export class Rest {
  private readonly waiting: { left: number; tell: () => void }[] = [];

  /** A frame has passed; `isStill`: it drew nothing new, and nothing is due. */
  frame(isStill: boolean): void {
    for (const one of this.waiting) one.left = isStill ? one.left - 1 : FRAMES;
    while (this.waiting.length > 0 && this.waiting[0].left <= 0) this.waiting.shift()!.tell();
  }

  reached(): Promise<void> {
    return new Promise((tell) => this.waiting.push({ left: FRAMES, tell }));
  }
}
