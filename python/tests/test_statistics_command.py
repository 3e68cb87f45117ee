"""`kingpost statistics`: reading, pooling, printing, warnings and refused input."""

import json
from pathlib import Path

import kingpost
import numpy as np
import pandas
import pytest
import xarray
from gaussian_samples import PEAK, WIDTH, gaussian_process
from kingpost import KingpostError
from kingpost.analysis import statistics
from kingpost.cli import main
from kingpost.reports import outcomes
from kingpost.reports import statistics as statistics_report
from kingpost.results import entries, files
from xarray.backends.h5netcdf_ import H5NetCDFArrayWrapper


def recorded(tmp_path, seed: int, duration_s: float = 1800.0, **parameters) -> str:
    """A file as `kingpost run` writes it, of half an hour of a Gaussian process as roll."""
    record = gaussian_process(np.random.default_rng(seed), duration_s=duration_s).values
    time = 0.25 * np.arange(len(record))
    ramp = np.where(time < 20, 100.0, 1.0)
    results = xarray.Dataset(
        {
            "roll": (
                ("time", "body"),
                (0.02 * ramp * record)[:, None],
                {"units": "rad", "column": "{body}.roll"},
            )
        },
        {"time": time, "body": ["ship"]},
        {
            "title": "a barge",
            "floating_bodies": "ship",
            "scenario": kingpost.load("barge", {"simulation.seed": seed}, **parameters).json,
        },
    )
    path = tmp_path / f"run_{seed}_{len(list(tmp_path.iterdir()))}.nc"
    results.to_netcdf(path, engine="h5netcdf")
    return str(path)


def test_the_command_prints_statistics_after_the_ramp(tmp_path, capsys) -> None:
    files = [recorded(tmp_path, seed) for seed in range(6)]
    table = tmp_path / "table.csv"
    assert main(["statistics", *files, "-o", str(table)]) == 0
    shown, warned = capsys.readouterr()
    assert "20 to 1799.75 s of 6 runs, 3 h in all: averages over" in shown, "the barge's ramp is 20 s"
    assert "warning: of 6 runs these are rough: 10 or more" in warned
    header = next(line for line in shown.splitlines() if line.startswith("channel"))
    assert header.split("  ")[-2:] == ["largest of all", "smallest of all"]
    roll = next(line.split() for line in shown.splitlines() if line.startswith("ship.roll"))
    deviation = np.rad2deg(0.02)
    # A deviation over half an hour is known to 2.8 %, over six of them to 1.2 %.
    assert float(roll[3]) == pytest.approx(deviation, rel=0.04)
    assert float(roll[4]) == pytest.approx(4 * float(roll[3]), rel=1e-3)
    assert float(roll[5]) == pytest.approx(2 * np.pi / np.hypot(PEAK, WIDTH), rel=0.01)
    root = np.sqrt(2 * np.log(10800.0 * np.hypot(PEAK, WIDTH) / (2 * np.pi)))
    rayleigh = deviation * (root + statistics.EULER / root)
    with table.open() as lines:
        names, values = (line.strip().split(",") for line in lines)
    row = dict(zip(names, values, strict=True))
    for side, sign in (("largest", 1), ("smallest", -1)):
        error = float(row[f"extreme_{side}_error"])
        assert 0 < error < 0.2 * rayleigh
        assert abs(float(row[f"extreme_{side}"]) - sign * rayleigh) < 3 * error


def test_the_command_statistics_reads_files_of_the_command_run(tmp_path, capsys) -> None:
    file = str(tmp_path / "run.nc")
    settings = ["--set", "waves=on", "--set", "simulation.duration_s=3"]
    assert main(["run", "barge", "-o", file, *settings]) == 0
    capsys.readouterr()
    assert main(["statistics", file, "--after-s", "1"]) == 0
    shown = capsys.readouterr().out
    assert all(name in shown for name in ("ship.position.z", "ship.roll", "wave_elevation", "pendant.first"))
    assert "arm.roll" not in shown
    assert "expected extremes of three hours need 10 runs or more" in shown
    assert "luff" not in shown, "it is held"
    assert main(["statistics", file, "--after-s", "1", "--channels", "luff.*", "*force_z", "*moment_z"]) == 0
    shown = capsys.readouterr().out
    rows = {line.split()[0]: line.split()[1:] for line in shown.splitlines() if "." in line.split(" ")[0]}
    assert (rows["luff.joint_position"][0], rows["luff.joint_position"][2]) == ("deg", "0.0000")
    assert rows["pendant.joint_reaction.force_z"][0] == "kN"
    assert rows["pendant.joint_reaction.moment_z"][:2] == ["kN", "m"]
    assert main(["statistics", file, "--after-s", "1", "--channels", "arm.ro*"]) == 0
    shown = capsys.readouterr().out
    assert "arm.roll" in shown
    assert "ship.roll" not in shown


