import { isClaimed, sent, toFigureOf } from "./protocol";
import type { FromFigure, ToFigure } from "./protocol";

/** Largest number of messages that wait for the page's first one. */
const MOST_WAITING = 100;
/** Origin of a page without one: a file, or a sandbox. Such a page can be addressed by no origin. */
const OPAQUE = "null";

/** The parts of a window that a port uses. */
export interface Framed {
  parent: { postMessage(message: unknown, origin: string): void };
  addEventListener(type: "message", hear: (event: Heard) => void): void;
}

type Heard = Pick<MessageEvent, "data" | "origin" | "source">;

/**
 * The figure's end of the messages. It hears only the window that embeds it, from its first message on only at that
 * message's origin, and answers only there.
 */
export class Port {
  private origin: string | null = null;
  private waiting: FromFigure[] = [];

  constructor(
    private readonly scope: Framed,
    private readonly take: (message: ToFigure) => void,
  ) {
    scope.addEventListener("message", (event) => this.hear(event));
  }

  /** Sends a message; before the page's first message it waits. */
  tell(message: FromFigure): void {
    if (this.origin !== null) return this.scope.parent.postMessage(sent(message), this.origin === OPAQUE ? "*" : this.origin);
    if (this.waiting.length < MOST_WAITING) this.waiting.push(message);
  }

  private hear({ data, origin, source }: Heard): void {
    const { parent } = this.scope;
    const isFramed = parent !== (this.scope as unknown);
    if (!isFramed || source !== (parent as unknown) || (this.origin !== null && origin !== this.origin)) return;
    const message = toFigureOf(data);
    if (message?.kind === "hello") this.begin(origin);
    else if (message && this.origin !== null) this.take(message);
    else if (!message && isClaimed(data)) this.tell({ kind: "error", code: "message", message: "the message is not one of this version of the figure" });
  }

  private begin(origin: string): void {
    this.origin = origin;
    const { waiting } = this;
    this.waiting = [];
    for (const message of [{ kind: "here" } as const, ...waiting]) this.tell(message);
  }
}
