"""Written files are complete, or unchanged."""

from __future__ import annotations

import json
import os
import random
import resource
import subprocess
import sys
import threading
from pathlib import Path

import kingpost
import pytest
from kingpost import output
from kingpost.errors import KingpostError, OutputError
from lanes import THOROUGH, sampled

RUN = ("run", "paper", "--set", "simulation.duration_s=0.5")
ENDINGS = (".nc", ".csv", ".parquet")
TRIES, KILLS = (16, 8) if THOROUGH else (4, 3)
"""Runs that are ended on their way, and how many of them have to be."""


@pytest.fixture(scope="module")
def results():
    """A short run."""
    return kingpost.run("paper", {"simulation.duration_s": 0.05})


def _names(folder: Path) -> list[str]:
    return sorted(path.name for path in folder.iterdir())


def test_a_failing_block_leaves_the_old_file(tmp_path):
    """Source: what a person would lose: the good file of the run before."""
    target = tmp_path / "good.csv"
    target.write_text("good")

    def fails() -> None:
        with output.whole(target) as beside:
            beside.write_text("half")
            raise ZeroDivisionError

    with pytest.raises(ZeroDivisionError):
        fails()
    assert target.read_text() == "good"
    assert _names(tmp_path) == ["good.csv"]


def test_a_new_file_gets_default_permissions_and_a_replaced_file_keeps_its_permissions(tmp_path):
    """Source: umask(2); a temporary file is readable by its owner alone."""
    mask = os.umask(0o027)
    try:
        new = output.write_text(tmp_path / "new.csv", "1")
        assert new.stat().st_mode & 0o777 == 0o640
        new.chmod(0o604)
        output.write_text(new, "2")
        assert new.stat().st_mode & 0o777 == 0o604
    finally:
        os.umask(mask)


@pytest.mark.parametrize("ending", ENDINGS)
def test_a_full_disk_gives_one_clear_error_and_keeps_the_old_file(tmp_path, results, ending):
    """Source: setrlimit(2): a file that may not grow fails as on a full disk."""
    target = tmp_path / f"run{ending}"
    kingpost.results.write(results, target)
    before = target.read_bytes()
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (2_000, hard))
    try:
        with pytest.raises(KingpostError, match=r"cannot be written: .*File too large"):
            kingpost.results.write(results, target)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))
    assert target.read_bytes() == before
    assert _names(tmp_path) == [target.name]


def test_an_unwritable_folder_is_refused_with_the_reason(tmp_path):
    """Source: the operating system's words."""
    with pytest.raises(OutputError, match="No such file or directory") as refused:
        output.write_text(tmp_path / "nowhere" / "x.csv", "1")
    assert refused.value.path == tmp_path / "nowhere" / "x.csv"


def test_two_processes_that_write_one_file_leave_one_complete_result(tmp_path):
    """Source: rename(2): at any moment a reader finds the one or the other, whole."""
    target = tmp_path / "run.csv"
    texts = [f"{letter}\n" * length for letter, length in (("a", 20_000), ("b", 50_000))]
    output.write_text(target, texts[0])
    writers = [
        threading.Thread(target=lambda text=text: [output.write_text(target, text) for _ in range(20)])
        for text in texts
    ]
    for writer in writers:
        writer.start()
    while any(writer.is_alive() for writer in writers):
        assert target.read_text() in texts
    assert target.read_text() in texts
    assert _names(tmp_path) == [target.name]


@pytest.mark.skipif(not hasattr(os, "fork"), reason="the test forks")
@pytest.mark.parametrize("ending", sampled(ENDINGS, keep=[".nc"]))
def test_a_kill_at_any_time_leaves_either_the_old_or_the_new_file(tmp_path, ending):
    """Source: a process that the system ends at moments spread over a run that writes over a good file. Old
    and new are the same run, so that the values are the same."""
    target = tmp_path / f"run{ending}"
    script = Path(__file__).with_name("run_killed.py")
    command = [sys.executable, str(script), str(TRIES), str(KILLS), *RUN, "-o", str(target)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=600, check=False)
    assert done.returncode == 0, done.stderr
    killed, digests = zip(*json.loads(done.stdout), strict=True)
    assert sum(killed) >= KILLS
    assert len(set(digests)) == 1


def test_a_flipped_bit_of_a_netcdf_file_is_never_read_as_another_number(tmp_path, results):
    """Source: the file as it was written."""
    path, damaged = tmp_path / "run.nc", tmp_path / "damaged.nc"
    kingpost.results.write(results, path)
    written, content, refused = kingpost.results.read(path), path.read_bytes(), 0
    for number in range(200 if THOROUGH else 25):
        draw, changed = random.Random(number), bytearray(content)
        changed[draw.randrange(len(changed))] ^= 1 << draw.randrange(8)
        damaged.write_bytes(changed)
        try:
            found = kingpost.results.read(damaged)
        except KingpostError:
            refused += 1
            continue
        # Descriptions are not protected.
        assert found.equals(written), number
        assert found.attrs["scenario"] == written.attrs["scenario"], number
        numbers = {name for name, value in written.attrs.items() if not isinstance(value, str)}
        assert all(found.attrs[name] == written.attrs[name] for name in numbers), number
    assert refused > 0
