import { fixed } from "../app/format";
import type { LimitInfo } from "../engine/engine";
import { texts } from "../texts";
import { make, setText } from "../ui/dom";
import type { LimitState, LimitTrack } from "./limits";

/**
 * A limit as a bar: the allowed range, the present value and the worst value so far; amber near a bound, red beyond it.
 */
export class LimitBar {
  readonly element: HTMLElement;
  private readonly value = make("span", { class: "limit-value" });
  private readonly worst = make("p", { class: "limit-worst" });
  private readonly meter: HTMLElement;
  private readonly allowed = make("span", { class: "limit-allowed" });
  private readonly fill = make("span", { class: "limit-now" });
  private readonly mark = make("span", { class: "limit-mark" });

  constructor(private readonly track: LimitTrack) {
    const name = track.limit.name.replaceAll("_", " ");
    this.meter = make("div", { class: "limit-bar", role: "meter", "aria-label": name, title: track.limit.column }, this.allowed, this.mark, this.fill);
    const heading = make("p", { class: "limit-heading" }, make("span", { class: "limit-name" }, name), this.value);
    this.element = make("li", { class: "limit", "data-testid": `limit-${track.limit.name}` }, heading, this.meter, this.worst);
  }

  show(time_s: number, row: ArrayLike<number>): LimitState {
    const { track } = this;
    const { limit } = track;
    const value = track.valueIn(row);
    const state = track.state(time_s, row);
    const worst = track.worstUntil(time_s);
    const [low, high] = track.range();
    const place = (at: number) => (100 * (Math.min(high, Math.max(low, at)) - low)) / (high - low);
    this.element.dataset.state = state;
    put(this.allowed, place(limit.at_least ?? low), place(limit.at_most ?? high));
    put(this.fill, place(value), place(value));
    put(this.mark, place(worst?.value ?? value), place(worst?.value ?? value));
    this.mark.hidden = worst === null;
    const shown = withUnit(number(value), limit);
    setText(this.value, shown);
    setText(this.worst, `${bounds(limit)}. ${worst ? texts.instruments.worst(number(worst.value), fixed(worst.time_s, 1)) : whenOf(limit)}`);
    // ARIA values may not have powers of ten.
    const values = { "aria-valuemin": low, "aria-valuemax": high, "aria-valuenow": value };
    for (const [name, one] of Object.entries(values)) this.meter.setAttribute(name, one.toFixed(6));
    this.meter.setAttribute("aria-valuetext", `${shown}, ${texts.instruments.states[state]}`);
    return state;
  }
}

/** Returns when a limit applies. */
function whenOf({ from_s, steps }: LimitInfo): string {
  return steps.length > 0 ? texts.instruments.counts_in_steps : texts.instruments.counts_from(from_s);
}

function put(element: HTMLElement, from: number, to: number): void {
  element.style.left = `${from}%`;
  element.style.width = `${to - from}%`;
}

/** Returns the bounds of a limit as text: "within 5 deg", "at most 80 kN". */
export function bounds(limit: LimitInfo): string {
  const say = texts.instruments;
  const { at_least, at_most } = limit;
  const shown = (bound: number | null) => withUnit(plain(bound ?? NaN), limit);
  if (at_least === null) return say.at_most(shown(at_most));
  if (at_most === null) return say.at_least(shown(at_least));
  return at_least === -at_most ? say.within(shown(at_most)) : say.between(plain(at_least), shown(at_most));
}

/** Formats a bound as the scenario gives it, without its unit. */
export function plain(bound: number): string {
  return String(Number(bound.toPrecision(6))).replace("-", "−");
}

/** Appends the unit of a limit; a ratio has none. */
function withUnit(text: string, { unit }: LimitInfo): string {
  return unit === "1" ? text : `${text} ${unit}`;
}

/** Formats a number with three digits, as on a dial. */
export function number(value: number): string {
  if (!Number.isFinite(value)) return "–";
  const size = Math.abs(value);
  return fixed(value, size >= 100 ? 0 : size >= 10 ? 1 : 2);
}
