"""A hydrodynamic database's file, `NAME.hydro.json`: every field is checked on reading, and files are written
completely or not at all.

Coefficients are stored with seven digits, the fitted memory with all digits. A file leaves out optional
fields without a value: the attitude of an upright hull, the loading of a mean drift.
"""

from __future__ import annotations

import json
import math
import os
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import output
from ..errors import HydrodynamicsError, OutputError
from ..reading import text_of
from .database import (
    Attitude,
    Database,
    DriftLoading,
    Hull,
    Mesh,
    Provenance,
    Radiation,
    RadiationMode,
    Water,
    Waterplane,
)
from .fields import Fields, shown

if TYPE_CHECKING:
    from numpy.typing import NDArray

ENDING = ".hydro.json"
FORMAT, VERSION = "kingpost-hydrodynamics", 1
SIGNIFICANT_DIGITS = 7


def read(path: str | Path) -> Database:
    """Read a database.

    Raises
    ------
    HydrodynamicsError
        If the file cannot be read, is not a database, is truncated or holds a value that is not allowed; the
        message names the field, the value found and the allowed values.
    """
    file = str(path)
    allowed = f"a hydrodynamic database, as `kingpost hydro` writes ({ENDING})"
    try:
        text = text_of(path, "utf-8")
    except UnicodeDecodeError:
        raise HydrodynamicsError("", "a file that is not text", allowed, file) from None
    except OSError as error:
        raise HydrodynamicsError("", error.strerror, allowed, file) from None
    try:
        tree = json.loads(text)
    except (ValueError, RecursionError) as error:
        ended = isinstance(error, json.JSONDecodeError) and error.pos >= len(text.rstrip())
        found = "a file that is cut short" if ended and text.strip() else "a file that is not JSON"
        raise HydrodynamicsError("", found, allowed, file) from None
    if not isinstance(tree, dict) or "format" not in tree:
        raise HydrodynamicsError("", "JSON of an unknown format", allowed, file)
    return from_tree(tree, file)


def write(database: Database, path: str | Path) -> Path:
    """Check a database and write it atomically: to a temporary file, which is then renamed.

    Raises
    ------
    HydrodynamicsError
        When a value is not allowed, or the file cannot be written.
    """
    target = check_output(path)
    tree = to_tree(database)
    from_tree(tree, str(target))
    text = json.dumps(tree, separators=(",", ":"), ensure_ascii=False, allow_nan=False) + "\n"
    try:
        output.write_text(target, text)
    except OutputError as error:
        raise HydrodynamicsError("", error.reason, "a path that can be written to", str(target)) from None
    return target


def rounded(database: Database) -> Database:
    """The database as read back from its file.

    The memory is fitted to these rounded numbers, so that a fit to the stored coefficients gives the stored
    memory: poles that the data hardly determine depend on the eighth digit.
    """
    return from_tree(to_tree(database))


def check_output(path: str | Path) -> Path:
    """Check the output path before any computation."""
    target = Path(path)
    if not target.name.endswith(ENDING):
        raise HydrodynamicsError("", repr(target.name), f"a name that ends with {ENDING}")
    if not os.path.isdir(target.parent):
        raise HydrodynamicsError("", "no such folder", "a folder that exists", str(target.parent))
    if os.path.isdir(target):
        raise HydrodynamicsError("", "a folder", "a file", str(target))
    return target


_HULL = ("draught_m", "length_m", "beam_m", "volume_m3", "centre_of_buoyancy_m", "waterplane", "mesh")
_ATTITUDE = ("roll_rad", "pitch_rad", "height_m")
_TOP = ("format", "version", "title", "provenance", "water", "hull", "frequencies_rad_s",
        "wave_directions_rad", "added_mass", "radiation_damping", "added_mass_infinite", "froude_krylov",
        "diffraction", "mean_drift", "radiation")  # fmt: skip


