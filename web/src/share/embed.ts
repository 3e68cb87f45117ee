import { FIGURE_PAGE } from "../app/address";
import { queryOfFigure, textOfValues } from "../figure/address";
import type { FigureChoice } from "../figure/address";
import type { SharedRun } from "./shared_run";

/** A figure to embed: what it shows, and the part of a run's link from the `#` on; empty for a scenario by its name. */
export interface Embedded extends Pick<FigureChoice, "scenario" | "set" | "controls" | "plot" | "camera" | "caption"> {
  hash: string;
}

/** Plot and viewpoint that the app shows at present. */
export interface Shown {
  plot: string[];
  camera: string;
}

/**
 * Returns the figure of a run. A scenario of the gallery without changes by hand is given by its name and the values of
 * the run; any other run by its link.
 */
export function figureOf({ scenario, values, changes }: SharedRun, title: string, { plot, camera }: Shown, hash: string): Embedded {
  const shown = { plot, camera: camera === "free" ? "" : camera, caption: title };
  if (!("gallery" in scenario) || changes.length > 0) return { ...shown, scenario: null, set: {}, controls: [], hash };
  return { ...shown, scenario: scenario.gallery, set: values, controls: Object.keys(values).filter((name) => !name.includes(".")), hash: "" };
}

/** Size of a plain frame, pixels: it cannot follow its content. The plot and each control need their own height. */
const FRAME = { width: 640, picture: 400, plot: 190, control: 60 };

/** Returns the HTML of the element `<kingpost-figure>` and of its script, for an app at this address. */
export function elementFor(figure: Embedded, app: string): string {
  const attributes = {
    src: app,
    scenario: figure.scenario ?? "",
    set: textOfValues(figure.set),
    controls: figure.controls.join(", "),
    plot: figure.plot.join(", "),
    camera: figure.camera,
    caption: figure.caption,
    run: figure.hash.replace(/^#/, ""),
  };
  const lines = Object.entries(attributes).filter(([, text]) => text !== "").map(([name, text]) => `\n  ${name}="${escaped(text)}"`);
  return `<script src="${escaped(app)}kingpost-figure.js" async></script>\n<kingpost-figure${lines.join("")}\n></kingpost-figure>`;
}

/** Returns the HTML of a plain frame, for pages that allow no scripts. */
export function frameFor(figure: Embedded, app: string): string {
  const height = FRAME.picture + (figure.plot.length > 0 ? FRAME.plot : 0) + FRAME.control * (figure.controls.length + 1);
  const address = `${app}${FIGURE_PAGE}${queryOfFigure(figure)}${figure.hash}`;
  return `<iframe src="${escaped(address)}" title="${escaped(figure.caption)}" width="${FRAME.width}" height="${height}" loading="lazy" style="border: 0; max-width: 100%"></iframe>`;
}

/** Escapes a text for an attribute in double quotes. */
function escaped(text: string): string {
  return text.replaceAll("&", "&amp;").replaceAll('"', "&quot;").replaceAll("<", "&lt;").replaceAll(">", "&gt;");
}
