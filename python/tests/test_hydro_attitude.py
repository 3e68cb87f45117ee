"""Inclined hulls: their meshes, coefficients and files, and refused input."""

from __future__ import annotations

import argparse
import json
from dataclasses import replace
from functools import cache
from pathlib import Path

import kingpost
import numpy as np
import pytest
from kingpost import cli
from kingpost.errors import HydrodynamicsError
from kingpost.hydro import attitude_command, build, database_file, inclined, solve, to_dataset
from kingpost.hydro.attitude import Inclination, from_degrees, placed, rotation
from kingpost.hydro.database import Attitude, Water
from kingpost.hydro.drift import Loading
from kingpost.hydro.hull_files import HullFile
from kingpost.hydro.hull_options import parse_shape
from kingpost.hydro.meshes import HullMeshes, parametric, whole
from kingpost.hydro.partial import Partial
from kingpost.hydro.summary import summary
from kingpost.hydro.surface import Surface, particulars
from kingpost.hydro.symmetry import SIGNS

BARGE = "box:length_m=20,beam_m=10,draught_m=2,depth_m=5"
SPHERE = "sphere:radius_m=5"
VESSEL = "offshore_vessel:length_m=80,beam_m=18,draught_m=5.5,depth_m=8,block_coefficient=0.68"
LENGTH, BEAM, DRAUGHT = 20.0, 10.0, 2.0
GALLERY = Path(__file__).parents[2] / "scenarios" / "hydro"


@cache
def standing(description: str, panels: int, heel_deg: float, trim_deg: float = 0.0) -> HullMeshes:
    shape = parse_shape(description)
    asked = from_degrees(heel_deg, trim_deg)
    upright = upright_hull(description, panels)
    return upright if asked is None else inclined.of_shape(shape, upright, panels, asked)


@cache
def upright_hull(description: str, panels: int) -> HullMeshes:
    return parametric(parse_shape(description), description, panels)


def wetted(hull: HullMeshes) -> Surface:
    return whole(hull.panels.surface, hull.reflections)


def box_centre(heel: float) -> np.ndarray:
    """Centre of buoyancy of a wall-sided box in level axes, from (I / V) tan and (I / 2 V) tan^2."""
    moment = BEAM**2 / (12 * DRAUGHT)
    y, z = -moment * np.tan(heel), -DRAUGHT / 2 + moment * np.tan(heel) ** 2 / 2
    return rotation(heel, 0.0) @ [0.0, y, z]


def test_heel_to_starboard_puts_the_starboard_side_down_and_trim_by_the_bow_the_bow():
    turned = rotation(np.radians(5), np.radians(2))
    assert (turned @ [0, -1, 0])[2] < 0
    assert (turned @ [1, 0, 0])[2] < 0
    np.testing.assert_allclose(turned @ turned.T, np.eye(3), atol=1e-15)
    # The heading stays: the hull's x axis is over the level one.
    assert (turned @ [1, 0, 0])[1] == 0


@pytest.mark.parametrize("heel_deg", [5.0, -5.0, 15.0])
def test_a_listed_box_keeps_its_displacement_and_turns_about_the_middle_of_its_waterplane(heel_deg):
    """Source: the wall-sided formulas, while neither deck nor bottom is at the water: 30.96 and 21.8 deg."""
    hull, heel = standing(BARGE, 300, heel_deg), np.radians(heel_deg)
    assert hull.attitude.height_m == pytest.approx(0.0, abs=1e-12)
    for found in (hull.particulars, particulars(wetted(hull))):
        assert found.volume_m3 == pytest.approx(LENGTH * BEAM * DRAUGHT, rel=1e-12)
        np.testing.assert_allclose(found.centre_of_buoyancy_m, box_centre(heel), atol=1e-9)
        breadth = BEAM / np.cos(heel)
        assert found.waterplane.area_m2 == pytest.approx(LENGTH * breadth, rel=1e-9)
        assert found.waterplane.second_moments_m4[2] == pytest.approx(LENGTH * breadth**3 / 12, rel=1e-9)
    assert hull.remarks == ()


