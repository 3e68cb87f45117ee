"""Resumption of studies: however the process ended, the resumed study equals an uninterrupted one."""

from __future__ import annotations

import json
import os
import resource
import shutil
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import kingpost
import pytest
from kingpost.cli import main
from kingpost.study.running import locks, pools
from kingpost.study.store.writing import Store
from lanes import THOROUGH
from study_samples import RUNS, SLEWING, numbers, written

LONGER = {
    **SLEWING,
    "axes": {"crane_x_m": {"range": {"from": -10, "to": 10, "count": 128}}},
    "seeds": {"count": 2},
}
"""256 runs in 64 units."""
SHORTER = {**LONGER, "axes": {"crane_x_m": {"range": {"from": -10, "to": 10, "count": 16}}}}
"""32 runs in 8 units."""
KILLED, KILLS, MOMENTS = (LONGER, 20, 6) if THOROUGH else (SHORTER, 3, 2)
"""A study that is killed, how often, and at how many different numbers of units done."""


@pytest.fixture(scope="module")
def whole(tmp_path_factory) -> tuple[kingpost.Study, Path]:
    """The fast study, uninterrupted."""
    study, folder = kingpost.Study(SLEWING), tmp_path_factory.mktemp("whole")
    study.run(folder, workers=1)
    return study, folder


@pytest.mark.skipif(not hasattr(os, "fork"), reason="the test forks")
def test_a_repeatedly_killed_study_equals_an_uninterrupted_one(tmp_path) -> None:
    """Source: the contract: kill -9 at any moment loses the units in flight at most; bits are the same."""
    path = written(KILLED, tmp_path / "study.yaml")
    script = Path(__file__).with_name("study_killed.py")
    command = [sys.executable, str(script), str(tmp_path / "killed"), str(path)]
    command += [str(KILLS), str(MOMENTS)]
    found = subprocess.run(command, capture_output=True, text=True, timeout=600, check=False)
    assert found.returncode == 0, found.stderr
    # Kills came at the beginning, between units and while they were written.
    done = json.loads(found.stdout)
    assert len(done) >= KILLS
    assert len(set(done)) >= MOMENTS
    kingpost.Study(path).run(tmp_path / "whole", workers=1)
    assert numbers(tmp_path / "killed") == numbers(tmp_path / "whole")
    assert not list((tmp_path / "killed").rglob("*.partial"))


def test_a_worker_that_is_killed_is_replaced_and_the_bits_are_those_of_one_worker(whole, tmp_path) -> None:
    """Source: the contract: the same bits on any number of workers, and with one killed."""
    study, folder = whole
    killed: list[int] = []

    def kill_one(runs: int):
        assert runs == RUNS
        return lambda done: killed or killed.append(kill_a_child())

    study.run(tmp_path / "killed", workers=2, progress=kill_one)
    assert killed
    assert numbers(tmp_path / "killed") == numbers(folder)


def kill_a_child() -> int:
    """Kill one of the worker processes of this one."""
    import multiprocessing

    child = multiprocessing.active_children()[0]
    assert child.pid is not None
    os.kill(child.pid, signal.SIGKILL)
    return child.pid


def test_a_damaged_unit_is_detected_and_runs_again(whole, tmp_path) -> None:
    """Source: the contract: a unit counts where the hash of its numbers is that of its marker."""
    study, folder = whole
    damaged = tmp_path / "damaged"
    shutil.copytree(folder, damaged)
    chunks = sorted((damaged / "results.zarr" / "statistics" / "c").rglob("0"))
    chunks = [path for path in chunks if path.is_file()]
    assert len(chunks) == study.plan.units == 6
    chunks[0].write_bytes(chunks[0].read_bytes()[:20])
    chunks[1].unlink()
    # The numbers of another unit, whole in themselves.
    chunks[2].write_bytes(chunks[3].read_bytes())
    markers = sorted((damaged / "units").glob("*.json"))
    markers[4].write_text(markers[4].read_text()[:30])
    (damaged / "results.zarr" / "statistics" / "zarr.json").write_text("{")
    (damaged / "results.zarr" / "crane_x_m" / "zarr.json").unlink()
    computed: list[int] = []
    study.run(
        damaged, workers=1, resume=True, progress=lambda runs: computed.append(runs) or (lambda done: None)
    )
    assert computed == [16]
    assert numbers(damaged) == numbers(folder)


def test_a_study_is_not_overwritten_and_another_study_is_not_resumed(whole, tmp_path) -> None:
    """Source: the contract of --resume: it says which part differs."""
    study, folder = whole
    with pytest.raises(kingpost.KingpostError, match="found a study, allowed: an empty folder; --resume"):
        study.run(folder)
    for change, part in [
        ({"set": {**SLEWING["set"], "simulation.duration_s": 0.3}}, r"scenario \(simulation.duration_s\);"),
        ({"axes": {"crane_x_m": {"values": [1, 2]}, "motor_2": {"values": [True]}}}, "axes;"),
        ({"seeds": {"count": 2, "first": 5}}, "seeds;"),
        ({"record": ["ship.pitch"]}, "what is recorded;"),
        ({"limits": {}}, r"scenario \(limits\);"),
    ]:
        with pytest.raises(kingpost.KingpostError, match=f"found a study that differs in {part}"):
            kingpost.Study({**SLEWING, **change}).run(folder, resume=True)
    before = numbers(folder)
    other = kingpost.Study({**SLEWING, "title": "Another title", "acceptance": 0.05})
    assert other.run(folder, resume=True).attrs["acceptance"] == 0.05
    assert study.run(folder, resume=True).attrs["acceptance"] == 0.1
    assert numbers(folder) == before


