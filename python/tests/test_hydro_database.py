"""File of the hydrodynamic database: round trips, refused input, and atomic writing."""

import json
import os

import numpy as np
import pint
import pytest
import xarray
from kingpost import gallery
from kingpost.errors import HydrodynamicsError
from kingpost.hydro import database_file, to_dataset
from kingpost.hydro.database import (
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
from kingpost.hydro.importers import capytaine_file
from kingpost.hydro.importers.foreign import Options

UNITS = pint.UnitRegistry()

TETRAHEDRON = Mesh(
    np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, -1.0]]),
    np.array([[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]]),
)
PLANE = Waterplane(0.5, np.array([1 / 6, 1 / 6]), np.array([1 / 12, 1 / 24, 1 / 12]))


def sample(n: int = 3, m: int = 4, **changes: object) -> Database:
    """Random numbers in every field."""
    random = np.random.default_rng(1)
    mode = RadiationMode(np.array([-1.0, -0.5 + 2j]), random.normal(size=(2, 6)) + 0j)
    values = {
        "title": "a hull",
        "provenance": Provenance("kingpost", "none", "random numbers", 4, None, ("for a test",)),
        "water": Water(depth_m=30.0),
        "hull": Hull(1.0, 1.0, 1.0, 1 / 6, np.array([0.25, 0.25, -0.25]), PLANE, TETRAHEDRON),
        "frequencies_rad_s": np.linspace(0.1, 2, n),
        "wave_directions_rad": 2 * np.pi * np.arange(m) / m,
        "added_mass": random.normal(size=(n, 6, 6)),
        "radiation_damping": random.normal(size=(n, 6, 6)),
        "added_mass_infinite": random.normal(size=(6, 6)),
        "froude_krylov": random.normal(size=(n, m, 6)) + 1j * random.normal(size=(n, m, 6)),
        "diffraction": random.normal(size=(n, m, 6)) + 1j * random.normal(size=(n, m, 6)),
        "mean_drift": random.normal(size=(n, m, 3)),
        "radiation": Radiation((mode,) * 6, 0.01),
    }  # fmt: skip
    return Database(**(values | changes))


def test_a_database_stores_the_loading_of_the_drift_and_files_without_one_are_read(tmp_path):
    loading = DriftLoading(4.1e5, 2.5, np.array([3.23, 5.95, 6.45]), 0.05)
    path = database_file.write(sample(mean_drift_loading=loading), tmp_path / "a.hydro.json")
    read = database_file.read(path).mean_drift_loading
    assert (read.mass_kg, read.keel_to_gravity_m, read.roll_damping_ratio) == (4.1e5, 2.5, 0.05)
    assert read.radii_of_gyration_m.tolist() == [3.23, 5.95, 6.45]
    tree = json.loads(path.read_text())
    tree["mean_drift_loading"]["radii_of_gyration_m"][1] = 0
    path.write_text(json.dumps(tree))
    with pytest.raises(HydrodynamicsError, match=r"mean_drift_loading\.radii_of_gyration_m: found 0"):
        database_file.read(path)
    before = database_file.write(sample(), tmp_path / "b.hydro.json")
    assert "mean_drift_loading" not in json.loads(before.read_text())
    assert database_file.read(before).mean_drift_loading is None


def test_a_written_database_reads_back_to_seven_digits(tmp_path):
    written = sample()
    read = database_file.read(database_file.write(written, tmp_path / "a.hydro.json"))
    assert read.title == written.title
    assert read.provenance == written.provenance
    assert read.water == written.water
    for name in ("added_mass", "radiation_damping", "added_mass_infinite", "froude_krylov", "diffraction",
                 "mean_drift", "frequencies_rad_s", "wave_directions_rad"):  # fmt: skip
        np.testing.assert_allclose(getattr(read, name), getattr(written, name), 1e-6, 1e-9, err_msg=name)
    np.testing.assert_allclose(read.hull.mesh.vertices_m, TETRAHEDRON.vertices_m, rtol=5e-7)
    np.testing.assert_array_equal(read.hull.mesh.triangles, TETRAHEDRON.triangles)
    modes = zip(read.radiation.modes, written.radiation.modes, strict=True)
    for mode, before in modes:
        np.testing.assert_allclose(mode.residues, before.residues, rtol=1e-6)


