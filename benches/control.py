"""Control steps per second of the environments, compared with MuJoCo's rollout of an equal crane.

Prints ``engine|model|threads|steps_per_wall_s|steps_per_cpu_s``: the best of many short repetitions, because
a machine may be shared. A control step of ``anti_sway`` is 50 ms: 5 steps of semi-implicit Euler of 10 ms,
inputs set and all columns of the task read; MuJoCo's is 5 steps of its Euler, which is semi-implicit too.
``environment`` lines measure the whole interface of Gymnasium, including the reward in NumPy.
"""

from __future__ import annotations

import argparse
import os
import sys
import time
from collections.abc import Callable, Sequence

import numpy as np
from kingpost.learn import ShipCraneVectorEnv, Task, anti_sway, heave_compensation

COPIES = 512

CRANE = """
<mujoco><option timestep="0.01" integrator="Euler"><flag contact="disable"/></option>
<worldbody><body pos="0 0 0"><joint name="slew" type="hinge" axis="0 0 1"/>
<geom type="cylinder" size="1.5 4.5" pos="0 0 4.5" mass="40000"/>
<body pos="0 0 9" euler="0 -45 0"><joint name="luff" type="hinge" axis="0 1 0"/>
<geom type="box" size="15 0.6 0.6" pos="15 0 0" mass="25000"/>
<body pos="30 0 0" euler="0 45 0"><joint name="across" type="hinge" axis="1 0 0" damping="10000"/>
<joint name="along" type="hinge" axis="0 1 0" damping="10000"/>
<geom type="box" size="0.5 0.5 0.5" pos="0 0 -15" mass="2000"/>
<body pos="0 0 -15">
<joint type="hinge" axis="1 0 0" damping="2000"/><joint type="hinge" axis="0 1 0" damping="2000"/>
<geom type="box" size="1.5 1.5 1.25" pos="0 0 -5" mass="20000"/>
</body></body></body></body></worldbody>
<actuator><velocity joint="slew" kv="6e7"/><velocity joint="luff" kv="3e8"/></actuator></mujoco>
"""
"""The crane of `anti_sway` in MuJoCo: the same bodies and joints, with speed servos without limits or a
reference."""


def best(work: Callable[[], object], steps: int, repetitions: int) -> tuple[float, float]:
    """Steps per second of wall-clock time and of processor time, the best of some repetitions."""
    wall, processor = [], []
    work()
    for _ in range(repetitions):
        begun, used = time.perf_counter(), time.process_time()
        work()
        wall.append(time.perf_counter() - begun)
        processor.append(time.process_time() - used)
    return steps / min(wall), steps / max(min(processor), 1e-9)


def kingpost_engine(task: Task, copies: int, threads: int, repetitions: int) -> tuple[float, float]:
    """Measures the copies of the engine alone."""
    envs = ShipCraneVectorEnv(task, copies, threads)
    envs.reset(seed=0)
    episodes = envs.episodes
    inputs = np.zeros(copies * len(task.set))
    engine, read, status = episodes._copies, episodes._read, episodes._status
    assert engine is not None
    return best(lambda: engine.advance(task.steps, inputs, read, status), copies, repetitions)


def kingpost_environment(task: Task, copies: int, threads: int, repetitions: int) -> tuple[float, float]:
    """Measures the environments through Gymnasium's interface."""
    envs = ShipCraneVectorEnv(task, copies, threads)
    envs.reset(seed=0)
    actions = np.zeros((copies, len(task.set)), dtype=np.float32)
    return best(lambda: envs.step(actions), copies, repetitions)


def mujoco_rollout(copies: int, threads: int, repetitions: int) -> tuple[float, float]:
    """Measures MuJoCo's rollout of ten control steps in one call."""
    import mujoco
    from mujoco.rollout import Rollout

    model = mujoco.MjModel.from_xml_string(CRANE)
    data = [mujoco.MjData(model) for _ in range(threads)]
    start = np.empty(mujoco.mj_stateSize(model, mujoco.mjtState.mjSTATE_FULLPHYSICS))
    mujoco.mj_getState(model, data[0], start, mujoco.mjtState.mjSTATE_FULLPHYSICS)
    initial, control = np.tile(start, (copies, 1)), np.zeros((copies, 50, 2))
    with Rollout(nthread=threads if threads > 1 else 0) as rollout:
        return best(
            lambda: rollout.rollout([model] * copies, data, initial, control), 10 * copies, repetitions
        )


def main(arguments: Sequence[str] | None = None) -> int:
    """Runs the command line and returns its exit code."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--quick", action="store_true", help="run for a few seconds, only as a test")
    quick = parser.parse_args(arguments).quick
    copies, times = (16, 2) if quick else (COPIES, 60)
    print(f"# processors: {os.cpu_count()}, load: {' '.join(f'{load:.1f}' for load in os.getloadavg())}")
    for threads in (1, 2):
        measured = {
            "kingpost|anti_sway": kingpost_engine(anti_sway(), copies, threads, times),
            "kingpost environment|anti_sway": kingpost_environment(anti_sway(), copies, threads, times),
            "kingpost|heave_compensation": kingpost_engine(
                heave_compensation(False), copies // 8, threads, times
            ),
        }
        try:
            measured["mujoco rollout|anti_sway"] = mujoco_rollout(copies // 4, threads, max(times // 6, 2))
        except ImportError:
            print("# mujoco is not installed")
        for what, (wall, processor) in measured.items():
            print(f"{what}|{threads}|{wall:.0f}|{processor:.0f}", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
