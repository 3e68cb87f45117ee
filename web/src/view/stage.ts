import type { Moment, Recording } from "../app/recording/recording";
import type { Run } from "../app/run";
import type { Size } from "./size";
import { Tensions } from "./tension";
import type { View } from "./view";

/** Draws moments of a recording in a fixed size, each independent of the clock, the page and other moments. */
export class Stage {
  private readonly tensions: Tensions;

  /** Throws a TooLargeError if the graphics card cannot draw the size. */
  constructor(
    private readonly view: View,
    run: Run,
    recording: Recording,
    size: Size,
    /** Shows what a moment has beside its poses, its sea and its tensions. */
    private readonly complete: (moment: Moment) => void,
    private readonly ended: () => void,
  ) {
    this.tensions = new Tensions(run.lines, run.channels);
    for (const { row } of recording.rows.items) this.tensions.read(row);
    view.hold(size);
  }

  /** Returns the picture of a moment; copy it at once, because a browser soon clears it. */
  draw(moment: Moment): HTMLCanvasElement {
    const { tensions, view } = this;
    view.showTensions(tensions.tints(moment.row));
    this.complete(moment);
    return view.still(moment, moment.surface, moment.time_s);
  }

  /** Whether the browser has dropped the graphics, so that the last picture may be empty. */
  get isLost(): boolean {
    return this.view.isLost;
  }

  /** Returns the picture to the page. */
  end(): void {
    this.view.letGo();
    this.ended();
  }
}
