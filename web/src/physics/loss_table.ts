import { fixed } from "../app/format";
import { texts } from "../texts";
import { make, setText } from "../ui/dom";
import { DEGREES } from "./loss_chart";
import { REQUIRED } from "./righting";
import type { Loss } from "./righting";

/** Range of the heel at which water enters, and its default, deg; the engine's curves end where the range ends. */
const FLOODING = { least: 0, most: 90, usual: 60 };
const ROWS = ["heel_before", "heel_after", "area_1", "area_2", "ratio", "reach", "furthest", "exposed", "sheltered"] as const;
type Row = (typeof ROWS)[number];

/** Table of the energy argument: the areas, the predicted and the actual roll, and the requirement. */
export class LossTable {
  readonly element = make("section", { class: "lesson-table" });
  private readonly flooding = make("input", { type: "number", min: FLOODING.least, max: FLOODING.most, step: "any", value: FLOODING.usual, id: "flooding", "data-testid": "flooding" });
  private readonly cells = new Map(ROWS.map((row) => [row, { name: make("th", { scope: "row" }), value: make("td", { "data-testid": `loss-${row}` }) }]));

  constructor(changed: () => void) {
    const rows = [...this.cells.values()].map(({ name, value }) => make("tr", {}, name, value));
    const flooding = make("p", { class: "lesson-field" }, make("label", { for: "flooding" }, texts.loss.flooding), this.flooding);
    this.element.append(make("h3", {}, texts.loss.argument), make("table", {}, ...rows), flooding);
    this.flooding.addEventListener("input", changed);
  }

  /** Heel at which water enters, rad; the default if the field is empty. */
  get flooding_rad(): number {
    const given = this.flooding.valueAsNumber;
    return (given >= FLOODING.least && given <= FLOODING.most ? given : FLOODING.usual) / DEGREES;
  }

  show(loss: Loss | null, furthest_deg: number | null): void {
    const { loss: words } = texts;
    const write = (row: Row, name: string, value: string) => {
      const cell = this.cells.get(row)!;
      setText(cell.name, name);
      setText(cell.value, loss ? value : "–");
    };
    const side = words.sides[loss?.way ?? 1];
    const heel = (rad: number) => words.degrees(fixed(rad * DEGREES, 2), side);
    const { start, rest, end, area_1, area_2, reach } = loss ?? { start: NaN, rest: NaN, end: NaN, area_1: NaN, area_2: NaN, reach: NaN };
    write("heel_before", words.heel_before, heel(start));
    write("heel_after", words.heel_after, heel(rest));
    write("area_1", words.area_1, words.area(fixed(area_1, 4)));
    write("area_2", words.area_2(fixed(end * DEGREES, 1)), words.area(fixed(area_2, 4)));
    write("ratio", words.ratio, area_1 > 0 ? fixed(area_2 / area_1, 1) : "–");
    const no_reach = loss?.floods ? words.beyond_flooding(fixed(end * DEGREES, 1)) : words.no_reach;
    write("reach", words.reach, reach === null ? no_reach : heel(reach));
    write("furthest", words.furthest, furthest_deg === null ? "–" : words.degrees(fixed(furthest_deg, 2), side));
    for (const waters of ["exposed", "sheltered"] as const) {
      const isHeld = area_2 > REQUIRED[waters] * area_1;
      write(waters, words.asked[waters], isHeld ? words.held : words.not_held);
      const { dataset } = this.cells.get(waters)!.value;
      if (loss) dataset.state = isHeld ? "ok" : "exceeded";
      else delete dataset.state;
    }
  }
}
