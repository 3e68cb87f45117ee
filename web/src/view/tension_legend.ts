import { inWords } from "../plots/lines";
import { texts } from "../texts";
import { byId, make } from "../ui/dom";
import { written } from "./overlays/scale";
import type { Tensions } from "./tension";

/** Width of the page below which only the bar is shown until the legend is opened, as in scene.css. */
const NARROW = "(max-width: 599px)";

/** Legend of the colours along lines: a bar from slack to the largest tension so far, and that tension of each line. */
export class TensionLegend {
  private readonly box = byId("tension-legend", HTMLDetailsElement);
  private readonly list = make("dl", {});
  private said = "";

  constructor() {
    const { tension } = texts.picture;
    const bar = make("span", { class: "tension-bar" }, make("span", {}, tension.slack), make("i", { "aria-hidden": "true" }), make("span", {}, tension.largest));
    this.box.replaceChildren(make("summary", {}, make("span", {}, tension.title), bar), this.list);
    this.box.open = !matchMedia(NARROW).matches;
  }

  /** Shows the largest tensions; hides the legend if no line has tensions along it. */
  show(tensions: Tensions | null): void {
    const largest = tensions?.largest ?? [];
    this.box.hidden = largest.length === 0;
    const rows = largest.map(({ name, largest_N }) => [inWords(name), written(largest_N, "N")] as const);
    const say = JSON.stringify(rows);
    if (say === this.said) return;
    this.said = say;
    this.list.replaceChildren(...rows.map(([name, value]) => make("div", {}, make("dt", {}, name), make("dd", {}, value))));
  }
}
