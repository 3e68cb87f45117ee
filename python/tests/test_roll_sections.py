"""Sections of hulls: cut from meshes, read from tables, and Lewis forms of them."""

import math

import numpy as np
import pytest
from kingpost.errors import RollDampingError
from kingpost.gallery import folder
from kingpost.hydro.surface import Surface
from kingpost.roll_damping import Sections, sections_of
from kingpost.roll_damping.cutting import cut
from kingpost.roll_damping.lewis import lewis_forms
from roll_samples import box_sections, lewis_hull

TABLE = "x_m,beam_m,draught_m,area_coefficient\n0,10,4,0.9\n10,12,4,0.95\n30,8,3,0.8\n"


def test_a_sphere_is_cut_into_half_circles():
    radius = 5.0
    found = sections_of(f"sphere:radius_m={radius:g}", stations=20)
    circle = np.sqrt(radius**2 - found.x_m**2)
    # Chords of a mesh of 6000 panels, 0.03 rad apart: of second order, 1e-3 where the sphere is cut steeply.
    np.testing.assert_allclose(found.area_m2, math.pi / 2 * circle**2, rtol=3e-3)
    np.testing.assert_allclose(found.beam_m, 2 * circle, rtol=3e-3)
    np.testing.assert_allclose(found.draught_m, circle, rtol=3e-3)


def test_the_volume_of_the_sections_is_that_of_the_mesh():
    found = sections_of(folder() / "hydro" / "offshore_vessel.hydro.json", stations=200)
    # 80 x 18 x 5.5 m, block coefficient 0.68; the midpoint rule over 200 stations, to its ends.
    assert found.volume_m3 == pytest.approx(0.68 * 80 * 18 * 5.5, rel=2e-3)
    assert found.beam_m.max() == pytest.approx(18, rel=1e-3)
    assert found.draught_m.max() == pytest.approx(5.5, rel=1e-12)


def test_a_cut_does_not_depend_on_where_the_corners_of_the_mesh_lie():
    # A tetrahedron with its apex down: the section at x is a triangle whose sides go with the distance from
    # the end.
    corners = np.array([[0, -1, 0], [0, 1, 0], [3, 0, 0], [0, 0, -2.0]])
    hull = Surface(corners, np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]))
    found = cut(hull, 3)
    share = 1 - found.x_m / 3
    np.testing.assert_allclose(found.area_m2, 2 * share**2, rtol=1e-12)
    np.testing.assert_allclose(found.beam_m, 2 * share, rtol=1e-12)


def test_a_mesh_file_gives_the_sections_of_its_draught(tmp_path):
    meshio = pytest.importorskip("meshio")
    from kingpost.hydro.meshes import parametric
    from kingpost.hydro.shapes import Box

    mesh = parametric(Box(20, 10, 2, 5), "box", 200).hull
    path = tmp_path / "box.stl"
    meshio.write(path, meshio.Mesh(mesh.vertices_m, [("triangle", mesh.triangles)]))
    found = sections_of(path, draught_m=3, stations=5)
    np.testing.assert_allclose(found.area_m2, 30, rtol=1e-6)
    assert found.volume_m3 == pytest.approx(600, rel=1e-6)


def test_lewis_forms_keep_beam_draught_and_area():
    beam, draught, sigma = np.array([10.0, 4.0, 20.0]), np.array([4.0, 6.0, 5.0]), np.array([0.9, 0.7, 0.98])
    forms = lewis_forms(beam, draught, sigma)
    psi = np.linspace(0, math.pi / 2, 20001)[:, None]
    y, z = forms.points(psi)
    np.testing.assert_allclose(2 * y[-1], beam, rtol=1e-12)
    np.testing.assert_allclose(-z[0], draught, rtol=1e-12)
    # Trapezoidal rule over 2e4 pieces: 1e-9.
    np.testing.assert_allclose(2 * np.trapezoid(y, z, axis=0), sigma * beam * draught, rtol=1e-8)


def test_a_table_is_read_with_its_remarks_and_in_any_order(tmp_path):
    path = tmp_path / "hull.csv"
    first, *rows = TABLE.splitlines()
    path.write_text("# a hull\n" + "\n".join([first, *reversed(rows)]) + "\n")
    found = Sections.read(path)
    assert found.x_m.tolist() == [0, 10, 30]
    # The trapezoidal rule.
    areas = np.array([0.9 * 40, 0.95 * 48, 0.8 * 24])
    assert found.volume_m3 == pytest.approx(np.trapezoid(areas, [0, 10, 30]), rel=1e-12)


def test_a_hull_of_lewis_forms_has_the_displacement_of_its_sections():
    sections = box_sections(area_coefficient=0.9)
    found = lewis_hull(sections, 21, 15).particulars
    # Chords of 14 pieces along the half girth.
    assert found.volume_m3 == pytest.approx(sections.volume_m3, rel=1e-2)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (("0.95", "nan"), "area_coefficient: found nan, allowed: finite numbers"),
        (("12,", "-12,"), "beam_m: found -12, allowed: numbers greater than 0"),
        (("0.95", "1.2"), "area_m2: found 1.2 times beam times draught"),
        (("10,12", "0,12"), "x_m: found 0 twice"),
        (("12,", "wide,"), "row 2 after the names: found 10,wide,4,0.95, allowed: 4 numbers"),
        (("10,12,4,0.95\n30,8,3,0.8\n", ""), "sections: found 1, allowed: 3 or more"),
        (("beam_m", "breadth"), "columns: found x_m, breadth, draught_m, area_coefficient, allowed"),
        (("12,4,0.95", "12,4"), "allowed: 4 numbers"),
        ((TABLE, ""), "an empty file"),
    ],
)  # fmt: skip
def test_a_wrong_table_is_refused_by_name(change, words, tmp_path):
    path = tmp_path / "hull.csv"
    path.write_text(TABLE.replace(*change))
    with pytest.raises(RollDampingError) as refused:
        Sections.read(path)
    assert words in str(refused.value)
    assert refused.value.file == str(path)


@pytest.mark.parametrize(
    ("hull", "options", "words"),
    [
        ("ship.xyz", {}, "no such file"),
        (
            "box:length_m=20,beam_m=10,draught_m=2,depth_m=5",
            {"draught_m": 3},
            "other hulls have their own draught",
        ),
        (
            "box:length_m=20,beam_m=10,draught_m=2,depth_m=5",
            {"stations": 2},
            "stations: found 2, allowed: 3 or more",
        ),
        ("missing.csv", {}, "No such file"),
    ],
)
def test_an_impossible_hull_is_refused(hull, options, words):
    with pytest.raises(RollDampingError, match=words):
        sections_of(hull, **options)
