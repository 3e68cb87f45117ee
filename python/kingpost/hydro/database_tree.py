"""Parts that the files of one hull and of several hulls share, as trees of plain values: each is read, with
every field checked, and made."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from .database import (
    Attitude,
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

    from .database import Database
    from .several import PlacedHull, SeveralHulls

FORMAT = "kingpost-hydrodynamics"
SIGNIFICANT_DIGITS = 7

_HULL = ("draught_m", "length_m", "beam_m", "volume_m3", "centre_of_buoyancy_m", "waterplane", "mesh")
_ATTITUDE = ("roll_rad", "pitch_rad", "height_m")


def check_format(tree: dict[str, Any], file: str | None, version: int) -> None:
    """Refuse another format or version: a file of another version has other fields, so that the error names
    the version, not the fields."""
    for name, value in (("format", FORMAT), ("version", version)):
        if name in tree:
            Fields(tree, "", file).constant(name, value)


def grid(top: Fields) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Read the frequencies and the wave directions."""
    frequencies = top.numbers("frequencies_rad_s", None)
    if len(frequencies) == 0 or frequencies[0] <= 0 or (np.diff(frequencies) <= 0).any():
        raise top.wrong("frequencies_rad_s", "a list that is not", "one or more, increasing, greater than 0")
    directions = top.numbers("wave_directions_rad", None)
    m = len(directions)
    if m == 0 or np.abs(directions - 2 * np.pi / m * np.arange(m)).max() > 1e-6:
        allowed = "a regular grid of the whole circle from 0"
        raise top.wrong("wave_directions_rad", "other directions", allowed)
    return frequencies, directions


def provenance(top: Fields) -> Provenance:
    """Read the origin of the numbers."""
    names = ("tool", "solver", "source", "panels", "lid_panels", "notes")
    at = top.fields("provenance", names, ("warnings",))
    warnings = () if at.values["warnings"] is None else at.texts("warnings")
    return Provenance(at.text("tool"), at.text("solver"), at.text("source"), at.count("panels"),
                      at.count("lid_panels"), at.texts("notes"), warnings)  # fmt: skip


def water(top: Fields) -> Water:
    """Read the water."""
    at = top.fields("water", ("density_kg_m3", "gravity_m_s2", "depth_m"))
    depth = None if at.values["depth_m"] is None else at.number("depth_m", positive=True)
    return Water(at.number("density_kg_m3", positive=True), at.number("gravity_m_s2", positive=True), depth)


def hull(top: Fields) -> Hull:
    """Read the particulars of a hull, its mesh and its attitude."""
    at = top.fields("hull", _HULL, ("attitude",))
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


def complex_forces(top: Fields, name: str, n: int, m: int) -> NDArray[np.complex128]:
    """Read forces of n frequencies and m directions."""
    at = top.fields(name, ("real", "imaginary"))
    return at.numbers("real", n, m, 6) + 1j * at.numbers("imaginary", n, m, 6)


def drift_loading(top: Fields) -> DriftLoading | None:
    """Read the loading of a mean drift, if there is one."""
    if top.values["mean_drift_loading"] is None:
        return None
    names = ("mass_kg", "keel_to_gravity_m", "radii_of_gyration_m", "roll_damping_ratio")
    at = top.fields("mean_drift_loading", names)
    radii = at.numbers("radii_of_gyration_m", 3)
    if not (radii > 0).all():
        raise at.wrong("radii_of_gyration_m", f"{radii.min():g}", "numbers greater than 0")
    mass, height = (at.number(name, positive=True) for name in ("mass_kg", "keel_to_gravity_m"))
    return DriftLoading(mass, height, radii, at.number("roll_damping_ratio"))


def mean_drift(top: Fields, n: int, m: int) -> NDArray[np.float64] | None:
    """Read the mean drift, if there is one."""
    return None if top.values["mean_drift"] is None else top.numbers("mean_drift", n, m, 3)


def radiation(top: Fields, motions: int) -> Radiation | None:
    """Read the fitted memory of a number of motions, if there is one."""
    if top.values["radiation"] is None:
        return None
    at = top.fields("radiation", ("modes", "fit_error"))
    modes = at.values["modes"]
    if not isinstance(modes, list) or len(modes) != motions:
        count = "six" if motions == 6 else str(motions)
        raise at.wrong("modes", "something else", f"a list of {count}, one for each motion")
    read = tuple(_mode(at, index, mode) for index, mode in enumerate(modes))
    return Radiation(read, at.number("fit_error"))


