"""The hydrodynamic database as a labelled data set."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    import xarray

    from .database import Database

MOTIONS = ("surge", "sway", "heave", "roll", "pitch", "yaw")
FRAME = "hull: x forward, y to port, z up, origin on the water plane"
LEVEL = "level: x forward, y to port, z up, origin on the water plane, above or below the hull's"
"""The frame of the coefficients of a hull that lists or trims; x is along its heading."""


def to_dataset(database: Database) -> xarray.Dataset:
    """Label a database.

    Returns
    -------
    xarray.Dataset
        Dimensions ``frequency`` (rad/s), ``wave_direction`` (rad, to where waves go), ``force`` and
        ``motion`` (surge to yaw); complex excitation is per metre of amplitude, for exp(-i w t). Of a hull
        that lists or trims the attributes have ``roll_rad``, ``pitch_rad`` and ``height_m``.
    """
    import xarray

    by_motion, by_wave = ("frequency", "force", "motion"), ("frequency", "wave_direction", "force")
    rows = [
        ("added_mass", by_motion, database.added_mass, "kg, kg m, kg m2", "added mass"),
        ("radiation_damping", by_motion, database.radiation_damping, "kg/s, kg m/s, kg m2/s",
         "radiation damping"),
        ("added_mass_infinite", ("force", "motion"), database.added_mass_infinite, "kg, kg m, kg m2",
         "added mass at infinite frequency"),
        ("froude_krylov", by_wave, database.froude_krylov, "N/m, N", "Froude-Krylov force"),
        ("diffraction", by_wave, database.diffraction, "N/m, N", "diffraction force"),
        ("excitation", by_wave, database.excitation, "N/m, N", "wave excitation force"),
    ]  # fmt: skip
    if database.mean_drift is not None:
        dims = ("frequency", "wave_direction", "drift")
        rows.append(("mean_drift", dims, database.mean_drift, "N/m2, N/m", "mean drift force"))
    frame = FRAME if database.hull.attitude is None else LEVEL
    variables = {
        name: (dims, values, {"units": units, "long_name": long_name, "frame": frame})
        for name, dims, values, units, long_name in rows
    }
    return xarray.Dataset(variables, _coordinates(database), _attributes(database))


def _coordinates(database: Database) -> dict[str, object]:
    circle = {"units": "rad", "long_name": "direction to which waves go, from +x counter-clockwise"}
    coordinates: dict[str, object] = {
        "frequency": ("frequency", database.frequencies_rad_s, {"units": "rad/s", "long_name": "frequency"}),
        "wave_direction": ("wave_direction", database.wave_directions_rad, circle),
        "force": np.array(MOTIONS, str),
        "motion": np.array(MOTIONS, str),
    }
    if database.mean_drift is not None:
        coordinates["drift"] = np.array(["surge", "sway", "yaw"], str)
    return coordinates


def _attributes(database: Database) -> dict[str, object]:
    water, hull = database.water, database.hull
    attitude = {} if hull.attitude is None else vars(hull.attitude)
    return {
        "title": database.title,
        "solver": database.provenance.solver,
        "source": database.provenance.source,
        "density_kg_m3": water.density_kg_m3,
        "gravity_m_s2": water.gravity_m_s2,
        "depth_m": float("inf") if water.depth_m is None else water.depth_m,
        "draught_m": hull.draught_m,
        "volume_m3": hull.volume_m3,
        "centre_of_buoyancy_m": hull.centre_of_buoyancy_m,
        "waterplane_area_m2": hull.waterplane.area_m2,
        **attitude,
    }
