import { make } from "../ui/dom";
import { ALLOWED, FORMATS, SIZES, sizeOf } from "./choice";
import type { FilmChoice, Format } from "./choice";
import { words } from "./words";

const FRAMES_PER_S = ["24", "25", "30", "50", "60"];
const SPEEDS = ["0.25", "0.5", "1", "2", "5", "10"];
const DEFAULT = { size: SIZES[0], frames_per_s: "30", speed: "1" };

/** Fields of the dialog of films. */
export class Fields {
  readonly element = make("fieldset", { class: "film-fields" });
  private readonly from = number("film-from", "0");
  private readonly to = number("film-to", "0");
  private readonly size = make("input", { type: "text", value: DEFAULT.size, inputmode: "text", autocomplete: "off", ...listed("film-size") });
  private readonly frames_per_s = make("input", { type: "number", step: "any", value: DEFAULT.frames_per_s, ...listed("film-frames") });
  private readonly speed = make("input", { type: "number", step: "any", value: DEFAULT.speed, ...listed("film-speed") });
  private readonly format = make("select", { "data-testid": "film-format" });
  private readonly plots = make("input", { type: "checkbox", checked: true, "data-testid": "film-plots" });
  private readonly plotsLabel = make("span", {}, words.plots);
  private readonly caption = make("input", { type: "text", maxlength: ALLOWED.caption, "data-testid": "film-caption" });
  private formats: readonly Format[] = [];

  constructor(changed: () => void) {
    const lists = [optionsOf("film-size", SIZES), optionsOf("film-frames", FRAMES_PER_S), optionsOf("film-speed", SPEEDS)];
    const rows = [
      [words.from, this.from],
      [words.to, this.to],
      [words.size, this.size],
      [words.frames_per_s, this.frames_per_s],
      [words.speed, this.speed],
      [words.format, this.format],
      [words.caption, this.caption],
    ] as const;
    const labels = rows.map(([label, input]) => make("label", { class: "film-field" }, make("span", {}, label), input));
    const help = make("p", { class: "muted", id: "film-caption-help" }, words.caption_help);
    this.caption.setAttribute("aria-describedby", "film-caption-help");
    this.element.append(...labels, help, make("label", { class: "film-tick" }, this.plots, this.plotsLabel), ...lists);
    this.element.addEventListener("input", changed);
  }

  /** Prepares the fields for a recording that ends at `end_s`. */
  offer(end_s: number, plots: string, hasPlots: boolean): void {
    const end = String(Number(end_s.toFixed(3)));
    if (!(Number(this.to.value) > 0 && Number(this.to.value) <= end_s)) this.to.value = end;
    if (Number(this.from.value) >= Number(this.to.value)) this.from.value = "0";
    this.plotsLabel.textContent = plots;
    this.plots.disabled = !hasPlots;
  }

  /** Offers the formats that can be encoded; all of them if none can, so that the reason is reported when one is made. */
  offerFormats(formats: readonly Format[]): void {
    const offered = formats.length > 0 ? formats : FORMATS;
    if (offered.join() === this.formats.join()) return;
    const chosen = this.format.value;
    this.formats = offered;
    this.format.replaceChildren(...offered.map((format) => make("option", { value: format, selected: format === chosen }, words.formats[format])));
  }

  /** Choices as they are written; a number that is missing is NaN, and a size that cannot be read is 0x0. */
  get choice(): FilmChoice {
    return {
      format: FORMATS.find((format) => format === this.format.value) ?? FORMATS[0],
      from_s: this.from.valueAsNumber,
      to_s: this.to.valueAsNumber,
      frames_per_s: this.frames_per_s.valueAsNumber,
      speed: this.speed.valueAsNumber,
      size: sizeOf(this.size.value) ?? { width: 0, height: 0 },
      hasPlots: this.plots.checked && !this.plots.disabled,
      caption: this.caption.value.trim(),
    };
  }
}

function number(testId: string, value: string): HTMLInputElement {
  return make("input", { type: "number", step: "any", min: 0, value, "data-testid": testId });
}

const listed = (testId: string) => ({ list: `${testId}-list`, "data-testid": testId });

function optionsOf(testId: string, values: readonly string[]): HTMLElement {
  return make("datalist", { id: `${testId}-list` }, ...values.map((value) => make("option", { value })));
}