def test_a_box_whose_bottom_emerges_keeps_its_displacement():
    """Source: a wedge of depth d at its edge has the section d^2 / (2 sin cos)."""
    heel, draught = np.radians(20.0), 0.5
    hull = standing(f"box:length_m=20,beam_m=10,draught_m={draught},depth_m=5", 200, 20.0)
    sin, cos = np.sin(heel), np.cos(heel)
    depth = np.sqrt(2 * BEAM * draught * sin * cos)
    assert hull.particulars.draught_m == pytest.approx(depth, rel=1e-9)
    assert hull.attitude.height_m == pytest.approx(BEAM / 2 * sin + draught * cos - depth, abs=1e-9)
    assert particulars(wetted(hull)).volume_m3 == pytest.approx(LENGTH * BEAM * draught, rel=1e-9)
    assert [remark.partition(":")[0] for remark in hull.remarks] == ["the bottom is partly out of the water"]


@pytest.mark.parametrize(("heel_deg", "trim_deg"), [(12.0, 0.0), (0.0, 2.0), (-7.0, 1.5)])
def test_the_panels_of_a_listed_and_trimmed_vessel_keep_its_displacement(heel_deg, trim_deg):
    hull = standing(VESSEL, 300, heel_deg, trim_deg)
    volume = hull.upright.particulars.volume_m3
    assert hull.particulars.volume_m3 == pytest.approx(volume, rel=1e-9)
    # Another part of what the panels' chords cut off: 2e-4 measured at 12 deg.
    assert particulars(wetted(hull)).volume_m3 == pytest.approx(volume, rel=5e-4)
    assert hull.upright.panel_count <= hull.panel_count < 1.1 * hull.upright.panel_count


def test_planes_of_symmetry_lost_by_heel_or_trim_are_not_used():
    assert standing(BARGE, 80, 5).reflections == (0,)
    assert standing(BARGE, 80, 0, 3).reflections == (1,)
    assert standing(BARGE, 80, 3, 3).reflections == ()
    assert standing(VESSEL, 300, 12).reflections == ()
    assert standing(VESSEL, 300, 0, 2).reflections == (1,)


def test_a_mesh_file_gets_the_attitude_of_the_parametric_hull_of_the_same_shape(tmp_path):
    meshio = pytest.importorskip("meshio")
    upright = parametric(parse_shape(BARGE), BARGE, 100).hull
    path = tmp_path / "barge.stl"
    meshio.write(path, meshio.Mesh(upright.vertices_m, [("triangle", upright.triangles)]))
    file = HullFile(path)
    found = inclined.of_file(file, file.meshes(200), 200, from_degrees(5, 0))
    expected = standing(BARGE, 200, 5)
    assert found.reflections == expected.reflections == (0,)
    # Single precision of the file's points.
    assert found.attitude.height_m == pytest.approx(0, abs=1e-5)
    np.testing.assert_allclose(
        found.particulars.centre_of_buoyancy_m, expected.particulars.centre_of_buoyancy_m, atol=1e-4
    )
    assert len(found.upright.hull.triangles) == len(upright.triangles)


def test_a_mesh_that_ends_at_the_water_line_cannot_be_inclined(tmp_path):
    meshio = pytest.importorskip("meshio")
    closed = parametric(parse_shape(BARGE), BARGE, 100).hull
    part = Surface(closed.vertices_m, closed.triangles).below()
    path = tmp_path / "open.stl"
    meshio.write(path, meshio.Mesh(part.vertices, [("triangle", part.triangles)]))
    file = HullFile(path)
    with pytest.raises(HydrodynamicsError, match=r"open.stl: hull: found a mesh that ends at the water line"):
        inclined.of_file(file, file.meshes(100), 100, from_degrees(5, 0))


def coefficients(hull: HullMeshes, omega: tuple[float, ...], directions: int) -> solve.Coefficients:
    pytest.importorskip("capytaine")
    return solve.solve(hull, Water(), np.array(omega), directions, with_lid=False)


