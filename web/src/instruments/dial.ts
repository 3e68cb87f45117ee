import { fixed } from "../app/format";
import { texts } from "../texts";
import { svg } from "./svg";

/** Factor by which the picture exaggerates the inclination, so that 5 degrees of heel are visible. */
const MAGNIFIED = 3;
const LARGEST_DEG = 25;

/** The view of a dial: from aft, or from starboard with the bow to the right. */
const SILHOUETTES = {
  aft: "M-34 -4 L-30 22 Q0 30 30 22 L34 -4 Z M-14 -4 V-22 H14 V-4 Z M-2 -22 V-36 H2 V-22 Z",
  side: "M-44 -4 L-40 16 H34 L44 -4 Z M-38 -4 V-20 H-20 V-4 Z M2 -4 V-30 H5 V-4 Z M4 -29 L26 -18 L25 -16 L4 -25 Z",
};

/** A dial with a silhouette of the ship inclined against a scale, and the range of the last minute. */
export class Dial {
  readonly element: SVGSVGElement;
  private readonly ship: SVGElement;
  private readonly range: SVGElement;
  private readonly needle: SVGElement;

  constructor(
    private readonly label: string,
    ship: keyof typeof SILHOUETTES,
    /** +1 if a positive angle turns the picture clockwise, otherwise -1. */
    private readonly clockwise: 1 | -1,
  ) {
    this.ship = svg("path", { d: SILHOUETTES[ship], class: "dial-ship" });
    this.range = svg("path", { class: "dial-range" });
    this.needle = svg("path", { d: "M0 -54 L4 -63 H-4 Z M0 54 L4 63 H-4 Z", class: "dial-needle" });
    const water = svg("path", { d: "M-52 8 H52", class: "dial-water" });
    this.element = svg("svg", { viewBox: "-70 -70 140 140", class: "dial", role: "img" }, ...ticks(), this.range, water, this.ship, this.needle);
  }

  /** Shows an angle and its range over the last minute, degrees. */
  show(angle: number, low: number, high: number): void {
    const turn = this.turned(angle);
    this.ship.setAttribute("transform", `rotate(${turn})`);
    this.needle.setAttribute("transform", `rotate(${turn})`);
    this.range.setAttribute("d", arc(this.turned(low), this.turned(high)));
    this.element.setAttribute("aria-label", texts.instruments.dial(this.label, `${fixed(angle, 1)}°`, `${fixed(low, 1)}°`, `${fixed(high, 1)}°`));
  }

  private turned(angle: number): number {
    return this.clockwise * MAGNIFIED * Math.max(-LARGEST_DEG, Math.min(LARGEST_DEG, angle));
  }
}

/** Draws a tick every degree, a longer one every five degrees, at both ends of the needle. */
function ticks(): SVGElement[] {
  const degrees = Array.from({ length: 2 * LARGEST_DEG + 1 }, (_, k) => k - LARGEST_DEG);
  return degrees.flatMap((degree) => {
    const length = degree % 5 === 0 ? 6 : 3;
    const at = (angle: number) => svg("path", { d: `M0 -64 V${-64 - length + 1}`, class: "dial-tick", transform: `rotate(${angle})` });
    return [at(MAGNIFIED * degree), at(180 + MAGNIFIED * degree)];
  });
}

/** Draws two arcs opposite to each other; angles in degrees of the picture. */
function arc(from: number, to: number): string {
  const [low, high] = [Math.min(from, to), Math.max(from, to)];
  const place = (angle: number) => {
    const radians = ((angle - 90) * Math.PI) / 180;
    return `${(60 * Math.cos(radians)).toFixed(2)} ${(60 * Math.sin(radians)).toFixed(2)}`;
  };
  const one = (offset: number) => `M${place(low + offset)} A60 60 0 0 1 ${place(high + offset)}`;
  return `${one(0)} ${one(180)}`;
}
