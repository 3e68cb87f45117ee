import type { Simulator } from "../simulator";
import type { Fault } from "../engine/engine";
import type { StartPage } from "../start/start";
import { byId, setText } from "../ui/dom";
import type { Choice } from "../ui/scenarios";
import { texts } from "../texts";
import { START, asksForStart, unknownIn } from "./address";
import { inBrief } from "./format";
import { isObject } from "./objects";

function isChoice(state: unknown): state is Choice {
  return isObject(state) && typeof state.choice === "string";
}

/** Shows one of the two pages: the start page, or the simulator, which is loaded when it is first asked for. */
export class Pages {
  private simulator: Promise<Simulator> | null = null;
  private loaded: Simulator | null = null;
  /** Whether the run is to start when the simulator is loaded. */
  private starts = false;
  /** The part of the address whose unknown key was reported. */
  private told = "";

  constructor(
    private readonly start: StartPage,
    private readonly load: () => Promise<Simulator>,
    /** The scenario that the server was started with. */
    private readonly opening: Promise<string | undefined>,
  ) {
    addEventListener("popstate", ({ state }) => void this.show(isChoice(state) ? state : null));
    byId("start").addEventListener("click", () => !this.loaded && this.startThen(!this.starts));
    byId("to-start").addEventListener("click", (event) => {
      event.preventDefault();
      void this.goToStart();
    });
  }

  /** Shows the page that the address, and the state of the history, ask for; `starts` starts the run. */
  async show(state: Choice | null, starts = false): Promise<void> {
    const isStart = asksForStart(location, await this.opening) && !this.loaded?.holds(state);
    if (isStart) {
      this.showStart();
      return this.tellUnknown();
    }
    const isFirst = !this.loaded;
    if (isFirst && starts) this.startThen(true);
    const simulator = await this.simulate();
    await simulator?.goTo(state);
    if (!isFirst && starts) simulator?.start();
    simulator?.entitle();
    this.tellUnknown();
  }

  /** Reports a part of the address that cannot be read, once. */
  private tellUnknown(): void {
    const key = unknownIn(location.hash);
    if (key === null || location.hash === this.told) return;
    this.told = location.hash;
    this.report({ kind: "link", message: texts.share.unknown(inBrief(key, 40)) });
  }

  /** A scenario that was chosen on the start page; `starts` also starts its run. */
  open(query: string, starts: boolean): void {
    history.pushState(null, "", location.pathname + query);
    void this.show(null, starts);
  }

  /** Keeps a press of Start until the simulator is loaded; a second press takes it back. */
  private startThen(starts: boolean): void {
    this.starts = starts;
    setText(byId("start-label"), starts ? texts.transport.pause : texts.transport.start);
    setText(byId("hint"), starts ? texts.transport.starts_then : texts.transport.loading);
  }

  /** Files that were chosen or dropped, on either page. */
  async openFiles(texts: Record<string, string>): Promise<void> {
    const simulator = await this.simulate();
    await simulator?.openFiles(texts);
    simulator?.entitle();
  }

  /** Reports on the visible page what could not be opened. */
  report(fault: Fault): void {
    if (byId("app").hidden) this.start.say(fault.message);
    else this.loaded?.report(fault);
  }

  private async goToStart(): Promise<void> {
    history.pushState(null, "", location.pathname + ((await this.opening) ? START : ""));
    this.showStart();
  }

  private showStart(): void {
    this.loaded?.pause();
    byId("app").hidden = true;
    this.start.isShown = true;
  }

  /** Shows the simulator; null if it could not be loaded, which the start page then reports. */
  private async simulate(): Promise<Simulator | null> {
    this.start.isShown = false;
    byId("app").hidden = false;
    try {
      this.simulator ??= this.load();
      this.loaded = await this.simulator;
      if (this.starts) this.loaded.start();
      this.starts = false;
    } catch (thrown) {
      this.simulator = null;
      this.startThen(false);
      this.showStart();
      this.start.say(texts.start.no_simulator(thrown instanceof Error ? thrown.message : String(thrown)));
    }
    return this.loaded;
  }
}
