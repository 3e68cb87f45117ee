"""`kingpost run --seeds`: runs of one scenario with many seeds, each in a separate file."""

from __future__ import annotations

import kingpost
import numpy as np
import pytest
import xarray
from kingpost.cli import main
from kingpost.simulation import seeds

SETTINGS = {"waves": True, "simulation.duration_s": 2.0}


def test_each_file_is_the_run_of_its_seed(tmp_path, capsys) -> None:
    """Source: the public contract of --seeds; a batch's runs have the bits that they have alone."""
    arguments = [f"--set={name}={str(value).lower()}" for name, value in SETTINGS.items()]
    assert main(["run", "barge", *arguments, "--seeds", "3", "-o", str(tmp_path / "run_*.nc")]) == 0
    shown = capsys.readouterr().out
    assert "3 runs, seeds 1 to 3" in shown
    files = sorted(tmp_path.glob("run_*.nc"))
    assert [path.name for path in files] == [f"run_{seed}.nc" for seed in range(1, 4)]
    for seed in (1, 3):
        found = xarray.load_dataset(files[seed - 1], engine="h5netcdf")
        alone = kingpost.run("barge", {**SETTINGS, "simulation.seed": seed})
        # A batch records no events.
        alone = alone.drop_dims("event")
        xarray.testing.assert_identical(found.drop_attrs(), alone.drop_attrs())
        assert found.attrs["scenario"] == alone.attrs["scenario"]
        assert (found.attrs["seed"], found.attrs["status"]) == (seed, "finished")
    files[1].unlink()
    assert main(["run", "barge", *arguments, "--seeds", "3", "--anew", "-o", str(tmp_path / "run_*.nc")]) == 0
    assert "run_3.nc, 2 replace an older file" in capsys.readouterr().out
    assert main(["statistics", *map(str, files), "--after-s", "1"]) == 0
    assert "of 3 runs" in capsys.readouterr().out


def test_a_finished_file_of_the_same_run_is_kept(tmp_path, capsys, monkeypatch) -> None:
    """Source: the public contract: other seeds, other settings, damaged files and others' are run."""
    # One column: a file of all takes most of the time.
    arguments = [
        "run",
        "barge",
        "--set=waves=on",
        "--set=simulation.duration_s=1",
        "--record",
        "ship.roll",
        "-o",
    ]
    pattern = str(tmp_path / "run_*.nc")
    assert main([*arguments, pattern, "--seeds", "3"]) == 0
    assert "kept" not in capsys.readouterr().out
    files = [tmp_path / f"run_{seed}.nc" for seed in (1, 2, 3, 4)]
    before = [path.stat().st_mtime_ns for path in files[:3]]
    files[1].write_bytes(files[1].read_bytes()[:1000])
    assert main([*arguments, pattern, "--seeds", "4"]) == 0
    shown = capsys.readouterr().out
    assert "kept            2 existing files" in shown
    assert "1 replace an older file" in shown
    after = [path.stat().st_mtime_ns for path in files]
    assert [new == old for new, old in zip(after, before, strict=False)] == [True, False, True]
    alone = kingpost.run("barge", {"waves": True, "simulation.duration_s": 1.0, "simulation.seed": 2})
    found = xarray.load_dataset(files[1], engine="h5netcdf")
    assert [name for name, of in found.data_vars.items() if "time" in of.dims] == ["roll"]
    np.testing.assert_array_equal(found["roll"].sel(body="ship"), alone["roll"].sel(body="ship"))
    assert main([*arguments, pattern, "--seeds", "4", "--set=significant_height_m=1"]) == 0
    assert "4 replace an older file" in capsys.readouterr().out
    monkeypatch.setattr(seeds, "Batch", None)
    assert main([*arguments, pattern, "--seeds", "4", "--set=significant_height_m=1"]) == 0
    assert "kept            4 existing files" in capsys.readouterr().out


def test_runs_that_diverge_keep_their_results_and_fail(tmp_path, capsys) -> None:
    """Source: exit code 1, what was computed is kept."""
    settings = ["--set=simulation.rate_limit=0.03", "--set=simulation.duration_s=5", "--set=waves=on"]
    assert main(["run", "barge", *settings, "--seeds", "2", "-o", str(tmp_path / "run_*.nc")]) == 1
    assert "run_1.nc: " in capsys.readouterr().err
    found = xarray.load_dataset(tmp_path / "run_1.nc", engine="h5netcdf")
    assert 0 < found.time[-1] < 5
    assert found.attrs["status"] != "finished"


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--seeds", "3"], "--seeds: found no -o"),
        (["--seeds", "3", "-o", "run.nc"], "run.nc: found no single * for the seed"),
        (["--seeds", "0", "-o", "run_*.nc"], "--seeds: found 0"),
        (["--seeds", "2", "-o", "run_*.txt"], "run_1.txt: unknown ending"),
    ],
)
def test_errors_are_reported_before_a_run(arguments, message, tmp_path, monkeypatch, capsys) -> None:
    monkeypatch.chdir(tmp_path)
    assert main(["run", "barge", *arguments]) == 2
    assert message in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (
            ["-o", "run_1.nc", "run_2.nc", "--seeds", "3"],
            "run_2.nc; a shell replaces * by the files that are there",
        ),
        (
            ["--seed", "2"],
            "--seed 2; did you mean --seeds? For one seed: --set simulation.seed=2 (see kingpost",
        ),
    ],
)
def test_a_pattern_expanded_by_the_shell_and_an_abbreviated_option_are_refused(
    arguments, message, capsys
) -> None:
    """Source: a second use of --seeds, where the shell expands run_*.nc; abbreviations of argparse."""
    with pytest.raises(SystemExit) as ended:
        main(["run", "barge", *arguments])
    assert ended.value.code == 2
    assert message in capsys.readouterr().err


def test_files_sort_by_seed() -> None:
    names = [path.name for path in seeds.files("run_*.csv", 100)]
    assert names == sorted(names)


@pytest.mark.thorough
def test_runs_too_long_for_memory_together_run_one_by_one(tmp_path, monkeypatch) -> None:
    scenario = kingpost.load("barge", {"waves": True, "simulation.duration_s": 2})
    wanted = list(seeds.run(scenario, seeds.files(tmp_path / "together_*.nc", 3)))
    monkeypatch.setattr(seeds, "MOST_MEMORY_GB", 1e-6)
    alone = list(seeds.run(scenario, seeds.files(tmp_path / "alone_*.nc", 3)))
    for one, other in zip(wanted, alone, strict=True):
        assert kingpost.results.read(one.path).equals(kingpost.results.read(other.path))


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["--units", "si"], "--units si: found no file, allowed: -o with .csv or .parquet"),
        (
            ["--units", "engineering", "-o", "run.nc"],
            "--units engineering: found run.nc, allowed: -o with .csv",
        ),
        (["--record", "*", "-o", "run.png"], "allowed: at most 8 of a unit"),
        (["--anew"], "--anew: found no --seeds"),
    ],
)
def test_options_that_would_lose_a_run_are_refused_before_it(
    arguments, said, tmp_path, monkeypatch, capsys
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(kingpost.Simulation, "run", None)
    assert main(["run", "paper", *arguments]) == 2
    assert said in capsys.readouterr().err
