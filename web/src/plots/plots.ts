import type { Outlook } from "../ahead/outlook";
import { onPalette } from "../app/palette";
import type { Run, Session } from "../app/session";
import { byId, make } from "../ui/dom";
import { Plot } from "./plot";
import { kindsOf } from "./quantities";
import type { FigureKey, Unit } from "./quantities";
import { windowLength } from "./window";

/** The plots of the recording: of the ship by default, of any joint or point by choice. */
export class Plots {
  private readonly plots: Record<FigureKey, Plot>;
  private unit: Unit = "deg";

  constructor(session: Session) {
    const { shown } = session;
    this.plots = {
      rates: new Plot(byId("plot-rates"), "rates", "What the first plot shows", shown),
      angles: new Plot(byId("plot-angles"), "angles", "What the second plot shows", shown),
    };
    session.listen({
      opened: (run) => this.open(run),
      advanced: (_run, { rows }) => rows.length > 0 && this.each((plot) => plot.touch()),
      // Of what is newest the rows tell.
      moved: () => session.status !== "running" && this.each((plot) => plot.touch()),
    });
    this.addUnitSwitch();
    onPalette(() => this.each((plot) => plot.restyle()));
  }

  draw(): void {
    this.each((plot) => plot.draw());
  }

  foresee(outlook: Outlook | null): void {
    this.each((plot) => plot.foresee(outlook));
  }

  private each(tell: (plot: Plot) => void): void {
    Object.values(this.plots).forEach(tell);
  }

  private open({ model, channels, columns }: Run): void {
    const { duration_s, record_every_s, step_s } = model;
    const kinds = kindsOf(model, channels);
    this.plots.rates.offer(kinds.rates, columns);
    this.plots.angles.offer(kinds.angles, columns);
    const { window_s } = windowLength(duration_s, Math.max(record_every_s, step_s));
    this.each((plot) => plot.setWindow(duration_s, window_s));
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
