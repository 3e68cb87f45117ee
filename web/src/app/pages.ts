import type { Simulator } from "../simulator";
import type { Fault } from "../engine/engine";
import type { StartPage } from "../start/start";
import { byId } from "../ui/dom";
import type { Choice } from "../ui/scenarios";
import { texts } from "../texts";
import { START, asksForStart } from "./address";
import { isObject } from "./objects";

function isChoice(state: unknown): state is Choice {
  return isObject(state) && typeof state.choice === "string";
}

/** Shows one of the two pages: the start page, or the simulator, which is loaded when it is first asked for. */
export class Pages {
  private simulator: Promise<Simulator> | null = null;
  private loaded: Simulator | null = null;

  constructor(
    private readonly start: StartPage,
    private readonly load: () => Promise<Simulator>,
    /** The scenario that the server was started with. */
    private readonly opening: Promise<string | undefined>,
  ) {
    addEventListener("popstate", ({ state }) => void this.show(isChoice(state) ? state : null));
    byId("to-start").addEventListener("click", (event) => {
      event.preventDefault();
      void this.goToStart();
    });
  }

  /** Shows the page that the address, and the state of the history, ask for. */
  async show(state: Choice | null): Promise<void> {
    const isStart = asksForStart(location, await this.opening) && !this.loaded?.holds(state);
    if (isStart) return this.showStart();
    const simulator = await this.simulate();
    await simulator?.goTo(state);
    simulator?.entitle();
  }

  /** A scenario that was chosen on the start page. */
  open(query: string): void {
    history.pushState(null, "", location.pathname + query);
    void this.show(null);
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
    } catch (thrown) {
      this.simulator = null;
      this.showStart();
      this.start.say(texts.start.no_simulator(thrown instanceof Error ? thrown.message : String(thrown)));
    }
    return this.loaded;
  }
}
