import { fixed } from "../app/format";
import type { Session } from "../app/session";
import { notice } from "../ui/notices";
import { byId, make } from "../ui/dom";
import { texts } from "../texts";
import { isSame } from "./making";
import type { SharedRun } from "./shared_run";

const words = texts.share;

/**
 * Notice for a run from a link: what the run repeats, a button that runs to the link's moment, and at that moment
 * whether the numbers agree.
 */
export class LinkNotice {
  private link: SharedRun | null = null;
  private isCompared = false;
  private close = () => {};

  constructor(private readonly session: Session) {
    session.listen({
      opened: (_run, _frame, isAnother) => (isAnother ? this.drop() : this.show()),
      moved: () => void this.compare(),
      statusChanged: () => void this.compare(),
    });
  }

  /** Shows the notice for a run that was opened from this link. */
  tell(link: SharedRun): void {
    this.link = link;
    this.show();
  }

  private drop(): void {
    this.link = null;
    this.close();
  }

  private show(): void {
    const { link, session } = this;
    this.close();
    this.isCompared = false;
    if (!link) return;
    const { changes, moment, scenario } = link;
    const isOther = "digest" in scenario && scenario.digest !== session.run?.digest;
    const says = [
      changes.length > 0 ? words.again(changes.length) : "",
      isOther ? words.other_files : "",
      moment ? words.was_shown(fixed(moment.time_s, 2)) : "",
    ].filter((text) => text !== "");
    const button = make("button", { type: "button", class: "button", "data-testid": "run-to" }, words.run_to);
    button.addEventListener("click", () => {
      // The notice is hidden until the run reaches the link's moment.
      this.close();
      byId("start").focus();
      session.runTo(moment!.time_s);
    });
    this.close = notice("link", words.notice, says, moment ? [button] : []);
  }

  /** Compares the numbers at the link's moment, and reports the result. */
  private async compare(): Promise<void> {
    const { link, session } = this;
    if (!link?.moment || this.isCompared || session.status !== "paused") return;
    const same = await isSame(session, link);
    if (same === null || link !== this.link) return;
    this.isCompared = true;
    const time_s = fixed(link.moment.time_s, 2);
    this.close();
    this.close = notice("link", words.notice, [same ? words.same(time_s) : words.other(time_s)]);
  }
}
