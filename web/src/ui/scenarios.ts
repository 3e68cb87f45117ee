import { askedBy, queryOf } from "../app/address";
import type { Asked } from "../app/address";
import { faultOfAddress, faultOfDatabase } from "../app/faults";
import { Gallery } from "../app/gallery";
import { OPENING } from "../app/opening";
import type { Source } from "../app/run";
import type { Session } from "../app/session";
import type { Fault, Values } from "../engine/engine";
import { isOfEngine } from "../engine/faults";
import { scenarioAmong } from "../engine/files";
import { texts } from "../texts";
import { byId, make } from "./dom";

/** Before the names of files among the choices. */
const FILE = "file:";
/** How long values stay as they are before the address says them, ms: browsers refuse many addresses at a time. */
const CALM_MS = 300;

/** What the browser's history keeps of a page. */
export interface Choice {
  choice: string;
}

/** Choosing a scenario: by the address, from the gallery or as a file; the address says which, and with which values. */
export class Scenarios {
  private readonly select = byId<HTMLSelectElement>("gallery");
  /** Files that were opened here, by their choices. */
  private readonly files = new Map<string, Source>();
  private gallery: Gallery;
  private shown = "";
  /** What the shown one was opened with. */
  private values: Values = {};
  private timer = 0;

  constructor(
    private readonly session: Session,
    base: string,
  ) {
    this.gallery = Gallery.empty(base);
    this.select.addEventListener("change", () => void this.choose(this.select.value));
    session.listen({ valuesChanged: () => this.writeSoon() });
  }

  /** What there is to choose from. */
  offer(gallery: Gallery): void {
    this.gallery = gallery;
    this.fill();
  }

  /** Opens what the address asks for; where that cannot be, what the bare address does. */
  async openAddress(): Promise<void> {
    const asked = askedBy(location.search);
    const { opening } = this.gallery;
    const first = opening ? { scenario: opening, values: {} } : OPENING;
    if (asked.scenario === null) return void (await this.openAsked({ ...first, values: { ...first.values, ...asked.values } }));
    if (await this.openAsked(asked)) return;
    const why = this.session.fault;
    // Where the engine is not there, another fails in the same way.
    if (isOfEngine(why) || !(await this.openAsked(first))) return;
    history.replaceState(null, "", location.pathname + (opening ? "" : queryOf(first)));
    if (why) this.session.report(why);
  }

  /** With the file's own values where those of the address are refused, which is said. */
  private async openAsked({ scenario, values }: Asked): Promise<boolean> {
    const name = scenario ?? "";
    if (await this.openNamed(name, values)) return true;
    const why = this.session.fault;
    if (!why?.file?.startsWith("--set ") || !(await this.openNamed(name, {}))) return false;
    this.write();
    this.session.report(faultOfAddress(why));
    return true;
  }

  private async openNamed(name: string, values: Values): Promise<boolean> {
    try {
      return await this.open(name, await this.gallery.read(name), values);
    } catch (fault) {
      this.session.report(fault as Fault);
      this.select.value = this.shown;
      return false;
    }
  }

  private async open(choice: string, source: Source, values: Values): Promise<boolean> {
    const isOpen = await this.session.open(source, values);
    if (isOpen) [this.shown, this.values] = [choice, this.session.values.wanted];
    this.fill();
    return isOpen;
  }

  /** What is chosen by hand stands in the address, so that a link to it can be sent and Back leads from it. */
  private async choose(choice: string): Promise<void> {
    const source = this.files.get(choice);
    if (!(await (source ? this.open(choice, source, {}) : this.openNamed(choice, {})))) return;
    history.pushState({ choice }, "", location.pathname + this.query());
  }

  /** Whether a file that was opened here is what a state of the history stands for. */
  holds(state: Choice | null): boolean {
    return state !== null && this.files.has(state.choice);
  }

  /** Back or forward; what is open already stays as it is. */
  async goTo(state: Choice | null): Promise<void> {
    clearTimeout(this.timer);
    const source = state && this.files.get(state.choice);
    if (source ? this.shown === state.choice : this.shown !== "" && this.query() === location.search && location.search !== "") return;
    if (source) await this.open(state.choice, source, {});
    else await this.openAddress();
  }

  /** A scenario, and with it the files that it names. */
  async openFiles(dropped: Record<string, string>): Promise<void> {
    const file = scenarioAmong(dropped);
    if (!file) return this.session.report(faultOfDatabase(Object.keys(dropped)[0]));
    const { [file]: text, ...opened } = dropped;
    const choice = FILE + file;
    const source = { text, file, opened };
    if (!(await this.open(choice, source, {}))) return;
    this.files.set(choice, source);
    this.fill();
    history.pushState({ choice }, "", location.pathname);
  }

  private fill(): void {
    const named = this.gallery.groups.map(({ title, entries }) => {
      const options = entries.map((entry) => make("option", { value: entry.name }, entry.title || entry.name));
      return make("optgroup", { label: title ?? texts.start.ungrouped }, ...options);
    });
    const own = Array.from(this.files, ([choice, { file }]) => make("option", { value: choice }, file));
    this.select.replaceChildren(...named, ...own);
    this.select.value = this.shown;
  }

  /** No address has a person's own file. */
  private query(): string {
    return this.files.has(this.shown) ? "" : queryOf({ scenario: this.shown, values: this.session.values.wanted });
  }

  private writeSoon(): void {
    clearTimeout(this.timer);
    this.timer = window.setTimeout(() => {
      if (this.session.values.wanted !== this.values && this.shown !== "") this.write();
    }, CALM_MS);
  }

  private write(): void {
    history.replaceState(history.state, "", location.pathname + this.query());
  }
}
