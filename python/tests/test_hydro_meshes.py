"""Meshes of hulls: closed forms of their particulars, and refused files."""

import itertools

import numpy as np
import pytest
from kingpost import cli
from kingpost.errors import HydrodynamicsError
from kingpost.hydro import hull_files, surface
from kingpost.hydro.database import Water
from kingpost.hydro.hull_files import HullFile
from kingpost.hydro.hull_options import parse_frequencies, parse_shape
from kingpost.hydro.meshes import HULL_TRIANGLES, parametric, whole
from kingpost.hydro.panels import lid
from kingpost.hydro.shapes import Box, Hemisphere, Sphere, Wigley
from kingpost.hydro.stitching import stitched
from kingpost.hydro.summary import summary
from kingpost.hydro.surface import Surface
from kingpost.hydro.vessel import OffshoreVessel

meshio = pytest.importorskip("meshio")

BARGE = Box(length_m=20, beam_m=10, draught_m=2, depth_m=5)
SHAPES = [
    BARGE,
    Wigley(length_m=10, beam_m=1, draught_m=0.625, depth_m=1),
    Sphere(radius_m=5),
    Hemisphere(radius_m=5, depth_m=7),
    OffshoreVessel(length_m=80, beam_m=18, draught_m=5.5, depth_m=8, block_coefficient=0.68),
]
WHOLE_BARGE = parametric(BARGE, "barge", 100).hull


def named(shape: object) -> str:
    return type(shape).__name__


def barge_surface() -> Surface:
    return Surface(WHOLE_BARGE.vertices_m, WHOLE_BARGE.triangles)


def moved(hull: Surface, x: float, z: float) -> Surface:
    return Surface(hull.vertices + np.array([x, 0, z]), hull.triangles)


def written(tmp_path, hull: Surface, name: str = "hull.stl"):
    path = tmp_path / name
    meshio.write(path, meshio.Mesh(hull.vertices, [("triangle", hull.triangles)]))
    return path


def test_a_box_barge_has_the_particulars_of_a_block():
    found = parametric(BARGE, "barge", 900).particulars
    assert found.volume_m3 == pytest.approx(20 * 10 * 2, rel=1e-12)
    np.testing.assert_allclose(found.centre_of_buoyancy_m, [0, 0, -1], atol=1e-12)
    assert found.waterplane.area_m2 == pytest.approx(200, rel=1e-12)
    second = found.waterplane.second_moments_m4
    np.testing.assert_allclose(second, [20**3 * 10 / 12, 0, 10**3 * 20 / 12], rtol=1e-12, atol=1e-9)
    assert second[2] / found.volume_m3 == pytest.approx(10**2 / (12 * 2), rel=1e-12)  # BM = B^2 / 12 T


def test_a_sphere_has_the_particulars_of_a_half_ball():
    found = parametric(Sphere(5), "sphere", 900).particulars
    # A grid of chords: relative error of second order in the angle between points, here 0.02 rad.
    assert found.volume_m3 == pytest.approx(2 / 3 * np.pi * 5**3, rel=2e-4)
    assert found.centre_of_buoyancy_m[2] == pytest.approx(-3 / 8 * 5, rel=2e-4)
    assert found.waterplane.area_m2 == pytest.approx(np.pi * 5**2, rel=2e-4)


def test_wigleys_hull_has_its_block_coefficient_of_four_ninths():
    found = parametric(SHAPES[1], "wigley", 900).particulars
    assert found.block_coefficient == pytest.approx(4 / 9, rel=5e-4)


@pytest.mark.parametrize("wanted", [0.62, 0.68, 0.75, 0.85])
def test_an_offshore_vessel_has_the_requested_block_coefficient(wanted):
    found = parametric(OffshoreVessel(80, 18, 5.5, 8, wanted), "vessel", 900).particulars
    assert found.block_coefficient == pytest.approx(wanted, abs=1e-3)
    assert (found.length_m, found.beam_m, found.draught_m) == pytest.approx((80, 18, 5.5), rel=1e-9)


def test_an_impossible_block_coefficient_is_refused_with_the_allowed_range():
    with pytest.raises(HydrodynamicsError, match=r"found 0.95, allowed: a number from 0\.\d+ to 0\.\d+"):
        OffshoreVessel(80, 18, 5.5, 8, 0.95)