def from_tree(tree: dict[str, Any], file: str | None = None) -> Database:
    """The database that a tree of plain values describes, every field checked."""
    for name, value in (("format", FORMAT), ("version", VERSION)):
        if name in tree:
            # A file of another version has other fields: the error names the version, not the fields.
            Fields(tree, "", file).constant(name, value)
    # Older files have no loading.
    top = Fields.of(tree, "", file, _TOP, ("mean_drift_loading",))
    frequencies = top.numbers("frequencies_rad_s", None)
    if len(frequencies) == 0 or frequencies[0] <= 0 or (np.diff(frequencies) <= 0).any():
        raise top.wrong("frequencies_rad_s", "a list that is not", "one or more, increasing, greater than 0")
    directions = top.numbers("wave_directions_rad", None)
    n, m = len(frequencies), len(directions)
    if m == 0 or np.abs(directions - 2 * np.pi / m * np.arange(m)).max() > 1e-6:
        allowed = "a regular grid of the whole circle from 0"
        raise top.wrong("wave_directions_rad", "other directions", allowed)
    return Database(
        title=top.text("title"),
        provenance=_provenance(top),
        water=_water(top),
        hull=_hull(top.fields("hull", _HULL, ("attitude",))),
        frequencies_rad_s=frequencies,
        wave_directions_rad=directions,
        added_mass=top.numbers("added_mass", n, 6, 6),
        radiation_damping=top.numbers("radiation_damping", n, 6, 6),
        added_mass_infinite=top.numbers("added_mass_infinite", 6, 6),
        froude_krylov=_complex(top, "froude_krylov", n, m),
        diffraction=_complex(top, "diffraction", n, m),
        mean_drift=None if top.values["mean_drift"] is None else top.numbers("mean_drift", n, m, 3),
        radiation=None if top.values["radiation"] is None else _radiation(top),
        mean_drift_loading=None if top.values["mean_drift_loading"] is None else _drift_loading(top),
    )


def _provenance(top: Fields) -> Provenance:
    names = ("tool", "solver", "source", "panels", "lid_panels", "notes")
    at = top.fields("provenance", names, ("warnings",))
    warnings = () if at.values["warnings"] is None else at.texts("warnings")
    return Provenance(at.text("tool"), at.text("solver"), at.text("source"), at.count("panels"),
                      at.count("lid_panels"), at.texts("notes"), warnings)  # fmt: skip


def _water(top: Fields) -> Water:
    at = top.fields("water", ("density_kg_m3", "gravity_m_s2", "depth_m"))
    depth = None if at.values["depth_m"] is None else at.number("depth_m", positive=True)
    return Water(at.number("density_kg_m3", positive=True), at.number("gravity_m_s2", positive=True), depth)


def _hull(at: Fields) -> Hull:
    plane = at.fields("waterplane", ("area_m2", "first_moments_m3", "second_moments_m4"))
    return Hull(
        draught_m=at.number("draught_m", positive=True),
        length_m=at.number("length_m", positive=True),
        beam_m=at.number("beam_m", positive=True),
        volume_m3=at.number("volume_m3", positive=True),
        centre_of_buoyancy_m=at.numbers("centre_of_buoyancy_m", 3),
        waterplane=Waterplane(
            plane.number("area_m2", positive=True),
            plane.numbers("first_moments_m3", 2),
            plane.numbers("second_moments_m4", 3),
        ),
        mesh=None if at.values["mesh"] is None else _mesh(at.fields("mesh", ("vertices_m", "triangles"))),
        attitude=None if at.values["attitude"] is None else _attitude(at.fields("attitude", _ATTITUDE)),
    )


def _attitude(at: Fields) -> Attitude:
    found = Attitude(*(at.number(name) for name in _ATTITUDE))
    for name in _ATTITUDE[:2]:
        if abs(at.number(name)) >= math.pi / 2:
            raise at.wrong(name, shown(at.values[name]), "an angle between -pi/2 and pi/2")
    return found


def _mesh(at: Fields) -> Mesh:
    vertices, indices = at.numbers("vertices_m", None, 3), at.numbers("triangles", None, 3)
    wrong = (indices < 0) | (indices >= len(vertices)) | (indices != np.floor(indices))
    if wrong.any():
        raise at.wrong("triangles", f"{indices[wrong][0]:g}", f"indices from 0 to {len(vertices) - 1}")
    return Mesh(vertices, indices.astype(np.int64))


def _complex(top: Fields, name: str, n: int, m: int) -> NDArray[np.complex128]:
    at = top.fields(name, ("real", "imaginary"))
    return at.numbers("real", n, m, 6) + 1j * at.numbers("imaginary", n, m, 6)


def _drift_loading(top: Fields) -> DriftLoading:
    names = ("mass_kg", "keel_to_gravity_m", "radii_of_gyration_m", "roll_damping_ratio")
    at = top.fields("mean_drift_loading", names)
    radii = at.numbers("radii_of_gyration_m", 3)
    if not (radii > 0).all():
        raise at.wrong("radii_of_gyration_m", f"{radii.min():g}", "numbers greater than 0")
    mass, height = (at.number(name, positive=True) for name in ("mass_kg", "keel_to_gravity_m"))
    return DriftLoading(mass, height, radii, at.number("roll_damping_ratio"))


