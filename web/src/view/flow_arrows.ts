import { fixed } from "../app/format";
import type { Flows } from "../engine/surface";
import { byTestId } from "../ui/dom";

type Plane = readonly [number, number];

const ARROW = "M10 17.5V3M4.5 9 10 2.5 15.5 9";

/** Returns the angle by which an upward arrow turns, clockwise, to point along a velocity as the eye sees it, degrees. */
export function turnOf([x, y]: Plane, [ahead_x, ahead_y]: Plane): number {
  const [away, right] = [x * ahead_x + y * ahead_y, x * ahead_y - y * ahead_x];
  return (Math.atan2(right, away) * 180) / Math.PI;
}

/** Wind and current beside the numbers of the ship: their speeds, and arrows that turn with the view. */
export class FlowArrows {
  private readonly rows = { wind_m_s: new Row("wind"), current_m_s: new Row("current") };

  show(flows: Flows | undefined, ahead: Plane): void {
    this.rows.wind_m_s.show(flows?.wind_m_s ?? null, ahead);
    this.rows.current_m_s.show(flows?.current_m_s ?? null, ahead);
  }
}

class Row {
  private readonly row: HTMLElement;
  private readonly words = document.createTextNode("");
  private readonly arrow = arrow();
  private said = "";

  constructor(name: string) {
    this.row = byTestId(name);
    this.row.querySelector("dd")!.replaceChildren(this.words, this.arrow);
  }

  show(velocity: Plane | null, ahead: Plane): void {
    const say = velocity ? `${Math.hypot(...velocity)} ${turnOf(velocity, ahead).toFixed(0)}` : "";
    if (say === this.said) return;
    this.said = say;
    this.row.hidden = velocity === null;
    if (!velocity) return;
    this.words.data = `${fixed(Math.hypot(...velocity), 1)} m/s`;
    this.arrow.style.rotate = `${turnOf(velocity, ahead).toFixed(0)}deg`;
  }
}

function arrow(): SVGElement {
  const svg = document.createElementNS("http://www.w3.org/2000/svg", "svg");
  for (const [name, value] of Object.entries({ class: "flow", viewBox: "0 0 20 20", width: "15", height: "15", "aria-hidden": "true", fill: "none", stroke: "currentColor", "stroke-width": "2.2" })) svg.setAttribute(name, value);
  const path = document.createElementNS("http://www.w3.org/2000/svg", "path");
  path.setAttribute("d", ARROW);
  svg.append(path);
  return svg;
}
