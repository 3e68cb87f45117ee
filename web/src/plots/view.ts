import { isObject } from "../app/objects";
import type { Figures } from "./figures";
import { MOST_LINES } from "./figures";
import type { Angle } from "./units";
import { FOLLOWING, isWindow } from "./window";
import type { WindowChoice } from "./window";

export const CHART_KINDS = ["time", "spectrum", "phase", "arms"] as const;
/** Kind of a chart: lines over time, their spectrum, one line over another, or righting arms over the heel. */
export type ChartKind = (typeof CHART_KINDS)[number];

/**
 * Smallest numbers of segments for a spectrum that the user can choose: more segments give a smoother spectrum, fewer a
 * finer one.
 */
export const PARTS = [2, 4, 8, 16];

/** Content of one plot. */
export interface PlotView {
  kind: ChartKind;
  /** Ids of the lines of the plot. */
  lines: string[];
  /** Whether the table of statistics is shown below the plot. */
  isTold: boolean;
  parts: number;
}

/** Content of all plots of a scenario. */
export interface PlotsView {
  plots: PlotView[];
  angle: Angle;
  window: WindowChoice;
}

export const MOST_PLOTS = 6;
const KEY = "kingpost.plots.";

export function plotOf(lines: string[], kind: ChartKind = "time"): PlotView {
  return { kind, lines, isTold: false, parts: 8 };
}

export function defaultView(figures: Figures): PlotsView {
  return { plots: figures.defaults().map((lines) => plotOf(lines)), angle: "deg", window: FOLLOWING };
}

/** Stores a view of a scenario; a fixed range of time belongs to the present run and is not stored. */
export function keepView(file: string, view: PlotsView): void {
  const window = view.window.kind === "between" ? FOLLOWING : view.window;
  try {
    localStorage.setItem(KEY + file, JSON.stringify({ ...view, window }));
  } catch {
    // Without storage, the view is valid for this page only.
  }
}

export function forgetView(file: string): void {
  try {
    localStorage.removeItem(KEY + file);
  } catch {
    // Without storage, there is no view to remove.
  }
}

/** Returns the stored view of a scenario, with the lines that still exist; null if there is none. */
export function keptView(file: string, figures: Figures): PlotsView | null {
  try {
    const text = localStorage.getItem(KEY + file);
    return text === null ? null : viewOf(JSON.parse(text), figures);
  } catch {
    return null;
  }
}

/** Checks a stored view, which another version of the app may have written. */
export function viewOf(kept: unknown, figures: Figures): PlotsView | null {
  if (!isObject(kept) || !Array.isArray(kept.plots)) return null;
  const plots = kept.plots.map((plot) => plotFrom(plot, figures)).filter((plot) => plot !== null);
  return {
    plots: plots.slice(0, MOST_PLOTS),
    angle: kept.angle === "rad" ? "rad" : "deg",
    window: isWindow(kept.window) ? kept.window : FOLLOWING,
  };
}

function plotFrom(kept: unknown, figures: Figures): PlotView | null {
  if (!isObject(kept) || !Array.isArray(kept.lines)) return null;
  const lines = kept.lines.filter((id): id is string => typeof id === "string" && figures.line(id) !== undefined).slice(0, MOST_LINES);
  const kind = CHART_KINDS.find((one) => one === kept.kind) ?? "time";
  if (lines.length === 0 && kind !== "arms") return null;
  return { kind, lines, isTold: kept.isTold === true, parts: PARTS.find((one) => one === kept.parts) ?? 8 };
}
