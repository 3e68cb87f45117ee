"""The restricted variation of the angular velocity (paper eqs. 53-55), checked by differences.

A rotation R(t) is varied to R(t) exp(eps S(dpi(t))). The angular velocity of the varied rotation comes only
from differences in time, and its variation from differences in eps, without any formula. They are compared
with the naive variation, d/dt dpi, and the restricted one, d/dt dpi + omega x dpi.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

import numpy as np

from ..errors import KingpostError
from .rotations import rodrigues, skew, unskew, vector_of_three

if TYPE_CHECKING:
    import xarray
    from numpy.typing import ArrayLike, NDArray

    from ..simulation.simulate import Simulation

EPSILONS = tuple(np.geomspace(0.1, 1e-3, 7))
# First derivative from five samples a step apart; its error is of the fourth order in the step.
FIVE_POINT = np.array([1.0, -8.0, 0.0, 8.0, -1.0]) / 12.0
AROUND = np.arange(-2, 3)


def restricted_variation(
    rotation: Callable[[float], ArrayLike],
    displacement: Callable[[float], ArrayLike],
    time_s: float,
    epsilons: Sequence[float] = EPSILONS,
    step_s: float = 1e-3,
) -> xarray.Dataset:
    """Compare the variation of omega with the naive and with the restricted formula.

    Parameters
    ----------
    rotation
        R(t), body to world.
    displacement
        The virtual rotation dpi(t), body axes, rad.
    time_s
        The instant, s.
    epsilons
        Sizes of the variation, descending.
    step_s
        Step of the differences in time, s.

    Returns
    -------
    xarray.Dataset
        ``variation`` (rad/s, body axes) by ``difference`` (central, one-sided), ``epsilon`` and
        ``axis``; ``formula`` likewise by ``form`` (naive, restricted); ``error``, the length of their
        difference (rad/s); and ``slope``, the power of epsilon with which it falls: 2 for central and
        1 for one-sided differences where the form is right, 0 where it is not.

    >>> spin = restricted_variation(lambda t: rodrigues([0, 0, 2 * t]), lambda t: [1, 0, 0], 0.3)
    >>> spin.formula.sel(form="restricted").round(6).values
    array([0., 2., 0.])
    >>> spin.slope.sel(difference="central").round(1).values + 0.0
    array([0., 2.])
    """
    times = time_s + step_s * AROUND
    return _compare(np.array([np.asarray(rotation(t)) for t in times]), displacement, times, epsilons)


def restricted_variation_of_body(
    simulation: Simulation,
    body: str,
    displacement: Callable[[float], ArrayLike],
    epsilons: Sequence[float] = EPSILONS,
) -> xarray.Dataset:
    """Compare the variation of omega with both formulas, for a body of a simulation at five steps from now.

    The variation is taken two steps from now; the simulation is restored afterwards.
    """
    if f"R_{body}" not in simulation.moving_frame():
        names = ", ".join(entry["name"] for entry in simulation.scenario.model["bodies"])
        raise KingpostError(f"body: found {body}, allowed: {names}")
    start, rotations, times = simulation.snapshot(), [], []
    try:
        for i in range(len(AROUND)):
            simulation.step(min(i, 1))
            rotations.append(simulation.moving_frame()[f"R_{body}"].values)
            times.append(simulation.time_s)
    finally:
        simulation.restore(start)
    return _compare(np.array(rotations), displacement, np.array(times), epsilons)


def _compare(
    rotations: NDArray[np.float64],
    displacement: Callable[[float], ArrayLike],
    times: NDArray[np.float64],
    epsilons: Sequence[float],
) -> xarray.Dataset:
    import xarray

    sizes = np.asarray(epsilons, dtype=np.float64)
    if sizes.ndim != 1 or len(sizes) < 2 or not (sizes > 0).all():
        raise KingpostError(f"epsilons: found {list(epsilons)}, allowed: two or more numbers above 0")
    step_s = times[1] - times[0]
    virtual = np.array([vector_of_three(displacement(float(t))) for t in times])

    def omega(epsilon: float) -> NDArray[np.float64]:
        varied = np.array([r @ rodrigues(epsilon * d) for r, d in zip(rotations, virtual, strict=True)])
        return unskew(varied[2].T @ np.tensordot(FIVE_POINT, varied, 1)) / step_s

    now = omega(0.0)
    central = np.array([(omega(e) - omega(-e)) / (2 * e) for e in sizes])
    one_sided = np.array([(omega(e) - now) / e for e in sizes])
    naive = FIVE_POINT @ virtual / step_s
    formulas = np.array([naive, naive + skew(now) @ virtual[2]])
    variation = np.array([central, one_sided])
    error = np.linalg.norm(variation[:, None] - formulas[None, :, None], axis=-1)
    logarithm = np.log(np.maximum(error, np.finfo(float).tiny))
    slope = np.polyfit(np.log(sizes), logarithm.reshape(-1, len(sizes)).T, 1)[0].reshape(2, 2)
    rate = {"units": "rad/s", "frame": "body"}
    return xarray.Dataset(
        {
            "variation": (("difference", "epsilon", "axis"), variation, rate),
            "formula": (("form", "axis"), formulas, rate),
            "error": (("difference", "form", "epsilon"), error, {"units": "rad/s"}),
            "slope": (("difference", "form"), slope, {"units": "1"}),
            "angular_velocity": ("axis", now, rate),
            "virtual_rotation": ("axis", virtual[2], {"units": "rad", "frame": "body"}),
        },
        {
            "difference": ["central", "one-sided"],
            "form": ["naive", "restricted"],
            "epsilon": sizes,
            "axis": list("xyz"),
        },
        {"time_s": float(times[2])},
    )
