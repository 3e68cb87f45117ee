import { fixed } from "../app/format";
import { texts } from "../texts";
import { byId, setText } from "../ui/dom";
import { HORIZON_S } from "./ahead";
import type { Ahead } from "./ahead";
import type { Outlook } from "./outlook";

/** The picture is wide enough for more than one line beside the ship. */
const WIDE = "(min-width: 600px)";

/** The button that switches the futures on, and a line on what they are and how reliable they are. */
export class AheadLine {
  private readonly button = byId<HTMLButtonElement>("look-ahead");
  private readonly box = byId<HTMLDetailsElement>("ahead");
  private readonly inShort = this.box.querySelector("summary")!;
  private readonly inFull = this.box.querySelector("p")!;

  constructor(private readonly ahead: Ahead) {
    this.inFull.title = texts.ahead.judged_by;
    this.box.open = matchMedia(WIDE).matches;
    this.button.addEventListener("click", () => ahead.switch(!ahead.isOn));
    ahead.onChange(() => this.show());
  }

  private show(): void {
    const { isOn, outlook, fault } = this.ahead;
    this.button.setAttribute("aria-pressed", String(isOn));
    this.box.hidden = !isOn;
    if (!isOn) return;
    // A screen reader reads it when it is complete.
    this.inShort.ariaBusy = String(!fault && (outlook?.futures.length ?? 0) < (outlook?.wanted ?? 1));
    const [inShort, inFull] = fault ? [texts.ahead.none, fault.message] : outlook ? this.words(outlook) : [texts.ahead.looking, ""];
    setText(this.inShort, inShort);
    setText(this.inFull, inFull);
  }

  private words(outlook: Outlook): [string, string] {
    const start = texts.ahead.start(fixed(outlook.start_s, 1));
    const broken = outlook.futures.filter((future) => future.fault).length;
    const notes = [outlook.futures[0].isGusty ? [texts.ahead.gusts] : [], broken > 0 ? [texts.ahead.broken(broken)] : []].flat();
    if (outlook.isOneLine) return [texts.ahead.one(HORIZON_S), [start, texts.ahead.no_waves, ...notes].join(" ")];
    const { past_s } = outlook.futures[0];
    const measured = past_s > 0 ? texts.ahead.agree(fixed(past_s, 0)) : texts.ahead.nothing_measured;
    const { held, of, minutes } = this.ahead.record.newest;
    const percent = fixed((100 * held) / of, 0);
    const judged = of > 0 ? texts.ahead.held(percent, minutes) : texts.ahead.not_judged;
    const futures = texts.ahead.futures(outlook.futures.length, outlook.wanted, HORIZON_S);
    const inShort = of > 0 ? [futures, texts.ahead.in_short(percent)] : [futures];
    return [inShort.join("; "), [start, measured, judged, ...notes].join(" ")];
  }
}
