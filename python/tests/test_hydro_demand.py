"""Memory that `kingpost hydro` estimates and uses, and the resumption of a killed run."""

import os
import re
import signal
import subprocess
import sys
import time
import zipfile
from pathlib import Path

import numpy as np
import pytest
from kingpost.hydro import demand
from kingpost.hydro.database import Water
from kingpost.hydro.hull_options import parse_shape
from kingpost.hydro.meshes import parametric
from kingpost.hydro.panels import lid

pytest.importorskip("capytaine")

PRISM = "box:length_m=6,beam_m=0.4,draught_m=0.2,depth_m=0.4"
MEASURED = "\n".join([
    "import sys",
    "from kingpost.cli import main",
    "from kingpost.hydro.demand import peak_bytes",
    "failed = main(['hydro', *sys.argv[1:]])",
    "print('taken', peak_bytes())",
    "sys.exit(failed)",
])  # fmt: skip


def start(folder: Path, *options: str) -> subprocess.Popen:
    return subprocess.Popen(
        [sys.executable, "-c", MEASURED, *options, "--accept-fit", "-o", str(folder / "x.hydro.json")],
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        env={**os.environ, "OMP_NUM_THREADS": "1"},
    )


@pytest.mark.skipif(sys.platform != "linux", reason="memory is measured as Linux counts it")
@pytest.mark.parametrize(
    "options",
    [
        ("sphere:radius_m=5", "--panels", "60", "--frequencies-rad-s", "0.5:2:8", "--directions", "4"),
        pytest.param(
            (PRISM, "--panels", "800", "--frequencies-rad-s", "1:8:8", "--directions", "4", "--trim-deg", "1",
             "--heel-deg", "2", "--no-lid"),
            marks=pytest.mark.thorough,
        ),
    ],
    ids=["few panels", "no plane of symmetry"],
)  # fmt: skip
def test_peak_memory_does_not_exceed_the_estimate_printed_before_the_run(tmp_path, options) -> None:
    run = start(tmp_path, *options)
    output, _ = run.communicate(timeout=600)
    assert run.returncode == 0, output
    said = 1e9 * float(re.search(r"^memory +([\d.]+) GB at most", output, re.M)[1])
    taken = float(re.search(r"^taken ([\d.]+)", output, re.M)[1])
    assert taken <= said
    assert said <= 2.0 * taken


def test_the_size_of_a_run_counts_the_lid_panels_and_excludes_mirrored_directions() -> None:
    hull = parametric(parse_shape(PRISM), PRISM, 400)
    omega = np.linspace(1.0, 8.0, 9)
    run = demand.size(hull, True, Water(), omega, 12)
    cover = len(lid(hull.panels, hull.panel_size_m).faces)
    assert (run.lid_panels, run.panels) == (cover, len(hull.panels.faces) + cover)
    assert (run.reflections, run.directions, run.frequencies) == (2, 4, 9)
    assert run.rings % 12 == 0
    without = demand.size(hull, False, Water(), omega, 12)
    assert demand.memory_bytes(without) < demand.memory_bytes(run)
    assert demand.process_bytes(run) >= demand.resident_bytes() + 8 * run.matrix_bytes


def solved(file: Path) -> int:
    """Frequencies in a file of partial results."""
    try:
        with zipfile.ZipFile(file) as stored:
            return len({name.split("/")[0] for name in stored.namelist() if "/" in name})
    except (OSError, zipfile.BadZipFile):
        return 0


@pytest.mark.skipif(os.name != "posix", reason="a process is killed by a signal")
@pytest.mark.thorough
def test_a_killed_run_is_resumed_and_writes_the_same_file(tmp_path) -> None:
    options = (PRISM, "--water-depth-m", "1", "--panels", "150", "--frequencies-rad-s", "2:5.5:9",
               "--directions", "12")  # fmt: skip
    whole, stopped = tmp_path / "whole", tmp_path / "stopped"
    for folder in (whole, stopped):
        folder.mkdir()
    run = start(stopped, *options)
    partial, until = stopped / "x.hydro.json.partial.npz", time.monotonic() + 600
    while solved(partial) < 3 and run.poll() is None and time.monotonic() < until:
        time.sleep(0.01)
    run.send_signal(signal.SIGKILL)
    run.communicate(timeout=600)
    assert run.returncode == -signal.SIGKILL
    done = solved(partial)
    assert 3 <= done < 10
    assert not (stopped / "x.hydro.json").exists()
    # What a kill while the file was being written leaves beside it.
    (stopped / ".x.hydro.json.partial.npz.1.npz").write_bytes(b"cut short")
    for folder in (stopped, whole):
        run = start(folder, *options)
        output, _ = run.communicate(timeout=600)
        assert run.returncode == 0, output
        assert (f"{done} of 10 frequencies are solved" in output) == (folder == stopped)
    assert (stopped / "x.hydro.json").read_bytes() == (whole / "x.hydro.json").read_bytes()
    assert [file.name for file in stopped.iterdir()] == ["x.hydro.json"]