@pytest.mark.thorough
def test_a_listed_sphere_has_the_coefficients_of_the_upright_one():
    """Source: symmetry. Panels that are turned and cut at the water are others: with 200, added mass differs
    by 0.9 %, damping by 2.6 %, excitation by 1.3 %, with 400 by half of that; limits are twice that."""
    upright, listed = (coefficients(standing(SPHERE, 200, heel), (0.8, 1.4), 4) for heel in (0, 20))
    for name, limit in (("added_mass", 0.02), ("radiation_damping", 0.05)):
        one, other = (np.diagonal(getattr(found, name), 0, 1, 2)[:, :3] for found in (upright, listed))
        np.testing.assert_allclose(other, one, rtol=limit, err_msg=name)
    force = [abs(found.froude_krylov + found.diffraction)[:, 0, [0, 2]] for found in (upright, listed)]
    np.testing.assert_allclose(force[1], force[0], rtol=0.026)


@pytest.fixture(scope="module")
def listed_barges() -> tuple[solve.Coefficients, solve.Coefficients]:
    return tuple(coefficients(standing(BARGE, 200, heel), (0.3, 1.2), 8) for heel in (5, -5))


@pytest.mark.thorough
def test_lists_to_port_and_to_starboard_are_mirror_images(listed_barges):
    starboard, port = listed_barges
    signs = SIGNS[1]
    for name in ("added_mass", "radiation_damping"):
        one, other = getattr(starboard, name), getattr(port, name)
        size = np.sqrt(np.diagonal(one, axis1=1, axis2=2).max(axis=0))
        # Capytaine's integral over a panel changes in the fourth digit with the order of its corners.
        np.testing.assert_allclose(
            other * np.outer(signs, signs) / np.outer(size, size), one / np.outer(size, size), atol=2e-3
        )
        # Sway and heave are coupled, which they are not upright.
        assert (np.abs(one[:, 1, 2]) > 1e-3 * one[:, 2, 2]).all()
    one, other = (found.froude_krylov + found.diffraction for found in listed_barges)
    back = -np.arange(8) % 8
    largest = np.abs(one).max(axis=(0, 1))
    np.testing.assert_allclose(other[:, back] * signs / largest, one / largest, atol=2e-3)


@pytest.mark.thorough
def test_a_listed_box_keeps_its_fore_and_aft_symmetry(listed_barges):
    """Head seas give no Froude-Krylov sway, whatever the hull's section: Int dp/dy dV = 0. In long waves the
    water that rises and falls by -w^2 a gives that of the coupling of heave and sway (G. I. Taylor)."""
    found, _ = listed_barges
    excitation = found.froude_krylov + found.diffraction
    abeam = excitation[:, 2]
    np.testing.assert_array_equal(abeam[:, [0, 4, 5]], 0)
    heave = np.abs(excitation[:, 0, 2])
    assert (np.abs(found.froude_krylov[:, 0, 1]) < 1e-4 * heave).all()
    omega = 0.3
    coupling = -(omega**2) * found.added_mass[0, 1, 2] - 1j * omega * found.radiation_damping[0, 1, 2]
    # Its wave number k = 0.0092 / m makes it smaller by k L / 2 = 9 % at the ends.
    assert excitation[0, 0, 1] == pytest.approx(coupling, rel=0.05)


def small_database(hull: HullMeshes, loading: Loading | None = None):
    pytest.importorskip("capytaine")
    return build.build(hull, Water(), "listed", np.array([0.6, 1.0]), 8, loading=loading)


def test_a_database_stores_the_upright_hull_and_its_attitude(tmp_path):
    hull = standing(BARGE, 200, 5)
    made = small_database(hull)
    target = database_file.write(made, tmp_path / "listed.hydro.json")
    found = database_file.read(target)
    assert vars(found.hull.attitude) == pytest.approx(vars(hull.attitude), rel=1e-6, abs=1e-12)
    upright = build.database_hull(upright_hull(BARGE, 200))
    tree = json.loads(target.read_text())["hull"]
    assert tree.pop("attitude").keys() == {"roll_rad", "pitch_rad", "height_m"}
    assert tree == database_file.to_tree(replace(made, hull=upright))["hull"]
    assert (
        "heel 5 deg to starboard, no trim, its origin on the water, at the upright hull's displacement"
        in found.provenance.notes
    )
    attributes = to_dataset(found).attrs
    assert attributes["roll_rad"] == pytest.approx(np.radians(5))
    assert to_dataset(found).added_mass.attrs["frame"].startswith("level")


