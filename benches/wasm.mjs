// Kingpost's WASM modules under node: wasm.mjs PACKAGE BENCH_MODULE MODEL OPERATION MODE NUMBERS
// The step with its ledger is the packed module's, as the browser app loads it; the other operations are
// the benchmark program's, compiled for WASM. MODEL.json is the resolved scenario, MODEL.files.json what it
// reads from other files, MODEL.txt and MODEL.snapshot the fixed state.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { measured } from './measured.mjs';

const [, , folder, benchModule, model, operation, mode, ...numbers] = process.argv;

async function packed() {
  const engine = await import(pathToFileURL(join(folder, 'kingpost_wasm.js')).href);
  engine.initSync({ module: readFileSync(join(folder, 'kingpost_wasm_bg.wasm')) });
  const start = readFileSync(`${model}.snapshot`);
  const scenario = readFileSync(`${model}.json`, 'utf8');
  const files = readFileSync(`${model}.files.json`, 'utf8');
  const simulation = new engine.Simulation(scenario, 'kingpost.json', '{}', files);
  return {
    reset: () => simulation.restore(start),
    repeat: (times) => simulation.step(times),
    result: () => positionsAndVelocities(simulation.row(), JSON.parse(simulation.channels_json())),
  };
}

// q and v from a row; the first body is the floating one
function positionsAndVelocities(row, channels) {
  return [
    ['position', 3],
    ['orientation', 4],
    ['joint_position', Infinity],
    ['velocity', 3],
    ['angular_velocity', 3],
    ['joint_velocity', Infinity],
  ].flatMap(([variable, count]) => {
    const { offset, len } = channels.find((channel) => channel.variable === variable);
    return [...row.slice(offset, offset + Math.min(count, len))];
  });
}

function bare() {
  const { exports } = new WebAssembly.Instance(new WebAssembly.Module(readFileSync(benchModule)));
  const endings = ['json', 'files.json', 'txt'];
  const texts = [...endings.map((ending) => readFileSync(`${model}.${ending}`)), Buffer.from(operation)];
  texts.forEach((text, index) => {
    const at = exports.text(index, text.length);
    new Uint8Array(exports.memory.buffer, at, text.length).set(text);
  });
  const must = (name, ...values) => {
    if (!exports[name](...values)) throw new Error(`${operation}: ${name} failed`);
  };
  must('prepare');
  return {
    reset: () => must('reset'),
    repeat: (times) => must('repeat', times),
    result: () => {
      const length = exports.result_length();
      return [...new Float64Array(exports.memory.buffer, exports.result(), length)];
    },
  };
}

const task = operation === 'rk4_step_ledger' ? await packed() : bare();
measured(task, mode, numbers.map(Number));
