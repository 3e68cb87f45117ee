import { askedBy, holdsRun, queryOf } from "../app/address";
import type { Asked } from "../app/address";
import { Calm } from "../app/calm";
import { faultOfAddress, faultOfDatabase } from "../app/faults";
import { Gallery } from "../app/gallery";
import { OPENING, openingOf } from "../app/opening";
import type { Source } from "../app/run";
import type { Session } from "../app/session";
import { asFault } from "../engine/engine";
import type { Fault, Values } from "../engine/engine";
import { isOfEngine } from "../engine/faults";
import { scenarioAmong } from "../engine/files";
import { runIn } from "../share/link";
import type { SharedRun } from "../share/shared_run";
import { language, texts } from "../texts";
import { byId, make } from "./dom";

/** Prefixes of choices that are files or links. */
const FILE = "file:";
const LINK = "link:";
/**
 * Pause after the last change before the values are written to the address, ms: browsers limit the number of changes.
 */
const CALM_MS = 300;

/** State of a page in the browser's history: the choice that was open. */
export interface Choice {
  choice: string;
}

/** Choice that is not in the gallery: a file that the user opened, or a scenario from a link. */
interface Own {
  source: Source;
  values: Values;
  title: string;
  /** The link in the address. */
  hash: string;
  link?: SharedRun;
}

/** The choice of a scenario, from the gallery or as a file; the address holds the choice and its values. */
export class Scenarios {
  private readonly select = byId("gallery", HTMLSelectElement);
  private readonly own = new Map<string, Own>();
  private gallery: Gallery;
  private shown = "";
  /** Values with which the present scenario was opened. */
  private values: Values = {};
  private readonly soon = new Calm(CALM_MS, () => this.writeValues());

  constructor(
    private readonly session: Session,
    base: string,
    /** Called when a run from a link has been opened. */
    private readonly linked: (link: SharedRun) => void,
  ) {
    this.gallery = Gallery.empty(base);
    this.select.addEventListener("change", () => void this.choose(this.select.value));
    session.listen({ valuesChanged: () => this.soon.ask() });
  }

  /** Fills the list of choices. */
  offer(gallery: Gallery): void {
    this.gallery = gallery;
    this.fill();
  }

  /** Opens the scenario of the address; if that fails, the default scenario. */
  async openAddress(): Promise<void> {
    if (holdsRun(location.hash)) return this.openLink(location.hash);
    const asked = askedBy(location.search);
    const { first } = this;
    if (asked.scenario === null) return void (await this.openAsked({ ...first, values: { ...first.values, ...asked.values } }));
    if (!(await this.openAsked(asked))) await this.openFirst(this.session.fault);
  }

  /** The default scenario. */
  private get first(): Asked {
    const { opening } = this.gallery;
    return opening ? openingOf(opening) : OPENING;
  }

  /** Opens the default scenario instead of one that cannot be opened, and reports the reason. */
  private async openFirst(why: Fault | null): Promise<void> {
    // If the engine does not work, another scenario would fail too.
    if (isOfEngine(why) || !(await this.openAsked(this.first))) return;
    history.replaceState(null, "", location.pathname + (this.gallery.opening ? "" : queryOf(this.first)));
    if (why) this.session.report(why);
  }

  /** Opens the run in the address; if it cannot be opened, the present run stays. */
  private async openLink(hash: string): Promise<void> {
    const why = await this.triedLink(hash);
    if (!why) return;
    if (!this.session.run && !isOfEngine(why)) return this.openFirst({ ...why, note: texts.share.opened_first });
    if (this.session.run) this.write();
    this.session.report(why);
  }

  /** Opens the run in the address; returns the reason if it cannot be opened. */
  private async triedLink(hash: string): Promise<Fault | null> {
    try {
      const link = await runIn(hash);
      const source = await this.sourceOf(link);
      if (!(await this.open(LINK + hash, source, link.values))) return this.session.fault;
      const title = texts.share.from_link(this.session.run!.model.title);
      this.keep(LINK + hash, { source, values: link.values, title, hash, link });
      this.linked(link);
      return null;
    } catch (fault) {
      return asFault(fault);
    }
  }

  private async sourceOf({ scenario, changes }: SharedRun): Promise<Source> {
    const source = "gallery" in scenario ? await this.gallery.read(scenario.gallery) : scenario;
    return { ...source, changes };
  }

  /**
   * Opens a scenario; if it refuses the values of the address, opens it with its own values and reports the refusal.
   */
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
    return this.open(name, this.gallery.read(name), values);
  }

  private async open(choice: string, source: Source | Promise<Source>, values: Values): Promise<boolean> {
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

  /** Opens the user's choice and writes it to the address, so that the address can be sent as a link and Back works. */
  private async choose(choice: string): Promise<void> {
    const own = this.own.get(choice);
    if (!(await (own ? this.openOwn(choice, own) : this.openNamed(choice, openingOf(choice).values)))) return;
    history.pushState({ choice }, "", location.pathname + this.address());
  }

  /** Whether a history state belongs to a file that the user opened, or to a link. */
  holds(state: Choice | null): boolean {
    return state !== null && this.own.has(state.choice);
  }

  /** Opens what the address or the history asks for; a scenario that is already open stays. */
  async goTo(state: Choice | null): Promise<void> {
    this.soon.cancel();
    const own = state && this.own.get(state.choice);
    const asked = location.search + (holdsRun(location.hash) ? location.hash : "");
    if (own ? this.shown === state.choice : this.shown !== "" && asked !== "" && asked === this.address()) return;
    if (own) await this.openOwn(state.choice, own);
    else await this.openAddress();
  }

  /** Opens a scenario together with the files that it names. */
  async openFiles(dropped: Record<string, string>): Promise<void> {
    const file = scenarioAmong(dropped);
    if (!file) return this.session.report(faultOfDatabase(Object.keys(dropped)[0]));
    const { [file]: text, ...opened } = dropped;
    const choice = FILE + file;
    const source = { text, file, opened };
    if (!(await this.open(choice, source, {}))) return;
    this.keep(choice, { source, values: {}, title: file, hash: "" });
    history.pushState({ choice }, "", location.pathname + this.address());
  }

  private keep(choice: string, own: Own): void {
    this.own.set(choice, own);
    this.fill();
  }

  private fill(): void {
    const named = this.gallery.groups.map(({ title, entries }) => {
      const options = entries.map((entry) => make("option", { value: entry.name, lang: "en" }, entry.title || entry.name));
      return make("optgroup", { label: title ?? texts.start.ungrouped, lang: title ? "en" : language }, ...options);
    });
    const own = Array.from(this.own, ([choice, { title }]) => make("option", { value: choice }, title));
    this.select.replaceChildren(...named, ...own);
    this.select.value = this.shown;
  }

  /** Returns the part of the address after its path: empty for a file of the user; a link is kept. */
  private address(): string {
    const own = this.own.get(this.shown);
    return own ? own.hash : queryOf({ scenario: this.shown, values: this.session.values.wanted });
  }

  private writeValues(): void {
    if (this.session.values.wanted !== this.values && this.shown !== "") this.write();
  }

  private write(): void {
    history.replaceState(history.state, "", location.pathname + this.address());
  }
}
