import { valueOf } from "../app/address";
import type { Values } from "../engine/engine";

/** Choices of the author of a figure; the address of the figure page holds them. */
export interface FigureChoice {
  /** Name of a scenario of the gallery, or address of a scenario file; null for a run in a link, or for none. */
  scenario: string | null;
  /** Values that override those of the scenario. */
  set: Values;
  /** Names of the parameters and inputs with a control. */
  controls: string[];
  /** Ids of the lines of the plot; empty for no plot. */
  plot: string[];
  /** Viewpoint, by name or by positions; empty for the scenario's first view. */
  camera: string;
  caption: string;
  /** Address of the still; empty for the picture of the gallery. */
  still: string;
  /** Whether the engine is loaded without a touch. */
  isAwake: boolean;
}

const BETWEEN_VALUES = ";";
const BETWEEN_NAMES = ",";

/** Reads the choices in the query of a figure page. */
export function figureBy(search: string): FigureChoice {
  const query = new URLSearchParams(search);
  const text = (name: string) => query.get(name) ?? "";
  return {
    scenario: query.get("scenario"),
    set: Object.assign({}, ...query.getAll("set").map(valuesIn)) as Values,
    controls: namesIn(text("controls")),
    plot: namesIn(text("plot")),
    camera: text("camera"),
    caption: text("caption"),
    still: text("still"),
    isAwake: query.has("awake"),
  };
}

/** Writes choices as the query of a figure page; what is not chosen is left out. */
export function queryOfFigure(choice: Partial<FigureChoice>): string {
  const { scenario, set = {}, controls = [], plot = [], camera = "", caption = "", still = "", isAwake = false } = choice;
  const texts = {
    scenario: scenario ?? "",
    set: textOfValues(set),
    controls: controls.join(BETWEEN_NAMES),
    plot: plot.join(BETWEEN_NAMES),
    camera,
    caption,
    still,
    awake: isAwake ? "1" : "",
  };
  return `?${new URLSearchParams(Object.entries(texts).filter(([, text]) => text !== ""))}`;
}

/** Reads values such as `load=true; crane_x_m=-2.5`; a part without a name is left out. */
export function valuesIn(text: string): Values {
  const parts = text.split(BETWEEN_VALUES).map((part) => /^\s*([^=\s]+)\s*=(.*)$/s.exec(part));
  return Object.fromEntries(parts.flatMap((found) => (found ? [[found[1], valueOf(found[2].trim())]] : [])));
}

export function textOfValues(values: Values): string {
  return Object.entries(values).map(([name, value]) => `${name}=${value}`).join(`${BETWEEN_VALUES} `);
}

/** Reads names with commas between them. */
export function namesIn(text: string): string[] {
  return text.split(BETWEEN_NAMES).map((name) => name.trim()).filter((name) => name !== "");
}

/** Whether a scenario is given by the address of its file, not by its name in the gallery. */
export function isFileAddress(scenario: string): boolean {
  return /\.(ya?ml|json)([?#]|$)/i.test(scenario);
}
