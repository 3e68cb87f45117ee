import { stemOf } from "../app/saved";
import type { Session } from "../app/session";
import { rowsAsCsv, rowsOfRunsAsCsv } from "../export/csv";
import type { NamedRows } from "../export/csv";
import { gathered, keptOf } from "../export/rows";
import type { MadeFile } from "../export/run_files";
import type { KeptRun } from "./kept";
import { words } from "./words";

const CSV = { type: "text/csv" };

/** Returns the approximate number of rows of a run before any were thinned. */
export function recordedOf(run: KeptRun): number {
  return keptOf(run.rows, run.facts.model).recorded;
}

/** Makes the CSV file of a kept run, as it was made of the run while it was present. */
export async function fileOf(run: KeptRun): Promise<MadeFile> {
  const parts = await gathered(rowsAsCsv(run.facts.columns.names, run.rows.map(({ row }) => row)));
  return { name: `${run.facts.stem}-${run.mark}.csv`, content: new Blob(parts, CSV) };
}

/** Makes one CSV file of the present run and of kept runs. */
export async function fileOfAll(session: Session, runs: readonly KeptRun[]): Promise<MadeFile> {
  const present: NamedRows = { run: words.present, names: session.run!.columns.names, rows: session.shown.recording!.rows.items.map(({ row }) => row) };
  const kept = runs.map(({ mark, name, facts, rows }): NamedRows => ({ run: `${mark}: ${name}`, names: facts.columns.names, rows: rows.map(({ row }) => row) }));
  const parts = await gathered(rowsOfRunsAsCsv([present, ...kept]));
  return { name: `${stemOf(session.source?.file ?? "run")}-runs.csv`, content: new Blob(parts, CSV) };
}
