"""A picture of a scenario, of a simulation or of a moment of a recorded run."""

from __future__ import annotations

import io
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np

from .. import output
from ..errors import KingpostError
from ..given import number
from ..results.entries import digests_of, scenario_of
from ..scenario import Scenario, load
from ..simulation.simulate import Simulation
from .drawing import SIZE_PX, Drawing, Viewpoint

if TYPE_CHECKING:
    import xarray
    from numpy.typing import NDArray

    Drawn: TypeAlias = Scenario | Simulation | xarray.Dataset | str | Path

ENDINGS = (".png",)
ANONYMOUS: dict[str, Any] = {"Software": None}
"""Metadata without the version of the library, so that every version writes the same bytes."""
SAME_PLACE_M = 1e-6
"""Largest distance between a body of a record and of its replay. Both have the same bits, but a file may have
been written with less digits."""


def picture(
    scenario_or_run: Drawn,
    time_s: float | None = None,
    *,
    camera: Viewpoint = "free",
    size_px: tuple[int, int] = SIZE_PX,
    path: str | Path | None = None,
) -> NDArray[np.uint8]:
    """Draw a scenario, a simulation or a recorded run, without a browser.

    Bodies, hulls, ropes and other lines are at their computed places; the sea is drawn still. A recorded run
    is computed again up to the time, since its records have no places of lines.

    Parameters
    ----------
    scenario_or_run
        A scenario, a file or a name of the gallery; a simulation, drawn in its present state; or the data set
        of a run.
    time_s
        Time, s, from 0 to the scenario's duration; for a run, of its nearest record. Default: the start.
    camera
        ``free``, from the starboard quarter, ``side``, ``top``, or a direction from the scene to the eye: x,
        y, z. Everything is then in the picture. Or ``load``, which follows the load, or the positions of the
        eye and its target relative to the first body, along the axes of the world, m.
    size_px
        Width and height, pixels.
    path
        File to write, ``.png``; default: none.

    Returns
    -------
    numpy.ndarray
        Red, green and blue from 0 to 255, shape (height, width, 3).

    Raises
    ------
    KingpostError
        If an argument is wrong, or a recorded run is not the run of its scenario, as with inputs set by hand.

    >>> picture("paper", size_px=(64, 36)).shape
    (36, 64, 3)
    """
    if path is not None:
        output.check(path, ENDINGS)
    drawing = Drawing(_at(scenario_or_run, time_s), camera, size_px)
    drawn = drawing.picture()
    if path is not None:
        with output.whole(path) as beside:
            beside.write_bytes(png(drawn))
    return drawn


def png(drawn: NDArray[np.uint8]) -> bytes:
    """A picture as the bytes of a PNG file; the same picture gives the same bytes.

    >>> png(np.zeros((2, 2, 3), np.uint8))[1:4]
    b'PNG'
    """
    from matplotlib.image import imsave

    held = io.BytesIO()
    imsave(held, drawn, format="png", metadata=ANONYMOUS)
    return held.getvalue()


def _at(given: Any, time_s: float | None) -> Simulation:
    """The simulation of a picture, at its time."""
    if isinstance(given, Simulation):
        if time_s is not None:
            raise KingpostError(f"time_s: found {time_s} for a simulation, allowed: its present state")
        return given
    if isinstance(given, Scenario | str | Path):
        scenario = given if isinstance(given, Scenario) else load(given)
        return _advanced(scenario, 0.0 if time_s is None else number("time_s", time_s))
    if not hasattr(given, "attrs"):
        found = type(given).__name__
        raise KingpostError(
            f"picture: found {found}, allowed: a scenario, a simulation, or the data set of a run"
        )
    return _replayed(given, time_s)


def _advanced(scenario: Scenario, time_s: float) -> Simulation:
    longest = scenario.model["duration_s"]
    if not 0 <= time_s <= longest:
        raise KingpostError(f"time_s: found {time_s:g}, allowed: 0 to {longest:g}")
    simulation = Simulation(scenario)
    simulation.step(round(time_s / simulation.step_s))
    return simulation


def _replayed(run: xarray.Dataset, time_s: float | None) -> Simulation:
    """The simulation of a recorded run at one of its records, whose bodies are those of the record."""
    if "run" in run.dims or "position" not in run or not run.attrs.get("scenario"):
        raise KingpostError("picture: found no single run, allowed: the data set of kingpost.run")
    asked = float(run["time"][0]) if time_s is None else number("time_s", time_s)
    first, last = float(run["time"][0]), float(run["time"][-1])
    if not first <= asked <= last:
        raise KingpostError(f"time_s: found {asked:g}, allowed: {first:g} to {last:g}")
    record = run.isel(time=int(np.abs(run["time"].values - asked).argmin()))
    scenario = scenario_of_run(run)
    simulation = _advanced(scenario, float(record["time"]))
    off = np.abs(simulation.poses()[:, :3] - record["position"].values)
    if not (off <= SAME_PLACE_M).all():
        raise KingpostError(
            f"picture: found a body {off.max():.2g} m from its place in the run, allowed: a run of its "
            "scenario alone; draw the simulation if inputs were set by hand"
        )
    return simulation


def scenario_of_run(run: xarray.Dataset) -> Scenario:
    """The scenario that a run records, with the files that it names.

    Raises
    ------
    KingpostError
        If a file has changed since the run.

    >>> from kingpost import run
    >>> scenario_of_run(run("paper", {"simulation.duration_s": 0.01}, motor_2=True))["motor_2"]
    True
    """
    import json

    scenario = Scenario(json.dumps(scenario_of(run)), str(run.attrs.get("source", "")))
    known = digests_of(run)
    for name, digest in scenario.digests.items():
        if known.get(name, digest) != digest:
            raise KingpostError(
                f"{name}: found another file than that of the run, allowed: the file of the run"
            )
    return scenario
