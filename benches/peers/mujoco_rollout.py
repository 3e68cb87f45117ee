"""MuJoCo's ``rollout``: many runs of one model on one thread or several, in the manner of the other programs.

``mujoco_rollout.py MODEL OPERATION MODE NUMBERS`` with the operations ``batch_euler_1``, ``batch_rk4_2`` and
so on: scheme and threads. MODEL.xml and MODEL.txt are those of ``mujoco_bench``, and the same stages are
switched off. All arrays are made before the clock starts and the checks are skipped, so that the cost of the
Python call is negligible.

    time BATCHES STEPS   a line per batch: nanoseconds per step and run
    check STEPS          qpos and qvel of the first run after that many steps, one number per line
"""

from __future__ import annotations

import sys
import time
from pathlib import Path

import mujoco
import numpy as np
from mujoco.rollout import Rollout

RUNS = 128
# run k starts with a velocity larger by k thousandths, so that all runs differ
SPREAD = 1e-3
INTEGRATORS = {"euler": mujoco.mjtIntegrator.mjINT_EULER, "rk4": mujoco.mjtIntegrator.mjINT_RK4}


class Runs:
    """A number of runs from fixed states, under a constant generalized force."""

    def __init__(self, path: str, operation: str, steps: int) -> None:
        """Makes model, threads and arrays."""
        _, scheme, threads = operation.split("_")
        self.model = mujoco.MjModel.from_xml_path(f"{path}.xml")
        self.model.opt.integrator = INTEGRATORS[scheme]
        flags = mujoco.mjtDisableBit
        off = [flags.mjDSBL_SPRING, flags.mjDSBL_DAMPER, flags.mjDSBL_AUTORESET, flags.mjDSBL_GRAVITY]
        for flag in off:
            self.model.opt.disableflags |= flag.value
        self.data = [mujoco.MjData(self.model) for _ in range(int(threads))]
        self.pool = Rollout(nthread=int(threads) if int(threads) > 1 else 0)
        self.steps = steps
        self._make_arrays(path)

    def _make_arrays(self, path: str) -> None:
        """Makes arrays of initial states, forces and results."""
        lines = (line.split() for line in Path(f"{path}.txt").read_text().splitlines())
        start = {name: np.array([float(x) for x in numbers]) for name, *numbers in lines}
        spec = mujoco.mjtState.mjSTATE_FULLPHYSICS
        size = mujoco.mj_stateSize(self.model, spec)
        self.initial = np.empty((RUNS, size))
        for run in range(RUNS):
            self.data[0].qpos[:] = start["qpos"]
            self.data[0].qvel[:] = start["qvel"] * (1.0 + SPREAD * run)
            mujoco.mj_getState(self.model, self.data[0], self.initial[run], spec)
        self.force = np.tile(start["qfrc"], (RUNS, self.steps, 1))
        self.state = np.empty((RUNS, self.steps, size))
        self.sensors = np.empty((RUNS, self.steps, self.model.nsensordata))

    def run(self) -> None:
        """Runs all steps of all runs."""
        self.pool.rollout(
            [self.model] * RUNS,
            self.data,
            self.initial,
            self.force,
            control_spec=mujoco.mjtState.mjSTATE_QFRC_APPLIED.value,
            skip_checks=True,
            nstep=self.steps,
            state=self.state,
            sensordata=self.sensors,
        )


def main(path: str, operation: str, mode: str, *numbers: str) -> None:
    """Runs the command line."""
    runs = Runs(path, operation, int(numbers[-1]))
    runs.run()  # warm-up
    if mode == "check":
        # the time precedes qpos and qvel
        print("\n".join(repr(float(x)) for x in runs.state[0, -1, 1:]))
        return
    for _ in range(int(numbers[0])):
        start = time.perf_counter_ns()
        runs.run()
        print((time.perf_counter_ns() - start) / (RUNS * runs.steps))


if __name__ == "__main__":
    main(*sys.argv[1:])
