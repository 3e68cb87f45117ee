import type { SimulationSettings } from "../generated/scenario";
import { texts } from "../texts";

type Names<Field extends "integrator" | "form"> = Record<NonNullable<SimulationSettings[Field]>, string>;
const INTEGRATORS: Record<string, string> = texts.settings.integrators satisfies Names<"integrator">;
const FORMS: Record<string, string> = texts.settings.forms satisfies Names<"form">;

const SUPERSCRIPT = "⁰¹²³⁴⁵⁶⁷⁸⁹";

function superscript(exponent: number): string {
  const digits = String(Math.abs(exponent)).replace(/\d/g, (digit) => SUPERSCRIPT[Number(digit)]);
  return exponent < 0 ? `⁻${digits}` : digits;
}

/** Cuts a text that is longer than a number of characters, and marks the cut. */
export function inBrief(text: string, most: number): string {
  // A character takes at most two places.
  const characters = Array.from(text.slice(0, 2 * most + 2));
  return characters.length > most ? `${characters.slice(0, most - 1).join("")}…` : text;
}

/** Formats a number with fixed decimals and a true minus sign, so that columns of numbers do not jump. */
export function fixed(value: number, decimals: number): string {
  if (!Number.isFinite(value)) return "–";
  const text = value.toFixed(decimals);
  return Number(text) === 0 ? text.replace("-", "") : text.replace("-", "−");
}

/** Formats a number with two digits and a power of ten, such as 1.9×10⁻⁷; "0" for zero and a dash for NaN. */
export function scientific(value: number): string {
  if (Number.isNaN(value)) return "–";
  if (value === 0) return "0";
  if (!Number.isFinite(value)) return "∞";
  const [mantissa, exponent] = value.toExponential(1).split("e");
  const power = Number(exponent) === 0 ? "" : `×10${superscript(Number(exponent))}`;
  return mantissa.replace("-", "−") + power;
}

/** Formats a time step or an interval; in ms below one second. */
export function duration(seconds: number): string {
  return seconds < 1 ? `${Number((seconds * 1000).toPrecision(6))} ms` : `${Number(seconds.toPrecision(6))} s`;
}

/** Formats a length; in cm below half a metre. */
export function length(metres: number): string {
  return metres < 0.5 ? `${Number((metres * 100).toPrecision(3))} cm` : `${Number(metres.toPrecision(3))} m`;
}

export function integratorName(name: string): string {
  return INTEGRATORS[name] ?? name;
}

export const INTEGRATOR_NAMES = Object.keys(INTEGRATORS);

export function formName(name: string): string {
  return FORMS[name] ?? name;
}

export const FORM_NAMES = Object.keys(FORMS);
