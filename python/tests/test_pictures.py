"""Pictures without a browser: faces, depth, water, the camera, and what they are drawn from."""

from __future__ import annotations

import re
from pathlib import Path

import kingpost
import numpy as np
import pytest
from kingpost import gallery
from kingpost.pictures import Drawing, picture
from kingpost.pictures.backdrop import Backdrop, Surroundings
from kingpost.pictures.camera import fitted
from kingpost.pictures.faces import Faces, ball, below, cuboid, joined, painted, round_bar
from kingpost.pictures.paint import paint
from kingpost.pictures.palette import HEX, colour
from kingpost.pictures.raster import Raster
from kingpost.pictures.solids import solid_of
from lanes import sampled
from matplotlib.image import imread

ROOT = Path(__file__).resolve().parents[2]
SMALL_PX = (160, 90)
GREY = (0.5, 0.5, 0.5)


def volume(faces: Faces) -> float:
    """Volume within closed faces, by the divergence theorem: negative if they are inside out."""
    a, b, c = np.moveaxis(faces.corners, 1, 0)
    return float(np.einsum("fi,fi->", a, np.cross(b, c)) / 6)


def area(corners: np.ndarray) -> float:
    return float(
        np.linalg.norm(np.cross(*np.moveaxis(corners[:, 1:] - corners[:, :1], 1, 0)), axis=1).sum() / 2
    )


@pytest.mark.parametrize("axis", ["x", "y", "z"])
def test_a_round_bar_is_closed_and_faces_outwards_along_every_axis(axis: str) -> None:
    """Source: the volume of the prism on a regular polygon of 24 sides."""
    bar = round_bar(0.5, 7.0, axis, GREY)
    assert volume(bar) == pytest.approx(12 * 0.25 * np.sin(np.pi / 12) * 7.0, rel=1e-12)
    assert np.ptp(bar.corners[..., "xyz".index(axis)]) == 7.0


def test_boxes_balls_and_bowed_hulls_face_outwards() -> None:
    """Source: volumes; a ball of flat faces is inside the sphere, a bowed hull inside its box."""
    assert volume(cuboid((2, 3, 4), GREY)) == pytest.approx(24.0, rel=1e-12)
    assert 0.96 < volume(ball(1.0, GREY)) / (4 / 3 * np.pi) < 1.0
    model = kingpost.load("knuckle_boom_crane").model
    hull = solid_of(model["bodies"][0], model, None)
    low, high = hull.box
    assert 0.8 < volume(hull) / np.prod(high - low) < 1.0


def test_a_cut_of_faces_keeps_their_area() -> None:
    """Source: the parts below and above a height are the whole."""
    faces = ball(1.0, GREY).corners
    parts = below(faces, 0.3), below(faces, 0.3, -1.0)
    assert sum(map(area, parts)) == pytest.approx(area(faces), rel=1e-12)
    assert parts[0][..., 2].max() <= 0.3 <= parts[1][..., 2].min() + 1e-12


def test_a_triangle_covers_the_samples_within_it() -> None:
    """Source: the definition, a sample counts if its middle is inside."""
    corners = np.array([[3.2, 2.1, 0.5], [27.7, 8.4, 0.5], [9.3, 29.6, 0.5]])
    raster = Raster(32, 32)
    raster.add(corners[None], np.array([GREY]))
    y, x = np.mgrid[0.5:32, 0.5:32]
    turns = [
        (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])
        for a, b in zip(corners, np.roll(corners, -1, axis=0), strict=True)
    ]
    assert np.array_equal(raster.nearness > 0, np.min(turns, axis=0) > 0)


def test_the_nearer_face_is_seen_in_any_order_and_crossing_faces_cut_each_other() -> None:
    """Source: two planes whose depths are equal at the middle of the picture."""
    rising = np.array(
        [[[0, 0, 0.1], [64, 0, 0.9], [0, 64, 0.1]], [[64, 0, 0.9], [64, 64, 0.9], [0, 64, 0.1]]]
    )
    falling = rising * [1, 1, 0] + (1 - rising) * [0, 0, 1]
    paints = np.array([[1.0, 0, 0]] * 2), np.array([[0, 0, 1.0]] * 2)
    for order in (0, 1), (1, 0):
        raster = Raster(64, 64)
        for k in order:
            raster.add((rising, falling)[k], paints[k])
        assert (raster.colours[:, :32] == [0, 0, 1]).all()
        assert (raster.colours[:, 32:] == [1, 0, 0]).all()


