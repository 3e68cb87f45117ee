import { fixed } from "../app/format";
import type { ParameterInfo } from "../engine/engine";
import { inWords } from "../plots/lines";
import { swatch } from "../plots/plot";
import { texts } from "../texts";
import { make } from "../ui/dom";
import { closest, crossings } from "./modes";
import type { PeriodLine, Place } from "./modes";
import { colourOf, SEA_COLOUR } from "./periods_chart";
import type { SeaSpectrum } from "./sea_spectrum";

/** Number of digits of a value that a button sets. */
const DIGITS = 3;

/** Sentences about periods that equal the peak period of the sea, each with the value to try. */
export interface Meetings {
  crossings: Place[];
  sentences(parameter: Pick<ParameterInfo, "unit">, isComputed: boolean): { text: string; value: number | null }[];
}

export function meetings(lines: readonly PeriodLine[], sea: SeaSpectrum | null): Meetings {
  const met = sea ? crossings(lines, sea.peak_s) : [];
  const near = sea && met.length === 0 ? closest(lines, sea.peak_s) : null;
  const { resonance } = texts;
  return {
    crossings: met,
    sentences({ unit }, isComputed) {
      if (!isComputed) return [];
      if (!sea) return lines.length > 0 ? [{ text: resonance.calm, value: null }] : [];
      const peak = fixed(sea.peak_s, 1);
      const told = met.map((place) => {
        const value = rounded(place.value);
        const text = resonance.meets(withUnit(String(value), unit, " "), inWords(place.coordinate), fixed(place.period_s, 1), peak);
        return { text: `${text} ${resonance.damping(fixed(100 * place.damping_ratio, 1))}`, value };
      });
      if (told.length > 0) return told;
      const words = near ? ` ${resonance.nearest(inWords(near.coordinate), fixed(near.period_s, 1), withUnit(String(rounded(near.value)), unit, " "))}` : "";
      return [{ text: `${resonance.peak(peak)} ${resonance.apart}${words}`, value: near && rounded(near.value) }];
    },
  };
}

function rounded(value: number): number {
  return Number(value.toPrecision(DIGITS));
}

/** Appends the unit to a name or a number, if it has a unit. */
export function withUnit(text: string, unit: string, between = ", "): string {
  return unit ? `${text}${between}${unit}` : text;
}

export function legendOf(lines: readonly PeriodLine[], sea: SeaSpectrum | null): HTMLElement[] {
  const entry = (colour: string, name: string) => make("span", { class: "plot-entry" }, swatch(colour), name);
  const entries = lines.map((line, k) => entry(colourOf(k), nameOf(line)));
  return sea ? [...entries, entry(SEA_COLOUR, texts.resonance.sea)] : entries;
}

/** Returns a table with a row for each value of the parameter and a column for each line. */
export function tableOf(axis: string, lines: readonly PeriodLine[]): HTMLElement[] {
  const values = [...new Set(lines.flatMap(({ places }) => places.map(({ value }) => value)))].sort((a, b) => a - b);
  const head = make("tr", {}, make("th", { scope: "col" }, axis), ...lines.map((line) => make("th", { scope: "col" }, `${nameOf(line)}, s`)));
  const cell = (line: PeriodLine, value: number) => fixed(line.places.find((place) => place.value === value)?.period_s ?? NaN, 2);
  return [head, ...values.map((value) => make("tr", {}, make("th", { scope: "row" }, String(value)), ...lines.map((line) => make("td", {}, cell(line, value)))))];
}

/** Returns the name of a mode; modes of one coordinate have numbers. */
function nameOf({ coordinate, number }: PeriodLine): string {
  return number === undefined ? inWords(coordinate) : `${inWords(coordinate)} (${number})`;
}
