import { fromFigureOf, sent } from "../../src/figure/protocol";
import type { FromFigure, ToFigure } from "../../src/figure/protocol";

/** The window of a figure, as the page around it uses it. */
export interface FigureWindow {
  postMessage(message: unknown, origin: string): void;
}

type Heard = Pick<MessageEvent, "data" | "origin" | "source">;

/** The page's end of the messages to one figure. It sends only to the origin of the app, and hears only its window. */
export class Link {
  private isThere = false;
  private waiting: ToFigure[] = [];

  constructor(
    private readonly figure: () => FigureWindow | null,
    private readonly origin: string,
    private readonly take: (message: FromFigure) => void,
  ) {}

  /** Greets a figure whose page has loaded. */
  greet(): void {
    this.isThere = false;
    this.post({ kind: "hello" });
  }

  /** Sends a message; before the figure has answered it waits. */
  send(message: ToFigure): void {
    if (this.isThere) this.post(message);
    else this.waiting.push(message);
  }

  /** Takes a message to the window, if it comes from the figure; one of another form is refused. */
  hear({ data, origin, source }: Heard): void {
    const figure = this.figure();
    if (figure === null || source !== (figure as unknown) || origin !== this.origin) return;
    const message = fromFigureOf(data);
    if (message?.kind === "here") this.begin();
    else if (message) this.take(message);
  }

  /** Whether the figure has answered. */
  get hasAnswered(): boolean {
    return this.isThere;
  }

  private begin(): void {
    this.isThere = true;
    const { waiting } = this;
    this.waiting = [];
    for (const message of waiting) this.post(message);
  }

  private post(message: ToFigure): void {
    this.figure()?.postMessage(sent(message), this.origin);
  }
}
