"""Numbers, from the engine, that the page's remarks on the paper's text rest on."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..scenario import load
from ..simulate import Simulation
from . import figures

PRINTED_AT_S = 0.25
"""When the printed kinematics is compared with the corrected one, s."""


@dataclass(frozen=True)
class Measured:
    """What the remarks quote.

    Attributes
    ----------
    eq_43_m_s, eq_46b_m_s
        Error of the arm's velocity by eq. 43 and by eq. 46b as printed, m/s.
    corrected_m_s, arm_m_s
        Error of the corrected form, and the arm's speed, m/s.
    held, free
        Number of coordinates with the ship's centre held and free.
    slew_inertia, slew_inertia_loaded
        Inertia about the tower's axis without and with the load, kg m2.
    level, upright
        Largest pitch, yaw and roll rate with the tower motor, the arm at first level or held
        upright, rad/s.
    level_damped, both, both_damped
        The same of Fig. 9 with damping, and of Fig. 11 without and with it, rad/s.
    without_d_energy, without_d_momentum
        Energy error over work, and momentum error (N m s), with D left out of eq. 60b.
    """

    eq_43_m_s: float
    eq_46b_m_s: float
    corrected_m_s: float
    arm_m_s: float
    held: list[str]
    free: list[str]
    slew_inertia: float
    slew_inertia_loaded: float
    level: dict[str, float]
    upright: dict[str, float]
    level_damped: dict[str, float]
    both: dict[str, float]
    both_damped: dict[str, float]
    without_d_energy: float
    without_d_momentum: float


def measure(drawn: list[figures.Figure]) -> Measured:
    """Measure them; `drawn` are Figs. 9 to 11 as run."""
    level, both = drawn[0], drawn[-1]
    arm = "bodies.arm.joint.revolute"
    held_upright = {f"{arm}.initial_angle_rad": -np.pi / 2, f"{arm}.mode": "held"}
    upright = figures.simulate(level.case, **held_upright)
    without_d = _without_d(both.case)
    return Measured(
        *_printed_kinematics(),
        held=_coordinates(hold_centre=True),
        free=_coordinates(hold_centre=False),
        slew_inertia=_slew_inertia(load_on=False),
        slew_inertia_loaded=_slew_inertia(load_on=True),
        level=_peaks(level.undamped),
        upright=_peaks(figures.rates(upright)),
        level_damped=_peaks(level.damped),
        both=_peaks(both.undamped),
        both_damped=_peaks(both.damped),
        without_d_energy=without_d[0],
        without_d_momentum=without_d[1],
    )


def _without_d(case: figures.Case) -> tuple[float, float]:
    settings = {"simulation.form": "moving_frame_without_d", "simulation.duration_s": 1.0}
    last = figures.simulate(case, **settings).isel(time=-1)
    return float(abs(last["energy_error"] / last["work_done"])), float(last["momentum_error"])


def _coordinates(hold_centre: bool) -> list[str]:
    return Simulation(load("paper", load=False, hold_centre=hold_centre)).coordinates


def _slew_inertia(load_on: bool) -> float:
    simulation = Simulation(load("paper", load=load_on))
    slew = simulation.coordinates.index("slew")
    return float(simulation.mass_matrix()[slew, slew])


def _peaks(rates: dict[str, np.ndarray]) -> dict[str, float]:
    return {name: float(np.abs(values).max()) for name, values in rates.items()}


def skew(vector: np.ndarray) -> np.ndarray:
    """Matrix of the cross product: skew(a) b = a x b."""
    x, y, z = vector
    return np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])


def _printed_kinematics() -> tuple[float, float, float, float]:
    """Velocity of the arm by eqs. 43 and 46b, printed and corrected, with the crane in its corner.

    Everything is in our axes (x forward, y to port, z up); the paper's e1 is our y, its e2 our z.
    """
    scenario = load("paper", motor_1=True, motor_2=True, load=False)
    simulation = Simulation(scenario)
    simulation.step(round(PRINTED_AT_S / simulation.step_s))
    matrices = {name: block.values for name, block in simulation.moving_frame().items()}
    r1 = matrices["E_ship"][:3, :3]
    r21, r32 = matrices["E_tower/ship"][:3, :3], matrices["E_arm/tower"][:3, :3]
    foot, _ = _joint(scenario.resolved, "tower")
    top, root = _joint(scenario.resolved, "arm")
    c2, j2, c3 = -_joint(scenario.resolved, "tower")[1], top, -root
    c21 = foot + c2
    e1, e2 = np.eye(3)[1], np.eye(3)[2]
    w1, (slew, luff) = np.split(simulation.state.v[3:8], [3])
    w2 = r21.T @ w1 + slew * e2
    w3 = r32.T @ w2 + luff * e1

    def velocity(s_first: np.ndarray) -> np.ndarray:
        return r1 @ (r21 @ r32 @ skew(c3).T @ w3 + r21 @ skew(j2).T @ w2 + skew(s_first).T @ w1)

    b54 = r1 @ r21 @ r32 @ skew(c3).T @ e1
    b52 = r1 @ (r21 @ r32 @ skew(c21).T @ r21.T @ r32.T + r21 @ skew(j2).T @ r21.T + skew(c2).T)
    b53 = r1 @ (r21 @ r32 @ skew(c21).T @ r32.T @ e2 + r21 @ skew(c2).T @ e2)
    printed_46b = b52 @ w1 + b53 * slew + b54 * luff
    arm = [body["name"] for body in scenario.model["bodies"]].index("arm")
    true = matrices["X_dot"].ravel()[6 * arm : 6 * arm + 3]
    errors = (velocity(c2) - true, printed_46b - true, velocity(c21) - true, true)
    return tuple(float(np.linalg.norm(error)) for error in errors)  # type: ignore[return-value]


def _joint(resolved: dict, body: str) -> tuple[np.ndarray, np.ndarray]:
    """A revolute joint's place in the parent and in the body itself, m."""
    joint = resolved["bodies"][body]["joint"]["revolute"]
    return np.array(joint["position_m"]), np.array(joint["child_position_m"])
