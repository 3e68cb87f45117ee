"""Mesh files of other programs: they are read completely, and errors are named.

Source: the same box of 20 x 8 x 3 m at a draught of 1.5 m, 240 m3, in each way of writing.
"""

from __future__ import annotations

from pathlib import Path

import pytest
from kingpost.cli import main
from kingpost.errors import HydrodynamicsError
from kingpost.hydro.hull_files import HullFile, read

CORNERS = [(x, y, z) for z in (0, 3) for y in (-4, 4) for x in (-10, 10)]
QUADS = [(1, 3, 4, 2), (5, 6, 8, 7), (1, 2, 6, 5), (3, 7, 8, 4), (1, 5, 7, 3), (2, 4, 8, 6)]


def obj(points: list[str], faces: list[str]) -> str:
    return "\n".join(["# box", "mtllib box.mtl", *points, "g hull", "usemtl steel", *faces]) + "\n"


def plain() -> list[str]:
    return [f"v {x} {y} {z}" for x, y, z in CORNERS]


def octagons() -> str:
    """The box with its vertical edges cut by 1 m: bottom and top are octagons."""
    cut = [(9, -4), (10, -3), (10, 3), (9, 4), (-9, 4), (-10, 3), (-10, -3), (-9, -4)]
    points = [f"v {x} {y} {z}" for z in (0, 3) for x, y in cut]
    sides = [f"f {k + 1} {(k + 1) % 8 + 1} {(k + 1) % 8 + 9} {k + 9}" for k in range(8)]
    return obj(points, ["f 8 7 6 5 4 3 2 1", "f 9 10 11 12 13 14 15 16", *sides])


FACES = [" ".join(["f", *map(str, quad)]) for quad in QUADS]
WITH_TEXTURE = [
    " ".join(["f", *(f"{corner}/{k % 4 + 1}/1" for k, corner in enumerate(quad))]) for quad in QUADS
]
WITH_NORMALS = [
    " ".join(["f", *(f"{corner}//{face + 1}" for corner in quad)]) for face, quad in enumerate(QUADS)
]
BACKWARDS = [" ".join(["f", *(str(corner - 9) for corner in quad)]) for quad in QUADS]
BROKEN = [face.replace(" ", " \\\n", 3) for face in FACES]


@pytest.mark.parametrize(
    "text",
    [
        obj(plain(), FACES),
        obj([*plain(), *(f"vt 0.{k} 0" for k in range(4)), "vn 0 0 1"], WITH_TEXTURE),
        obj([*plain(), *("vn 0 0 1" for _ in range(6))], WITH_NORMALS),
        obj([f"{point} 0.5 0.2 0.1" for point in plain()], FACES),
        obj(plain(), BACKWARDS),
        obj(plain(), BROKEN),
    ],
    ids=["plain", "texture", "normals", "colours", "backwards", "continued"],
)
def test_an_obj_file_is_the_same_hull_in_each_way_of_writing(text: str, tmp_path: Path) -> None:
    path = tmp_path / "box.obj"
    path.write_text(text)
    found = HullFile(path, 1.5).meshes(100).particulars
    assert (found.volume_m3, found.length_m, found.beam_m) == pytest.approx((240, 20, 8))


def test_faces_of_many_corners_are_read_whole(tmp_path: Path) -> None:
    path = tmp_path / "octagon.obj"
    path.write_text(octagons())
    found = HullFile(path, 1.5).meshes(100).particulars
    assert found.volume_m3 == pytest.approx(1.5 * (20 * 8 - 4 * 0.5))


GDF = "box\n1.0 9.80665\n0 0\n{count}\n{panels}\n"
PANELS = [" ".join(f"{x} {y} {z - 1.5}" for x, y, z in (CORNERS[k - 1] for k in quad)) for quad in QUADS]


@pytest.mark.parametrize(
    ("name", "text", "message"),
    [
        (
            "box.gdf",
            GDF.format(count=9, panels="\n".join(PANELS)),
            "found 9 panels by the header, 6 in the file",
        ),
        (
            "box.gdf",
            GDF.format(count=4, panels="\n".join(PANELS)),
            "found 4 panels by the header, 6 in the file",
        ),
        ("box.gdf", GDF.format(count="6 -11", panels="3 3"), "a high-order geometry, of patches .IGDEF -11."),
        ("hull.mar", "2 0\n", "found the format .mar, allowed: STL, OBJ, GDF"),
        ("hull", "solid\n", "found a name without an ending"),
        ("hull.obj.gz", "x", "found a packed file .*unpack it first"),
        ("hull.obj", "v 0 0\n", "hull.obj:1: hull: found a point of 2 coordinates"),
        (
            "hull.obj",
            "v 0 0 0\nf 1 2 3\n",
            "hull.obj:2: hull: found a face with a point that is not in the file",
        ),
        (
            "hull.obj",
            obj(["v 0 0 0", "v 4 0 0", "v 4 4 0", "v 3 1 0"], ["f 1 2 3 4"]),
            "a concave face of 4 corners",
        ),
    ],
)
def test_the_fault_of_a_mesh_file_is_named(name: str, text: str, message: str, tmp_path: Path) -> None:
    path = tmp_path / name
    path.write_text(text)
    with pytest.raises(HydrodynamicsError, match=message):
        read(path)


def test_the_error_names_a_hole_in_the_hull_and_not_the_open_water_plane(tmp_path: Path) -> None:
    """Source: a box without its top, which may be open, and with a hole in its bottom, which may not."""
    path = tmp_path / "open.obj"
    path.write_text(obj([f"v {x} {y} {z - 3}" for x, y, z in CORNERS], FACES[2:]))
    with pytest.raises(HydrodynamicsError, match=r"a mesh with holes: 8 open edges, one at \(.*, -3\) m"):
        HullFile(path).meshes(100)


def test_a_bow_along_y_gives_a_warning(tmp_path: Path) -> None:
    path = tmp_path / "across.obj"
    path.write_text(obj([f"v {-y} {x} {z}" for x, y, z in CORNERS], FACES))
    (remark,) = HullFile(path, 1.5).meshes(100).remarks
    assert remark.startswith("the hull is 8 m long and 20 m wide: x must point to the bow")


def test_a_mesh_of_hydrostar_is_not_confused_with_wamits_hst(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "ship.hst"
    path.write_text("PROJECT Ship\n\nSYMMETRY_BODY 1 2\n\nNBBODY 1\n")
    assert main(["hydro", str(path), "-o", str(tmp_path / "a.hydro.json")]) == 2
    assert "found a mesh of Hydrostar" in capsys.readouterr().err


def test_a_density_in_tonnes_is_refused_before_the_computation(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    words = ["hydro", "sphere:radius_m=5", "--density-kg-m3", "1.025", "-o", str(tmp_path / "a.hydro.json")]
    assert main(words) == 2
    assert "density_kg_m3: found 1.025, allowed: 900 to 1300 kg/m3" in capsys.readouterr().err