def _mode(radiation: Fields, index: int, mode: object) -> RadiationMode:
    at = Fields.of(mode, radiation.at(f"modes[{index}]"), radiation.file, ("poles_rad_s", "residues"))
    poles = at.numbers("poles_rad_s", None, 2)
    if (poles[:, 0] >= 0).any() or (poles[:, 1] < 0).any():
        raise at.wrong("poles_rad_s", "a pole that is not", "real parts below 0, imaginary parts from 0")
    residues = at.numbers("residues", len(poles), len(radiation.values["modes"]), 2)
    return RadiationMode(poles[:, 0] + 1j * poles[:, 1], residues[..., 0] + 1j * residues[..., 1])


def head_tree(database: Database | SeveralHulls, version: int) -> dict[str, Any]:
    """Format, version, title, origin and water."""
    return {
        "format": FORMAT, "version": version, "title": database.title,
        "provenance": provenance_tree(database.provenance), "water": water_tree(database.water),
    }  # fmt: skip


def matrices_tree(database: Database | SeveralHulls) -> dict[str, Any]:
    """Grids, added mass and damping."""
    names = ("frequencies_rad_s", "wave_directions_rad", "added_mass", "radiation_damping",
             "added_mass_infinite")  # fmt: skip
    return {name: getattr(database, name) for name in names}


def waves_tree(one: Database | PlacedHull) -> dict[str, Any]:
    """Loads of waves on one hull; without a field for the loading of a drift that has none."""
    tree = {
        "froude_krylov": complex_tree(one.froude_krylov), "diffraction": complex_tree(one.diffraction),
        "mean_drift": one.mean_drift,
    }  # fmt: skip
    loading = one.mean_drift_loading
    return tree if loading is None else {**tree, "mean_drift_loading": vars(loading)}


def provenance_tree(about: Provenance) -> dict[str, Any]:
    """The origin of the numbers as plain values."""
    found = {"tool": about.tool, "solver": about.solver, "source": about.source, "panels": about.panels,
             "lid_panels": about.lid_panels, "notes": list(about.notes)}  # fmt: skip
    if about.warnings:
        found["warnings"] = list(about.warnings)
    return found


def water_tree(of: Water) -> dict[str, Any]:
    """The water as plain values."""
    return {"density_kg_m3": of.density_kg_m3, "gravity_m_s2": of.gravity_m_s2, "depth_m": of.depth_m}


def hull_tree(of: Hull) -> dict[str, Any]:
    """A hull as plain values."""
    plane, mesh = of.waterplane, of.mesh
    found = {
        "draught_m": of.draught_m, "length_m": of.length_m, "beam_m": of.beam_m, "volume_m3": of.volume_m3,
        "centre_of_buoyancy_m": of.centre_of_buoyancy_m,
        "waterplane": {"area_m2": plane.area_m2, "first_moments_m3": plane.first_moments_m3,
                       "second_moments_m4": plane.second_moments_m4},
        "mesh": None if mesh is None else {"vertices_m": mesh.vertices_m, "triangles": mesh.triangles},
    }  # fmt: skip
    if of.attitude is not None:
        found["attitude"] = vars(of.attitude)
    return found


def radiation_tree(memory: Radiation | None) -> dict[str, Any] | None:
    """Write the memory with all digits: with rounded residues K(0) would not be zero and would resist a
    steady drift."""
    if memory is None:
        return None
    modes = [
        {"poles_rad_s": _pairs(mode.poles_rad_s).tolist(), "residues": _pairs(mode.residues).tolist()}
        for mode in memory.modes
    ]
    return {"modes": modes, "fit_error": plain(memory.fit_error)}


def complex_tree(values: NDArray[np.complex128]) -> dict[str, NDArray[np.float64]]:
    """Real and imaginary parts."""
    return {"real": np.real(values), "imaginary": np.imag(values)}


def _pairs(values: NDArray[np.complex128]) -> NDArray[np.float64]:
    return np.stack([np.real(values), np.imag(values)], axis=-1)


def plain(value: Any) -> Any:
    """Rounded Python lists, dictionaries and numbers; whole numbers without a decimal point."""
    if isinstance(value, dict):
        return {name: plain(item) for name, item in value.items()}
    if isinstance(value, np.ndarray):
        return plain(value.tolist())
    if isinstance(value, list | tuple):
        return [plain(item) for item in value]
    if isinstance(value, float | np.floating):
        rounded = float(f"{value:.{SIGNIFICANT_DIGITS}g}")
        return int(rounded) if abs(rounded) < 1e15 and rounded.is_integer() else rounded
    return value