@pytest.mark.thorough
def test_only_runs_that_differ_in_their_seeds_are_pooled(tmp_path, capsys) -> None:
    """Source: another sea state, records of another length, the same seed twice."""
    first = recorded(tmp_path, 0, significant_height_m=1)
    higher = recorded(tmp_path, 1, significant_height_m=3)
    short = recorded(tmp_path, 2, duration_s=600.0, significant_height_m=1)
    again = recorded(tmp_path, 0, significant_height_m=1)
    height = "sea.waves.wind_sea.jonswap.significant_height_m"
    for of_seeds, message in [
        ([first, higher], f"{higher}: found {height} 3.0, allowed: 1.0, as in {first}"),
        ([first, short], f"{short}: found 2400 records to 599.75 s, allowed: 7200 records to 1799.75 s"),
        ([first, again], f"{again}: found simulation.seed 0, which is that of {first}"),
    ]:
        assert main(["statistics", *of_seeds]) == 2
        assert message in capsys.readouterr().err
    assert main(["statistics", first, recorded(tmp_path, 3, significant_height_m=1)]) == 0


@pytest.mark.parametrize(
    ("parameters", "message"),
    [
        (
            {"simulation.seed": [1, 2], "significant_height_m": [1, 3]},
            "significant_height_m 1 and 3, allowed",
        ),
        ({"simulation.seed": [1, 1]}, "found simulation.seed 1, which is that of"),
        ({"simulation.seed": [1, 2]}, ""),
    ],
)
def test_only_runs_of_a_batch_that_differ_in_their_seeds_are_pooled(
    tmp_path, capsys, parameters, message
) -> None:
    file = tmp_path / "batch.nc"
    found = kingpost.Batch("barge", parameters, {"simulation.duration_s": 1, "waves": True}).run()
    found.to_netcdf(file, engine="h5netcdf")
    assert main(["statistics", str(file), "--after-s", "0"]) == (2 if message else 0)
    assert message in capsys.readouterr().err


def test_the_command_names_what_is_wrong(tmp_path, capsys) -> None:
    file = recorded(tmp_path, 0)
    text = tmp_path / "table.csv"
    text.write_text("time,roll")
    for arguments, message in [
        ([file, "--channels", "boat.roll"], "--channels: found 'boat.roll'"),
        ([file, "--after-s", "5000"], "after_s: found 5000 s"),
        ([str(tmp_path / "none.nc")], "none.nc: no such file, allowed: results in NetCDF"),
        (
            [str(text)],
            "table.csv: found a file that is not NetCDF, allowed: results in NetCDF, as kingpost run",
        ),
        ([file, "-o", "table.txt"], "table.txt: unknown ending, allowed: .csv"),
    ]:
        assert main(["statistics", *arguments]) == 2
        assert message in capsys.readouterr().err


def test_a_run_keeps_the_density_of_its_water() -> None:
    assert kingpost.run("barge", {"simulation.duration_s": 0.1}).attrs["water_density_kg_m3"] == 1025
    assert kingpost.run("paper", {"simulation.duration_s": 0.1}).attrs["water_density_kg_m3"] == 0


def test_a_run_that_ended_early_is_reported(tmp_path, capsys) -> None:
    results = kingpost.run("barge", {"simulation.duration_s": 3.0})
    results.attrs["status"] = "interrupted"
    results.to_netcdf(tmp_path / "part.nc", engine="h5netcdf")
    assert main(["statistics", str(tmp_path / "part.nc"), "--after-s", "1"]) == 0
    assert "warning: a run ended early, at 3 s: interrupted" in capsys.readouterr().err


