import type { Recording } from "../app/recording/recording";
import { stemOf } from "../app/saved";
import type { Run, Session } from "../app/session";
import type { Values } from "../engine/engine";
import { KeptRun, RUN_COLOURS } from "./kept";
import type { Facts } from "./kept";
import { KEPT_BYTES, thin } from "./memory";
import { markOf, nameOf, unlike } from "./naming";
import { words } from "./words";

/** Largest number of kept runs in the plots: one for each colour. */
export const MOST_SHOWN = RUN_COLOURS.length;

export const COMPARISONS = ["lines", "difference"] as const;
export type Comparison = (typeof COMPARISONS)[number];

/** The list of kept runs. A run that is left at an earlier moment joins it; nothing is stored beyond the page. */
export class Runs {
  /** Whether a run that a reset or another scenario ends is kept too. */
  keepsAtReset = false;
  comparison: Comparison = "lines";
  /** Run whose bodies the picture shows beside the present ones. */
  ghost: KeptRun | null = null;
  /** Says which run was kept last. */
  said = "";
  private kept: readonly KeptRun[] = [];
  private readonly facts = new WeakMap<Run, Facts>();
  private first: Values = {};
  private readonly listeners: (() => void)[] = [];

  constructor(
    private readonly session: Session,
    private readonly limit = KEPT_BYTES,
  ) {
    session.listen({
      opened: (_run, _frame, isAnother) => {
        if (isAnother) this.first = session.values.inForce;
      },
      leaves: (run, recording, from_s) => {
        const isKept = from_s === null ? this.keepsEnded(recording) : recording.rows.last!.time_s > from_s;
        if (isKept) this.take(run, recording, from_s);
      },
    });
  }

  /** Whether a run is kept that a reset ends: one that was steered by hand cannot be repeated after a restart with other values. */
  private keepsEnded({ rows, changes }: Recording): boolean {
    const isSteered = changes.length > 0 && this.session.pending().length > 0;
    return rows.items.length > 1 && (this.keepsAtReset || isSteered);
  }

  get all(): readonly KeptRun[] {
    return this.kept;
  }

  /** Runs that the plots show. */
  get shown(): readonly KeptRun[] {
    return this.kept.filter(({ isShown }) => isShown);
  }

  /** Calls a listener after a change of the list, or of how the page shows a run. */
  onChange(listener: () => void): void {
    this.listeners.push(listener);
  }

  private tell(): void {
    for (const listener of this.listeners) listener();
  }

  /** Keeps the present run as it is recorded so far; null if nothing is recorded or the memory is full. */
  keep(): KeptRun | null {
    const { run, shown } = this.session;
    return run && shown.recording && this.take(run, shown.recording, null);
  }

  private take(run: Run, recording: Recording, left_s: number | null): KeptRun | null {
    const last = recording.rows.last;
    // A run that is kept twice without a new row is one run.
    const same = this.kept.find(({ rows }) => rows[rows.length - 1] === last);
    if (same) return this.found(same);
    const { begun } = this.session.values;
    const name = nameOf({ model: run.model, first: this.first, begun, changes: recording.changes, left_s });
    const taken = new KeptRun(markOf(this.kept.map(({ mark }) => mark)), unlike(name, this.kept.map((one) => one.name)), RUN_COLOURS[0], this.factsOf(run), recording);
    if (!thin([...this.kept, taken], this.limit)) {
      this.session.report({ kind: "runs", message: words.full });
      return null;
    }
    taken.isShown = this.shown.length < MOST_SHOWN;
    taken.colour = this.freeColour();
    this.kept = [...this.kept, taken];
    return this.found(taken);
  }

  private found(run: KeptRun): KeptRun {
    this.said = words.said(run.mark, run.name);
    this.tell();
    return run;
  }

  /** Describes a run once for all runs that are kept of it. */
  private factsOf(run: Run): Facts {
    const known = this.facts.get(run);
    if (known) return known;
    const { channels, columns } = run;
    const model = { ...run.model, hulls: run.model.hulls.map((hull) => ({ ...hull, mesh: null })) };
    const bytes = 2 * JSON.stringify([model, channels, columns.names]).length;
    const facts = { model, channels, columns, stem: stemOf(this.session.source?.file ?? "run"), lines: new Map(), bytes };
    this.facts.set(run, facts);
    return facts;
  }

  /** Returns the first colour that no other run in the plots has. */
  private freeColour(but?: KeptRun): string {
    const taken = this.shown.filter((run) => run !== but).map(({ colour }) => colour);
    return RUN_COLOURS.find((colour) => !taken.includes(colour)) ?? RUN_COLOURS[this.kept.length % RUN_COLOURS.length];
  }

  rename(run: KeptRun, name: string): void {
    if (name.trim() !== "") run.name = name.trim();
    this.tell();
  }

  /** Shows a run in the plots, or hides it; a colour that another run has taken is replaced. */
  show(run: KeptRun, isShown: boolean): void {
    if (isShown && !run.isShown) {
      if (this.shown.length >= MOST_SHOWN) return this.tell();
      if (this.shown.some(({ colour }) => colour === run.colour)) run.colour = this.freeColour();
    }
    run.isShown = isShown;
    this.tell();
  }

  /** Gives a run the next colour that no other run in the plots has. */
  recolour(run: KeptRun): void {
    const taken = this.shown.filter((other) => other !== run).map(({ colour }) => colour);
    const place = RUN_COLOURS.indexOf(run.colour);
    const next = RUN_COLOURS.map((_, i) => RUN_COLOURS[(place + 1 + i) % RUN_COLOURS.length]);
    run.colour = next.find((colour) => !taken.includes(colour)) ?? run.colour;
    this.tell();
  }

  haunt(run: KeptRun | null): void {
    this.ghost = run;
    this.tell();
  }

  compare(comparison: Comparison): void {
    this.comparison = comparison;
    this.tell();
  }

  remove(...runs: readonly KeptRun[]): void {
    this.kept = this.kept.filter((run) => !runs.includes(run));
    if (this.ghost && runs.includes(this.ghost)) this.ghost = null;
    this.said = "";
    this.tell();
  }
}
