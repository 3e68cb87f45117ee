import { fixed } from "../app/format";
import type { Moment } from "../app/recording/recording";
import type { Run, Session } from "../app/session";
import { texts } from "../texts";
import { make, setText } from "../ui/dom";
import { Dial } from "./dial";
import { rangeOf } from "./range";
import { hullBodyOf } from "./readings";

const DEGREES = 180 / Math.PI;

/** Dials of heel and trim of the first hull. */
export class ShipDials {
  readonly element: HTMLElement;
  private readonly dials: { column: string; dial: Dial; value: HTMLElement; range: HTMLElement }[];

  private constructor(
    body: string,
    private readonly session: Session,
  ) {
    const { heel, trim } = texts.floating;
    this.dials = [
      // Seen from aft, a heel to starboard turns the ship clockwise; seen from starboard, a trim by the bow does.
      { column: `${body}.roll`, dial: new Dial(heel, "aft", 1), ...words() },
      { column: `${body}.pitch`, dial: new Dial(trim, "side", 1), ...words() },
    ];
    const figures = this.dials.map(({ dial, value, range }, k) => {
      const caption = make("figcaption", {}, make("span", { class: "dial-name" }, k === 0 ? heel : trim), value, range);
      return make("figure", {}, dial.element, caption);
    });
    this.element = make("section", { class: "dials", "aria-label": texts.instruments.ship }, ...figures);
  }

  /** Returns the dials for a run; null if no hull floats. */
  static of({ model }: Run, session: Session): ShipDials | null {
    const body = hullBodyOf(model);
    return body === null ? null : new ShipDials(body, session);
  }

  show({ columns }: Run, { time_s, row }: Moment): void {
    const { recording } = this.session.shown;
    for (const { column, dial, value, range } of this.dials) {
      const angle = columns.read(row, column) * DEGREES;
      const range_rad = rangeOf(recording!.rows, columns.at(column), time_s);
      const low = Math.min(angle, range_rad[0] * DEGREES);
      const high = Math.max(angle, range_rad[1] * DEGREES);
      dial.show(angle, low, high);
      setText(value, `${fixed(angle, 1)}°`);
      setText(range, texts.instruments.minute(`${fixed(low, 1)}° … ${fixed(high, 1)}°`));
    }
  }
}

function words(): { value: HTMLElement; range: HTMLElement } {
  return { value: make("strong", {}), range: make("span", { class: "muted" }) };
}