def test_a_wall_meets_the_water_at_height_0() -> None:
    """Source: the projection of the water line; above it the whole paint, below it the water on it."""
    wall = painted(
        np.array([[[-4, 0, -4], [4, 0, -4], [4, 0, 4]], [[-4, 0, -4], [4, 0, 4], [-4, 0, 4]]], float), GREY
    )
    camera = fitted(wall.corners.reshape(-1, 3), (0, -1, 0.3), 1.0)
    around = Surroundings(True, False, 0.0, 10.0, 8.0)
    drawn = paint(wall, [], camera, Backdrop(camera, around, (200, 200)))[:, 100].astype(int)
    row = (1 - camera.seen(np.zeros(3))[1]) * 100
    is_grey = np.ptp(drawn, axis=1) == 0
    rows = np.flatnonzero(is_grey)
    assert abs(rows.max() + 1 - row) <= 1.0
    assert (np.diff(rows) == 1).all()
    wet = drawn[rows.max() + 3 : rows.max() + 60]
    # The deeper, the bluer.
    assert (np.diff(wet[:, 2] - wet[:, 0]) >= -1).all()
    assert wet[-1, 2] - wet[-1, 0] > wet[0, 2] - wet[0, 0]


@pytest.mark.parametrize(
    "name", sampled(gallery.names(), keep=["paper", "slew_and_land", "underwater_vehicle"])
)
def test_the_whole_subject_is_in_the_picture(name: str) -> None:
    drawing = Drawing(kingpost.Simulation(name), size_px=SMALL_PX)
    drawn = drawing.picture().astype(int)
    corners = drawing._scene.corners_m(drawing.simulation.poses())
    assert drawing._camera is not None
    assert drawing._camera.holds(corners)
    # It fills the picture in one direction at least, and differs from an empty one.
    assert np.abs(drawing._camera.seen(corners)[..., :2]).max() > 0.85
    assert drawing._backdrop is not None
    empty = (drawing._backdrop.light * 255 + 0.5).astype(int)
    assert (np.abs(drawn - empty).max(axis=2) > 8).mean() > 0.005


def test_a_camera_steps_back_when_a_body_leaves_and_never_comes_nearer() -> None:
    simulation = kingpost.Simulation("loss_of_hook_load")
    drawing = Drawing(simulation, size_px=SMALL_PX)
    away = []
    for _ in range(4):
        drawing.picture()
        away.append(float(np.linalg.norm(drawing._camera.eye_m)))
        simulation.step(300)
    assert away == sorted(away)


def test_eye_and_target_are_relative_to_the_first_body() -> None:
    """Source: the target is in the middle of the picture."""
    simulation = kingpost.Simulation("offshore_vessel")
    place = simulation.poses()[0, :3]
    drawing = Drawing(simulation, (30, -40, 25, 5, 2, 10), SMALL_PX)
    drawing.picture()
    camera = drawing._placed(simulation.poses(), place[None])
    assert np.allclose(camera.eye_m - place, [30, -40, 25])
    assert np.allclose(camera.seen(place + np.array([5, 2, 10]))[:2], 0, atol=1e-12)


def test_a_run_is_drawn_at_its_records_as_the_simulation_was() -> None:
    """Source: the simulation, stepped to the same time."""
    run = kingpost.run("offshore_vessel", {"simulation.duration_s": 4.0})
    simulation = kingpost.Simulation(kingpost.load("offshore_vessel", {"simulation.duration_s": 4.0}))
    start = picture(run, size_px=SMALL_PX)
    assert np.array_equal(start, picture(simulation, size_px=SMALL_PX))
    simulation.step(round(3.0 / simulation.step_s))
    later = picture(run, 3.0, size_px=SMALL_PX)
    assert np.array_equal(later, picture(simulation, size_px=SMALL_PX))
    assert not np.array_equal(start, later)


