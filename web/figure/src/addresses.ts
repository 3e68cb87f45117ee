import { FIGURE_PAGE } from "../../src/app/address";
import { isFileAddress, namesIn, queryOfFigure, valuesIn } from "../../src/figure/address";

/** Attributes of a figure; null for one that is missing. */
export type Attribute = (name: string) => string | null;

/** Returns the address of the figure page for the attributes of an element, on a page with the address `base`. */
export function pageOf(attribute: Attribute, app: string, base: string): string {
  const scenario = attribute("scenario");
  const choice = {
    scenario: scenario !== null && isFileAddress(scenario) ? new URL(scenario, base).href : scenario,
    set: valuesIn(attribute("set") ?? ""),
    controls: namesIn(attribute("controls") ?? ""),
    plot: namesIn(attribute("plot") ?? ""),
    camera: attribute("camera") ?? "",
    isAwake: true,
  };
  const run = attribute("run");
  return new URL(FIGURE_PAGE + queryOfFigure(choice) + (run ? `#${run.replace(/^#/, "")}` : ""), app).href;
}

/** Returns the address of the still: the author's, or the gallery's picture of the scenario; empty for none. */
export function stillOf(attribute: Attribute, app: string, base: string): string {
  const [poster, scenario] = [attribute("poster"), attribute("scenario")];
  if (poster) return new URL(poster, base).href;
  if (scenario === null || scenario === "" || isFileAddress(scenario)) return "";
  return new URL(`cards/${encodeURIComponent(scenario)}.webp`, app).href;
}

/** Returns the address of the app's folder, with a slash at the end; null if it is not known. */
export function appOf(src: string | null, script: string | null, base: string): string | null {
  if (src !== null) return new URL(src.endsWith("/") || src === "" ? src : `${src}/`, base).href;
  return script === null ? null : new URL("./", script).href;
}
