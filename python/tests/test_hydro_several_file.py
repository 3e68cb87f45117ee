"""File of a database of several hulls: round trips, the view of one hull, refused input."""

import json
from dataclasses import replace

import numpy as np
import pytest
from kingpost import hydro
from kingpost.errors import HydrodynamicsError
from kingpost.hydro import database_file, several_tree
from kingpost.hydro.database import Attitude, DriftLoading, Radiation, RadiationMode
from kingpost.hydro.several import Place, PlacedHull, SeveralHulls
from test_hydro_database import sample as one_hull


def sample(n: int = 3, m: int = 4) -> SeveralHulls:
    """Three hulls, random numbers in every field."""
    random = np.random.default_rng(3)
    one = one_hull(n, m)
    listed = replace(one.hull, attitude=Attitude(0.02, -0.01, -0.1))
    shapes = {"barge": one.hull, "ship": listed, "tug": replace(one.hull, mesh=None)}

    def forces() -> np.ndarray:
        return random.normal(size=(n, m, 6)) + 1j * random.normal(size=(n, m, 6))

    hulls = [
        PlacedHull(name, Place(3.0 * k, -20.5 * k, 0.25 * k), hull, forces(), forces())
        for k, (name, hull) in enumerate(shapes.items())
    ]
    loading = DriftLoading(4.1e5, 2.5, np.array([3.23, 5.95, 6.45]), 0.05)
    hulls[1] = replace(hulls[1], mean_drift=random.normal(size=(n, m, 3)), mean_drift_loading=loading)
    mode = RadiationMode(np.array([-1.0, -0.5 + 2j]), random.normal(size=(2, 18)) + 0j)
    return SeveralHulls(
        "three hulls", one.provenance, one.water, tuple(hulls), one.frequencies_rad_s,
        one.wave_directions_rad, random.normal(size=(n, 18, 18)), random.normal(size=(n, 18, 18)),
        random.normal(size=(18, 18)), Radiation((mode,) * 18, 0.01),
    )  # fmt: skip


def test_a_written_database_reads_back_to_seven_digits_and_writes_the_same_bytes(tmp_path):
    written = sample()
    path = hydro.write(written, tmp_path / "a.hydro.json")
    found = hydro.read_several(path)
    assert found.names == ("barge", "ship", "tug")
    for name in ("added_mass", "radiation_damping", "added_mass_infinite"):
        np.testing.assert_allclose(getattr(found, name), getattr(written, name), rtol=5e-7, err_msg=name)
    for hull, before in zip(found.hulls, written.hulls, strict=True):
        assert (hull.place, hull.hull.attitude) == (before.place, before.hull.attitude)
        np.testing.assert_allclose(hull.excitation, before.excitation, rtol=1e-5, atol=1e-6)
    np.testing.assert_allclose(found.hulls[1].mean_drift, written.hulls[1].mean_drift, rtol=5e-7)
    assert found.hulls[1].mean_drift_loading.mass_kg == 4.1e5
    np.testing.assert_array_equal(found.radiation.modes[17].residues, written.radiation.modes[17].residues)
    again = hydro.write(found, tmp_path / "b.hydro.json")
    assert again.read_bytes() == path.read_bytes()
    np.testing.assert_array_equal(database_file.rounded(written).added_mass, found.added_mass)


def test_the_view_of_one_hull_has_its_own_blocks(tmp_path):
    every = sample()
    ship = every.of("ship")
    np.testing.assert_array_equal(ship.added_mass, every.added_mass[:, 6:12, 6:12])
    np.testing.assert_array_equal(ship.added_mass_infinite, every.added_mass_infinite[6:12, 6:12])
    np.testing.assert_array_equal(ship.excitation, every.hulls[1].excitation)
    np.testing.assert_array_equal(
        ship.radiation.modes[4].residues, every.radiation.modes[10].residues[:, 6:12]
    )
    assert (ship.hull, ship.mean_drift_loading.mass_kg) == (every.hulls[1].hull, 4.1e5)
    # It is a database of one hull in every respect.
    assert hydro.read(hydro.write(ship, tmp_path / "ship.hydro.json")).hull.attitude.roll_rad == 0.02
    with pytest.raises(HydrodynamicsError, match="hulls: found 'boat', allowed: one of barge, ship, tug"):
        every.of("boat")


def test_a_reader_of_one_hull_refuses_several_by_their_names(tmp_path):
    path = hydro.write(sample(), tmp_path / "a.hydro.json")
    with pytest.raises(
        HydrodynamicsError, match=r"hulls: found several, 'barge', 'ship', 'tug', allowed: one"
    ):
        hydro.read(path)
    with pytest.raises(HydrodynamicsError, match="found several hulls, barge, ship, tug, allowed: one hull"):
        hydro.to_dataset(sample())
    alone = hydro.write(sample().of("tug"), tmp_path / "b.hydro.json")
    with pytest.raises(HydrodynamicsError, match="hull: found one hull, allowed: several"):
        hydro.read_several(alone)


@pytest.mark.parametrize(
    ("place", "value", "message"),
    [
        (("version",), 3, "version: found 3, allowed: 2"),
        (("hulls",), [], "hulls: found [], allowed: a list of two hulls or more"),
        (("hulls", 1, "name"), "barge", "hulls[1].name: found 'barge', allowed: a name that no other"),
        (("hulls", 0, "name"), "", "hulls[0].name: found '', allowed"),
        (("hulls", 2, "place", "x_m"), None, "hulls[2].place.x_m: found null, allowed: a finite number"),
        (("hulls", 2, "place"), {"x_m": 0}, "hulls[2].place.y_m: found nothing"),
        (("hulls", 1, "colour"), "red", "hulls[1].colour: found an unknown field"),
        (("hulls", 1, "hull", "volume_m3"), -1, "hulls[1].hull.volume_m3: found -1"),
        (("hulls", 1, "diffraction", "real"), [1], "hulls[1].diffraction.real: found the shape 1"),
        (("hulls", 1, "mean_drift"), [1], "hulls[1].mean_drift: found the shape 1, allowed: numbers in the "
         "shape 3 x 4 x 3"),
        (("added_mass",), [[1.0]], "added_mass: found the shape 1 x 1, allowed: numbers in the shape "
         "3 x 18 x 18"),
        (("radiation", "modes"), [], "radiation.modes: found something else, allowed: a list of 18, one"),
        (("radiation", "modes", 2, "residues"), [[[1, 0]] * 6] * 2, "radiation.modes[2].residues: found the "
         "shape 2 x 6 x 2, allowed: numbers in the shape 2 x 18 x 2"),
    ],
)  # fmt: skip
def test_a_wrong_value_is_named_with_its_place(tmp_path, place, value, message):
    tree = json.loads(json.dumps(several_tree.to_tree(sample())))
    at = tree
    for key in place[:-1]:
        at = at[key]
    at[place[-1]] = value
    path = tmp_path / "wrong.hydro.json"
    path.write_text(json.dumps(tree))
    with pytest.raises(HydrodynamicsError) as caught:
        hydro.read_several(path)
    assert str(caught.value).startswith(f"{path}: {message}")


def test_every_missing_field_is_named():
    for name in several_tree.to_tree(sample()):
        if name != "format":
            tree = several_tree.to_tree(sample())
            del tree[name]
            with pytest.raises(HydrodynamicsError, match=name):
                several_tree.from_tree(tree)
