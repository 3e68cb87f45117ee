import type { Session } from "../app/session";
import { texts } from "../texts";
import { byId } from "../ui/dom";
import { follow, showLosses } from "../view/scene";
import { Tensions } from "../view/tension";
import { View } from "../view/view";
import { CAMERAS } from "../view/viewpoint";
import { words } from "./words";

/** The 3D picture of a figure; without WebGL it shows a message, and the rest of the figure works. */
export class Picture {
  private readonly view: View | null = this.viewIn(byId("canvas", HTMLCanvasElement));
  private readonly timeOfPicture: () => number;
  private tensions: Tensions | null = null;
  private drawn: unknown = null;

  constructor(
    private readonly session: Session,
    /** Viewpoint of a scenario that has just opened; empty for the first view. */
    camera: string,
    /** Reports a viewpoint that is not possible. */
    private readonly refuse: (message: string) => void,
  ) {
    session.listen({
      opened: (run, frame, isAnother) => {
        const { view } = this;
        if (!view) return;
        this.tensions = new Tensions(run.lines, run.channels);
        view.showTensions([]);
        view.build(run, frame, isAnother);
        view.showTensions(this.tensions.read(frame.row));
        view.showLevels((column) => run.columns.read(frame.row, column));
        view.showSea(frame.surface);
        if (isAnother && camera !== "") this.look(camera);
      },
    });
    this.timeOfPicture = follow(session);
  }

  private viewIn(canvas: HTMLCanvasElement): View | null {
    try {
      const view = new View(canvas);
      showLosses(canvas, view);
      leaveScrolling(canvas);
      return view;
    } catch {
      const message = byId("scene-message");
      message.hidden = false;
      message.textContent = texts.picture.no_graphics;
      return null;
    }
  }

  /** Changes the viewpoint. */
  look(camera: string): void {
    const { view } = this;
    if (!view || view.lookBy(camera)) return;
    this.refuse(words.no_camera(camera, (this.session.run ? view.cameras() : CAMERAS).join(", ")));
  }

  /** Draws the picture if something has changed. */
  draw(): void {
    const { session, view } = this;
    const moment = session.shown.recording?.at(this.timeOfPicture());
    if (!view) return;
    if (moment && moment.poses !== this.drawn) {
      view.show(moment);
      view.showSea(moment.surface);
      view.showLevels((column) => session.run?.columns.read(moment.row, column) ?? NaN);
      if (this.tensions) view.showTensions(this.tensions.read(moment.row));
      this.drawn = moment.poses;
    }
    view.draw();
  }
}

/**
 * Leaves the wheel and vertical swipes to the article: the wheel zooms only in a picture that has the focus.
 */
function leaveScrolling(canvas: HTMLCanvasElement): void {
  canvas.style.touchAction = "pan-y";
  const keep = (event: WheelEvent) => {
    if (!event.ctrlKey && document.activeElement !== canvas) event.stopPropagation();
  };
  canvas.parentElement!.addEventListener("wheel", keep, { capture: true, passive: true });
}