def test_a_file_has_the_pixels_of_the_picture(tmp_path: Path) -> None:
    path = tmp_path / "paper.png"
    drawn = picture("paper", 1.5, size_px=SMALL_PX, path=path)
    assert np.array_equal((imread(path)[..., :3] * 255).round().astype(np.uint8), drawn)


def test_a_run_with_levers_set_by_hand_is_refused() -> None:
    scenario = kingpost.load("lowering_by_winch", {"simulation.duration_s": 3.0})
    simulation = kingpost.Simulation(scenario)
    simulation.set_input("hoist", -100.0)
    run = simulation.run()
    assert picture(run, size_px=SMALL_PX).shape == (90, 160, 3)
    with pytest.raises(kingpost.KingpostError, match=r"found a body .* m from its place in the run"):
        picture(run, 3.0, size_px=SMALL_PX)


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"time_s": 3.1}, "time_s: found 3.1, allowed: 0 to 3"),
        ({"time_s": float("nan")}, "time_s: found nan"),
        ({"camera": "above"}, "camera: found 'above', allowed: free, load, side, top, a direction"),
        ({"camera": (0, 0, 1)}, r"camera: found \(0, 0, 1\), allowed: .* none vertical"),
        ({"camera": (1, 2)}, r"camera: found \(1, 2\)"),
        ({"camera": (1, 2, 3, 1, 2, 0)}, r"camera: found \(1, 2, 3, 1, 2, 0\), allowed: .* none vertical"),
        ({"size_px": (0, 90)}, r"size_px: found \(0, 90\), allowed: width and height, 1 to 8192"),
        ({"size_px": 90}, "size_px: found 90"),
        ({"path": "still.jpg"}, "still.jpg: unknown ending, allowed: .png"),
    ],
)
def test_wrong_arguments_are_refused_with_what_is_allowed(given: dict, message: str) -> None:
    with pytest.raises(kingpost.KingpostError, match=message):
        picture("paper", **given)


def test_other_objects_are_refused() -> None:
    with pytest.raises(kingpost.KingpostError, match="picture: found int, allowed: a scenario"):
        picture(3)
    batch = kingpost.Batch("paper", {"crane_x_m": [0, 1]}, {"simulation.duration_s": 0.1}).run()
    with pytest.raises(kingpost.KingpostError, match="picture: found no single run"):
        picture(batch)
    with pytest.raises(kingpost.KingpostError, match=r"time_s: found 1\.0 for a simulation"):
        picture(kingpost.Simulation("paper"), 1.0)


def test_colours_are_those_of_the_apps_light_theme() -> None:
    text = (ROOT / "web" / "src" / "styles" / "theme.css").read_text(encoding="utf-8")
    # The light theme is the first in the file.
    light = dict(reversed(re.findall(r"--([\w-]+): (#\w{6});", text)))
    assert {name: light[name if name.startswith("sky") else f"scene-{name}"] for name in HEX} == HEX
    assert np.allclose(colour("load"), np.array([0xEF, 0xA1, 0x2D]) / 255)


def test_a_picture_of_many_faces_equals_that_of_each_alone() -> None:
    """Source: faces that do not cover each other."""
    solids = [cuboid((1, 1, 1), GREY).moved((3.0 * k, 0, 0)) for k in range(3)]
    every = joined(solids)
    camera = fitted(every.corners.reshape(-1, 3), (0, -1, 0.2), 16 / 9)
    backdrop = Backdrop(camera, Surroundings(False, False, -1.0, 8.0, 1.0), SMALL_PX)
    together = paint(every, [], camera, backdrop).astype(int)
    empty = (backdrop.light * 255 + 0.5).astype(int)
    alone = sum(paint(one, [], camera, backdrop).astype(int) - empty for one in solids)
    assert np.array_equal(together, empty + alone)