def test_writing_a_database_that_was_read_gives_the_same_bytes(tmp_path):
    first = database_file.write(sample(mean_drift=None, radiation=None), tmp_path / "a.hydro.json")
    second = database_file.write(database_file.read(first), tmp_path / "b.hydro.json")
    assert first.read_bytes() == second.read_bytes()


def test_the_data_set_carries_units_and_names():
    labelled = to_dataset(sample())
    for name, variable in labelled.variables.items():
        if variable.dtype.kind in "fc":
            assert "long_name" in variable.attrs, name
            units = (
                labelled[f"{name}_unit"].values.ravel()
                if name in labelled.data_vars
                else [variable.attrs["units"]]
            )
            for unit in units:
                UNITS.parse_units(str(unit))
    # A moment is a force with a lever; so is what a turn takes beside a shift.
    for name in ("added_mass", "radiation_damping"):
        of = labelled[f"{name}_unit"]
        shift, turn = (UNITS.parse_units(str(of.sel(influenced_dof=k, radiating_dof=k).item()))
                       for k in ("Surge", "Roll"))  # fmt: skip
        assert (turn / shift).dimensionality == UNITS.parse_units("m^2").dimensionality
    expected = sample().froude_krylov + sample().diffraction
    np.testing.assert_array_equal(labelled.excitation_force, expected)


def test_capytaine_accepts_the_data_set_and_its_file_reads_back(tmp_path):
    """Source: Capytaine: its post-processing beside the equation solved here, and its own file."""
    capytaine = pytest.importorskip("capytaine")
    database = database_file.read(gallery.folder() / "hydro" / "barge.hydro.json")
    labelled = to_dataset(database)
    inertia, stiffness = np.diag([4e5, 4e5, 4e5, 5e6, 2e7, 2e7]), np.diag([1e3, 1e3, 2e6, 9e6, 7e7, 1e4])
    matrix = {name: labelled[name] for name in ("influenced_dof", "radiating_dof")}
    labelled["inertia_matrix"] = xarray.DataArray(inertia, matrix)
    labelled["hydrostatic_stiffness"] = xarray.DataArray(stiffness, matrix)
    found = capytaine.post_pro.rao(labelled).transpose("omega", "wave_direction", "radiating_dof").values
    for k, omega in enumerate(database.frequencies_rad_s):
        impedance = (stiffness - omega**2 * (inertia + database.added_mass[k])
                     - 1j * omega * database.radiation_damping[k])  # fmt: skip
        expected = np.linalg.solve(impedance, database.excitation[k].T).T
        np.testing.assert_allclose(found[k], expected, rtol=1e-10, atol=1e-14)
    path = tmp_path / "barge.nc"
    apart = capytaine.io.xarray.separate_complex_values(to_dataset(database))
    apart.to_netcdf(path, engine="h5netcdf")
    again = capytaine_file.read(str(path), Options())
    np.testing.assert_array_equal(again.added_mass, database.added_mass)
    np.testing.assert_array_equal(again.radiation_damping, database.radiation_damping)
    np.testing.assert_allclose(again.excitation, database.excitation, rtol=1e-15)
    assert (again.density_kg_m3, again.gravity_m_s2) == (
        database.water.density_kg_m3,
        database.water.gravity_m_s2,
    )