def _warned(values: list[float], **warnings: str) -> xarray.Dataset:
    """Rows of one channel, with what the engine warned of by name."""
    found = [_warning(name, text) for name, text in warnings.items()]
    attrs = {"scenario": json.dumps({"simulation": {"seed": len(values)}})}
    rows = xarray.Dataset({"roll": ("time", values)}, {"time": np.arange(len(values))}, attrs)
    return entries.with_entries(rows, warnings=found)


def _warning(name: str, text: str) -> entries.WarningEntry:
    return {"time_s": 1.0, "code": "made_up", "name": name, "value": None, "bound": None, "unit": "",
            "text": text}  # fmt: skip


def test_warnings_of_a_run_are_printed() -> None:
    run = _warned([0.0, 1.0, 0.5], hull="it heeled to 21.00 deg, at 4 s")
    assert "\nwarning: hull: it heeled to 21.00 deg, at 4 s\n" in _text([run])


def test_limits_of_one_run_in_a_file_of_several_are_refused() -> None:
    """Source: an attack on files: limits of several runs have an entry for each."""
    run = kingpost.run("container_to_quay", {"simulation.duration_s": 0.02})
    several = [run.expand_dims(run=[0, 1]), run.assign_coords(run=[0, 1])]
    assert run.sizes["limit"] not in (0, 2)
    for one in several:
        with pytest.raises(KingpostError, match="found events, warnings or limits of another form"):
            outcomes.of_runs([one])


def test_a_rounding_error_of_a_channel_is_printed_as_0() -> None:
    """Source: the yaw of a ship that turns by a degree and began at 1.5e-27 deg."""
    assert statistics_report._number(1.5e-27, 1.0) == "0.0000"
    assert statistics_report._number(1.5e-27, 1e-20) == "1.5e-27"


def test_warnings_of_several_runs_are_printed_once_with_their_number() -> None:
    first = _warned([0.0, 1.0, 0.5], hull="it heeled to 21.00 deg, at 4 s", boom="it pushes")
    second = _warned([0.0, 1.0], hull="it heeled to -33.10 deg, at 17.5 s")
    third = _warned([0.0, 1.0, 0.3, 0.2])
    lines = _text([first, second, third]).splitlines()
    of_hull = "warning, in 2 of 3 runs, from -33.10 (seed 2) to 21.00 (seed 3), first: hull"
    assert f"{of_hull}: it heeled to 21.00 deg, at 4 s" in lines
    assert "warning, in 1 of 3 runs, first: boom: it pushes" in lines
    assert sum(line.startswith("warning, in") for line in lines) == 2


@pytest.mark.parametrize(
    ("operation", "exposure_s"),
    [(None, statistics.THREE_HOURS_S), ({"steps": []}, 90.0), ({"enabled": False}, statistics.THREE_HOURS_S)],
)
def test_extremes_of_an_operation_are_those_of_doing_it_once(
    operation: dict | None, exposure_s: float
) -> None:
    scenario = {"sea": {"ramp_s": 10.0}} | ({"operation": operation} if operation else {})
    attrs = {"scenario": json.dumps(scenario)}
    run = xarray.Dataset({"roll": ("time", [1.0, 0.0])}, {"time": [0.0, 100.0]}, attrs)
    assert statistics_report.exposure_s(run, None) == exposure_s
    of = "three hours" if exposure_s > 1000 else "one operation of 90 s"
    shown = statistics_report.text([run], pandas.DataFrame(), None)
    assert f"expected extremes of {of} need 10 runs or more" in shown


def test_extremes_of_an_operation_of_a_batch_are_those_of_doing_it_once() -> None:
    each = [[_warning("hull", f"it heeled to {angle} deg")] for angle in (21, 22)]
    coordinates = {"time": [0.0, 1.0], "simulation.seed": ("run", [5, 6])}
    runs = xarray.Dataset({"roll": (("run", "time"), np.eye(2))}, coordinates)
    runs = entries.with_entries_of_runs(runs, warnings=each, limits=[[], []])
    words = "warning, in 2 of 2 runs, from 21 (seed 5) to 22 (seed 6), first: hull: it heeled to 21 deg"
    assert words in _text([runs])


