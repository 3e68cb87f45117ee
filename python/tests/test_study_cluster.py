"""Studies beyond one machine: Dask, a Slurm array, any executor; and the command that starts them."""

from __future__ import annotations

import json
import os
import re
import signal
import subprocess
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import kingpost
import pytest
from kingpost.cli import main
from lanes import THOROUGH
from pages import DOCS, commands_folder
from study_samples import RUNS, SLEWING, numbers, written


@pytest.fixture(scope="module")
def whole(tmp_path_factory) -> tuple[kingpost.Study, Path]:
    """The fast study in one process."""
    study, folder = kingpost.Study(SLEWING), tmp_path_factory.mktemp("whole")
    study.run(folder, workers=1)
    return study, folder


def test_any_executor_gives_the_same_bits(whole, tmp_path) -> None:
    """Source: the contract: the same bits on any number of workers."""
    study, folder = whole
    with ThreadPoolExecutor(8) as pool:
        study.run(tmp_path, executor=pool)
    assert numbers(tmp_path) == numbers(folder)


@pytest.mark.thorough
def test_a_dask_cluster_that_loses_a_worker_gives_the_same_bits(whole, tmp_path, capsys) -> None:
    """Source: the contract, on a cluster of three worker processes of which one is killed on the way."""
    distributed = pytest.importorskip("distributed")
    _, folder = whole
    path = written(SLEWING, tmp_path / "study.yaml")
    with (
        distributed.LocalCluster(n_workers=3, threads_per_worker=1, dashboard_address=None) as cluster,
        distributed.Client(cluster) as client,
    ):
        pids = list(client.run(os.getpid).values())
        assert len(set(pids)) == 3
        units = tmp_path / "dask" / "units"

        def kill_one() -> None:
            limit = time.monotonic() + 600
            while not list(units.glob("0*.json")) and time.monotonic() < limit:
                time.sleep(0.005)
            os.kill(pids[0], signal.SIGKILL)

        killer = threading.Thread(target=kill_one)
        killer.start()
        command = ["study", str(path), "-o", str(tmp_path / "dask"), "--scheduler", cluster.scheduler_address]
        assert main(command) == 0
        killer.join()
    assert f"finished        {RUNS} of {RUNS} runs" in capsys.readouterr().out
    assert numbers(tmp_path / "dask") == numbers(folder)


def test_the_array_script_of_the_page_runs_the_study_in_parts(whole, tmp_path) -> None:
    """Source: docs/howto/cluster.md, whose script runs here as Slurm runs it: once for each task, at once,
    with the task's number in the environment; a task that is put back runs twice."""
    _, folder = whole
    page = (DOCS / "howto" / "cluster.md").read_text(encoding="utf-8")
    found = re.search(r'^```sh title="array.sh"\n(.*?)^```', page, re.MULTILINE | re.DOTALL)
    assert found
    (tmp_path / "array.sh").write_text(found[1])
    tasks = int(re.search(r"--array=1-(\d+)", found[1])[1]) if THOROUGH else 2
    written(SLEWING, tmp_path / "lift.yaml")
    commands = commands_folder(tmp_path / "commands")
    package = str(Path(kingpost.__file__).parents[1])
    always = {
        **os.environ,
        "PATH": f"{commands}{os.pathsep}{os.environ['PATH']}",
        "PYTHONPATH": os.pathsep.join([package, os.environ.get("PYTHONPATH", "")]),
        "SLURM_ARRAY_TASK_COUNT": str(tasks),
        "SLURM_CPUS_PER_TASK": "1",
    }

    def task(number: int) -> subprocess.Popen[str]:
        environment = {**always, "SLURM_ARRAY_TASK_ID": str(number)}
        return subprocess.Popen(["bash", "-eu", "array.sh"], cwd=tmp_path, env=environment, text=True,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE)  # fmt: skip

    for process in [task(number) for number in range(1, tasks + 1)]:
        out, told = process.communicate(timeout=600)
        assert process.returncode == 0, told
    assert numbers(tmp_path / "results") == numbers(folder)
    again = task(1)
    out, told = again.communicate(timeout=600)
    assert (again.returncode, "finished        24 of 24 runs" in out) == (0, True), told


def test_the_command_prints_the_planned_runs_and_their_results(tmp_path, capsys) -> None:
    """Source: what a user does; the numbers are those of `open_study`."""
    path = written(
        {**SLEWING, "limits": {"roll": {"column": "ship.roll", "at_most": 0.1}}}, tmp_path / "s.yaml"
    )
    assert main(["study", str(path)]) == 0
    shown = capsys.readouterr().out
    assert "runs            24 of 0.2 s, statistics after 0.05 s: 12 cases, seeds 1 to 2" in shown
    assert "axis            crane_x_m: -10, -8, -6, -4, -2, 0" in shown
    assert "to run it" in shown
    assert main(["study", str(path), "-o", str(tmp_path / "out"), "--workers", "1", "--part", "1/2"]) == 0
    shown = capsys.readouterr().out
    assert "12 are left" in shown
    assert f"to go on        kingpost study {path} -o {tmp_path / 'out'} --resume" in shown
    assert (
        main(["study", str(path), "-o", str(tmp_path / "out"), "--workers", "1", "--resume", "--json"]) == 0
    )
    told = json.loads(capsys.readouterr().out)
    found = kingpost.open_study(tmp_path / "out")
    assert (told["runs"], told["finished"], told["limits"][0]["held"]) == (24, 24, 24)
    assert told["limits"][0]["worst"] == found.limit_worst.max()
    assert told["limits"][0]["worst_run"] == found.limit_worst.values.argmax()


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--resume"], "--resume: found no -o, allowed: with -o DIR alone"),
        (["-o", "out", "--part", "3/2"], "--part: found '3/2', allowed: K/N, K from 1 to N"),
        (["-o", "out", "--workers", "0"], "workers: found 0, allowed: a whole number from 1 to 10000"),
        (["-o", "out", "--scheduler", "nowhere"], "--scheduler: found no scheduler at nowhere"),
        (["-o", "study.yaml"], "study.yaml"),
    ],
)
def test_an_error_of_the_command_study_is_one_line(arguments, message, tmp_path, monkeypatch, capsys) -> None:
    """Source: the contract of the command line: exit code 2, or 1 where a folder cannot be written."""
    monkeypatch.chdir(tmp_path)
    written(SLEWING, tmp_path / "study.yaml")
    assert main(["study", "study.yaml", *arguments]) in (1, 2)
    told = capsys.readouterr().err
    assert message in told
    assert told.count("\n") == 1
