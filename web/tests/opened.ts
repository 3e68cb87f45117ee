import type { Moment } from "../src/app/recording/recording";
import type { Run } from "../src/app/session";
import { Columns } from "../src/engine/columns";
import { readModel } from "../src/engine/engine";
import type { Channel, DrawnLine } from "../src/engine/engine";
import { Simulation } from "../src/engine/pkg/kingpost_wasm.js";
import { filesOf, initEngine, read } from "./gallery";

await initEngine();

/** A scenario of the gallery, with the data that the page reads. */
export interface Opened {
  /** The simulation, at its start until a test steps it. */
  simulation: Simulation;
  run: Run;
  start: Moment;
  /** Returns the present moment of the simulation. */
  moment(): Moment;
}

const known = new Map<string, { opened: Promise<Opened>; begin?: Uint8Array }>();

async function open(name: string): Promise<Opened> {
  const text = read(`scenarios/${name}.yaml`);
  const simulation = new Simulation(text, name, "{}", await filesOf(text));
  const channels = JSON.parse(simulation.channels_json()) as Channel[];
  const run = { model: readModel(simulation.model_json()), lines: JSON.parse(simulation.lines_json()) as DrawnLine[], channels, columns: new Columns(channels) } as unknown as Run;
  const moment = (): Moment => ({ time_s: simulation.time_s(), row: simulation.row(), poses: simulation.poses(), line_points: simulation.line_points(), surface: null });
  return { simulation, run, start: moment(), moment };
}

/** Opens a scenario once per process and resets it for each caller, because the test files share it. */
export async function opened(name: string): Promise<Opened> {
  const one = known.get(name) ?? { opened: open(name) };
  known.set(name, one);
  const found = await one.opened;
  one.begin ??= found.simulation.snapshot();
  found.simulation.restore(one.begin);
  return found;
}
