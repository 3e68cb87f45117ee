"""Exudyn's explicit RK4 on the lift, in the manner of the other programs.

``exudyn_lift.py CASE.json rk4_step MODE NUMBERS``: the numbers of the lift as JSON. Each call of the solver
starts from the fixed state with a preparation that is not part of the figure: the figure is the time of 50
STEPS + 1 steps less that of one step. Nothing is recorded or written.

    time BATCHES STEPS   a line per batch: nanoseconds per step
    check STEPS          q and v in Kingpost's layout after that many steps, one number per line
"""

from __future__ import annotations

import json
import sys
import time
import warnings
from pathlib import Path

import exudyn as exu

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "python" / "tests"))

from peers import exudyn_ropes

STEP_S = 1e-3
# Factor on the steps of a batch: the solver takes a millisecond or two to start.
LONGER = 50


class Lift:
    """The lift, which can be run repeatedly from its start."""

    def __init__(self, path: str) -> None:
        """Makes the model."""
        self.model = exudyn_ropes.lift(json.loads(Path(path).read_text()), records=False)
        self.settings = exu.SimulationSettings()
        self.settings.solution.file.write = False

    def run(self, steps: int) -> float:
        """Runs a number of steps from the start; returns their time, ns."""
        self.settings.timeIntegration.numberOfSteps = steps
        self.settings.timeIntegration.endTime = steps * STEP_S
        start = time.perf_counter_ns()
        self.model.mbs.SolveDynamic(self.settings, solverType=exu.DynamicSolverType.RK44)
        return time.perf_counter_ns() - start

    def state(self) -> list[float]:
        """Position and orientation of the load, travel of the carriage; velocity and angular velocity of the
        load, speed of the carriage."""
        load, winch = self.model.nodes
        node = self.model.mbs.GetNodeOutput
        out = exu.OutputVariableType
        place, velocity = node(load, out.Position), node(load, out.Velocity)
        travel, speed = node(winch, out.Displacement), node(winch, out.Velocity)
        return [*place, 1.0, 0.0, 0.0, 0.0, travel[0], *velocity, 0.0, 0.0, 0.0, speed[0]]


def main(path: str, operation: str, mode: str, *numbers: str) -> None:
    """Runs the command line."""
    if operation != "rk4_step":
        raise SystemExit(f"unknown operation {operation}")
    warnings.simplefilter("ignore", DeprecationWarning)
    lift, steps = Lift(path), int(numbers[-1])
    if mode == "check":
        lift.run(steps)
        print("\n".join(repr(float(x)) for x in lift.state()))
        return
    many = LONGER * steps
    lift.run(many)  # warm-up
    for _ in range(int(numbers[0])):
        print((lift.run(many + 1) - lift.run(1)) / many)


if __name__ == "__main__":
    main(*sys.argv[1:])