@pytest.mark.parametrize("shape", SHAPES, ids=named)
def test_the_panels_and_the_closed_hull_displace_the_same_volume(shape):
    meshes = parametric(shape, "a hull", 600)
    closed = Surface(meshes.hull.vertices_m, meshes.hull.triangles)
    surface.check_closed(closed, None)
    assert 250 < len(closed.triangles) <= HULL_TRIANGLES
    panels = whole(meshes.panels.surface, meshes.reflections)
    for mesh in (panels, closed.below()):
        found = surface.particulars(mesh)
        assert found.volume_m3 == pytest.approx(meshes.particulars.volume_m3, rel=1e-9)
        # Chords of about thirty stations: 2 percent at most, of a circle's area.
        assert found.waterplane.area_m2 == pytest.approx(meshes.particulars.waterplane.area_m2, rel=0.02)


@pytest.mark.parametrize("shape", SHAPES, ids=named)
def test_the_lid_covers_the_waterplane_of_the_panels(shape):
    meshes = parametric(shape, "a hull", 600)
    cover = lid(meshes.panels, meshes.panel_size_m).surface
    waterplane = surface.particulars(whole(meshes.panels.surface, meshes.reflections)).waterplane
    # Stations between which the water line curves leave slivers.
    assert cover.area * 2 ** len(meshes.reflections) == pytest.approx(waterplane.area_m2, rel=0.02)
    np.testing.assert_array_equal(cover.vertices[:, 2], 0)
    assert (cover.area_vectors[:, 2] < 0).all() or (cover.area_vectors[:, 2] > 0).all()


@pytest.mark.parametrize("ending", ["stl", "obj", "ply"])
def test_a_barge_from_a_file_is_the_parametric_barge(tmp_path, ending):
    lifted = barge_surface()
    keel_at_zero = moved(lifted, 0, 2)
    path = written(tmp_path, keel_at_zero, f"hull.{ending}")
    meshes = HullFile(path, draught_m=2).meshes(200)
    assert meshes.particulars.volume_m3 == pytest.approx(400, rel=1e-5)
    assert meshes.particulars.waterplane.area_m2 == pytest.approx(200, rel=1e-5)
    assert meshes.panel_count >= 200
    assert len(meshes.hull.triangles) == len(lifted.triangles)


def test_a_symmetric_mesh_is_solved_in_part_and_an_asymmetric_one_whole(tmp_path):
    barge = barge_surface()
    meshes = HullFile(written(tmp_path, barge)).meshes(200)
    assert meshes.reflections == (0, 1)
    assert HullFile(written(tmp_path, moved(barge, 1, 0))).meshes(200).reflections == (1,)
    turned = Surface(barge.vertices[:, [1, 0, 2]] * [1, -1, 1] + [1.0, 0.5, 0], barge.triangles)
    meshes = HullFile(written(tmp_path, turned)).meshes(200)
    assert meshes.reflections == ()
    np.testing.assert_allclose(meshes.particulars.centre_of_buoyancy_m, [1, 0.5, -1], atol=1e-5)


def test_panels_of_a_coarse_file_are_cut_to_size(tmp_path):
    corners = np.array([[x, y, z] for x in (-10, 10) for y in (-5, 5) for z in (-2, 3)], float)
    quads = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    path = tmp_path / "box.obj"
    meshio.write(path, meshio.Mesh(corners, [("quad", np.array(quads))]))
    meshes = HullFile(path).meshes(400)
    assert meshes.particulars.volume_m3 == pytest.approx(400)
    assert meshes.panel_count >= 400


GDF = """a box of WAMIT's, a quarter of its wetted part
1.0 9.80665
1 1
3
0 0 -2  0 5 -2  10 5 -2  10 0 -2
0 5 -2  0 5 0  10 5 0  10 5 -2
10 0 -2  10 5 -2  10 5 0  10 0 0
"""


def test_a_gdf_file_is_read_with_its_symmetry_and_without_a_deck(tmp_path):
    path = tmp_path / "box.gdf"
    path.write_text(GDF)
    meshes = HullFile(path).meshes(200)
    assert meshes.particulars.volume_m3 == pytest.approx(400)
    assert meshes.reflections == (0, 1)
    assert meshes.hull is None


