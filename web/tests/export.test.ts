import { parquetMetadata, parquetReadObjects } from "hyparquet";
import { describe, expect, it } from "vitest";
import { eventsAsCsv, rowsAsCsv, written } from "../src/export/csv";
import { parquetOf } from "../src/export/parquet";
import { bits } from "./gallery";

describe("a CSV file", () => {
  it("has numbers as Python writes them", () => {
    const pairs: [number, string][] = [
      [0, "0.0"], [-0, "-0.0"], [1, "1.0"], [-2.5, "-2.5"], [120, "120.0"], [0.1, "0.1"], [1 / 3, "0.3333333333333333"],
      [1e-4, "0.0001"], [1e-5, "1e-05"], [-1.25e-7, "-1.25e-07"], [1e15, "1000000000000000.0"], [1e16, "1e+16"], [1.5e300, "1.5e+300"],
      [123456789.125, "123456789.125"], [5e-324, "5e-324"], [NaN, ""], [Infinity, "inf"], [-Infinity, "-inf"],
    ];
    for (const [value, text] of pairs) expect(written(value)).toBe(text);
  });

  it("reads back to the same bits", () => {
    let seed = 7;
    const random = () => (seed = (seed * 1103515245 + 12345) % 2 ** 31) / 2 ** 31;
    const values = Float64Array.from({ length: 2000 }, () => (random() - 0.5) * 10 ** Math.round(60 * (random() - 0.5)));
    expect(bits(values.map((value) => Number(written(value))))).toEqual(bits(values));
  });

  it("has a row a record under the names of the columns", () => {
    const text = [...rowsAsCsv(["time", "a,b"], [[0, 1.5], Float64Array.of(0.1, -2)])].join("");
    expect(text).toBe('time,"a,b"\n0.0,1.5\n0.1,-2.0\n');
  });

  it("has what happened, with words in quotes where they need them", () => {
    expect(eventsAsCsv([{ time_s: 2, name: "deck", text: 'slides, then "stops"' }])).toBe(
      'event_time,event_element,event_what\n2.0,deck,"slides, then ""stops"""\n',
    );
  });
});

describe("a Parquet file", () => {
  it("has the columns bit for bit, with their units and what is said of the run", async () => {
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
});
