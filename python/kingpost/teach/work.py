"""Virtual work (paper eqs. 56-61): of the loads in both sets of coordinates, and of the reactions."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np

from ..errors import KingpostError

if TYPE_CHECKING:
    import xarray
    from numpy.typing import NDArray

    from ..simulate import Simulation


def virtual_work(simulation: Simulation, displacement: Mapping[str, float]) -> xarray.Dataset:
    """The virtual work that a virtual displacement of the free coordinates makes the loads do now.

    Parameters
    ----------
    simulation
        At any instant.
    displacement
        dq by coordinate (m or rad; virtual rotation of a floating body in its own axes), zero where
        none is given.

    Returns
    -------
    xarray.Dataset
        By ``body`` and ``axis``, all in world axes, to be drawn as arrows at ``point`` (the centre of
        mass, m): ``displacement`` (m) and ``rotation`` (rad) from dX = B dq, ``force`` (N) and
        ``moment`` (N m) of the loads {F}, and ``reaction_force`` and ``reaction_moment``, what the
        joints hold each body with. By ``body``: ``work`` of the loads and ``work_of_reactions`` (J).
        In all: ``work_in_x`` = {F}^T B dq, ``work_in_q`` = {F*}^T dq, ``reactions``, the sum of
        their work, which is zero, though on one body it is not (J).

    Where a joint follows a prescribed motion, F* also holds what that motion takes, and the two differ
    by it.

    >>> from kingpost import Simulation, load
    >>> ship = Simulation(load("paper"))
    >>> work = virtual_work(ship, {"slew": 0.01})
    >>> round(float(work.work_in_x), 9), round(float(work.work_in_q), 9)
    (1000.0, 1000.0)
    """
    import xarray

    frame = simulation.moving_frame()
    matrices = {name: matrix.values for name, matrix in frame.items()}
    free = simulation.coordinates
    unknown = [name for name in displacement if name not in free]
    if unknown:
        raise KingpostError(f"displacement: found {unknown[0]}, allowed: {', '.join(free)}")
    dq = np.array([float(displacement.get(name, 0.0)) for name in free])
    if not np.isfinite(dq).all():
        raise KingpostError("displacement: found a number that is not finite, allowed: finite numbers")
    columns = [str(name) for name in frame["B"]["column"].values]
    dx = matrices["B"][:, [columns.index(name) for name in free]] @ dq
    loads = matrices["F"].ravel()
    reactions = _reactions(simulation, matrices, columns)

    bodies = [str(row).rpartition(".")[0] for row in frame["B"]["row"].values[::6]]
    rotations = np.array([matrices[f"R_{body}"] for body in bodies])

    def in_world(values: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        linear, angular = values.reshape(-1, 2, 3).swapaxes(0, 1)
        return linear, np.einsum("bij,bj->bi", rotations, angular)

    arrows = {}
    for names, units, values in (
        (("displacement", "rotation"), ("m", "rad"), dx),
        (("force", "moment"), ("N", "N m"), loads),
        (("reaction_force", "reaction_moment"), ("N", "N m"), reactions),
    ):
        for name, unit, vectors in zip(names, units, in_world(values), strict=True):
            arrows[name] = (("body", "axis"), vectors, {"units": unit, "frame": "world"})
    points = np.array([matrices[f"E_{body}"][:3, 3] for body in bodies])
    by_body = [(values * dx).reshape(-1, 6).sum(axis=1) for values in (loads, reactions)]
    joules = {"units": "J"}
    return xarray.Dataset(
        {
            "point": (("body", "axis"), points, {"units": "m", "frame": "world"}),
            **arrows,
            "work": ("body", by_body[0], joules),
            "work_of_reactions": ("body", by_body[1], joules),
            "virtual_displacement": ("coordinate", dq, {"units": "m or rad"}),
            "work_in_x": ((), float(loads @ dx), joules),
            "work_in_q": ((), float(matrices["F_star"].ravel() @ dq), joules),
            "reactions": ((), float(reactions @ dx), joules),
        },
        {"body": bodies, "axis": list("xyz"), "coordinate": free},
        {"time_s": simulation.time_s},
    )


def _reactions(
    simulation: Simulation, matrices: Mapping[str, NDArray[np.float64]], columns: list[str]
) -> NDArray[np.float64]:
    """What the joints hold the bodies with, by d'Alembert: M X'' + D M X' less the loads.

    X'' = B q'' + B' q' takes q'' from the recursive form, so that the sum over the bodies is zero only
    where the two forms of the equations of motion agree.
    """
    rates = matrices["X_dot"].ravel()
    accelerations = np.zeros(len(columns))
    accelerations[[columns.index(name) for name in simulation.coordinates]] = simulation.acceleration()
    second = matrices["B"] @ accelerations + matrices["B_dot"] @ simulation.state.v
    inertia = matrices["M"]
    return inertia @ second + matrices["D"] @ inertia @ rates - matrices["F"].ravel()
