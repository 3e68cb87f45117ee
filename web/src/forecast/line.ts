import { fixed } from "../app/format";
import { texts } from "../texts";
import { byId, setText } from "../ui/dom";
import { HORIZON_S } from "./forecast";
import type { Forecast } from "./forecast";
import type { Outlook } from "./outlook";

/** Media query for pages that are wide enough for the full text beside the ship. */
const WIDE = "(min-width: 600px)";

/** Button that switches the forecast on, and a line that describes the futures and their reliability. */
export class ForecastLine {
  private readonly button = byId("look-ahead", HTMLButtonElement);
  private readonly box = byId("ahead", HTMLDetailsElement);
  private readonly inShort = this.box.querySelector("summary")!;
  private readonly inFull = this.box.querySelector("p")!;

  constructor(private readonly forecast: Forecast) {
    this.inFull.title = texts.forecast.judged_by;
    this.box.open = matchMedia(WIDE).matches;
    this.button.addEventListener("click", () => forecast.switch(!forecast.isOn));
    forecast.onChange(() => this.show());
  }

  private show(): void {
    const { isOn, outlook, fault } = this.forecast;
    this.button.setAttribute("aria-pressed", String(isOn));
    this.box.hidden = !isOn;
    if (!isOn) return;
    // A screen reader reads the line only when it is complete.
    this.inShort.ariaBusy = String(!fault && (outlook?.futures.length ?? 0) < (outlook?.wanted ?? 1));
    const [inShort, inFull] = fault ? [texts.forecast.none, fault.message] : outlook ? this.words(outlook) : [texts.forecast.looking, ""];
    setText(this.inShort, inShort);
    setText(this.inFull, inFull);
  }

  private words(outlook: Outlook): [string, string] {
    const start = texts.forecast.start(fixed(outlook.start_s, 1));
    const broken = outlook.futures.filter((future) => future.fault).length;
    const notes = [outlook.futures[0].isGusty ? [texts.forecast.gusts] : [], broken > 0 ? [texts.forecast.broken(broken)] : []].flat();
    if (outlook.isOneLine) return [texts.forecast.one(HORIZON_S), [start, texts.forecast.no_waves, ...notes].join(" ")];
    const { past_s } = outlook.futures[0];
    const measured = past_s > 0 ? texts.forecast.agree(fixed(past_s, 0)) : texts.forecast.nothing_measured;
    const { held, of, minutes } = this.forecast.record.newest;
    const percent = fixed((100 * held) / of, 0);
    const judged = of > 0 ? texts.forecast.held(percent, minutes) : texts.forecast.not_judged;
    const futures = texts.forecast.futures(outlook.futures.length, outlook.wanted, HORIZON_S);
    const inShort = of > 0 ? [futures, texts.forecast.in_short(percent)] : [futures];
    return [inShort.join("; "), [start, measured, judged, ...notes].join(" ")];
  }
}
