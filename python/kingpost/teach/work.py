"""Virtual work (paper eqs. 56-61) of the loads, in both sets of coordinates, and of the reactions."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from ..errors import KingpostError
from ..results.columns import unit_coordinate

if TYPE_CHECKING:
    import xarray
    from numpy.typing import NDArray

    from ..simulation.simulate import Simulation


def virtual_work(simulation: Simulation, displacement: Mapping[str, float]) -> xarray.Dataset:
    """The virtual work of the present loads in a virtual displacement of the free coordinates.

    Parameters
    ----------
    simulation
        A simulation at any instant.
    displacement
        dq by coordinate (m or rad; virtual rotation of a floating body in body axes), zero if not given.

    Returns
    -------
    xarray.Dataset
        By ``body`` and ``axis``, all in world axes, to be drawn as arrows at ``point`` (the centre of
        mass, m): ``displacement`` (m) and ``rotation`` (rad) from dX = B dq, ``force`` (N) and
        ``moment`` (N m) of the loads {F}, and ``reaction_force`` and ``reaction_moment`` of the joints on
        each body. By ``body``: ``work`` of the loads and ``work_of_reactions`` (J).
        Totals: ``work_in_x`` = {F}^T B dq, ``work_in_q`` = {F*}^T dq, and ``reactions``, the sum of
        their work, which is zero, though on one body it is not (J).

    If a joint follows a prescribed motion, F* also contains the effect of that motion on the other
    coordinates, and the two totals differ by it. With closed loops, a displacement that opens a loop makes
    its reaction do work; a displacement with J dq = 0 does not. The torque that turns a rotor belongs to its
    drive.

    >>> from kingpost import Simulation, load
    >>> ship = Simulation(load("paper"))
    >>> work = virtual_work(ship, {"slew": 0.01})
    >>> round(float(work.work_in_x), 9), round(float(work.work_in_q), 9)
    (1000.0, 1000.0)
    """
    import xarray

    frame = simulation.moving_frame()
    matrices = {name: matrix.values for name, matrix in frame.items()}
    dq = _given(displacement, simulation.coordinates)
    columns = [str(name) for name in frame["B"]["column"].values]
    at = [columns.index(name) for name in simulation.coordinates]
    accelerations = np.zeros(len(columns))
    accelerations[at] = simulation.acceleration()
    if "q_ddot_given" in matrices:
        accelerations += matrices["q_ddot_given"].ravel()
    b = matrices["B"][:, at]
    dx, loads, f_star = b @ dq, matrices["F"].ravel(), matrices["F_star"].ravel()
    reactions = _reactions(simulation, matrices, accelerations)
    # M* contains the inertia of rotors in addition to B^T M B; their torque acts inside the joint.
    rotors = (matrices["M_star"] - b.T @ matrices["M"] @ b) @ accelerations[at]
    by_body = [(values * dx).reshape(-1, 6).sum(axis=1) for values in (loads, reactions)]
    bodies = [str(row).rpartition(".")[0] for row in frame["B"]["row"].values[::6]]
    joules = {"units": "J"}
    return xarray.Dataset(
        {
            **_arrows(bodies, matrices, dx, loads, reactions),
            "work": ("body", by_body[0], joules),
            "work_of_reactions": ("body", by_body[1], joules),
            "virtual_displacement": ("coordinate", dq),
            "work_in_x": ((), float(loads @ dx), joules),
            "work_in_q": ((), float(f_star @ dq), joules),
            "reactions": ((), float(reactions @ dx + rotors @ dq), joules),
        },
        {
            "body": bodies,
            "axis": list("xyz"),
            "coordinate": simulation.coordinates,
            unit_coordinate("virtual_displacement"): ("coordinate", simulation.coordinate_units),
        },
        {"time_s": simulation.time_s},
    )


def _given(displacement: Mapping[str, float], free: list[str]) -> NDArray[np.float64]:
    unknown = [name for name in displacement if name not in free]
    if unknown:
        raise KingpostError(f"displacement: found {unknown[0]}, allowed: {', '.join(free)}")
    dq = np.array([float(displacement.get(name, 0.0)) for name in free])
    if not np.isfinite(dq).all():
        raise KingpostError("displacement: found a number that is not finite, allowed: finite numbers")
    return dq


def _arrows(
    bodies: list[str],
    matrices: Mapping[str, NDArray[np.float64]],
    dx: NDArray[np.float64],
    loads: NDArray[np.float64],
    reactions: NDArray[np.float64],
) -> dict[str, Any]:
    """Lists by body, such as dX, as vectors in world axes at the centres of mass."""
    points = np.array([matrices[f"E_{body}"][:3, 3] for body in bodies])
    rotations = np.array([matrices[f"R_{body}"] for body in bodies])
    arrows = {"point": (("body", "axis"), points, {"units": "m", "frame": "world"})}
    for names, units, values in (
        (("displacement", "rotation"), ("m", "rad"), dx),
        (("force", "moment"), ("N", "N m"), loads),
        (("reaction_force", "reaction_moment"), ("N", "N m"), reactions),
    ):
        linear, angular = values.reshape(-1, 2, 3).swapaxes(0, 1)
        in_world = (linear, np.einsum("bij,bj->bi", rotations, angular))
        for name, unit, vectors in zip(names, units, in_world, strict=True):
            arrows[name] = (("body", "axis"), vectors, {"units": unit, "frame": "world"})
    return arrows


def _reactions(
    simulation: Simulation, matrices: Mapping[str, NDArray[np.float64]], accelerations: NDArray[np.float64]
) -> NDArray[np.float64]:
    """The reactions of the joints on the bodies, by d'Alembert: M X'' + D M X' less the loads.

    X'' = B q'' + B' q' takes q'' from the recursive form, so that the sum over the bodies is zero only
    where the two forms of the equations of motion agree.
    """
    rates = matrices["X_dot"].ravel()
    second = matrices["B"] @ accelerations + matrices["B_dot"] @ simulation.state.v
    inertia = matrices["M"]
    return inertia @ second + matrices["D"] @ inertia @ rates - matrices["F"].ravel()
