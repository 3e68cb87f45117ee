"""A ship's displacement RAOs as a table that the joint ``moved_by_waves`` reads."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from .. import output
from ..errors import KingpostError
from ..results.columns import floating_bodies
from .response import complex_amplitude

if TYPE_CHECKING:
    import pandas
    import xarray

ENDINGS = (".csv",)
SENSES = ("surge_forward", "sway_port", "heave_up", "roll_port_up", "pitch_bow_down", "yaw_bow_port")


def displacement_raos(found: xarray.Dataset, body: str | None = None) -> pandas.DataFrame:
    """Displacement RAOs of a floating body: a row for each direction and frequency.

    The RAOs are those of the point of the body that at rest is at the phase reference (``reference_m``, on
    the still water), in axes with the heading of the first hull. They follow from the motion X(p) of the
    body's centre of mass p and its small rotation theta: ``X(0) = X(p) - theta x p``.

    Parameters
    ----------
    found
        Result of `rao`, with the body among its points.
    body
        Name of a floating body; default: the first.

    Returns
    -------
    pandas.DataFrame
        ``direction_to_deg`` against the heading (180 is a head sea), ``frequency_rad_s``, then for each
        motion its amplitude, such as ``surge_forward_m_per_m`` or ``roll_port_up_deg_per_m``, and
        ``surge_lag_deg`` behind the crest at the reference.

    Raises
    ------
    KingpostError
        If no such body floats, or it is not among the points.

    >>> from kingpost import rao
    >>> found = rao("barge", directions_rad=[np.pi], frequencies_rad_s=[0.4])
    >>> table = displacement_raos(found)
    >>> round(table["direction_to_deg"].item()), round(table["heave_up_m_per_m"].item(), 1)
    (180, 1.0)
    """
    floating = [name for name in floating_bodies(found) if name in found["point"].values]
    if body is None and floating:
        body = floating[0]
    if body not in floating:
        raise KingpostError(f"body: found {body!r}, allowed: {', '.join(floating) or 'a body that floats'}")
    return _frame(found, _about_reference(found, body))


def _about_reference(found: xarray.Dataset, body: str) -> np.ndarray:
    """Surge, sway, heave, roll, pitch and yaw by direction and frequency, in axes of the heading."""
    cos, sin = np.cos(found.attrs["heading_rad"]), np.sin(found.attrs["heading_rad"])
    to_heading = np.array([[cos, sin, 0], [-sin, cos, 0], [0, 0, 1]])
    # Roll and pitch are about horizontal axes with the body's heading, yaw is about the vertical.
    theta = (
        complex_amplitude(found, "rotation").sel(body=body).transpose("direction", "omega", "angle").values
    )
    moved = complex_amplitude(found, "displacement").sel(point=body).transpose("direction", "omega", "axis")
    at_rest = found["place"].sel(point=body).values - np.append(found.attrs["reference_m"], 0.0)
    moved = moved.values @ to_heading.T - np.cross(theta, to_heading @ at_rest)
    return np.concatenate([moved, theta], axis=-1)


def _frame(found: xarray.Dataset, raos: np.ndarray) -> pandas.DataFrame:
    import pandas

    directions, frequencies = np.meshgrid(found["direction"], found["omega"], indexing="ij")
    against = np.rad2deg(directions - found.attrs["heading_rad"]) % 360
    # Round before wrapping to one turn: 359.999999 deg would otherwise be printed instead of 0.
    columns = {"direction_to_deg": np.round(against, 9).ravel() % 360, "frequency_rad_s": frequencies.ravel()}
    for mode, sense in enumerate(SENSES):
        amplitude, lag = np.abs(raos[..., mode]), np.rad2deg(np.angle(raos[..., mode]))
        unit = "m_per_m" if mode < 3 else "deg_per_m"
        columns[f"{sense}_{unit}"] = (amplitude if mode < 3 else np.rad2deg(amplitude)).ravel()
        columns[f"{sense.split('_')[0]}_lag_deg"] = lag.ravel()
    return pandas.DataFrame(columns)


def write(found: xarray.Dataset, path: str | Path, body: str | None = None) -> Path:
    """Write the table as CSV with ten significant digits and a title line."""
    path = output.check(path, ENDINGS)
    text = displacement_raos(found, body).to_csv(index=False, float_format="%.10g", lineterminator="\n")
    title = " ".join(str(found.attrs["title"]).split())
    return output.write_text(path, f"# {title}: displacement RAOs about rest in still water\n{text}")
