import { expect, it } from "vitest";
import { Futures } from "../src/forecast/futures";
import { Outlook } from "../src/forecast/outlook";
import { pastOf } from "../src/forecast/past";
import { judgedColumns, scoreOf } from "../src/forecast/score";
import type { EngineInSeas } from "../src/forecast/sea";
import { Recording } from "../src/app/recording/recording";
import { Columns } from "../src/engine/columns";
import { readModel } from "../src/engine/engine";
import type { ModelInfo, Values } from "../src/engine/engine";
import type { Frame } from "../src/engine/messages";
import { Simulation } from "../src/engine/pkg/kingpost_wasm.js";
import { filesOf, initEngine, read } from "./gallery";
import { isThorough } from "./lane.mjs";

// docs/afloat.md has the figure of 200 windows: KINGPOST_LANE=thorough FORECAST_WINDOWS=200 FORECAST_FUTURES=64 npx vitest run tests/forecast_coverage.test.ts
const WINDOWS = Number(process.env.FORECAST_WINDOWS ?? 8);
const FUTURES = Number(process.env.FORECAST_FUTURES ?? 32);
/** First start time, after the ramp of the waves and the slewing of the crane, s. */
const FIRST_S = 160;
const WINDOWS_OF_A_SEED = 8;
const HORIZON_S = 60;
const EVERY_S = 0.6;

await initEngine();
const text = read("scenarios/offshore_vessel.yaml");
const files = await filesOf(text);

const vessel = (seed: number): EngineInSeas =>
  new Simulation(text, "offshore_vessel.yaml", JSON.stringify({ waves: true, "simulation.seed": seed }), files);

/** The recording of a run, as the page makes it. */
class Truth {
  readonly model: ModelInfo;
  readonly columns: Columns;
  readonly recording: Recording;

  constructor(readonly engine: EngineInSeas) {
    this.model = readModel(engine.model_json());
    this.columns = new Columns(JSON.parse(engine.channels_json()));
    this.recording = new Recording(this.columns, EVERY_S, this.frame(), {});
  }

  runTo(end_s: number): void {
    while (this.engine.time_s() < end_s - 1e-9) {
      this.engine.step(Math.round(EVERY_S / this.engine.step_s()));
      this.recording.add(this.frame(), {} as Values);
    }
  }

  private frame(): Frame {
    const { engine } = this;
    const [row, poses] = [engine.row(), engine.poses()];
    const none = new Float64Array();
    return { rows: row, row_poses: poses, row_line_points: none, keyframes: [], row, poses, line_points: none, surface: null, warnings: [], events: [], changes: [], isPart: false, fault: null };
  }
}

function outlookFrom({ engine, model, columns, recording }: Truth, futures: Futures): Outlook {
  const past = pastOf(model, columns, recording, engine.time_s());
  futures.begin({ snapshot: engine.snapshot(), past, horizon_s: HORIZON_S, every_s: EVERY_S });
  const outlook = new Outlook(FUTURES, columns.width);
  for (let seed = 1; seed <= FUTURES; seed++) {
    const running = futures.run(1000 * engine.time_s() + seed);
    let next = running.next();
    while (!next.done) next = running.next();
    outlook.add(next.value);
  }
  return outlook;
}

/** Returns the share of the true values inside the band in one window, by column. */
function held(truth: Truth, futures: Futures): number[] {
  const outlook = outlookFrom(truth, futures);
  truth.runTo(outlook.end_s);
  const rowAt = (time_s: number) => truth.recording.rowAt(time_s);
  return judgedColumns(truth.model, truth.columns).map((place) => {
    const score = scoreOf(outlook, [place], rowAt);
    expect(score.of).toBe(HORIZON_S / EVERY_S);
    return score.held / score.of;
  });
}

const mean = (values: number[]) => values.reduce((sum, value) => sum + value, 0) / values.length;

// Only many windows give a share to a few per cent.
it.runIf(isThorough)("the 90 % band of a ship in waves contains 90 % of the later values", { timeout: 7_200_000 }, () => {
  const windows: number[][] = [];
  for (let seed = 1; windows.length < WINDOWS; seed++) {
    const truth = new Truth(vessel(seed));
    const futures = new Futures(vessel(seed), () => vessel(seed));
    truth.runTo(FIRST_S);
    for (let k = 0; k < WINDOWS_OF_A_SEED && windows.length < WINDOWS; k++) {
      windows.push(held(truth, futures));
      truth.runTo(truth.engine.time_s() + HORIZON_S);
    }
    [truth.engine, futures].forEach((one) => one.free());
  }
  const shares = windows.map(mean);
  const all = mean(shares);
  const spread = Math.sqrt(mean(shares.map((share) => (share - all) ** 2)));
  const byColumn = windows[0].map((_, i) => mean(windows.map((window) => window[i])).toFixed(3));
  console.log(`${WINDOWS} windows of ${FUTURES} futures: the 90 % band held ${(100 * all).toFixed(1)} %, from window to window +-${(100 * spread).toFixed(1)} %; by column ${byColumn.join(" ")}`);
  expect(all).toBeGreaterThan(0.85);
  expect(all).toBeLessThan(0.95);
});