def test_a_database_without_a_hull_mesh_gives_a_warning(tmp_path):
    """Source: the public contract: at most 2000 triangles, and a hull that is closed."""
    path = tmp_path / "box.gdf"
    path.write_text(GDF)
    open_above = HullFile(path).meshes(200)
    barge = barge_surface()
    small = HullFile(written(tmp_path, barge)).meshes(200)
    fine = barge.refined(barge.area**0.5 / 25)
    large = HullFile(written(tmp_path, fine)).meshes(200)
    assert len(fine.triangles) > 2000 >= len(barge.triangles)
    assert small.hull is not None
    assert large.hull is None
    assert "warning" not in summary(small, Water())
    words = f"warning: the database gets no hull mesh, because the mesh has {len(fine.triangles)} triangles"
    assert words in summary(large, Water())
    assert "because the mesh ends at the water line" in summary(open_above, Water())


def test_a_gdf_file_cut_short_is_refused(tmp_path):
    path = tmp_path / "box.gdf"
    for end in (5, 60, 90, len(GDF) - 20):
        path.write_text(GDF[:end])
        with pytest.raises(HydrodynamicsError, match=r"cut short|panels by the header, .* in the file"):
            hull_files.read(path)


@pytest.mark.parametrize(
    ("line", "change", "message"),
    [
        (1, "1.0 32.174", "found GRAV 32.174, a mesh that is not in metres, allowed: GRAV from 9.7 to 9.9"),
        (1, "1.0 0", "found GRAV 0, allowed: GRAV from 9.7 to 9.9"),
        (1, "1.0 nan", "found GRAV nan, allowed"),
        (2, "1 -1", "found ISY -1, a wall along that plane, allowed: ISY 0, or 1"),
        (2, "3 1", "found ISX 3, allowed: ISX 0, or 1"),
    ],
)
def test_a_gdf_file_in_feet_or_beside_a_wall_is_refused(tmp_path, line, change, message):
    """Source: WAMIT User Manual, version 7, chapter 6: GRAV has the corners' unit of length."""
    path = tmp_path / "box.gdf"
    lines = GDF.splitlines()
    lines[line] = change
    path.write_text("\n".join(lines))
    with pytest.raises(HydrodynamicsError, match=message):
        hull_files.read(path)


def test_a_gdf_file_without_symmetry_is_read_as_the_whole_hull(tmp_path):
    path = tmp_path / "box.gdf"
    lines = GDF.splitlines()
    whole = hull_files.read(_written(path, lines)).area
    lines[2] = "0 0"
    assert hull_files.read(_written(path, lines)).area == pytest.approx(whole / 4)


def _written(path, lines):
    path.write_text("\n".join(lines))
    return path


def refused(tmp_path, hull: Surface, **options: object) -> str:
    with pytest.raises(HydrodynamicsError) as caught:
        HullFile(written(tmp_path, hull), **options).meshes(200)
    return str(caught.value)


def test_a_mesh_with_a_hole_is_refused_with_the_position_of_the_hole(tmp_path):
    barge = barge_surface()
    message = refused(tmp_path, Surface(barge.vertices, barge.triangles[1:]))
    assert "found a mesh with holes: 3 open edges, one at (" in message


def test_half_a_hull_is_refused_with_advice(tmp_path):
    assert "on y = 0: mirror this half" in refused(tmp_path, barge_surface().below(0.0, 1))


def test_inward_normals_are_refused_and_reversed_on_request(tmp_path):
    barge = barge_surface()
    inward = Surface(barge.vertices, barge.triangles[:, ::-1])
    assert "found normals that point inwards" in refused(tmp_path, inward)
    path = written(tmp_path, inward)
    found = HullFile(path, flip_normals=True).meshes(200).particulars
    assert found.volume_m3 == pytest.approx(400, rel=1e-5)


def test_one_reversed_triangle_is_refused_with_its_position(tmp_path):
    barge = barge_surface()
    triangles = barge.triangles.copy()
    triangles[7] = triangles[7, ::-1]
    assert "normals that disagree across 3 edges" in refused(tmp_path, Surface(barge.vertices, triangles))


def test_a_hull_above_the_water_is_refused(tmp_path):
    barge = barge_surface()
    message = refused(tmp_path, moved(barge, 0, 4))
    assert "a hull above the water" in message
    assert "--draught-m" in message


def test_a_mesh_in_millimetres_is_refused(tmp_path):
    barge = barge_surface()
    message = refused(tmp_path, Surface(1000 * barge.vertices, barge.triangles))
    assert "a mesh of 20000 m, allowed: a mesh in metres, of 0.01 to 2000 m" in message