def _text(runs: list[xarray.Dataset]) -> str:
    return statistics_report.text(runs, pandas.DataFrame(), 0.0)


def test_a_damaged_file_is_refused_in_one_line_and_does_not_hang_the_program(tmp_path, capsys) -> None:
    """Source: a file cut short, bytes of its headers overwritten by others, and a text."""
    whole = Path(recorded(tmp_path, 0, duration_s=60.0)).read_bytes()
    rng = np.random.default_rng(0)
    damaged = {f"cut_{size}": whole[:size] for size in (8, len(whole) // 2)}
    for _ in range(2):
        at = int(rng.integers(8, min(6000, len(whole))))
        damaged[f"at_{at}"] = whole[:at] + rng.bytes(24) + whole[at + 24 :]
    for name, content in damaged.items():
        file = tmp_path / f"{name}.nc"
        file.write_bytes(content)
        code = main(["statistics", str(file), "--after-s", "0"])
        said = capsys.readouterr().err
        assert code in (0, 2), name
        assert (said == "") == (code == 0), "an error is one line"
        assert said.count("\n") == (0 if code == 0 else 1)
        if name.startswith("cut"):
            assert code == 2
            assert "allowed: results in NetCDF" in said


def test_a_file_on_which_the_library_hangs_is_refused(tmp_path, monkeypatch) -> None:
    file = recorded(tmp_path, 0, duration_s=60.0)
    endless = tmp_path / "results" / "probe.py"
    endless.parent.mkdir()
    endless.write_text("while True: pass", encoding="utf-8")
    monkeypatch.setattr(files, "__file__", str(endless.with_name("files.py")))
    with pytest.raises(KingpostError, match="found a damaged file"):
        files.open_all([file], time_limit_s=0.5)


def test_all_columns_of_a_variable_are_read_once(tmp_path, monkeypatch) -> None:
    """Each variable is read from a file once for all of its columns, and what is not asked for not at all."""
    file = str(tmp_path / "run.nc")
    kingpost.results.write(kingpost.run("paper", {"simulation.duration_s": 0.1}), file)
    read: list[str] = []
    numbers = H5NetCDFArrayWrapper._getitem
    monkeypatch.setattr(
        H5NetCDFArrayWrapper,
        "_getitem",
        lambda self, key: (read.append(self.variable_name), numbers(self, key))[1],
    )
    (run,) = kingpost.results.open_all([file])
    read.clear()
    found = statistics_report.frame([run], 0.0, ["*"])
    assert len(found) > 100
    assert len(read) == len(set(read)) == sum("time" in variable.dims for variable in run.data_vars.values())
    read.clear()
    statistics_report.frame([run], 0.0, ["ship.roll"])
    assert read == ["roll"]


def test_runs_with_different_input_files_are_not_pooled(tmp_path, capsys) -> None:
    """Two databases of one name are two."""
    names = []
    for seed, digest in ((1, "a" * 64), (2, "b" * 64)):
        path = recorded(tmp_path, seed)
        found = xarray.load_dataset(path, engine="h5netcdf")
        found.attrs["files"] = json.dumps({"hydro/ship.hydro.json": digest})
        names.append(str(tmp_path / f"other_{seed}.nc"))
        found.to_netcdf(names[-1], engine="h5netcdf")
    assert main(["statistics", *names]) == 2
    assert "found the file hydro/ship.hydro.json with SHA-256 bbbbbbbbbbbb" in capsys.readouterr().err


def test_tables_are_in_engineering_units_with_heights_of_points_and_forces_of_lines() -> None:
    run = kingpost.run("lowering_by_winch", {"simulation.duration_s": 2})
    found = statistics_report.frame([run], 0.0).set_index("channel")
    rope = next(name for name in found.index if name.endswith(".rope_tension"))
    assert found.loc[rope, "unit"] == "kN"
    largest = float(run["rope_tension"].sel(rope=rope.removesuffix(".rope_tension")).max())
    assert found.loc[rope, "maximum"] == pytest.approx(largest / 1e3)
    assert any(name.endswith(".point_position.z") for name in found.index)
