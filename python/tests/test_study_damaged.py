"""Damaged folders of a study: damage is reported or repaired, and damaged numbers are never returned."""

from __future__ import annotations

import json
import random
import shutil
from collections.abc import Iterator
from pathlib import Path

import kingpost
import numpy as np
import pytest
import xarray
from kingpost import KingpostError
from kingpost.cli import main
from kingpost.study.reduce import NOT_RUN
from lanes import THOROUGH
from study_samples import SLEWING, written

KINDS = ("gone", "cut short", "bit flipped", "emptied", "of another")


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Path]:
    folder = tmp_path_factory.mktemp("study")
    study = written(SLEWING, folder / "slewing.yaml")
    assert main(["study", str(study), "-o", str(folder / "out"), "-q"]) == 0
    return study, folder / "out"


def damages() -> Iterator[tuple[str, int]]:
    """Kinds of damage, each with the number from which the file and the place are drawn."""
    return ((kind, number) for number in range(24 if THOROUGH else 4) for kind in KINDS)


def damage(folder: Path, kind: str, number: int) -> str:
    """Damage one file of a study; returns which."""
    draw = random.Random(f"{kind} {number}")
    files = sorted(path for path in folder.rglob("*") if path.is_file() and path.stat().st_size > 0)
    path = draw.choice(files)
    content = bytearray(path.read_bytes())
    if kind == "gone":
        path.unlink()
    elif kind == "cut short":
        path.write_bytes(content[: draw.randrange(len(content))])
    elif kind == "bit flipped":
        content[draw.randrange(len(content))] ^= 1 << draw.randrange(8)
        path.write_bytes(content)
    elif kind == "emptied":
        path.write_bytes(b"")
    else:
        path.write_bytes(draw.choice([one for one in files if one != path]).read_bytes())
    return path.relative_to(folder).as_posix()


def same_where_run(found: xarray.Dataset, expected: xarray.Dataset) -> bool:
    """Whether each run that counts as run has the numbers that it had, and all coordinates are the same."""
    ran = np.flatnonzero(found.status.values != NOT_RUN)

    def same(name: str) -> bool:
        pair = [
            one[name].isel(run=ran) if "run" in one[name].dims else one[name] for one in (found, expected)
        ]
        return np.array_equal(*(one.values for one in pair), equal_nan=pair[0].dtype.kind == "f")

    return all(same(str(name)) for name in expected.variables)


def test_damaged_numbers_of_a_folder_are_never_returned(whole: tuple[Path, Path], tmp_path: Path) -> None:
    """Source: damages of five kinds at any file and place, 120 in the thorough lane. What is read equals what
    was written, or an error names it; a unit whose marker is gone counts as not run."""
    _, folder = whole
    expected = kingpost.open_study(folder)
    said, wrong = [], []
    for kind, number in damages():
        damaged = tmp_path / "damaged"
        shutil.rmtree(damaged, ignore_errors=True)
        shutil.copytree(folder, damaged)
        what = damage(damaged, kind, number)
        try:
            found = kingpost.open_study(damaged)
        except KingpostError as error:
            said.append(str(error))
            continue
        if not same_where_run(found, expected):
            wrong.append((kind, number, what))
    assert wrong == []
    assert len(said) > 0
    assert all(str(tmp_path) in words for words in said)


def test_a_resumed_study_repairs_what_an_error_names(whole: tuple[Path, Path], tmp_path: Path) -> None:
    study, folder = whole
    damaged = tmp_path / "out"
    shutil.copytree(folder, damaged)
    held = damaged / "results.zarr" / "limit_held"
    chunk = next(path for path in sorted(held.rglob("*")) if path.is_file() and path.name != "zarr.json")
    chunk.unlink()
    with pytest.raises(
        KingpostError, match=r"found damaged numbers in unit \d+.*--resume. computes the damaged parts again"
    ):
        kingpost.open_study(damaged)
    assert main(["study", str(study), "-o", str(damaged), "--resume", "-q"]) == 0
    assert kingpost.open_study(damaged).identical(kingpost.open_study(folder))


def test_a_unit_without_a_marker_counts_as_not_run(whole: tuple[Path, Path], tmp_path: Path) -> None:
    _, folder = whole
    damaged = tmp_path / "out"
    shutil.copytree(folder, damaged)
    first = sorted((damaged / "units").glob("[0-9]*.json"))[0]
    start, stop = json.loads(first.read_text())["runs"]
    first.unlink()
    found = kingpost.open_study(damaged)
    assert (found.status.values[start:stop] == NOT_RUN).all()
    assert (kingpost.open_study(folder).status.values[start:stop] != NOT_RUN).all()
