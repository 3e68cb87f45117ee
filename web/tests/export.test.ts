import { readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { parquetMetadata, parquetReadObjects } from "hyparquet";
import { describe, expect, it } from "vitest";
import { Columns } from "../src/engine/columns";
import type { Channel } from "../src/engine/engine";
import { Simulation } from "../src/engine/pkg/kingpost_wasm.js";
import { eventsAsCsv, rowsAsCsv, written } from "../src/export/csv";
import { parquetOf } from "../src/export/parquet";
import { keptOf } from "../src/export/rows";
import { bits, filesOf, initEngine, read } from "./gallery";

/** Files that Python's tests compare with their own output for the same run: python/tests/test_app_files.py. */
const golden = (name: string) => fileURLToPath(new URL(`golden/${name}`, import.meta.url));

/** 0.05 s of the paper's ship, as the app records them. */
async function recorded(): Promise<{ channels: Channel[]; rows: Float64Array[] }> {
  await initEngine();
  const text = read("scenarios/paper.yaml");
  const simulation = new Simulation(text, "paper", "{}", await filesOf(text));
  const rows = [simulation.row()];
  for (let i = 0; i < 5; i++) {
    simulation.step(10);
    rows.push(simulation.row());
  }
  return { channels: JSON.parse(simulation.channels_json()), rows };
}

describe("a CSV file", () => {
  it("a CSV file has numbers as Python writes them", () => {
    const pairs: [number, string][] = [
      [0, "0.0"], [-0, "-0.0"], [1, "1.0"], [-2.5, "-2.5"], [120, "120.0"], [0.1, "0.1"], [1 / 3, "0.3333333333333333"],
      [1e-4, "0.0001"], [1e-5, "1e-05"], [-1.25e-7, "-1.25e-07"], [1e15, "1000000000000000.0"], [1e16, "1e+16"], [1.5e300, "1.5e+300"],
      [123456789.125, "123456789.125"], [5e-324, "5e-324"], [NaN, ""], [Infinity, "inf"], [-Infinity, "-inf"],
    ];
    for (const [value, text] of pairs) expect(written(value)).toBe(text);
  });

  it("numbers of a CSV file are read back to the same bits", () => {
    let seed = 7;
    const random = () => (seed = (seed * 1103515245 + 12345) % 2 ** 31) / 2 ** 31;
    const values = Float64Array.from({ length: 2000 }, () => (random() - 0.5) * 10 ** Math.round(60 * (random() - 0.5)));
    expect(bits(values.map((value) => Number(written(value))))).toEqual(bits(values));
  });

  it("a CSV file has the names of the columns, then one row for each record", () => {
    const text = [...rowsAsCsv(["time", "a,b"], [[0, 1.5], Float64Array.of(0.1, -2)])].join("");
    expect(text).toBe('time,"a,b"\n0.0,1.5\n0.1,-2.0\n');
  });

  it("the CSV file of a run is identical to the file that Python writes", async () => {
    const { channels, rows } = await recorded();
    expect([...rowsAsCsv(new Columns(channels).names, rows)].join("")).toBe(readFileSync(golden("paper.csv"), "utf8"));
  });

  it("a CSV file of events has texts in quotes if they need quotes", () => {
    expect(eventsAsCsv([{ time_s: 2, code: "slides", name: "deck", text: 'slides, then "stops"' }])).toBe(
      'event_time,event_code,event_element,event_what\n2.0,slides,deck,"slides, then ""stops"""\n',
    );
  });
});

describe("a Parquet file", () => {
  it("a Parquet file has the columns to the same bits, their units and the attributes of the run", async () => {
    const columns = [
      { name: "time", unit: "s", data: Float64Array.from({ length: 3000 }, (_, i) => 0.1 * i) },
      { name: "hull.roll", unit: "rad", data: Float64Array.from({ length: 3000 }, (_, i) => Math.sin(i)) },
    ];
    const file = await parquetOf(columns, { title: "A box", status: "finished" });
    const rows = (await parquetReadObjects({ file })) as Record<string, number>[];
    expect(Object.keys(rows[0])).toEqual(["time", "hull.roll"]);
    for (const { name, data } of columns) expect(bits(rows.map((row) => row[name]))).toEqual(bits(data));
    const kept = Object.fromEntries(parquetMetadata(file).key_value_metadata!.map(({ key, value }) => [key, value]));
    expect(kept).toMatchObject({ title: "A box", status: "finished" });
    expect(JSON.parse(kept.units!)).toEqual({ time: "s", "hull.roll": "rad" });
  });

  it("a Parquet file is identical to the stored file that Python's tests read", async () => {
    const { channels, rows } = await recorded();
    const units = channels.flatMap((channel) => channel.units);
    const columns = new Columns(channels).names.map((name, at) => ({ name, unit: units[at], data: Float64Array.from(rows, (row) => row[at]) }));
    const file = await parquetOf(columns, { title: "Crane ship of Jardim et al. (2019)" });
    // GOLDEN=write stores the file again, for Python's tests.
    if (process.env.GOLDEN === "write") writeFileSync(golden("paper.parquet"), new Uint8Array(file));
    const stored = new Uint8Array(readFileSync(golden("paper.parquet"))).buffer;
    expect(await parquetReadObjects({ file: stored })).toEqual(await parquetReadObjects({ file }));
    expect(parquetMetadata(stored).key_value_metadata).toEqual(parquetMetadata(file).key_value_metadata);
  });
});

describe("kept rows of a recording", () => {
  const row = (time_s: number) => ({ time_s, row: Float64Array.of(time_s), poses: new Float64Array(), line_points: new Float64Array() });
  const model = { record_every_s: 0.5, step_s: 0.01 } as Parameters<typeof keptOf>[1];

  it("all rows of a short run are kept, also if it ended off the grid", () => {
    const items = [...Array.from({ length: 21 }, (_, i) => row(0.5 * i)), row(10.2)];
    expect(keptOf(items, model)).toMatchObject({ recorded: 22, thinnedUntil_s: null, last_s: 10.2 });
    expect(keptOf([row(0)], model)).toMatchObject({ recorded: 1, thinnedUntil_s: null });
  });

  it("a thinned recording reports the number of missing rows and their last time", () => {
    const items = Array.from({ length: 401 }, (_, i) => row(0.5 * i)).filter(({ time_s }, i) => time_s >= 100 || i % 2 === 0);
    const kept = keptOf(items, model);
    expect([kept.rows.length, kept.recorded, kept.last_s]).toEqual([301, 401, 200]);
    expect(kept.thinnedUntil_s).toBe(100);
  });
});
