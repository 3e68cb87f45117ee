import type { Outlook } from "../forecast/outlook";
import type { BackgroundEngine } from "../app/background_engine";
import { Calm } from "../app/calm";
import { onPalette } from "../app/palette";
import type { Run, Session } from "../app/session";
import type { Runs } from "../runs/runs";
import { RunStrip } from "../runs/strip";
import { words } from "../runs/words";
import { texts } from "../texts";
import { byId, make } from "../ui/dom";
import type { Arms } from "./arms_chart";
import { Figures } from "./figures";
import { Picker } from "./picker";
import { Plot } from "./plot";
import type { PlotContext } from "./plot";
import { tool } from "./tool";
import { defaultView, forgetView, keepView, keptView, MOST_PLOTS, plotOf } from "./view";
import type { PlotsView } from "./view";
import { between, ViewDialog } from "./view_dialog";
import { stretchOf, windowLength } from "./window";

/**
 * Pause after the last change before righting arms are computed, and interval between computations during a run, ms.
 */
const CALM_MS = 300;
const ARMS_EVERY_MS = 4000;

/**
 * Plots of the recording: any column over time, as a spectrum or against another column; the choice is stored for each
 * scenario.
 */
export class Plots {
  private readonly list = make("div", { class: "plots-list" });
  private readonly picker = new Picker();
  private readonly dialog: ViewDialog;
  private readonly add: HTMLButtonElement;
  private plots: Plot[] = [];
  private view: PlotsView | null = null;
  private file = "";
  private figures: Figures | null = null;
  private context: PlotContext | null = null;
  private arms: Arms | null = null;
  private outlook: Outlook | null = null;
  private armsAsked_ms = 0;
  private readonly soon = new Calm(CALM_MS, () => this.askArms());

  constructor(
    private readonly session: Session,
    private readonly background: BackgroundEngine,
    private readonly runs: Runs,
    tools: HTMLElement[],
  ) {
    this.dialog = new ViewDialog(() => this.show(), () => this.reset());
    this.add = tool(texts.plots.add, texts.plots.add_plot, "add-plot", "M10 4v12M4 10h12", () => this.append());
    const view = tool(texts.plots.view, texts.plots.view_title, "view-plots", "M3 5h14M3 10h14M3 15h14M7 3v4M13 8v4M9 13v4", () => this.view && this.dialog.open(this.view, () => this.range_s()));
    const tall = tool(texts.plots.tall, texts.plots.tall_plots, "tall-plots", "M10 3v14M6 7l4-4 4 4M6 13l4 4 4-4", () => {
      tall.setAttribute("aria-pressed", String(document.querySelector(".app")!.classList.toggle("has-tall-plots")));
    });
    const keep = tool(words.keep, words.keep_run, "keep-run", "M5 3h10v14l-5-4-5 4z", () => void runs.keep());
    tall.classList.add("wide-tool");
    tall.setAttribute("aria-pressed", "false");
    const toolbar = make("div", { class: "plots-tools", role: "group", "aria-label": texts.plots.title }, this.add, view, keep, ...tools, tall);
    byId("plots").append(toolbar, make("div", { class: "plots-main" }, new RunStrip(runs, session).element, this.list));
    runs.onChange(() => this.plots.forEach((plot) => plot.show()));
    session.listen({
      opened: (run, _frame) => this.open(run),
      advanced: (_run, { rows }) => rows.length > 0 && this.touch(),
      // During a run, new rows update the plots.
      moved: () => session.status !== "running" && this.touch(),
      branched: () => this.askArmsSoon(),
      statusChanged: (status) => status === "paused" && this.askArmsSoon(),
    });
    onPalette(() => this.plots.forEach((plot) => plot.restyle()));
  }

  /** Whether anything was drawn. */
  draw(): boolean {
    if (this.session.status === "running" && performance.now() - this.armsAsked_ms > ARMS_EVERY_MS) void this.askArms();
    return this.plots.filter((plot) => plot.draw()).length > 0;
  }

  foresee(outlook: Outlook | null): void {
    this.outlook = outlook;
    this.touch();
  }

  /** Plots that can be saved as pictures. */
  get shown(): readonly Plot[] {
    return this.plots;
  }

  /** Ids of the lines of the first plot over time. */
  get first(): string[] {
    return this.view?.plots.find(({ kind }) => kind === "time")?.lines ?? [];
  }

  private touch(): void {
    for (const plot of this.plots) plot.touch();
  }

