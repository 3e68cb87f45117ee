import type uPlot from "uplot";
import { dot, endsOf, fill, stroke } from "../plots/chart";
import type { PaintedAxes, Style } from "../plots/chart";
import { texts } from "../texts";
import { Figure } from "./figure";
import type { PeriodLine, Place } from "./modes";
import type { SeaSpectrum } from "./sea_spectrum";

/** Colours of the theme, for the modes and for the sea. */
export const MODE_COLOURS = ["roll", "yaw", "line-4", "line-5", "line-6", "line-8", "pitch"];
export const SEA_COLOUR = "line-7";
/** Share of the chart's width that the peak of the sea's spectrum takes. */
const SEA_SHARE = 0.3;
/** Smallest drawn density of the sea's spectrum, relative to its peak. */
const FAINT = 0.02;
const MARGIN = 1.06;

/**
 * Natural periods over the varied parameter, the spectrum of the sea, the present value, and the points at which a
 * period equals the peak period.
 */
export interface PeriodsContent {
  axis: string;
  range: [number, number];
  lines: readonly PeriodLine[];
  sea: SeaSpectrum | null;
  now: number | null;
  met: readonly Place[];
}

/**
 * Chart of natural periods over a parameter; the spectrum of the sea is drawn on the right, on the same axis of
 * periods.
 */
export class PeriodsChart extends Figure<PeriodsContent> {
  protected axesOf({ axis }: PeriodsContent): PaintedAxes {
    return { across: axis, upwards: texts.resonance.period_axis };
  }

  protected endsOf({ range, lines, sea }: PeriodsContent): [[number, number], [number, number]] {
    const periods = lines.flatMap(({ places }) => places.map(({ period_s }) => period_s));
    const seen = sea ? sea.period_s.filter((_, k) => sea.density[k] > FAINT) : [];
    return [range, [0, MARGIN * Math.max(1, ...periods, ...seen)]];
  }

  protected paint(u: uPlot, style: Style, { lines, sea, now, met }: PeriodsContent): void {
    const [left, right, bottom, top] = endsOf(u);
    if (sea) {
      const from = (density: number) => right - SEA_SHARE * (right - left) * density;
      const curve = sea.period_s.map((period_s, k): [number, number] => [from(sea.density[k]), period_s]);
      const seen = curve.filter(([, period_s]) => period_s <= top);
      fill(u, [[right, seen[0][1]], ...seen, [right, seen[seen.length - 1][1]]], "y", style.colour(SEA_COLOUR));
      stroke(u, [[left, sea.peak_s], [right, sea.peak_s]], "y", { colour: style.colour(SEA_COLOUR), width: 1.5, dash: [6, 4] });
    }
    if (now !== null) stroke(u, [[now, bottom], [now, top]], "y", { colour: style.colour("accent"), width: 1.5, dash: [4, 3] });
    lines.forEach(({ places }, k) => {
      const colour = style.colour(colourOf(k));
      const points = places.map(({ value, period_s }): [number, number] => [value, period_s]);
      stroke(u, points, "y", { colour, width: 2 });
      if (points.length === 1) dot(u, points[0], "y", colour, style.colour("surface"));
    });
    for (const { value, period_s } of met) dot(u, [value, period_s], "y", style.colour("accent"), style.colour("surface"));
  }
}

export function colourOf(line: number): string {
  return MODE_COLOURS[line % MODE_COLOURS.length];
}