def test_results_of_another_engine_are_not_resumed(whole, monkeypatch) -> None:
    """Source: the fingerprint has the digest of the engine's sources."""
    _, folder = whole
    monkeypatch.setattr("kingpost.study.design.plan.source_digest", lambda: "another")
    with pytest.raises(kingpost.KingpostError, match="differs in engine;"):
        kingpost.Study(SLEWING).run(folder, resume=True)


def test_two_studies_into_one_folder_are_refused(whole, tmp_path) -> None:
    """Source: the contract: one process at a time, or parts of an array, each once."""
    study, _ = whole
    with locks.alone(tmp_path):
        for part in (None, (1, 2)):
            with pytest.MonkeyPatch.context() as patch:
                patch.setattr(locks, "WAIT_S", 0.1)
                with pytest.raises(kingpost.KingpostError, match="found another process at work there"):
                    study.run(tmp_path, workers=1, part=part)
    with locks.beside_other_parts(tmp_path, (1, 2)):
        for part in (None, (1, 2)):
            with pytest.raises(kingpost.KingpostError, match="found another process at work there"):
                study.run(tmp_path, workers=1, part=part)
        study.run(tmp_path, workers=1, part=(2, 2))
    # No process holds the lock any more.
    study.run(tmp_path, workers=1, resume=True)


def test_parts_of_a_study_run_in_parallel_and_complete_it(whole, tmp_path) -> None:
    """Source: docs/howto/cluster.md: the tasks of an array are parts; --resume completes them."""
    study, folder = whole
    parts = [
        threading.Thread(target=study.run, args=(tmp_path,), kwargs={"workers": 1, "part": (k, 3)})
        for k in (1, 2)
    ]
    for part in parts:
        part.start()
    for part in parts:
        part.join()
    assert (kingpost.open_study(tmp_path).status == -1).sum() == 8
    study.run(tmp_path, workers=1, resume=True)
    assert numbers(tmp_path) == numbers(folder)


def test_ctrl_c_keeps_finished_units(tmp_path) -> None:
    """Source: exit code 130: interrupted, what was computed is kept."""
    path, folder = written(LONGER, tmp_path / "study.yaml"), tmp_path / "results"
    command = [sys.executable, "-m", "kingpost", "study", str(path), "-o", str(folder), "--workers", "2"]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    limit = time.monotonic() + 600
    while len(list(folder.glob("units/0*.json"))) < 2 and time.monotonic() < limit:
        time.sleep(0.02)
    process.send_signal(signal.SIGINT)
    _, told = process.communicate(timeout=600)
    assert process.returncode == 130, told
    assert "interrupted, what is finished is kept" in told
    assert "--resume goes on" in told
    assert "Traceback" not in told
    done = len(list(folder.glob("units/0*.json")))
    assert 2 <= done < 64


def test_a_full_disk_gives_one_error_and_the_study_can_be_resumed(
    whole, tmp_path, monkeypatch, capsys
) -> None:
    """Source: the contract: exit code 1, what is finished is kept. The disk takes no more after two units."""
    study, folder = whole
    path, full = written(SLEWING, tmp_path / "study.yaml"), tmp_path / "full"
    write, written_units = Store.write, []

    def on_a_full_disk(store, result) -> None:
        if len(written_units) == 2:
            # Files of more than 20 bytes are refused, as by a full disk.
            resource.setrlimit(resource.RLIMIT_FSIZE, (20, limits[1]))
        try:
            write(store, result)
        finally:
            resource.setrlimit(resource.RLIMIT_FSIZE, limits)
        written_units.append(result.unit)

    limits = resource.getrlimit(resource.RLIMIT_FSIZE)
    monkeypatch.setattr(Store, "write", on_a_full_disk)
    assert main(["study", str(path), "-o", str(full), "--workers", "1"]) == 1
    told = capsys.readouterr().err
    assert (
        f"error: {full / 'results.zarr'}: cannot be written: File too large; what is finished is kept" in told
    )
    assert len(list(full.glob("units/0*.json"))) == 2
    monkeypatch.undo()
    assert main(["study", str(path), "-o", str(full), "--workers", "1", "--resume"]) == 0
    found = {name: text for name, text in numbers(full).items() if name.startswith("units")}
    assert found == {name: text for name, text in numbers(folder).items() if name.startswith("units")}
    assert study.plan.units == len(found)


def test_workers_that_end_repeatedly_give_an_error(whole, tmp_path, monkeypatch) -> None:
    """Source: a unit is begun four times at most, and the error says what may be wrong."""
    study, _ = whole

    class Dies(pools.Executor):
        def submit(self, call, /, *arguments):
            future = pools.Future()
            future.set_exception(ConnectionError("the worker is gone"))
            return future

    with pytest.raises(kingpost.RunError, match="its worker ended 4 times: the worker is gone"):
        study.run(tmp_path, executor=Dies())


@pytest.mark.parametrize("resume", [False, True])
def test_a_study_does_not_overwrite_a_foreign_file_of_the_same_name(tmp_path, resume) -> None:
    """The study's own file, say, in the folder that it is told to write to."""
    path = written({**SLEWING, "title": "Mine"}, tmp_path / "study.yaml")
    text = path.read_text(encoding="utf-8") + "# my notes\n"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(kingpost.KingpostError, match=r"study.yaml: found a file of something else, allowed"):
        kingpost.Study(SLEWING).run(tmp_path, workers=1, resume=resume)
    assert path.read_text(encoding="utf-8") == text
    # Files with other names, a cluster's logs, may stand there.
    path.rename(tmp_path / "log.txt")
    kingpost.Study(SLEWING).run(tmp_path, workers=1, resume=resume)
    assert (tmp_path / "log.txt").read_text(encoding="utf-8") == text
