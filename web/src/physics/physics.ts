import type { BackgroundEngine } from "../app/background_engine";
import type { Run, Session } from "../app/session";
import { texts } from "../texts";
import { byId, make } from "../ui/dom";
import { isPanelOpen, offerPanel, onPanelOpened } from "../ui/switcher";
import { LossLesson } from "./loss";
import { ResonanceLesson } from "./resonance";
import type { Periods } from "./periods";

/** A lesson, as the panel uses it. */
interface Lesson {
  readonly element: HTMLElement;
  /** Called when another run begins. */
  open(run: Run): void;
  /** Called when another moment is shown and the panel is visible. */
  show(): void;
}

/** Lessons on the physics of a ship with a crane, each with a run to try it on. */
export class PhysicsPanel {
  private readonly lessons: Record<keyof typeof texts.physics.lessons, Lesson>;
  private chosen: keyof typeof texts.physics.lessons = "loss";
  private isStale = true;

  constructor(
    private readonly session: Session,
    background: BackgroundEngine,
    periods: Periods,
  ) {
    this.lessons = { loss: new LossLesson(session, background), resonance: new ResonanceLesson(session, periods) };
    const choice = make("div", { class: "segmented lesson-choice", role: "group", "aria-label": texts.physics.lesson });
    for (const key of ["loss", "resonance"] as const) {
      const state = { "aria-pressed": String(key === this.chosen), "data-testid": `show-lesson-${key}` };
      const button = make("button", { type: "button", ...state }, texts.physics.lessons[key]);
      button.addEventListener("click", () => this.choose(key, choice));
      choice.append(button);
    }
    byId("physics").append(make("h2", { class: "visually-hidden" }, texts.physics.title), choice, ...Object.values(this.lessons).map(({ element }) => element));
    this.showChosen();
    session.listen({
      opened: (run) => this.open(run),
      advanced: () => this.touch(),
      moved: () => this.touch(),
      branched: () => this.touch(),
      inputsChanged: () => this.touch(),
      valuesChanged: () => this.touch(),
      statusChanged: () => this.touch(),
    });
    onPanelOpened("physics", () => this.look());
  }

  /** Draws the visible lesson with each picture, if something is new. */
  draw(): void {
    if (!this.isStale || !isPanelOpen("physics") || !this.session.run) return;
    this.isStale = false;
    this.lessons[this.chosen].show();
  }

  private open(run: Run): void {
    for (const lesson of Object.values(this.lessons)) lesson.open(run);
    offerPanel("physics", true);
    this.touch();
  }

  private choose(key: typeof this.chosen, choice: HTMLElement): void {
    this.chosen = key;
    [...choice.children].forEach((button, k) => button.setAttribute("aria-pressed", String(Object.keys(this.lessons)[k] === key)));
    this.showChosen();
    this.look();
  }

  /** Shows the chosen lesson at once, without waiting for the next picture. */
  private look(): void {
    this.touch();
    this.draw();
  }

  private showChosen(): void {
    for (const [key, { element }] of Object.entries(this.lessons)) element.hidden = key !== this.chosen;
  }

  private touch(): void {
    this.isStale = true;
  }
}