def _radiation(top: Fields) -> Radiation:
    at = top.fields("radiation", ("modes", "fit_error"))
    modes = at.values["modes"]
    if not isinstance(modes, list) or len(modes) != 6:
        raise at.wrong("modes", "something else", "a list of six, one for each motion")
    read = tuple(_mode(at, index, mode) for index, mode in enumerate(modes))
    return Radiation(read, at.number("fit_error"))


def _mode(radiation: Fields, index: int, mode: object) -> RadiationMode:
    at = Fields.of(mode, radiation.at(f"modes[{index}]"), radiation.file, ("poles_rad_s", "residues"))
    poles = at.numbers("poles_rad_s", None, 2)
    if (poles[:, 0] >= 0).any() or (poles[:, 1] < 0).any():
        raise at.wrong("poles_rad_s", "a pole that is not", "real parts below 0, imaginary parts from 0")
    residues = at.numbers("residues", len(poles), 6, 2)
    return RadiationMode(poles[:, 0] + 1j * poles[:, 1], residues[..., 0] + 1j * residues[..., 1])


def to_tree(database: Database) -> dict[str, Any]:
    """The database as plain values, with seven digits except for the memory: the contents of its file."""
    here, hull, plane = database, database.hull, database.hull.waterplane
    about, water, mesh = here.provenance, here.water, hull.mesh
    tree = {
        "format": FORMAT, "version": VERSION, "title": here.title,
        "provenance": {"tool": about.tool, "solver": about.solver, "source": about.source,
                       "panels": about.panels, "lid_panels": about.lid_panels, "notes": list(about.notes)},
        "water": {"density_kg_m3": water.density_kg_m3, "gravity_m_s2": water.gravity_m_s2,
                  "depth_m": water.depth_m},
        "hull": {
            "draught_m": hull.draught_m, "length_m": hull.length_m, "beam_m": hull.beam_m,
            "volume_m3": hull.volume_m3, "centre_of_buoyancy_m": hull.centre_of_buoyancy_m,
            "waterplane": {"area_m2": plane.area_m2, "first_moments_m3": plane.first_moments_m3,
                           "second_moments_m4": plane.second_moments_m4},
            "mesh": None if mesh is None else {"vertices_m": mesh.vertices_m, "triangles": mesh.triangles},
        },
        "frequencies_rad_s": here.frequencies_rad_s, "wave_directions_rad": here.wave_directions_rad,
        "added_mass": here.added_mass, "radiation_damping": here.radiation_damping,
        "added_mass_infinite": here.added_mass_infinite,
        "froude_krylov": _parts(here.froude_krylov), "diffraction": _parts(here.diffraction),
        "mean_drift": here.mean_drift,
    }  # fmt: skip
    if hull.attitude is not None:
        tree["hull"]["attitude"] = vars(hull.attitude)
    if about.warnings:
        tree["provenance"]["warnings"] = list(about.warnings)
    loading = here.mean_drift_loading
    if loading is not None:
        tree["mean_drift_loading"] = vars(loading)
    return {**_plain(tree), "radiation": _radiation_tree(here.radiation)}


def _radiation_tree(radiation: Radiation | None) -> dict[str, Any] | None:
    """Write the memory with all digits: with rounded residues K(0) would not be zero and would resist a
    steady drift."""
    if radiation is None:
        return None
    modes = [
        {"poles_rad_s": _pairs(mode.poles_rad_s).tolist(), "residues": _pairs(mode.residues).tolist()}
        for mode in radiation.modes
    ]
    return {"modes": modes, "fit_error": _plain(radiation.fit_error)}


def _parts(values: NDArray[np.complex128]) -> dict[str, NDArray[np.float64]]:
    return {"real": np.real(values), "imaginary": np.imag(values)}


def _pairs(values: NDArray[np.complex128]) -> NDArray[np.float64]:
    return np.stack([np.real(values), np.imag(values)], axis=-1)


def _plain(value: Any) -> Any:
    """Rounded Python lists, dictionaries and numbers; whole numbers without a decimal point."""
    if isinstance(value, dict):
        return {name: _plain(item) for name, item in value.items()}
    if isinstance(value, np.ndarray):
        return _plain(value.tolist())
    if isinstance(value, list | tuple):
        return [_plain(item) for item in value]
    if isinstance(value, float | np.floating):
        rounded = float(f"{value:.{SIGNIFICANT_DIGITS}g}")
        return int(rounded) if abs(rounded) < 1e15 and rounded.is_integer() else rounded
    return value
