"""Capytaine's NetCDF files, of its versions 2 and 3.

Dimensions are read by name, in any order. Real and imaginary parts are along the dimension `complex`. Phases
are those of exp(-i w t), directions in radians to where waves go, as here.
Version 3 also writes the rotation centre, the centre of mass, the centre of buoyancy, the displaced mass
and the draught; version 2 does not. The hydrostatic stiffness includes weight if the file has a centre of
mass.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..database import MOTIONS
from .foreign import Foreign, Options, reading_error

if TYPE_CHECKING:
    import xarray
    from numpy.typing import NDArray

DOFS = [motion.capitalize() for motion in MOTIONS]
CLASSIC = b"CDF"
ALLOWED = "a NetCDF file of Capytaine with added mass, damping and excitation of one body in six motions"


def read(path: str, options: Options) -> Foreign:
    """Read a file of one body.

    Raises
    ------
    HydrodynamicsError
        When it cannot be read, lacks a field or has several bodies, speeds, depths or densities.
    """
    import xarray

    with open(path, "rb") as file:
        classic = file.read(3) == CLASSIC
    try:
        with xarray.open_dataset(path, engine="scipy" if classic else "h5netcdf") as dataset:
            return _read(dataset.load(), path)
    except (OSError, ValueError, TypeError, RuntimeError, IndexError, EOFError) as error:
        raise reading_error(f"a file that cannot be read ({error})", ALLOWED, path) from None
    except KeyError as error:
        raise reading_error(f"nothing named {error}", ALLOWED, path) from None


def _read(dataset: xarray.Dataset, path: str) -> Foreign:
    for name in ("radiating_dof", "influenced_dof"):
        found = [str(value) for value in dataset[name].values]
        if sorted(found) != sorted(DOFS):
            raise reading_error(", ".join(found[:8]), ", ".join(DOFS), path, name)
        dataset = dataset.assign_coords({name: found})
    dataset = _by_frequency(dataset, path)
    if "forward_speed" in dataset.coords and np.abs(dataset["forward_speed"].values).max() > 0:
        raise reading_error("a forward speed", "zero forward speed", path, "forward_speed")
    omega = dataset["omega"].values
    inside, infinite = (omega > 0) & np.isfinite(omega), np.isinf(omega)
    if not inside.any():
        raise reading_error("no frequency", "frequencies greater than 0", path, "omega")
    added_mass = _matrix(dataset, "added_mass", path)
    damping = _matrix(dataset, "radiation_damping", path)
    waves = {name: _waves(dataset, name, path) for name in ("Froude_Krylov_force", "diffraction_force")}
    version = str(dataset.attrs.get("capytaine_version", "unknown"))
    density, gravity = _number(dataset, "rho", path), _number(dataset, "g", path)
    mass = _number(dataset, "disp_mass", path)
    return Foreign(
        file=path,
        solver=f"Capytaine {version}",
        frequencies_rad_s=omega[inside],
        directions_rad=np.atleast_1d(dataset["wave_direction"].values).astype(float),
        added_mass=added_mass[inside],
        radiation_damping=damping[inside],
        added_mass_infinite=added_mass[infinite][0] if infinite.any() else None,
        excitation=(waves["Froude_Krylov_force"] + waves["diffraction_force"])[inside],
        froude_krylov=waves["Froude_Krylov_force"][inside],
        restoring=_restoring(dataset),
        density_kg_m3=density,
        gravity_m_s2=gravity,
        water_depth_m=_number(dataset, "water_depth", path),
        reference_m=_vector(dataset, "rotation_center", path),
        restoring_includes_weight=True if "center_of_mass" in dataset.variables else None,
        centre_of_gravity_m=_vector(dataset, "center_of_mass", path),
        centre_of_buoyancy_m=_vector(dataset, "center_of_buoyancy", path),
        volume_m3=None if mass is None or density is None else mass / density,
        draught_m=_number(dataset, "draught", path),
    )


def _by_frequency(dataset: xarray.Dataset, path: str) -> xarray.Dataset:
    """Return the data along an increasing dimension omega, whichever kind of frequency Capytaine was run
    with."""
    if "omega" not in dataset.dims:
        along = dataset["omega"].dims
        if len(along) != 1:
            raise reading_error(f"omega along {along}", "one frequency or many, along one dimension", path)
        dataset = dataset.swap_dims({along[0]: "omega"})
    return dataset.sortby("omega")


def _matrix(dataset: xarray.Dataset, name: str, path: str) -> NDArray[np.float64]:
    chosen = dataset[name].sel(influenced_dof=DOFS, radiating_dof=DOFS)
    return _alone(chosen, ("omega", "influenced_dof", "radiating_dof"), path)


def _waves(dataset: xarray.Dataset, name: str, path: str) -> NDArray[np.complex128]:
    values = dataset[name].sel(influenced_dof=DOFS)
    if "wave_direction" not in values.dims:
        values = values.expand_dims("wave_direction")
    dims = ("omega", "wave_direction", "influenced_dof")
    if "complex" not in values.dims:
        return _alone(values, dims, path)
    values = values.assign_coords(complex=[str(part) for part in values["complex"].values])
    return _alone(values.sel(complex="re", drop=True), dims, path) + 1j * _alone(
        values.sel(complex="im", drop=True), dims, path
    )


def _alone(values: xarray.DataArray, dims: tuple[str, ...], path: str) -> NDArray:
    """Return the values with the dimensions in this order; any other dimension must have a single value."""
    for name in values.dims:
        if name not in dims:
            if values.sizes[name] != 1:
                raise reading_error(f"{values.sizes[name]} values", "one value", path, str(name))
            values = values.isel({name: 0}, drop=True)
    return values.transpose(*dims).values


def _restoring(dataset: xarray.Dataset) -> NDArray[np.float64] | None:
    if "hydrostatic_stiffness" not in dataset:
        return None
    chosen = dataset["hydrostatic_stiffness"].sel(influenced_dof=DOFS, radiating_dof=DOFS)
    return chosen.transpose(..., "influenced_dof", "radiating_dof").values.reshape(6, 6)


def _number(dataset: xarray.Dataset, name: str, path: str) -> float | None:
    found = _vector(dataset, name, path)
    if found is not None and found.size != 1:
        raise reading_error(f"{found.size} values", "one value", path, name)
    return None if found is None else float(found[0])


def _vector(dataset: xarray.Dataset, name: str, path: str) -> NDArray[np.float64] | None:
    """Return the vector; `None` if it is missing or NaN, which Capytaine writes for an unknown value."""
    if name not in dataset.variables:
        return None
    found = np.atleast_1d(dataset[name].values).astype(float).ravel()
    return None if np.isnan(found).any() else found
