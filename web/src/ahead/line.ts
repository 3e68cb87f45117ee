import { fixed } from "../app/format";
import { texts } from "../texts";
import { byId, setText } from "../ui/dom";
import { HORIZON_S } from "./ahead";
import type { Ahead } from "./ahead";
import type { Outlook } from "./outlook";

/** The button that switches the look ahead on, and the line that says what the futures are and how far they are to be trusted. */
export class AheadLine {
  private readonly button = byId<HTMLButtonElement>("look-ahead");
  private readonly line = byId("ahead-line");

  constructor(private readonly ahead: Ahead) {
    this.button.append(texts.ahead.button);
    this.button.title = texts.ahead.help;
    this.line.title = texts.ahead.judged_by;
    this.button.addEventListener("click", () => ahead.switch(!ahead.isOn));
    ahead.onChange(() => this.show());
  }

  private show(): void {
    const { isOn, outlook, fault } = this.ahead;
    this.button.setAttribute("aria-pressed", String(isOn));
    this.line.hidden = !isOn;
    if (!isOn) return;
    // One who listens hears it when it is whole.
    this.line.ariaBusy = String(!fault && (outlook?.futures.length ?? 0) < (outlook?.wanted ?? 1));
    if (fault) setText(this.line, texts.ahead.none(fault.message));
    else setText(this.line, outlook ? this.words(outlook).join(" ") : texts.ahead.looking);
  }

  private words(outlook: Outlook): string[] {
    const start_s = fixed(outlook.start_s, 1);
    const broken = outlook.futures.filter((future) => future.fault).length;
    const failed = broken > 0 ? [texts.ahead.broken(broken)] : [];
    const gusts = outlook.futures[0].isGusty ? [texts.ahead.gusts] : [];
    if (outlook.isOneLine) return [texts.ahead.one(HORIZON_S, start_s), ...gusts, ...failed];
    const { past_s } = outlook.futures[0];
    const measured = past_s > 0 ? texts.ahead.agree(fixed(past_s, 0)) : texts.ahead.nothing_measured;
    const { held, of, minutes } = this.ahead.record.newest;
    const judged = of > 0 ? texts.ahead.held(fixed((100 * held) / of, 0), minutes) : texts.ahead.not_judged;
    return [texts.ahead.futures(outlook.futures.length, outlook.wanted, HORIZON_S, start_s), measured, judged, ...gusts, ...failed];
  }
}
