import type uPlot from "uplot";
import { onPalette } from "../app/palette";
import { Painted } from "../plots/chart";
import type { PaintedAxes, Style } from "../plots/chart";
import { make } from "../ui/dom";

/** Smallest width and height of a picture that is drawn, pixels. */
const LEAST_PX = 40;

/** Picture of a lesson, repainted when its content, its size or the colours of the page change. */
export abstract class Figure<Content> {
  readonly area = make("div", { class: "lesson-area", role: "img" });
  private chart: Painted | null = null;
  private axes = "";
  private content: Content | null = null;
  private size = "";

  constructor() {
    new ResizeObserver(() => this.redraw()).observe(this.area);
    onPalette(() => {
      this.forget();
      this.redraw();
    });
  }

  /** Draws a content; `name` is its description for screen readers. */
  draw(content: Content, name: string): void {
    this.content = content;
    if (this.area.getAttribute("aria-label") !== name) this.area.setAttribute("aria-label", name);
    this.redraw();
  }

  protected abstract axesOf(content: Content): PaintedAxes;
  /** Returns the ends of the axes: left and right, bottom and top. */
  protected abstract endsOf(content: Content): [[number, number], [number, number]];
  protected abstract paint(u: uPlot, style: Style, content: Content): void;

  private redraw(): void {
    const { area, content } = this;
    if (!content || area.clientWidth < LEAST_PX || area.clientHeight < LEAST_PX) return;
    const axes = this.axesOf(content);
    const names = `${axes.across} ${axes.upwards}`;
    if (names !== this.axes) this.forget();
    this.axes = names;
    this.chart ??= new Painted(area, axes, (u, style) => this.content && this.paint(u, style, this.content));
    const size = `${area.clientWidth} ${area.clientHeight}`;
    if (size !== this.size) this.chart.resize(area.clientWidth, area.clientHeight);
    this.size = size;
    this.chart.fit(...this.endsOf(content));
  }

  private forget(): void {
    this.chart?.destroy();
    this.chart = null;
  }
}
