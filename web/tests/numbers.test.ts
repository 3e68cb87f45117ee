import { createHash } from "node:crypto";
import { expect, it } from "vitest";
import { Recording } from "../src/app/recording/recording";
import { Columns } from "../src/engine/columns";
import type { Values } from "../src/engine/engine";
import { Simulation } from "../src/engine/pkg/kingpost_wasm.js";
import { Runner } from "../src/engine/runner";
import { filesOf, initEngine, read } from "./gallery";

interface Kept {
  scenario: string;
  overrides: Values;
  /** Indices of rows, and digests of these rows as `kingpost run` writes them. */
  places: number[];
  sha256: string[];
}

const kept: Kept[] = JSON.parse(read("web/tests/numbers.json"));
await initEngine();

const digest = (row: ArrayLike<number>) => createHash("sha256").update(new Uint8Array(Float64Array.from(row).buffer)).digest("hex");

it.each(kept)("a run in the app has the same bits as kingpost run at ten times of $scenario", async ({ scenario, overrides, places, sha256 }) => {
  const text = read(`scenarios/${scenario}.yaml`);
  const files = await filesOf(text);
  const runner = new Runner((opened, file, values) => new Simulation(opened, file, values, files), () => 0);
  const { channels, model, frame } = runner.open(text, `${scenario}.yaml`, overrides);
  const recording = new Recording(new Columns(channels), Math.max(model.record_every_s, model.step_s), frame, {});
  for (let place = 1; place <= places.at(-1)!; place += 1) recording.add(runner.step(), {});
  const found = places.map((place) => digest(recording.at(recording.nearest(place * model.record_every_s)).row));
  expect(found).toEqual(sha256);
});