@pytest.mark.parametrize("name", ["barge", "sphere", "offshore_vessel"])
def test_a_file_without_attitude_is_rewritten_unchanged(name, tmp_path):
    source = GALLERY / f"{name}.hydro.json"
    target = database_file.write(database_file.read(source), tmp_path / source.name)
    assert target.read_bytes() == source.read_bytes()


@pytest.mark.parametrize(
    ("attitude", "message"),
    [
        (
            {"roll_rad": 2, "pitch_rad": 0, "height_m": 0},
            "hull.attitude.roll_rad: found 2, allowed: an angle",
        ),
        ({"roll_rad": 0, "pitch_rad": 0}, "hull.attitude.height_m: found nothing"),
        ({"roll_rad": 0, "pitch_rad": "x", "height_m": 0}, "hull.attitude.pitch_rad: found 'x'"),
        ([], r"hull.attitude: found \[\], allowed: an object"),
    ],
)
def test_a_wrong_attitude_in_a_file_is_named(attitude, message):
    tree = json.loads((GALLERY / "barge.hydro.json").read_text())
    tree["hull"]["attitude"] = attitude
    with pytest.raises(HydrodynamicsError, match=message):
        database_file.from_tree(tree)


@pytest.mark.thorough
def test_frequencies_solved_for_one_attitude_are_not_reused_for_another(tmp_path):
    pytest.importorskip("capytaine")
    path, omega = tmp_path / "x.partial.npz", np.array([0.8])
    opened = []

    class Watched(Partial):
        def open(self, settings: str) -> int:
            opened.append(super().open(settings))
            return opened[-1]

    for heel in (5, 5, -5, 6, 0):
        solve.solve(standing(BARGE, 80, heel), Water(), omega, 4, with_lid=False, partial=Watched(path))
    assert opened == [0, 2, 0, 0, 0]


@pytest.mark.thorough
def test_a_listed_sphere_with_equal_loading_drifts_as_the_upright_one():
    """Source: symmetry. The centre of gravity is 2 m under the water, under the middle, in both."""
    heel, radii = 20.0, (3.0, 3.0, 3.0)
    depths = (2.0, 2.0 * np.cos(np.radians(heel)))
    upright, listed = (
        small_database(standing(SPHERE, 200, angle), Loading(5.0 - depth, *radii))
        for angle, depth in zip((0.0, heel), depths, strict=True)
    )
    largest = np.abs(upright.mean_drift[..., :2]).max()
    # Measured 4.8 % at 200 panels, 7.2 % at 100.
    np.testing.assert_allclose(listed.mean_drift[..., :2], upright.mean_drift[..., :2], atol=0.1 * largest)


def test_a_loading_that_would_capsize_a_listed_hull_is_refused():
    with pytest.raises(HydrodynamicsError, match=r"--loading kg_m: found 6, .* so that the hull stays as it"):
        small_database(standing(BARGE, 80, 5), Loading(6.0, 3.0, 6.0, 6.0))


def test_the_attitude_by_a_scenario_equals_the_one_printed_by_check():
    scenario = kingpost.load("barge", {"forces.water.hydrodynamics.hydrostatics": "mesh"})
    (afloat,) = scenario.hydrostatics["hulls"]
    upright = upright_hull(BARGE, 80)
    asked = attitude_command.of_scenario(scenario, upright.particulars)
    assert (asked.roll_rad, asked.pitch_rad) == (afloat["heel_rad"], afloat["trim_rad"])
    assert asked.remarks == ()
    hull = inclined.of_shape(parse_shape(BARGE), upright, 80, asked)
    assert hull.particulars.volume_m3 == pytest.approx(afloat["displacement_m3"], rel=1e-6)
    keel = placed(np.array([0.0, 0.0, -DRAUGHT]), hull.attitude)
    assert -keel[2] == pytest.approx(afloat["draught_m"], rel=1e-9)
    assert hull.attitude_source == "as ship floats in barge.yaml"


