import { onPalette } from "../app/palette";
import type { Run, Session } from "../app/session";
import type { Content } from "../plots/chart";
import { coloursOf, DrawnLine } from "../plots/drawn";
import { Fan } from "../plots/fan";
import { Figures, MOST_LINES, titleAndLabels } from "../plots/figures";
import { swatch } from "../plots/plot";
import { read, Stretch } from "../plots/stretch";
import { TimeChart } from "../plots/time_chart";
import { FOLLOWING, stretchOf, windowLength } from "../plots/window";
import { texts } from "../texts";
import { make, setText } from "../ui/dom";
import { words } from "./words";

/** The plot of a figure: the lines that the author chose, over time. */
export class Graph {
  private readonly area = make("div", { class: "plot-area", role: "img" });
  private readonly chart = new TimeChart(this.area, () => undefined);
  private readonly stretch = new Stretch();
  private readonly fan = new Fan();
  private lines: DrawnLine[] = [];
  private values: HTMLElement[] = [];
  private isStale = true;

  constructor(
    private readonly element: HTMLElement,
    private readonly session: Session,
    private readonly ids: readonly string[],
    /** Reports lines that the run does not have. */
    private readonly refuse: (message: string) => void,
  ) {
    session.listen({
      opened: (run) => this.open(run),
      advanced: () => (this.isStale = true),
      moved: () => (this.isStale = true),
    });
    onPalette(() => this.renew());
    new ResizeObserver(([{ contentRect }]) => {
      this.chart.resize(contentRect.width, contentRect.height);
      this.isStale = true;
    }).observe(this.area);
  }

  private open(run: Run): void {
    const figures = new Figures(run.model, run.channels);
    const known = this.ids.filter((id) => figures.line(id));
    const [unknown] = this.ids.filter((id) => !known.includes(id));
    if (unknown !== undefined) this.refuse(words.unknown(unknown, figures.lines.map(({ id }) => id).join(", ")));
    const chosen = known.slice(0, MOST_LINES).map((id) => figures.line(id)!);
    const { title, labels } = titleAndLabels(chosen, figures.ofLines(known));
    const colours = coloursOf(chosen);
    this.lines = chosen.map((line, i) => new DrawnLine(line, labels[i], colours[i], run.columns, "deg", run.model.limits));
    this.values = this.lines.map(() => make("span", { class: "plot-value" }));
    const entries = this.lines.map(({ colour, label, shown }, i) => make("span", { class: "plot-entry" }, swatch(colour), label, this.values[i], make("span", { class: "plot-unit" }, ` ${shown.unit}`)));
    this.area.setAttribute("aria-label", texts.plots.over_time(title));
    this.element.hidden = this.lines.length === 0;
    this.element.replaceChildren(make("figcaption", {}, make("strong", {}, title), make("span", { class: "plot-legend" }, ...entries)), this.area);
    this.renew();
  }

  private renew(): void {
    this.chart.destroy();
    this.isStale = true;
  }

  /** Draws the plot if something has changed. */
  draw(): void {
    const { area, chart, session } = this;
    if (!this.isStale || this.lines.length === 0 || !session.run || area.clientWidth === 0) return;
    this.isStale = false;
    const content = this.content(session.run);
    chart.draw(content);
    const columns = content.stretch.data.slice(1);
    this.lines.forEach((line, i) => (line.largest = columns[i].reduce((most, value) => Math.max(most, Math.abs(value) || 0), 0)));
    chart.values(content).forEach((value, i) => setText(this.values[i], value));
  }

  private content({ model }: Run): Content {
    const { fan, lines, session, stretch } = this;
    const { shown } = session;
    const { duration_s, record_every_s, step_s } = model;
    const rows = shown.recording?.rows;
    const { window_s } = windowLength(duration_s, Math.max(record_every_s, step_s));
    const range_s = stretchOf(FOLLOWING, { now_s: rows?.last?.time_s ?? 0, shown_s: shown.time_s, duration_s, window_s });
    const from = Math.max(0, rows?.indexAt(range_s[0]) ?? 0);
    stretch.fill(rows?.items ?? [], rows ? [from, Math.max(from, rows.indexAt(range_s[1]) + 1)] : [0, 0], lines.map(({ places }) => places), (value, i) => lines[i].scaled(value));
    const { row = [], time_s: row_s = 0 } = rows?.around(shown.time_s)[0] ?? {};
    return { lines, stretch, fan, others: null, range_s, shown_s: shown.time_s, isBack: shown.isBack, row_s, now: (line) => line.scaled(read(row, line.places)) };
  }
}
