"""The hydrodynamic database as a labelled data set."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..errors import HydrodynamicsError
from .database import MOTIONS
from .several import SeveralHulls

if TYPE_CHECKING:
    import xarray
    from numpy.typing import NDArray

    from .database import Database

FRAME = "hull: x forward, y to port, z up, origin on the water plane"
LEVEL = "level: x forward, y to port, z up, origin on the water plane, above or below the hull's"
"""Description of the coefficients' frame for an inclined hull; x is along its heading."""


def to_dataset(database: Database) -> xarray.Dataset:
    """Convert a database to a data set with Capytaine's names, for Capytaine's post-processing.

    Parameters
    ----------
    database
        A database of one hull.

    Returns
    -------
    xarray.Dataset
        ``added_mass`` and ``radiation_damping`` along ``omega`` (rad/s), ``influenced_dof`` and
        ``radiating_dof`` (Surge to Yaw), ``added_mass_infinite`` without ``omega``; ``Froude_Krylov_force``,
        ``diffraction_force`` and ``excitation_force`` along ``omega``, ``wave_direction`` (rad, to where
        waves go) and ``influenced_dof``, complex, for each metre of amplitude, for exp(-i w t);
        ``mean_drift``, if it is known. The variable ``<variable>_unit`` holds the units, which differ by
        motion. For a hull that lists or trims, the attributes have ``roll_rad``, ``pitch_rad`` and
        ``height_m``.

    Raises
    ------
    HydrodynamicsError
        If it is a database of several hulls.

    >>> from kingpost import gallery
    >>> from kingpost.hydro import read
    >>> found = to_dataset(read(gallery.folder() / "hydro" / "barge.hydro.json"))
    >>> found["added_mass"].dims
    ('omega', 'influenced_dof', 'radiating_dof')
    >>> str(found["added_mass_unit"].sel(influenced_dof="Roll", radiating_dof="Roll").item())
    'kg m^2'
    """
    import xarray

    if isinstance(database, SeveralHulls):
        found = f"several hulls, {', '.join(database.names)}"
        raise HydrodynamicsError("database", found, "one hull: database.of(name) gives one of them")
    by_motion, by_wave = ("influenced_dof", "radiating_dof"), ("omega", "wave_direction", "influenced_dof")
    rows = [
        ("added_mass", ("omega", *by_motion), database.added_mass, "added mass"),
        ("radiation_damping", ("omega", *by_motion), database.radiation_damping, "radiation damping"),
        ("added_mass_infinite", by_motion, database.added_mass_infinite, "added mass at infinite frequency"),
        ("Froude_Krylov_force", by_wave, database.froude_krylov, "Froude-Krylov force"),
        ("diffraction_force", by_wave, database.diffraction, "diffraction force"),
        ("excitation_force", by_wave, database.excitation, "wave excitation force"),
    ]
    if database.mean_drift is not None:
        rows.append(
            ("mean_drift", ("omega", "wave_direction", "drift"), database.mean_drift, "mean drift force")
        )
    frame = FRAME if database.hull.attitude is None else LEVEL
    variables = {
        name: (dims, values, {"long_name": long_name, "frame": frame})
        for name, dims, values, long_name in rows
    }
    variables |= {f"{name}_unit": _units(name, dims) for name, dims, *_ in rows}
    return xarray.Dataset(variables, _coordinates(database), _attributes(database))


def _units(name: str, dims: tuple[str, ...]) -> tuple[tuple[str, ...], NDArray[np.str_], dict[str, str]]:
    """Units of a variable by its motions; not a coordinate, because Capytaine would carry it along."""
    # Exponent of the length in the unit of an entry, relative to translations.
    lever = np.repeat([0, 1], 3)
    kept, units = {
        "added_mass": (dims[-2:], np.array(["kg", "kg m", "kg m^2"])[lever[:, None] + lever]),
        "radiation_damping": (dims[-2:], np.array(["kg/s", "kg m/s", "kg m^2/s"])[lever[:, None] + lever]),
        "mean_drift": (dims[-1:], np.array(["N/m^2", "N/m^2", "N/m"])),
    }.get(name.removesuffix("_infinite"), (dims[-1:], np.array(["N/m", "N"])[lever]))
    return kept, units, {"long_name": f"units of {name}"}


def _coordinates(database: Database) -> dict[str, object]:
    circle = {"units": "rad", "long_name": "direction to which waves go, from +x counter-clockwise"}
    dofs = np.array([motion.capitalize() for motion in MOTIONS], str)
    water = database.water
    depth_m = np.inf if water.depth_m is None else water.depth_m
    coordinates: dict[str, object] = {
        "omega": ("omega", database.frequencies_rad_s, {"units": "rad/s", "long_name": "angular frequency"}),
        "wave_direction": ("wave_direction", database.wave_directions_rad, circle),
        "influenced_dof": dofs,
        "radiating_dof": dofs,
        "rho": ((), water.density_kg_m3, {"units": "kg/m^3", "long_name": "density of the water"}),
        "g": ((), water.gravity_m_s2, {"units": "m/s^2", "long_name": "acceleration of gravity"}),
        "water_depth": ((), depth_m, {"units": "m", "long_name": "depth of the water"}),
        "forward_speed": ((), 0.0, {"units": "m/s", "long_name": "forward speed"}),
    }
    if database.mean_drift is not None:
        coordinates["drift"] = np.array(["surge", "sway", "yaw"], str)
    return coordinates


def _attributes(database: Database) -> dict[str, object]:
    hull = database.hull
    attitude = {} if hull.attitude is None else vars(hull.attitude)
    return {
        "Conventions": "CF-1.11",
        "title": database.title,
        "solver": database.provenance.solver,
        "source": database.provenance.source,
        "draught_m": hull.draught_m,
        "volume_m3": hull.volume_m3,
        "centre_of_buoyancy_m": hull.centre_of_buoyancy_m,
        "waterplane_area_m2": hull.waterplane.area_m2,
        **attitude,
    }
