import { stemOf } from "../app/saved";
import type { Run, Session } from "../app/session";
import type { Warning } from "../engine/engine";
import type { Happened } from "../engine/messages";
import { eventsAsCsv, rowsAsCsv, written } from "./csv";
import { parquetOf } from "./parquet";
import { gathered, keptOf } from "./rows";
import type { Kept } from "./rows";

/** A file that is ready to be saved. */
export interface MadeFile {
  name: string;
  content: Blob;
}

/** Values of attributes, equal to those in results of the Python package. */
const FINISHED = "finished";
const MODEL = "model";
const AXES = "world: z up, x forward, y to port; body: at its centre of mass, ship x forward, y to port";

/** Makes files of the recording of the present run. */
export class RunFiles {
  constructor(private readonly session: Session) {}

  get stem(): string {
    return stemOf(this.session.source?.file ?? "run");
  }

  get kept(): Kept {
    const { run, shown } = this.session;
    return keptOf(shown.recording!.rows.items, run!.model);
  }

  get hasEvents(): boolean {
    return (this.session.shown.recording?.events.length ?? 0) > 0;
  }

  async csv(): Promise<MadeFile> {
    const { names } = this.session.run!.columns;
    const parts = await gathered(rowsAsCsv(names, this.kept.rows.map(({ row }) => row)));
    return { name: `${this.stem}.csv`, content: new Blob(parts, { type: "text/csv" }) };
  }

  async events(): Promise<MadeFile> {
    return { name: `${this.stem}.events.csv`, content: new Blob([eventsAsCsv(this.session.shown.recording!.events)], { type: "text/csv" }) };
  }

  async parquet(): Promise<MadeFile> {
    const run = this.session.run!;
    const { rows } = this.kept;
    const units = run.channels.flatMap((channel) => channel.units);
    const columns = run.columns.names.map((name, at) => ({ name, unit: units[at], data: Float64Array.from(rows, ({ row }) => row[at]) }));
    const file = await parquetOf(columns, await this.about(run));
    return { name: `${this.stem}.parquet`, content: new Blob([file], { type: "application/vnd.apache.parquet" }) };
  }

  /** Returns the attributes of the run that `kingpost.results` also has, as far as the page knows them. */
  private async about({ model }: Run): Promise<Record<string, string>> {
    const { recorded, rows } = this.kept;
    const scenario = await this.session.resolved();
    const bodies = model.bodies.filter(({ floats }) => floats).map(({ name }) => name);
    const { events, warnings } = this.session.shown.recording!;
    return {
      title: model.title,
      status: this.status(model.duration_s),
      source: this.session.source?.file ?? "",
      ...(scenario ? { scenario, seed: seedOf(scenario) } : {}),
      gravity_m_s2: written(model.gravity_m_s2),
      water_density_kg_m3: written(model.sea?.density_kg_m3 ?? 0),
      floating_bodies: bodies.join(" "),
      entries: entriesOf(model.warnings, warnings, events),
      axes: AXES,
      ...(recorded > rows.length ? { thinned: `${rows.length} of about ${recorded} rows` } : {}),
    };
  }

  private status(duration_s: number): string {
    const { fault, shown, status } = this.session;
    if (status === "stopped" && fault) return fault.message;
    return shown.recording!.now.time_s >= duration_s - 1e-9 ? FINISHED : `paused at ${shown.recording!.now.time_s} s`;
  }
}

/**
 * Returns events and warnings as JSON, with the fields of `kingpost.results.entries`. Limits are left out: the page does
 * not ask the engine for them.
 */
export function entriesOf(ofModel: readonly string[], warnings: readonly Warning[], events: readonly Happened[]): string {
  const before = ofModel.map((text) => ({ time_s: null, code: MODEL, name: "", value: null, bound: null, unit: "", text }));
  const happened = events.map(({ time_s, code, name, text }) => ({ time_s, element: name, code, what: text }));
  return JSON.stringify({ events: happened, warnings: [...before, ...warnings] });
}

/** Returns the seed of a resolved scenario as it is written in the text: JSON.parse would round a seed beyond 2^53. */
function seedOf(scenario: string): string {
  return /"seed":\s*(\d+)/.exec(scenario)?.[1] ?? "0";
}
