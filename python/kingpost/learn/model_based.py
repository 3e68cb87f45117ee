"""Model-based controllers of `Kingpost/AntiSway-v0` by `kingpost.lqr` and `kingpost.mpc`."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache

import numpy as np

from ..analysis.predictive import PredictiveRegulator, mpc
from ..simulation.simulate import Simulation
from .policies import Policy, in_units
from .task import Task

PERIOD_S = 0.2
"""Time between two plans; between them the action is held."""
HORIZON = 60
"""Periods of a plan: 12 s, longer than the swing of 9 s."""
LUFFS_DEG = tuple(range(-62, -27, 4))
"""Boom angles at which the crane is linearised; a controller takes the nearest one."""
LUFF_AT_START = -np.pi / 4
LUFF = "bodies.boom.joint.revolute.initial_angle_deg"
JOINTS = ("slew", "luff", "pendant.first", "pendant.second", "sling.first", "sling.second")
PLACE_WEIGHT, SPEED_WEIGHT, SWING_WEIGHT = 0.1, 0.3, 10.0
"""Weights of the load's position (1/m^2), velocity (s^2/m^2) and swing angles (1/rad^2): the best of thirteen
sets on eight episodes that are not among those of the scores."""
PLAN_INPUT_WEIGHT, LQR_INPUT_WEIGHT = 0.1, 200.0
"""Weights of the inputs (s^2/rad^2) in the plans and in the limited regulator: the best of six."""


def states(task: Task, seen: np.ndarray, names: list[str]) -> np.ndarray:
    """Convert observations to states of the linear model, as deviations from rest at the target. The drives'
    references, which are not observed, are assumed equal to the joint positions.
    """
    now = in_units(task, seen)
    along = now["swing_along"] - now["luff_error"]
    places = [now["slew_error"], now["luff_error"], now["swing_across"], along]
    places += [now[f"{joint}.joint_position"] for joint in JOINTS[4:]]
    by_name = dict(zip(JOINTS, places, strict=True))
    by_name |= {f"{joint}.rate": now[f"{joint}.joint_velocity"] for joint in JOINTS}
    for drive, joint in zip(task.action_names, JOINTS, strict=False):
        by_name[f"{drive}.position"] = by_name[joint]
        by_name[f"{drive}.speed"] = by_name[f"{joint}.rate"]
    return np.stack([by_name[name] for name in names], axis=1)


def load_weights(task: Task, luff_deg: float, names: list[str]) -> np.ndarray:
    """Weight matrix Q of the load's horizontal position and velocity, by finite differences about rest, and
    of the swing angles."""
    simulation = Simulation(task.based_on.with_overrides({LUFF: luff_deg}))
    simulation.settle()
    columns = [name for channel in simulation.channels for name in channel["columns"]]
    load = [columns.index(f"load.position.{axis}") for axis in "xy"]
    rest, at, step = simulation.state, simulation.row()[load], 1e-5
    place, speed = np.zeros((2, len(names))), np.zeros((2, len(names)))
    for k, joint in enumerate(simulation.coordinates):
        moved = rest.q.copy()
        moved[k] += step
        simulation.set_state(moved, rest.v)
        by_joint = (simulation.row()[load] - at) / step
        place[:, names.index(joint)] = speed[:, names.index(f"{joint}.rate")] = by_joint
    angles = np.diag([{"slew": 1.0, "luff": 1.0}.get(name, 0.0) for name in names])
    for joint in JOINTS[2:4]:
        angles[names.index(joint), names.index(joint)] = SWING_WEIGHT
    return PLACE_WEIGHT * place.T @ place + SPEED_WEIGHT * speed.T @ speed + angles


@cache
def _regulators(task: Callable[[], Task], weight: float) -> list[PredictiveRegulator]:
    """Regulators, one for each boom angle."""
    made = task()
    names = Simulation(made.based_on).linearize().states
    drives = made.based_on.resolved["drives"]
    rates = {
        name: given["acceleration_limit_rad_s2"]
        for name in made.action_names
        for given in drives[name].values()
    }
    return [
        mpc(
            made.based_on,
            {LUFF: float(luff)},
            inputs=made.action_names,
            Q=load_weights(made, luff, names),
            R=[weight] * len(made.action_names),
            period_s=PERIOD_S,
            horizon=HORIZON,
            input_limits=dict(zip(made.action_names, made.bounds, strict=True)),
            input_rates=rates,
        )
        for luff in LUFFS_DEG
    ]


class _ByModel:
    """Policy that chooses the regulator by the boom angle, found from the angle at the start of every
    episode."""

    def __init__(self, task: Task, plans: bool) -> None:
        from .tasks import anti_sway

        self.task, self.plans = task, plans
        self.regulators = _regulators(anti_sway, PLAN_INPUT_WEIGHT if plans else LQR_INPUT_WEIGHT)
        self.every = round(PERIOD_S / task.control_period_s)
        self.highest = np.array([high for _, high in task.bounds])
        self.taken = 0
        self.target: np.ndarray | None = None
        self.speeds = np.zeros(0)

    def __call__(self, seen: np.ndarray) -> np.ndarray:
        if self.target is None:
            self.target = LUFF_AT_START - in_units(self.task, seen)["luff_error"]
            self.speeds = np.zeros((len(seen), len(self.highest)))
        if self.taken % self.every == 0:
            luffs = self.target + in_units(self.task, seen)["luff_error"]
            x = states(self.task, seen, self.regulators[0].states)
            nearest = np.abs(np.radians(LUFFS_DEG) - luffs[:, None]).argmin(axis=1)
            self.speeds = np.stack([self._speeds(k, x[i], self.speeds[i]) for i, k in enumerate(nearest)])
        self.taken += 1
        return np.clip(self.speeds / self.highest, -1.0, 1.0)

    def _speeds(self, nearest: int, x: np.ndarray, before: np.ndarray) -> np.ndarray:
        regulator = self.regulators[nearest]
        if not self.plans:
            return np.clip(-regulator.gains @ x, -self.highest, self.highest)
        return regulator.action(x, np.clip(before, -self.highest, self.highest))


def linear_quadratic(task: Task) -> Policy:
    """Linear-quadratic regulator for the boom angle, with outputs limited to the speed limits."""
    return _ByModel(task, plans=False)


def predictive(task: Task) -> Policy:
    """Predictive control with the same weights, within the limits of speeds and accelerations."""
    return _ByModel(task, plans=True)
