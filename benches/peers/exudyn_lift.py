"""Exudyn's explicit RK4 on the lift, in the manner of the other programs.

``exudyn_lift.py CASE.json rk4_step MODE NUMBERS``: the numbers of the lift as JSON. Each call of the solver
starts from the fixed state and prepares itself, which is not in the figure: it is the time of fifty times
STEPS and one less that of one. Nothing is recorded, nothing written.

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
# Steps in a batch: the solver takes a millisecond or two to begin.
LONGER = 50


class Lift:
    """The lift, run from its start as often as wanted."""

    def __init__(self, path: str) -> None:
        """Makes the model."""
        self.model = exudyn_ropes.lift(json.loads(Path(path).read_text()), records=False)
        self.settings = exu.SimulationSettings()
        self.settings.solution.file.write = False

    def run(self, steps: int) -> float:
        """So many steps from the start; the time that they took, ns."""
        self.settings.timeIntegration.numberOfSteps = steps
        self.settings.timeIntegration.endTime = steps * STEP_S
        start = time.perf_counter_ns()
        self.model.mbs.SolveDynamic(self.settings, solverType=exu.DynamicSolverType.RK44)
        return time.perf_counter_ns() - start

    def state(self) -> list[float]:
        """Place, orientation, travel; velocity, angular velocity, speed: the load's, last the carriage's."""
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
