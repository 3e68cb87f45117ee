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
import { isLink, runIn } from "../share/link";
import type { SharedRun } from "../share/shared_run";
import { texts as words } from "../texts";
import { byId, make } from "./dom";
import { enableFiles } from "./files";

/** Before the names of files, and of links, among the choices. */
const FILE = "file:";
const LINK = "link:";
/** How long values stay as they are before the address says them, ms: browsers refuse many addresses at a time. */
const CALM_MS = 300;

/** A choice beside those of the gallery: a file that was opened here, or what came by a link. */
interface Own {
  source: Source;
  values: Values;
  title: string;
  /** Where the address has it. */
  hash: string;
  link?: SharedRun;
}

/** Choosing a scenario: by the address, from the gallery or as a file; the address says which, and with which values. */
export class Scenarios {
  private readonly select = byId<HTMLSelectElement>("gallery");
  private readonly own = new Map<string, Own>();
  private gallery: Gallery;
  private shown = "";
  /** What the shown one was opened with. */
  private values: Values = {};
  private timer = 0;

  constructor(
    private readonly session: Session,
    base: string,
    /** Is told of a run that came by a link, once it is open. */
    private readonly linked: (link: SharedRun) => void,
  ) {
    this.gallery = Gallery.empty(base);
    this.select.addEventListener("change", () => void this.choose(this.select.value));
    addEventListener("popstate", ({ state }) => void this.goTo(state));
    session.listen({ valuesChanged: () => this.writeSoon() });
    enableFiles((texts) => void this.openFiles(texts));
  }

  /** What there is to choose from. */
  offer(gallery: Gallery): void {
    this.gallery = gallery;
    this.fill();
  }

  /** Opens what the address asks for; where that cannot be, what the bare address does. */
  async openAddress(): Promise<void> {
    if (isLink(location.hash)) return this.openLink(location.hash);
    const asked = askedBy(location.search);
    const { first } = this;
    if (asked.scenario === null) return void (await this.openAsked({ ...first, values: { ...first.values, ...asked.values } }));
    if (await this.openAsked(asked)) return;
    const why = this.session.fault;
    // Where the engine is not there, another fails in the same way.
    if (isOfEngine(why) || !(await this.openAsked(first))) return;
    history.replaceState(null, "", location.pathname);
    if (why) this.session.report(why);
  }

  /** What the bare address opens. */
  private get first(): Asked {
    const { opening } = this.gallery;
    return opening ? { scenario: opening, values: {} } : OPENING;
  }

  /** A run that the address holds. One that does not open leaves the run in hand as it was; where there is none, the first opens. */
  private async openLink(hash: string): Promise<void> {
    const why = await this.triedLink(hash);
    if (!why) return;
    const { run } = this.session;
    if (run) this.write();
    // Where the engine is not there, another fails in the same way.
    if (run || isOfEngine(why)) return this.session.report(why);
    if (!(await this.openAsked(this.first))) return;
    history.replaceState(null, "", location.pathname);
    this.session.report({ ...why, message: `${why.message} ${words.share.opened_first}` });
  }

  /** Why it does not open. */
  private async triedLink(hash: string): Promise<Fault | null> {
    try {
      const link = await runIn(hash);
      const source = await this.sourceOf(link);
      if (!(await this.open(LINK + hash, source, link.values))) return this.session.fault;
      const title = words.share.from_link(this.session.run!.model.title);
      this.keep(LINK + hash, { source, values: link.values, title, hash, link });
      this.linked(link);
      return null;
    } catch (fault) {
      return fault as Fault;
    }
  }

  private async sourceOf({ scenario, changes }: SharedRun): Promise<Source> {
    const source = "gallery" in scenario ? await this.gallery.read(scenario.gallery) : scenario;
    return { ...source, changes };
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

  private async openOwn(choice: string, { source, values, link }: Own): Promise<boolean> {
    const isOpen = await this.open(choice, source, values);
    if (isOpen && link) this.linked(link);
    return isOpen;
  }

  /** What is chosen by hand stands in the address, so that a link to it can be sent and Back leads from it. */
  private async choose(choice: string): Promise<void> {
    const own = this.own.get(choice);
    if (!(await (own ? this.openOwn(choice, own) : this.openNamed(choice, {})))) return;
    history.pushState({ choice }, "", this.address());
  }

  /** Back or forward, or another link in the address. */
  private async goTo(state: { choice: string } | null): Promise<void> {
    clearTimeout(this.timer);
    const own = state && this.own.get(state.choice);
    if (own) await this.openOwn(state.choice, own);
    else await this.openAddress();
  }

  /** A scenario, and with it the files that it names. */
  private async openFiles(texts: Record<string, string>): Promise<void> {
    const file = scenarioAmong(texts);
    if (!file) return this.session.report(faultOfDatabase(Object.keys(texts)[0]));
    const { [file]: text, ...opened } = texts;
    const choice = FILE + file;
    const source = { text, file, opened };
    if (!(await this.open(choice, source, {}))) return;
    this.keep(choice, { source, values: {}, title: file, hash: "" });
    history.pushState({ choice }, "", this.address());
  }

  private keep(choice: string, own: Own): void {
    this.own.set(choice, own);
    this.fill();
  }

  private fill(): void {
    const named = this.gallery.entries.map((entry) => make("option", { value: entry.name }, entry.title || entry.name));
    const own = Array.from(this.own, ([choice, { title }]) => make("option", { value: choice }, title));
    this.select.replaceChildren(...named, ...own);
    this.select.value = this.shown;
  }

  /** No address has a person's own file, and a link stays the link. */
  private address(): string {
    const own = this.own.get(this.shown);
    return location.pathname + (own ? own.hash : queryOf({ scenario: this.shown, values: this.session.values.wanted }));
  }

  private writeSoon(): void {
    clearTimeout(this.timer);
    this.timer = window.setTimeout(() => {
      if (this.session.values.wanted !== this.values && this.shown !== "") this.write();
    }, CALM_MS);
  }

  private write(): void {
    history.replaceState(history.state, "", this.address());
  }
}
