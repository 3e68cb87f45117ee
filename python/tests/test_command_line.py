"""What commands print and write on demand: JSON, nothing, chosen columns, engineers' units, completion."""

from __future__ import annotations

import json
import subprocess
import sys

import kingpost
import numpy as np
import pandas
import pytest
import xarray
from kingpost.cli import main
from kingpost.reports import sea
from samples import read_csv

SHORT = ["--set", "simulation.duration_s=0.5"]
RESTLESS = {"simulation.begin_at_equilibrium": False}
TOP_HEAVY = RESTLESS | {"bodies.load.mass_kg": 10, "bodies.ship.centre_of_mass_m": [0, 0, 5]}
KEEL_UP = RESTLESS | {"bodies.load.mass_kg": 100000}


def test_numbers_of_a_run_are_printed_as_json(capsys) -> None:
    """Source: the same run in Python."""
    assert main(["run", "paper", *SHORT, "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    expected = kingpost.run("paper", {"simulation.duration_s": 0.5})
    assert (found["status"], found["time_s"]) == ("finished", 0.5)
    roll = expected["roll"].sel(body="ship").values
    assert found["columns"]["ship.roll"] == {
        "unit": "rad", "last": roll[-1], "smallest": roll.min(), "largest": roll.max()
    }  # fmt: skip


@pytest.mark.parametrize(
    "command",
    [
        ["check", "barge"],
        ["modes", "chain"],
        ["rao", "barge", "--directions-deg", "180", "--frequencies-rad-s", "0.5:1:2"],
        ["list"],
        ["run", "paper", *SHORT],
    ],
)
def test_json_is_json_and_quiet_is_quiet(command, capsys) -> None:
    assert main([*command, "--json"]) == 0
    assert json.loads(capsys.readouterr().out)
    assert main([*command, "--quiet"]) == 0
    assert capsys.readouterr().out == ""
    with pytest.raises(SystemExit) as ended:
        main([*command, "--quiet", "--json"])
    assert ended.value.code == 2


def test_statistics_and_seeds_are_printed_as_json(tmp_path, capsys) -> None:
    pattern = str(tmp_path / "run_*.nc")
    settings = ["--set=waves=on", "--set=simulation.duration_s=2"]
    assert main(["run", "barge", *settings, "--seeds", "2", "-o", pattern, "--json"]) == 0
    assert [run["seed"] for run in json.loads(capsys.readouterr().out)] == [1, 2]
    files = [str(path) for path in sorted(tmp_path.glob("*.nc"))]
    assert main(["statistics", *files, "--after-s", "1", "--json"]) == 0
    rows = {row["channel"]: row for row in json.loads(capsys.readouterr().out)}
    assert rows["ship.roll"]["unit"] == "deg"
    assert rows["ship.roll"]["zero_up_crossing_period"] is None, "too few crossings is no number"


def test_warnings_are_on_stderr_whatever_is_printed(capsys) -> None:
    for how in ([], ["--json"], ["--quiet"]):
        assert main(["check", "offshore_vessel_moored", *how]) == 0
        shown, warned = capsys.readouterr()
        assert "warning: hull: heel 3.34 deg to port" in warned
        assert "warning: " not in shown.replace("warned", "")


def test_chosen_columns_are_written_in_engineering_units(tmp_path) -> None:
    """Source: the same columns of the whole run; a hundredth of a turn is 3.6 deg."""
    run = ["run", "lowering_by_winch", "--set", "simulation.duration_s=1", "--quiet"]
    chosen = ["--record", "*.roll", "*tension"]
    whole, part = str(tmp_path / "whole.csv"), str(tmp_path / "part.csv")
    assert main([*run, "-o", whole]) == 0
    assert main([*run, "-o", part, *chosen, "--units", "engineering"]) == 0
    si, shown = read_csv(whole), read_csv(part)
    names = [name for name in si if name.endswith((".roll", "tension"))]
    factor = {name: (180 / np.pi, "deg") if name.endswith("roll") else (1e-3, "kN") for name in names}
    assert list(shown) == ["time [s]", *(f"{name} [{factor[name][1]}]" for name in names)]
    for name in names:
        scale, unit = factor[name]
        np.testing.assert_allclose(shown[f"{name} [{unit}]"], si[name] * scale, rtol=1e-14)
    assert main([*run, "-o", part, *chosen, "--units", "si"]) == 0
    np.testing.assert_array_equal(read_csv(part)[f"{names[0]} [rad]"], si[names[0]])


def test_parquet_and_netcdf_have_the_chosen_columns_too(tmp_path, capsys) -> None:
    run = ["run", "paper", *SHORT, "--quiet", "--record", "ship.roll"]
    parquet, netcdf = str(tmp_path / "run.parquet"), str(tmp_path / "run.nc")
    assert main([*run, "-o", parquet, "--units", "engineering"]) == 0
    assert list(pandas.read_parquet(parquet)) == ["time [s]", "ship.roll [deg]"]
    assert main([*run, "-o", netcdf]) == 0
    found = xarray.load_dataset(netcdf, engine="h5netcdf")
    assert [name for name, of in found.data_vars.items() if "time" in of.dims] == ["roll"]
    assert found.sizes["event"] == found.sizes["warning"] == found.sizes["limit"] == 0
    assert main([*run, "-o", netcdf, "--units", "engineering"]) == 2
    assert "allowed: -o with .csv or .parquet" in capsys.readouterr().err


def test_an_unknown_column_is_refused_before_the_run(tmp_path, capsys, monkeypatch) -> None:
    output = tmp_path / "run.csv"
    monkeypatch.delattr(kingpost.Simulation, "run")
    assert main(["run", "paper", "-o", str(output), "--record", "boat.roll"]) == 2
    shown = capsys.readouterr()
    assert "--record: found 'boat.roll', allowed: columns such as arm.roll, tower.roll" in shown.err
    assert shown.out == ""
    assert not output.exists()


def test_a_file_is_written_when_the_reader_of_a_pipe_leaves(tmp_path) -> None:
    """Source: `kingpost run ... -o run.csv | head -1`."""
    output = tmp_path / "run.csv"
    command = [sys.executable, "-m", "kingpost", "run", "paper", *SHORT, "-o", str(output)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as started:
        started.stdout.close()
        assert started.wait(600) == 0
        assert started.stderr.read() == b""
    assert len(read_csv(output)) == 51


@pytest.mark.parametrize("wrong", [TOP_HEAVY, KEEL_UP])
def test_a_ship_that_capsizes_gives_exit_code_1_unless_allowed(wrong, capsys) -> None:
    """Source: the metacentric height and the heel that are printed."""
    scenario = kingpost.load("barge", wrong)
    hull = scenario.hydrostatics["hulls"][0]
    assert hull["metacentric_height_m"][0] < 0 or abs(hull["heel_rad"]) > 2.5
    settings = [f"--set={name}={json.dumps(value)}" for name, value in wrong.items()]
    assert main(["check", "barge", *settings]) == 1
    assert "not stable" in capsys.readouterr().err
    assert main(["check", "barge", *settings, "--allow-unstable"]) == 0
    assert main(["check", "barge"]) == 0


def test_check_states_the_sea_the_current_and_the_wind(capsys) -> None:
    """Source: the fields of the file."""
    assert main(["check", "offshore_vessel_moored"]) == 0
    shown = " ".join(capsys.readouterr().out.split())
    for words in (
        "water density 1025 kg/m3, deep",
        "wind_sea jonswap on significant height 2.5 m, peak period 8 s, gamma 1, direction 150 deg",
        "current uniform on speed 0.6 m/s, to 180 deg",
        "wind on speed 12 m/s, direction 180 deg",
    ):
        assert words in shown
    assert sea.lines(kingpost.load("chain")) == []
    assert main(["check", "offshore_vessel"]) == 0
    assert "level: no waves act" in capsys.readouterr().out


def test_masses_of_ships_are_in_tonnes(capsys) -> None:
    assert main(["check", "offshore_vessel"]) == 0
    shown = capsys.readouterr().out
    assert "total mass: 5519 t" in shown
    assert "e+0" not in shown.split("drives")[0]


def test_a_summary_has_the_motion_of_a_cranes_tip_and_forces_before_the_rest(capsys) -> None:
    """Source: the same run in Python."""
    settings = {"simulation.duration_s": 2}
    assert main(["run", "lowering_by_winch", "--set", "simulation.duration_s=2"]) == 0
    lines = capsys.readouterr().out.splitlines()
    run = kingpost.run("lowering_by_winch", settings)
    tip = run["point"].values[0]
    (row,) = (line.split() for line in lines if line.startswith(f"{tip} "))
    expected = np.ptp(run["point_position"].sel(point=tip).values, axis=0)
    np.testing.assert_allclose([float(word) for word in row[1:4]], expected, atol=6e-5)
    heading = next(k for k, line in enumerate(lines) if line.startswith("force or drive"))
    assert lines[heading + 1].endswith("kN")


@pytest.mark.parametrize("shell", ["bash", "zsh"])
def test_shell_completions_are_printed(shell, capsys) -> None:
    with pytest.raises(SystemExit) as ended:
        main(["--print-completion", shell])
    assert ended.value.code == 0
    script = capsys.readouterr().out
    assert "roll-damping" in script
    assert "--displacement-raos" in script