def test_a_hull_that_cannot_float_is_refused(tmp_path):
    assert "cannot float" in refused(tmp_path, barge_surface(), draught_m=6)
    for hull in ("box:length_m=20,beam_m=10,draught_m=5,depth_m=5", "hemisphere:radius_m=5,depth_m=4"):
        with pytest.raises(HydrodynamicsError, match="cannot float"):
            parse_shape(hull)


@pytest.mark.parametrize("content", [b"", b"solid of nothing", b"\x00\x01\x02" * 50, b"v 1 2\nf 9 8 7\n"])
@pytest.mark.parametrize("ending", ["stl", "obj", "gdf", "vtk", "xyz"])
def test_a_file_that_is_not_a_mesh_is_refused(tmp_path, content, ending):
    path = tmp_path / f"hull.{ending}"
    path.write_bytes(content)
    with pytest.raises(HydrodynamicsError):
        HullFile(path).meshes(200)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("box", "hull: found no length_m, allowed: box:length_m=..."),
        ("box:length=20", "hull.length: found an unknown dimension, allowed: box:length_m=..."),
        ("box:length_m=20,length_m=2", "hull.length_m: found given twice"),
        ("box:length_m=long", "hull.length_m: found 'long', allowed: a number"),
        (
            "box:length_m=20,beam_m=-1,draught_m=1,depth_m=2",
            "hull.beam_m: found -1, allowed: a number greater",
        ),
        ("box:length_m=nan,beam_m=1,draught_m=1,depth_m=2", "hull.length_m: found nan"),
        ("sphere:radius_m=1e9", "hull.radius_m: found 1e+09, allowed: metres, from 0.01 to 2000"),
        ("sphere:radius_m=1e-9", "hull.radius_m: found 1e-09, allowed: metres, from 0.01 to 2000"),
        ("boat:length_m=20", "hull: found 'boat', allowed: one of box, wigley, sphere"),
    ],
)
def test_a_wrong_parametric_hull_is_named(text, message):
    with pytest.raises(HydrodynamicsError) as caught:
        parse_shape(text)
    assert str(caught.value).startswith(message)


@pytest.mark.parametrize(
    "text",
    ["", "0:1:9", "1:2", "2:1:9", "a,b", "nan", "1:2:0", "1:2:1000000000", "1:inf:9", "-1:2:9", "1:2:7"],
)
def test_wrong_frequencies_are_refused(text):
    with pytest.raises(HydrodynamicsError, match="--frequencies-rad-s: found"):
        parse_frequencies(text)


def patches(gap_m: float = 0.0) -> str:
    """WAMIT's GDF of a box of 4 x 2 x 2 m open at the water: each side one panel, the bottom four; the ends
    stand off the sides by a gap."""
    x, y, g = (-2.0, 0.0, 2.0), (-1.0, 0.0, 1.0), gap_m
    panels = [
        [(a, c, -2), (a, d, -2), (b, d, -2), (b, c, -2)]
        for a, b in itertools.pairwise(x)
        for c, d in itertools.pairwise(y)
    ]
    panels += [
        [(-2, -1, 0), (-2, -1, -2), (2, -1, -2), (2, -1, 0)],
        [(2, 1, 0), (2, 1, -2), (-2, 1, -2), (-2, 1, 0)],
        [(2 + g, -1, 0), (2 + g, -1, -2), (2 + g, 1, -2), (2 + g, 1, 0)],
        [(-2 - g, 1, 0), (-2 - g, 1, -2), (-2 - g, -1, -2), (-2 - g, -1, 0)],
    ]
    rows = [" ".join(str(float(value)) for value in point) for panel in panels for point in panel]
    return "\n".join(["patches", "1 9.81", "0 0", str(len(panels)), *rows, ""])


@pytest.mark.parametrize("gap_m", [0.0, 0.02])
def test_panels_that_do_not_meet_edge_to_edge_are_joined_with_a_note(tmp_path, gap_m):
    path = tmp_path / "patches.gdf"
    path.write_text(patches(gap_m))
    meshes = HullFile(path).meshes(200)
    # The ends stand off by the gap, on a length of 4 m, at most.
    assert meshes.particulars.volume_m3 == pytest.approx(16.0, rel=2 * gap_m / 4 + 1e-12)
    assert meshes.particulars.waterplane.area_m2 == pytest.approx(8.0, rel=2 * gap_m / 4 + 1e-12)
    assert len(meshes.remarks) == 1
    assert "open edges joined, of panels that do not meet edge to edge in patches.gdf" in meshes.remarks[0]


