// One RK4 step of Kingpost's WASM module under node: wasm.mjs PACKAGE MODEL OPERATION MODE NUMBERS
//   time BATCHES REPETITIONS   nanoseconds per step, a line per batch
//   check STEPS                q and v after that many steps
// MODEL.json is the resolved scenario, MODEL.snapshot the fixed state.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';

const [, , folder, model, operation, mode, ...numbers] = process.argv;
if (operation !== 'rk4_step_ledger') throw new Error(`unknown operation ${operation}`);

const engine = await import(pathToFileURL(join(folder, 'kingpost_wasm.js')).href);
engine.initSync({ module: readFileSync(join(folder, 'kingpost_wasm_bg.wasm')) });
const start = readFileSync(`${model}.snapshot`);
const simulation = new engine.Simulation(readFileSync(`${model}.json`, 'utf8'), 'kingpost.json', '{}');
const [first, second] = numbers.map(Number);

if (mode === 'time') {
  for (let batch = -1; batch < first; batch += 1) {
    simulation.restore(start);
    const begin = process.hrtime.bigint();
    simulation.step(second);
    const nanoseconds = Number(process.hrtime.bigint() - begin) / second;
    // the first batch warms up
    if (batch >= 0) console.log(nanoseconds.toFixed(3));
  }
} else {
  simulation.restore(start);
  simulation.step(first);
  const [row, channels] = [simulation.row(), JSON.parse(simulation.channels_json())];
  // the first body is the floating one
  for (const [variable, count] of [
    ['position', 3],
    ['orientation', 4],
    ['joint_position', 0],
    ['velocity', 3],
    ['angular_velocity', 3],
    ['joint_velocity', 0],
  ]) {
    const { offset, len } = channels.find((channel) => channel.variable === variable);
    for (const value of row.slice(offset, offset + (count || len))) console.log(value);
  }
}