@pytest.mark.parametrize(
    ("place", "value", "message"),
    [
        (("version",), 2, "version: found 2, allowed: 1"),
        (("format",), "wamit", "format: found 'wamit', allowed: 'kingpost-hydrodynamics'"),
        (("added_mass",), [[1.0]],
         "added_mass: found the shape 1 x 1, allowed: numbers in the shape 3 x 6 x 6"),
        (("added_mass_infinite", 2, 3), float("nan"),
         "added_mass_infinite[2][3]: found nan, allowed: a finite number"),
        (("added_mass_infinite", 2), [1], "added_mass_infinite: found lists of unequal lengths"),
        (("hull", "volume_m3"), -1, "hull.volume_m3: found -1, allowed: a number greater than 0"),
        (("hull", "colour"), "red", "hull.colour: found an unknown field"),
        (("hull", "mesh", "triangles", 0, 0), 9,
         "hull.mesh.triangles: found 9, allowed: indices from 0 to 3"),
        (("frequencies_rad_s", 0), 5.0, "frequencies_rad_s"),
        (("wave_directions_rad", 1), 1.0, "wave_directions_rad"),
        (("water", "density_kg_m3"), "1025",
         "water.density_kg_m3: found '1025', allowed: a number greater than 0"),
        (("radiation", "modes", 2, "poles_rad_s", 0, 0), 0.5, "radiation.modes[2].poles_rad_s"),
        (("radiation", "modes"), [], "radiation.modes"),
        (("mean_drift",), "none", "mean_drift: found 'none', allowed: numbers in the shape 3 x 4 x 3"),
    ],
)  # fmt: skip
def test_a_wrong_value_is_named_with_its_place(tmp_path, place, value, message):
    tree = database_file.to_tree(sample())
    at = tree
    for key in place[:-1]:
        at = at[key]
    at[place[-1]] = value
    path = tmp_path / "wrong.hydro.json"
    path.write_text(json.dumps(tree))
    with pytest.raises(HydrodynamicsError) as caught:
        database_file.read(path)
    assert str(caught.value).startswith(f"{path}: {message}")


def test_every_missing_field_is_named(tmp_path):
    path = tmp_path / "wrong.hydro.json"
    for name in database_file.to_tree(sample()):
        tree = database_file.to_tree(sample())
        del tree[name]
        path.write_text(json.dumps(tree))
        with pytest.raises(HydrodynamicsError, match=name if name != "format" else "unknown format"):
            database_file.read(path)


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (b"", "a file that is not JSON"),
        (b"[1, 2]", "JSON of an unknown format"),
        (b"frequency, added mass\n", "a file that is not JSON"),
        (b"\x89HDF\r\n\x1a\n\xff", "a file that is not text"),
        (b"[" * 100_000, "a file that is"),
    ],
)
def test_a_foreign_file_is_refused(tmp_path, content, message):
    path = tmp_path / "foreign.hydro.json"
    path.write_bytes(content)
    with pytest.raises(HydrodynamicsError, match=message):
        database_file.read(path)


def test_a_missing_file_is_refused(tmp_path):
    with pytest.raises(HydrodynamicsError, match="No such file"):
        database_file.read(tmp_path / "none.hydro.json")


def test_a_file_cut_short_anywhere_is_refused(tmp_path):
    path = database_file.write(sample(), tmp_path / "a.hydro.json")
    whole = path.read_text()
    for part in (0.01, 0.3, 0.77, 0.999):
        path.write_text(whole[: int(part * len(whole))])
        with pytest.raises(HydrodynamicsError):
            database_file.read(path)


def test_a_wrong_database_is_never_written(tmp_path):
    wrong = sample(added_mass_infinite=np.full((6, 6), np.nan))
    with pytest.raises(HydrodynamicsError, match="added_mass_infinite"):
        database_file.write(wrong, tmp_path / "a.hydro.json")
    assert os.listdir(tmp_path) == []


def test_an_interrupted_write_leaves_the_old_file(tmp_path, monkeypatch):
    path = database_file.write(sample(), tmp_path / "a.hydro.json")
    before = path.read_bytes()

    def interrupted(*_arguments: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(os, "replace", interrupted)
    with pytest.raises(KeyboardInterrupt):
        database_file.write(sample(title="another"), path)
    assert os.listdir(tmp_path) == ["a.hydro.json"]
    assert path.read_bytes() == before


def test_a_missing_folder_and_a_wrong_ending_are_refused(tmp_path):
    with pytest.raises(HydrodynamicsError, match="no such folder"):
        database_file.write(sample(), tmp_path / "none" / "a.hydro.json")
    with pytest.raises(HydrodynamicsError, match=r"ends with \.hydro\.json"):
        database_file.write(sample(), tmp_path / "a.json")
