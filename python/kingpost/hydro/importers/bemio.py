"""BEMIO's HDF5 files, as WEC-Sim's functions write them (`writeBEMIOH5`, `normalizeBEM`, `readWAMIT`).

Coefficients are divided: A by rho, B by rho w, C by rho g, X by rho g, unless `scaled` is 1. Phases are
those of exp(+i w t): BEMIO keeps WAMIT's phases and conjugates Capytaine's. Moments are about `cg`.
Whether C includes weight depends on BEMIO's source; the file does not contain this.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .foreign import Foreign, Options, reading_error

if TYPE_CHECKING:
    from numpy.typing import NDArray

EXCITATION = "hydro_coeffs/excitation"


def read(path: str, options: Options) -> Foreign:
    """Read a file of one body.

    Raises
    ------
    HydrodynamicsError
        When it cannot be read, has several bodies or lacks a field.
    """
    import h5py

    try:
        with h5py.File(path) as file:
            return _read(_Group(file, path), options)
    except (OSError, RuntimeError) as error:
        raise reading_error(
            f"a file that h5py cannot read ({error})", "a BEMIO .h5 file, whole", path
        ) from None


class _Group:
    """A group of the HDF5 file, with checked access by path."""

    def __init__(self, group: Any, file: str) -> None:
        self.group, self.file = group, file

    def has(self, name: str) -> bool:
        return name in self.group

    def array(self, name: str, *shape: int | None) -> NDArray[np.float64]:
        if name not in self.group:
            raise reading_error("nothing", "this field of a BEMIO file", self.file, name)
        values = np.array(self.group[name])
        fits = not shape or (
            values.ndim == len(shape)
            and all(wanted in (None, length) for wanted, length in zip(shape, values.shape, strict=True))
        )
        if not fits or values.dtype.kind not in "iuf":
            wanted = " x ".join("n" if length is None else str(length) for length in shape) or "any"
            raise reading_error(
                f"the shape {values.shape}", f"numbers in the shape {wanted}", self.file, name
            )
        return values.astype(float)

    def number(self, name: str) -> float:
        return float(self.array(name).ravel()[0])


def _read(at: _Group, options: Options) -> Foreign:
    if at.has("body2"):
        raise reading_error("several bodies", "a file of one body", at.file)
    omega = at.array("simulation_parameters/w").ravel()
    directions = at.array("simulation_parameters/wave_dir").ravel()
    n, m = len(omega), len(directions)
    increasing = np.argsort(omega)
    rho, g = at.number("simulation_parameters/rho"), at.number("simulation_parameters/g")
    divided = at.number("simulation_parameters/scaled") == 0.0
    coefficients, properties = "body1/hydro_coeffs", "body1/properties"
    mass_unit = rho if divided else 1.0
    damping_unit = rho * omega[:, None, None] if divided else 1.0
    force_unit = rho * g if divided else 1.0
    added_mass = at.array(f"{coefficients}/added_mass/all", 6, 6, n).transpose(2, 0, 1) * mass_unit
    damping = at.array(f"{coefficients}/radiation_damping/all", 6, 6, n).transpose(2, 0, 1) * damping_unit
    excitation = _complex(at, f"body1/{EXCITATION}", m, n) * force_unit
    froude_krylov = None
    if at.has(f"body1/{EXCITATION}/froude-krylov/re"):
        froude_krylov = _complex(at, f"body1/{EXCITATION}/froude-krylov", m, n)[increasing] * force_unit
    return Foreign(
        file=at.file,
        solver=f"{_text(at, 'bem_data/code')}, by BEMIO",
        frequencies_rad_s=omega[increasing],
        directions_rad=np.radians(directions),
        added_mass=added_mass[increasing],
        radiation_damping=damping[increasing],
        added_mass_infinite=at.array(f"{coefficients}/added_mass/inf_freq", 6, 6) * mass_unit,
        excitation=excitation[increasing],
        froude_krylov=froude_krylov if froude_krylov is None or np.isfinite(froude_krylov).all() else None,
        restoring=at.array(f"{coefficients}/linear_restoring_stiffness", 6, 6) * force_unit,
        density_kg_m3=rho,
        gravity_m_s2=g,
        water_depth_m=_depth(at),
        reference_m=at.array(f"{properties}/cg").ravel(),
        centre_of_gravity_m=at.array(f"{properties}/cg").ravel(),
        centre_of_buoyancy_m=at.array(f"{properties}/cb").ravel(),
        volume_m3=at.number(f"{properties}/disp_vol"),
    )


def _complex(at: _Group, name: str, directions: int, frequencies: int) -> NDArray[np.complex128]:
    """(frequency, direction, 6) of exp(-i w t): conjugated."""
    real = at.array(f"{name}/re", 6, directions, frequencies)
    imaginary = at.array(f"{name}/im", 6, directions, frequencies)
    return (real - 1j * imaginary).transpose(2, 1, 0)


def _text(at: _Group, name: str) -> str:
    value = at.group[name][()] if at.has(name) else b"unknown"
    return value.decode() if isinstance(value, bytes) else str(value)


def _depth(at: _Group) -> float:
    name = "simulation_parameters/water_depth"
    if at.has(name) and at.group[name].dtype.kind in "SO":
        return np.inf if "inf" in _text(at, name) else at.number(name)
    return at.number(name)
