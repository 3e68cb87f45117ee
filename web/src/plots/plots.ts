import type { Frame } from "../engine/messages";
import type { Run, Session } from "../app/session";
import { byId, make } from "../ui/dom";
import { History } from "./history";
import { Plot } from "./plot";
import { kindsOf } from "./quantities";
import type { Unit } from "./quantities";
import { windowLength } from "./window";

/** The live plots: of the ship by default, of any joint or point by choice. */
export class Plots {
  private readonly plots = {
    rates: new Plot(byId("plot-rates"), "rates", "What the first plot shows"),
    angles: new Plot(byId("plot-angles"), "angles", "What the second plot shows"),
  };
  private history = new History(1, 1);
  /** For each column of the history where it stands in a row: one place, or those of a vector whose length it is. */
  private places: number[][] = [];
  private unit: Unit = "deg";

  constructor(session: Session) {
    session.listen({
      opened: (run, frame) => this.open(run, frame),
      advanced: (run, frame) => this.take(run, frame),
    });
    this.addUnitSwitch();
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.each((plot) => plot.restyle()));
  }

  draw(): void {
    this.each((plot) => plot.draw());
  }

  private each(tell: (plot: Plot) => void): void {
    Object.values(this.plots).forEach(tell);
  }

  /** Every column that a figure can show is kept, so that a choice shows what has been. */
  private open(run: Run, frame: Frame): void {
    const { duration_s, record_every_s, step_s } = run.model;
    const kinds = kindsOf(run.model, run.channels);
    const shown = [...kinds.rates, ...kinds.angles].flatMap(({ quantities }) => quantities);
    const parts = new Map([["time", ["time"]], ...shown.map(({ column, lengthOf }) => [column, lengthOf ?? [column]] as const)]);
    const names = [...parts.keys()];
    this.places = [...parts.values()].map((columns) => columns.map((column) => run.columns.at(column)));
    const { window_s, capacity } = windowLength(duration_s, Math.max(record_every_s, step_s), names.length);
    this.history = new History(names.length, capacity);
    this.plots.rates.offer(kinds.rates, this.history, names);
    this.plots.angles.offer(kinds.angles, this.history, names);
    this.each((plot) => plot.setWindow(duration_s, window_s));
    this.take(run, frame);
  }

  private take(run: Run, frame: Frame): void {
    const { width } = run.columns;
    for (let at = 0; at < frame.rows.length; at += width) {
      const value = (place: number) => (place < 0 ? NaN : frame.rows[at + place]);
      this.history.push(this.places.map((places) => (places.length === 1 ? value(places[0]) : Math.hypot(...places.map(value)))));
    }
    if (frame.rows.length > 0) this.each((plot) => plot.touch());
  }

  private addUnitSwitch(): void {
    const labels: [Unit, string][] = [["deg", "Degrees"], ["rad", "Radians"]];
    const buttons = labels.map(([unit, label]) => {
      const button = make("button", { type: "button", "data-testid": `unit-${unit}` }, label);
      button.addEventListener("click", () => {
        this.unit = unit;
        this.each((plot) => plot.setUnit(unit));
        buttons.forEach((other) => other.setAttribute("aria-pressed", String(other === button)));
      });
      return button;
    });
    buttons.forEach((button, i) => button.setAttribute("aria-pressed", String(labels[i][0] === this.unit)));
    byId("plots").prepend(make("div", { class: "segmented units", role: "group", "aria-label": "Units of the plots" }, ...buttons));
  }
}