def test_a_scenario_of_another_hull_is_refused_with_both_sizes():
    with pytest.raises(HydrodynamicsError, match=r"offshore_vessel.yaml with hull, 80 x 18 m .* 20 x 10 m"):
        attitude_command.of_scenario(kingpost.load("offshore_vessel"), upright_hull(BARGE, 80).particulars)


def test_a_scenario_without_a_hull_afloat_is_refused():
    with pytest.raises(HydrodynamicsError, match=r"paper.yaml with no hull that floats, allowed: a scenario"):
        attitude_command.of_scenario(kingpost.load("paper"), upright_hull(BARGE, 80).particulars)


def test_a_hull_with_another_displacement_than_in_its_scenario_is_refused():
    asked = Inclination(0.1, 0.0, 0.0, "as ship floats in x.yaml", 500.0)
    with pytest.raises(HydrodynamicsError, match=r"found a hull that displaces 500 m3 as ship floats in x"):
        inclined.of_shape(parse_shape(BARGE), upright_hull(BARGE, 80), 80, asked)


def test_the_summary_contains_the_upright_hull_and_its_attitude():
    shown = summary(standing(BARGE, 100, -5), Water()).splitlines()
    assert "draught             2 m" in shown
    assert "attitude            heel 5 deg to port, no trim, its origin on the water" in shown
    assert "  wetted volume     400 m3, +0.00% of the upright hull's" in shown
    assert shown[-1].endswith("planes of symmetry: x = 0")


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ([BARGE, "--heel-deg", "200"], "--heel-deg: found 200, allowed: an angle between -90 and 90 deg"),
        ([BARGE, "--trim-deg", "nan"], "--trim-deg: found nan, allowed: an angle between -90 and 90 deg"),
        ([BARGE, "--heel-deg", "inf"], "--heel-deg: found inf"),
        ([BARGE, "--heel-deg", "5", "--attitude-of", "barge"], "--heel-deg: found --attitude-of, too"),
        ([BARGE, "--attitude-of", "none.yaml"], "none.yaml: no such file"),
        (["x.hst", "--heel-deg", "5"], "--heel-deg: found x.hst, allowed: a hull that is computed"),
    ],
)
def test_a_wrong_attitude_gives_one_error_line_and_no_file(tmp_path, capsys, monkeypatch, words, message):
    monkeypatch.chdir(tmp_path)
    status = cli.main(["hydro", *words, "-o", "hull.hydro.json"])
    assert status == cli.WRONG_INPUT
    shown = capsys.readouterr().err
    assert shown.startswith(f"error: {message}")
    assert shown.count("\n") == 1
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("heel_deg", [None, 0.0])
def test_a_hull_with_zero_heel_is_the_upright_one(heel_deg):
    options = argparse.Namespace(heel_deg=heel_deg, trim_deg=None, attitude_of=None)
    assert attitude_command.parse(options, upright_hull(BARGE, 80).particulars) is None


def test_the_command_writes_the_database_of_a_listed_hull(tmp_path, capsys):
    pytest.importorskip("capytaine")
    target = tmp_path / "listed.hydro.json"
    words = ["--panels", "60", "--directions", "4", "--frequencies-rad-s", "0.5:2.2:12", "--accept-fit"]
    assert cli.main(["hydro", SPHERE, "-o", str(target), *words, "--heel-deg=-4.7"]) == 0
    assert "attitude            heel 4.7 deg to port, no trim" in capsys.readouterr().out
    hull = database_file.read(target).hull
    assert hull.attitude == Attitude(pytest.approx(np.radians(-4.7)), 0.0, pytest.approx(0.0, abs=1e-9))
    assert hull.volume_m3 == pytest.approx(2 / 3 * np.pi * 5**3, rel=2e-4)
