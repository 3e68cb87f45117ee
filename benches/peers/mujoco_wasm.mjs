// MuJoCo's official WASM build under node: mujoco_wasm.mjs MODEL OPERATION MODE NUMBERS
// Model, state and switches are those of mujoco_bench.cpp beside this file. Each evaluation is a call from JavaScript, the
// only way into that build.
import { readFileSync } from 'node:fs';
import loadMujoco from '@mujoco/mujoco';
import { measured } from '../measured.mjs';

const [, , path, operation, mode, ...numbers] = process.argv;
const mujoco = await loadMujoco();
const model = mujoco.MjModel.from_xml_string(readFileSync(`${path}.xml`, 'utf8'));
const { mjtDisableBit: off, mjtIntegrator: schemes } = mujoco;
model.opt.disableflags |= off.mjDSBL_AUTORESET.value | off.mjDSBL_SPRING.value | off.mjDSBL_DAMPER.value;
if (model.opt.gravity[2] === 0) model.opt.disableflags |= off.mjDSBL_GRAVITY.value;
model.opt.integrator = (operation === 'euler_step' ? schemes.mjINT_EULER : schemes.mjINT_RK4).value;
const data = new mujoco.MjData(model);
const start = Object.fromEntries(
  readFileSync(`${path}.txt`, 'utf8').trim().split('\n').map((line) => {
    const [name, ...values] = line.trim().split(/\s+/);
    return [name, values.map(Number)];
  }),
);
if (start.qpos.length !== model.nq || start.qvel.length !== model.nv) throw new Error('the state does not fit the model');

const evaluate = operation === 'forward' ? mujoco.mj_forward : mujoco.mj_step;
measured(
  {
    reset() {
      mujoco.mj_resetData(model, data);
      data.qpos.set(start.qpos);
      data.qvel.set(start.qvel);
      data.qfrc_applied.set(start.qfrc);
    },
    repeat(times) {
      for (let k = 0; k < times; k += 1) evaluate(model, data);
    },
    result: () => (operation === 'forward' ? [...data.qacc] : [...data.qpos, ...data.qvel]),
  },
  mode,
  numbers.map(Number),
);