  /** A reset keeps the plots whose lines still exist. */
  private open(run: Run): void {
    this.figures = new Figures(run.model, run.channels);
    this.arms = null;
    const file = this.session.source?.file ?? "";
    const view = keptView(file, this.figures) ?? defaultView(this.figures);
    if (file === this.file && this.view) view.window = this.view.window;
    const isSame = file === this.file && JSON.stringify(view) === JSON.stringify(this.view);
    this.file = file;
    if (isSame) {
      Object.assign(this.context!, { run, figures: this.figures });
      this.plots.forEach((plot) => plot.show());
    } else {
      this.view = view;
      this.build(run);
    }
    this.askArmsSoon();
  }

  private build(run: Run): void {
    this.plots.forEach((plot) => plot.destroy());
    const context = this.contextOf(run);
    this.context = context;
    this.plots = this.view!.plots.map((view, i) => new Plot(view, i + 1, context));
    this.list.replaceChildren(...this.plots.map(({ element }) => element));
    this.list.dataset.count = String(this.plots.length);
    this.add.disabled = this.plots.length >= MOST_PLOTS;
  }

  private rebuild(): void {
    const { run } = this.session;
    if (!run || !this.view) return;
    keepView(this.file, this.view);
    this.build(run);
  }

  /** Shows another range of time, or another unit of angles. */
  private show(): void {
    if (!this.context || !this.view) return;
    keepView(this.file, this.view);
    this.context.angle = this.view.angle;
    this.plots.forEach((plot) => plot.show());
  }

  private contextOf(run: Run): PlotContext {
    return {
      run,
      shown: this.session.shown,
      figures: this.figures!,
      angle: this.view!.angle,
      range_s: () => this.range_s(),
      arms: () => this.arms,
      outlook: () => this.outlook,
      compared: () => ({ runs: this.runs.shown, isDifference: this.runs.comparison === "difference" }),
      chooseRange: ([from_s, to_s]) => {
        this.view!.window = between(from_s, to_s);
        this.show();
      },
      choose: (plot) => this.choose(plot),
      changed: () => keepView(this.file, this.view!),
    };
  }

  /** Returns the visible time. */
  private range_s(): [number, number] {
    const { run, shown } = this.session;
    const { duration_s, record_every_s, step_s } = run!.model;
    const now_s = Math.max(shown.recording?.rows.last?.time_s ?? 0, this.outlook?.end_s ?? 0);
    const { window_s } = windowLength(duration_s, Math.max(record_every_s, step_s));
    return stretchOf(this.view!.window, { now_s, shown_s: shown.time_s, duration_s, window_s });
  }

  private choose(plot: Plot): void {
    const { view, place } = plot;
    const { run } = this.session;
    if (!run) return;
    this.picker.open({
      place,
      view,
      figures: this.figures!,
      hasHulls: run.model.hulls.length > 0,
      changed: () => {
        plot.show();
        keepView(this.file, this.view!);
        this.askArmsSoon();
      },
      remove: () => this.remove(plot),
    });
  }

  private append(): void {
    const { view } = this;
    if (!view || view.plots.length >= MOST_PLOTS) return;
    view.plots.push(plotOf([]));
    this.rebuild();
    const added = this.plots[this.plots.length - 1];
    added.element.scrollIntoView({ block: "nearest" });
    this.choose(added);
  }

  private remove(plot: Plot): void {
    this.view!.plots = this.view!.plots.filter((one) => one !== plot.view);
    this.rebuild();
    this.add.focus();
  }

  private reset(): void {
    const { run } = this.session;
    if (!run || !this.figures) return;
    forgetView(this.file);
    this.view = defaultView(this.figures);
    this.build(run);
  }

  /** Whether a plot shows righting arms: they are computed only then, because this takes longer than many frames. */
  private get needsArms(): boolean {
    return this.session.run !== null && this.session.run.model.hulls.length > 0 && this.view !== null && this.view.plots.some(({ kind }) => kind === "arms");
  }

  private askArmsSoon(): void {
    if (this.needsArms) this.soon.ask();
  }

  private async askArms(): Promise<void> {
    const { run, shown } = this.session;
    this.armsAsked_ms = performance.now();
    if (!this.needsArms) return;
    const time_s = shown.recording!.now.time_s;
    const found = await this.background.hydrostatics(this.session, "plots").catch(() => null);
    if (this.session.run !== run || !found) return;
    this.arms = { found, time_s };
    this.touch();
  }
}
