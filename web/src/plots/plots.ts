import type { Frame } from "../engine/messages";
import type { Run, Session } from "../app/session";
import { byId, make } from "../ui/dom";
import { History } from "./history";
import { Plot } from "./plot";
import { PLOTS } from "./quantities";
import type { Unit } from "./quantities";
import { windowLength } from "./window";

const QUANTITIES = PLOTS.flatMap((kind) => kind.quantities);

/** The live plots of the first body, which is the ship. */
export class Plots {
  private plots: Plot[] = [];
  private history = new History(1, 1);
  private places: number[] = [];
  private unit: Unit = "deg";

  constructor(session: Session) {
    session.listen({
      opened: (run, frame) => this.open(run, frame),
      advanced: (run, frame) => this.take(run, frame),
    });
    this.addUnitSwitch();
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.plots.forEach((plot) => plot.restyle()));
  }

  draw(): void {
    for (const plot of this.plots) plot.draw();
  }

  private open(run: Run, frame: Frame): void {
    const { duration_s, record_every_s, step_s } = run.model;
    const { window_s, capacity } = windowLength(duration_s, Math.max(record_every_s, step_s));
    const body = run.model.bodies[0]?.name ?? "";
    this.places = [run.columns.at("time"), ...QUANTITIES.map(({ column }) => run.columns.at(`${body}.${column}`))];
    if (this.plots.length === 0 || this.history.capacity !== capacity) this.build(capacity);
    this.history.clear();
    for (const plot of this.plots) plot.setWindow(duration_s, window_s);
    this.take(run, frame);
  }

  private build(capacity: number): void {
    this.history = new History(1 + QUANTITIES.length, capacity);
    this.plots.forEach((plot) => plot.restyle());
    let column = 1;
    this.plots = PLOTS.map((kind) => {
      const columns = kind.quantities.map(() => column++);
      const plot = new Plot(byId(`plot-${kind.key}`), kind, this.history, columns);
      plot.setUnit(this.unit);
      return plot;
    });
  }

  private take(run: Run, frame: Frame): void {
    const { width } = run.columns;
    for (let at = 0; at < frame.rows.length; at += width) {
      this.history.push(this.places.map((place) => (place < 0 ? NaN : frame.rows[at + place])));
    }
    if (frame.rows.length > 0) this.plots.forEach((plot) => plot.touch());
  }

  private addUnitSwitch(): void {
    const labels: [Unit, string][] = [["deg", "Degrees"], ["rad", "Radians"]];
    const buttons = labels.map(([unit, label]) => {
      const button = make("button", { type: "button", "data-testid": `unit-${unit}` }, label);
      button.addEventListener("click", () => {
        this.unit = unit;
        this.plots.forEach((plot) => plot.setUnit(unit));
        buttons.forEach((other) => other.setAttribute("aria-pressed", String(other === button)));
      });
      return button;
    });
    buttons.forEach((button, i) => button.setAttribute("aria-pressed", String(labels[i][0] === this.unit)));
    byId("plots").prepend(make("div", { class: "segmented units", role: "group", "aria-label": "Units of the plots" }, ...buttons));
  }
}
