"""Three views of a model in its present state: the outlines of its solids, hulls and lines."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from ..errors import KingpostError
from ..simulation.simulate import Simulation

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

    Points = NDArray[np.float64]

X, Y, Z = range(3)
VIEWS = (("from the side", (X, Z)), ("from ahead", (Y, Z)), ("from above", (X, Y)))
ROUND = 24
"""Number of corners of a drawn circle."""
WATER, GREY = "#4a90b8", "#6b7280"


def figure(simulation: Simulation) -> Figure:
    """Draw the model in its present state to scale: world axes, m; the still water is a line at z = 0.

    Parameters
    ----------
    simulation
        Simulation in the state to draw: at its start, at rest or during a run.

    Returns
    -------
    matplotlib.figure.Figure
        Three views: x and z, y and z, x and y.

    Raises
    ------
    KingpostError
        If the model has nothing to draw.

    >>> from kingpost import Simulation, load
    >>> [axes.get_title() for axes in figure(Simulation(load("paper"))).axes]
    ['from the side', 'from ahead', 'from above']
    """
    from matplotlib.figure import Figure

    model = simulation.scenario.model
    solids = list(_solids(model, simulation.poses()))
    lines = [np.asarray(line.points_m) for line in simulation.lines()]
    if not solids and not lines:
        raise KingpostError("outline: found no solid and no line, allowed: a model with one or more")
    spans = np.ptp(np.vstack([*(points for points, _ in solids), *lines]), axis=0)
    drawn = Figure(figsize=(10, 7), layout="constrained")
    side, ahead, above, _ = drawn.subplots(
        2, 2, width_ratios=[spans[X], spans[Y]], height_ratios=[spans[Z], spans[Y]]
    ).ravel()
    drawn.delaxes(drawn.axes[-1])
    for axes, (title, across) in zip((side, ahead, above), VIEWS, strict=True):
        for points, colour in sorted(solids, key=lambda solid: _depth(solid[0], across)):
            _draw(axes, points[:, across], colour)
        for points in lines:
            axes.plot(*points[:, across].T, color="black", lw=0.8)
        if Z in across and model["hulls"]:
            axes.axhline(0.0, color=WATER, lw=1.2)
        right, up = ("xyz"[axis] for axis in across)
        axes.set(xlabel=f"{right}, m", ylabel=f"{up}, m", aspect="equal")
        axes.set_title(title, fontsize=10)
        axes.grid(alpha=0.25)
    return drawn


def _solids(model: dict[str, Any], poses: Points) -> Iterator[tuple[Points, str]]:
    """Corners of each solid in the world, with its colour: solids of bodies, and meshes of hulls."""
    places = {body["name"]: pose for body, pose in zip(model["bodies"], poses, strict=True)}
    for hull in model["hulls"]:
        vertices = (hull["mesh"] or {}).get("vertices_m")
        if vertices is not None:
            yield _placed(np.asarray(vertices, float), places[hull["body"]]), _colour(model, hull["body"])
    for body in model["bodies"]:
        corners = _corners(body["shape"] or {})
        if len(corners):
            yield _placed(corners, places[body["name"]]), body["colour"] or GREY


def _colour(model: dict[str, Any], name: str) -> str:
    return next(body["colour"] for body in model["bodies"] if body["name"] == name) or GREY


def _corners(shape: dict[str, Any]) -> Points:
    """Corners of a solid in its body's axes; points on the surface of a ball or a cylinder."""
    signs = np.stack(np.meshgrid([-1, 1], [-1, 1], [-1, 1], indexing="ij"), axis=-1).reshape(-1, 3)
    angles = np.linspace(0, 2 * np.pi, ROUND, endpoint=False)
    circle = np.stack([np.cos(angles), np.sin(angles)], axis=1)
    # Distinguish solids by the fields of their size: their names are also those of kinds of elements.
    size: dict[str, Any] = next(iter(shape.values()), {}) if shape else {}
    if "width_m" in size:
        return signs * [size["length_m"] / 2, size["width_m"] / 2, size["height_m"] / 2]
    if "axis" in size:
        along = "xyz".index(size["axis"])
        ends = [np.insert(size["radius_m"] * circle, along, end * size["length_m"] / 2, axis=1)
                for end in (-1, 1)]  # fmt: skip
        return np.vstack(ends)
    if "radius_m" in size:
        return np.vstack([np.insert(size["radius_m"] * circle, axis, 0.0, axis=1) for axis in (X, Y, Z)])
    return np.empty((0, 3))


def _placed(points: Points, pose: Points) -> Points:
    """Transform points of a body to the world, by its position, m, and its unit quaternion (w, x, y, z)."""
    from scipy.spatial.transform import Rotation

    position, (w, *xyz) = pose[:3], pose[3:]
    return Rotation.from_quat([*xyz, w]).apply(points) + position


def _depth(points: Points, across: tuple[int, int]) -> float:
    """Distance of a solid towards the viewer: from starboard, from ahead or from above."""
    (along,) = {X, Y, Z} - set(across)
    nearer = -1.0 if along == Y else 1.0
    return float(nearer * points[:, along].mean())


def _draw(axes: Axes, points: Points, colour: str) -> None:
    """Draw the outline of a convex solid: the convex hull of its projected corners."""
    from scipy.spatial import ConvexHull, QhullError

    try:
        outline = points[ConvexHull(points).vertices]
    except QhullError:
        # A plate seen edge-on.
        axes.plot(*points.T, color=colour, lw=1.0)
        return
    axes.fill(*outline.T, facecolor=colour, edgecolor="black", lw=0.6, alpha=0.75)
