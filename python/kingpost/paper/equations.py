"""Eqs. 43 and 46b, the velocity of the arm's centre, as printed and corrected.

LaTeX is in the paper's notation: S(a) is the skew matrix of a, and the paper's axes are 1 athwartship,
2 up, 3 along the ship. Numbers are in Kingpost's axes (x forward, y to port, z up): the paper's e1 is our y,
its e2 our z.
"""

from __future__ import annotations

import json
from dataclasses import dataclass
from importlib.resources import files
from typing import TYPE_CHECKING, Any

import numpy as np

from ..errors import KingpostError
from ..simulation.simulate import Simulation
from ..teach import skew

if TYPE_CHECKING:
    from numpy.typing import NDArray

FORMS = ("printed", "corrected")


@dataclass(frozen=True)
class Equation:
    """One equation in LaTeX, as printed and corrected."""

    printed: list[str]
    corrected: list[str]

    def _repr_latex_(self) -> str:
        lines = [r"& \text{printed:}", *self.printed, r"& \text{corrected:}", *self.corrected]
        aligned = r" \\ ".join(line if line.startswith("&") else f"& {line}" for line in lines)
        return rf"$\displaystyle \begin{{aligned}} {aligned} \end{{aligned}}$"


EQUATIONS = {
    name: Equation(**forms)
    for name, forms in json.loads(files(__package__).joinpath("equations.json").read_text()).items()
}
"""The equations by the paper's number, or by the block of B. The app shows the same file."""


def arm_velocity(
    simulation: Simulation, equation: str = "43", form: str = "corrected"
) -> NDArray[np.float64]:
    """Compute the velocity of the arm's centre by eq. 43 or 46b, as printed or corrected, m/s in world axes.

    Parameters
    ----------
    simulation
        A simulation of the scenario ``paper``, at any instant.
    equation
        ``43``, or ``46b``: the arm's row of B times the generalized velocity.
    form
        ``printed`` or ``corrected``.

    >>> from kingpost import load
    >>> ship = Simulation(load("paper", motor_2=True))
    >>> ship.step(250)
    >>> errors = [arm_velocity(ship, "43", form) - arm_velocity(ship, "46b", "corrected") for form in FORMS]
    >>> [bool(np.linalg.norm(error) > 1e-9) for error in errors]
    [True, False]
    """
    if form not in FORMS:
        raise KingpostError(f"form: found {form}, allowed: {', '.join(FORMS)}")
    corrected = form == "corrected"
    vectors = _vectors(simulation.scenario.resolved)
    state = simulation.state
    x1, w1, (slew, luff) = np.split(state.v[:8], [3, 6])
    frame = simulation.moving_frame()
    r1, r21, r32 = (frame[f"E_{name}"].values[:3, :3] for name in ("ship", "tower/ship", "arm/tower"))
    r31, e1, e2 = r21 @ r32, np.eye(3)[1], np.eye(3)[2]
    j2, c2, c3 = vectors["J2"], vectors["C2"], vectors["C3"]
    c21 = vectors["J1"] + c2
    if equation == "43":
        w2 = r21.T @ w1 + slew * e2
        w3 = r32.T @ w2 + luff * e1
        first = c21 if corrected else c2
        return x1 + r1 @ (r31 @ skew(c3).T @ w3 + r21 @ skew(j2).T @ w2 + skew(first).T @ w1)
    if equation != "46b":
        raise KingpostError(f"equation: found {equation}, allowed: 43, 46b")
    b54 = r1 @ r31 @ skew(c3).T @ e1
    if corrected:
        b52 = r1 @ (r31 @ skew(c3).T @ r31.T + r21 @ skew(j2).T @ r21.T + skew(c21).T)
        b53 = r1 @ (r31 @ skew(c3).T @ r32.T @ e2 + r21 @ skew(j2).T @ e2)
    else:
        b52 = r1 @ (r31 @ skew(c21).T @ r21.T @ r32.T + r21 @ skew(j2).T @ r21.T + skew(c2).T)
        b53 = r1 @ (r31 @ skew(c21).T @ r32.T @ e2 + r21 @ skew(c2).T @ e2)
    return x1 + b52 @ w1 + b53 * slew + b54 * luff


def _vectors(resolved: dict[str, Any]) -> dict[str, NDArray[np.float64]]:
    """s_J1, s_C2, s_J2 and s_C3 of the paper's crane, m."""

    def joint(body: str) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        hinge = resolved["bodies"].get(body, {}).get("joint", {}).get("revolute")
        if hinge is None:
            raise KingpostError(f"scenario: found no hinge of {body}, allowed: the scenario paper")
        return np.array(hinge["position_m"]), -np.array(hinge["child_position_m"])

    (j1, c2), (j2, c3) = joint("tower"), joint("arm")
    return {"J1": j1, "C2": c2, "J2": j2, "C3": c3}