def test_a_gap_wider_than_a_seam_stays_a_hole(tmp_path):
    path = tmp_path / "patches.gdf"
    path.write_text(patches(0.5))
    with pytest.raises(HydrodynamicsError, match=r"holes.*give panels side by side the same corners"):
        HullFile(path).meshes(200)


def plate(heights: tuple[float, ...] = (0.0, -1.0)) -> Surface:
    """4 m long, 1 m deep, 0.02 m thick, open at the water: four panels on one side, of which the first is cut
    at these heights, and five on the other."""
    quads = []
    for y, count in ((0.01, 4), (-0.01, -5)):
        x = np.linspace(-2.0, 2.0, abs(count) + 1)[:: np.sign(count)]
        for k, (at, beyond) in enumerate(itertools.pairwise(x)):
            cuts = heights if (y, k) == (0.01, 0) else (0.0, -1.0)
            quads += [[(at, y, z), (beyond, y, z), (beyond, y, low), (at, y, low)]
                      for z, low in itertools.pairwise(cuts)]  # fmt: skip
    for x, y in ((2.0, 0.01), (-2.0, -0.01)):
        quads.append([(x, y, 0), (x, -y, 0), (x, -y, -1), (x, y, -1)])
    triangles = [[quad[0], *quad[k : k + 2]] for quad in quads for k in (1, 2)]
    left, right = ([(x, y, -1) for x in np.linspace(-2.0, 2.0, n)] for y, n in ((0.01, 5), (-0.01, 6)))
    triangles += [[b, right[0], a] for a, b in itertools.pairwise(left)]
    triangles += [[a, left[-1], b] for a, b in itertools.pairwise(right)]
    corners = np.array(triangles, float).reshape(-1, 3)
    return Surface(corners, np.arange(len(corners)).reshape(-1, 3)).welded()


@pytest.mark.parametrize("lift_m", [0.0, 3.0])
def test_the_sides_of_a_thin_hull_are_not_joined_across_its_water_plane(lift_m):
    """Source: 4 m x 1 m x 0.02 m, wherever the file has its origin."""
    thin = plate()
    assert surface.particulars(thin).volume_m3 == pytest.approx(0.08, rel=1e-12)
    lifted = Surface(thin.vertices + np.array([0.0, 0.0, lift_m]), thin.triangles)
    assert len(surface.open_edges(lifted)) == 4 + 5 + 2
    assert stitched(lifted) is lifted


def test_a_seam_in_the_side_of_a_thin_hull_is_joined_and_its_water_plane_stays(tmp_path):
    seamed, path = plate((0.0, -0.5, -1.0)), tmp_path / "plate.obj"
    assert len(surface.open_edges(seamed)) == 4 + 5 + 2 + 2 * 3
    meshio.write_points_cells(path, seamed.vertices, [("triangle", seamed.triangles)])
    meshes = HullFile(path).meshes(40)
    assert meshes.particulars.volume_m3 == pytest.approx(0.08, rel=1e-12)
    assert meshes.remarks[0].startswith("6 open edges joined")


def test_a_deck_is_joined_to_the_sides_though_its_edge_is_the_highest_of_the_hull():
    """Source: a box of 4 x 2 x 2 m; two triangles of its deck meet one edge of a side."""
    x, y, z = np.moveaxis(np.array(list(itertools.product((-2.0, 2.0), (-1.0, 1.0), (-1.0, 1.0)))), 1, 0)
    corners = np.stack([x, y, z], axis=1)
    faces = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4)]
    middle = len(corners)
    triangles = [half for a, b, c, d in faces for half in ((a, b, c), (a, c, d))]
    triangles += [(1, 5, middle), (middle, 5, 7), (1, middle, 3)]
    box = Surface(np.concatenate([corners, [[0.0, 1.0, 1.0]]]), np.array(triangles))
    assert len(surface.open_edges(box)) == 3
    found = stitched(box)
    assert len(surface.open_edges(found)) == 0
    assert found.volume == pytest.approx(16.0, rel=1e-12)


@pytest.mark.parametrize("ending", ["1", "3", "4", "8", "9", "12"])
def test_a_parametric_hull_that_ends_in_a_number_is_not_taken_as_a_file(capsys, ending):
    hull = f"box:length_m=6,beam_m=4,draught_m=0.1,depth_m=0.{ending}"
    assert cli.main(["hydro", hull, "--draught-m", "1", "-o", "hull.hydro.json"]) == 2
    assert "a parametric hull has its own draught" in capsys.readouterr().err
