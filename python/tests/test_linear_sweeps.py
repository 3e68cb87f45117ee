"""Modes along a sweep, their files, and the command that prints them."""

from __future__ import annotations

import kingpost
import numpy as np
import pytest
import xarray
from kingpost.analysis.vibration import frame, write
from kingpost.cli import main
from samples import DAMPING, read_csv, rod

G = 9.80665


def test_a_sweep_tracks_a_mode_that_crosses_another(hang):
    """Source: two rods that do not meet; the frequency of one passes the other's, sqrt(3 g / 2 L)."""
    scenario = hang(rod("left", "left", 1.0), rod("right", "right", 1.2))
    heights = np.linspace(0.2, 0.9, 8)
    found = kingpost.modes(scenario, sweep={"bodies.left.joint.revolute.child_position_m.2": heights})
    sweep = found.kind.dims[0]
    assert found.sizes == {sweep: 8, "mode": 2, "coordinate": 2}
    moment = 3 * 1.0**2 / 12
    left = np.sqrt(3 * G * heights / (moment + 3 * heights**2))
    number = int(found.mode[found.named_after.isel({sweep: 0}) == "left"].item())
    assert set(found.named_after.sel(mode=number).values) == {"left"}
    assert found.angular_frequency.sel(mode=number).values == pytest.approx(left, rel=1e-12)
    other = found.angular_frequency.sel(mode=3 - number).values
    assert other == pytest.approx(np.full(8, np.sqrt(1.5 * G / 1.2)), rel=1e-12)
    # They pass one another, so that order by frequency would have mixed them.
    assert 0 < np.sum(left > other) < 8


def test_a_sweep_through_critical_damping_ends_and_begins_tracks(hang):
    """Source: the critical damping 2 sqrt(J k)."""
    critical = 2 * np.sqrt(4 * 3 * G)
    shares = np.array([0.5, 0.9, 1.1, 2.0])
    found = kingpost.modes(hang(rod(), parameters=DAMPING), sweep={"damping": shares * critical})
    assert found.sizes["damping"] == 4
    assert found.kind.values.tolist() == [
        ["oscillation", ""],
        ["oscillation", ""],
        ["decay", "decay"],
        ["decay", "decay"],
    ]
    assert found.damping_ratio.values[:2, 0] == pytest.approx(shares[:2], rel=1e-12)
    assert np.isnan(found.damping_ratio.values[:2, 1]).all()
    slow_and_fast = shares[2:, None] + np.array([[-1, 1]]) * np.sqrt(shares[2:, None] ** 2 - 1)
    rates = 1 / found.time_constant.values[2:] / np.sqrt(3 * G / 4)
    assert np.sort(rates, axis=1) == pytest.approx(slow_and_fast, rel=1e-9)
    # Each keeps its place.
    assert np.argmax(rates, axis=1).tolist() in ([0, 0], [1, 1])


@pytest.mark.parametrize("sweep", [{}, {"a": [1], "b": [2]}, {"damping": []}])
def test_a_sweep_has_one_name_and_some_values(hang, sweep):
    """Source: the public contract."""
    with pytest.raises(kingpost.KingpostError, match="sweep: found"):
        kingpost.modes(hang(rod(), parameters=DAMPING), sweep=sweep)


def test_the_error_of_a_sweep_names_the_value_at_which_it_failed(hang):
    """Source: the public contract."""
    with pytest.raises(kingpost.KingpostError, match="damping = -1: "):
        kingpost.modes(hang(rod(), parameters=DAMPING), sweep={"damping": [1, -1]})


def test_modes_are_written_and_read_back(hang, tmp_path):
    """Source: the round trip."""
    for found in (
        kingpost.modes("chain"),
        kingpost.modes(hang(rod(), parameters=DAMPING), sweep={"damping": [1, 100]}),
    ):
        again = xarray.load_dataset(write(found, tmp_path / "modes.nc"), engine="h5netcdf")
        xarray.testing.assert_identical(again, found)
        table = read_csv(write(found, tmp_path / "modes.csv"), keep_default_na=False, na_values=["nan"])
        assert len(table) == found.kind.size
        assert table["kind"].tolist() == found.kind.values.ravel().tolist()
        assert set(table.columns) == set(frame(found).columns)
        name = found.coordinate.values[0]
        assert f"shape.{name}" in table.columns
    with pytest.raises(kingpost.KingpostError, match=r"\.nc, \.csv"):
        write(found, tmp_path / "modes.parquet")


def test_the_command_prints_modes_and_writes_them(tmp_path, capsys):
    """Source: the public contract of `kingpost modes`."""
    output = tmp_path / "modes.csv"
    assert main(["modes", "chain", "--set=hold_rotation=on", "-o", str(output)]) == 0
    text = capsys.readouterr().out
    found = kingpost.modes("chain", hold_rotation=True)
    assert "at rest after" in text
    assert f"{found.frequency[0].item():.5g}" in text
    assert f"written  {output}" in text
    assert len(read_csv(output)) == 10


def test_the_command_prints_a_sweep(capsys):
    """Source: the public contract of `kingpost modes --sweep`."""
    assert main(["modes", "chain", "--set=hold_rotation=on", "--sweep=damping=0:200:3"]) == 0
    lines = capsys.readouterr().out.splitlines()
    values = [line.split()[0] for line in lines[-3:]]
    assert values == ["0", "100", "200"]
    assert all(" Hz" in line for line in lines[-3:])


@pytest.mark.parametrize("sweep", ["damping", "damping=1:2", "damping=1:2:0", "=1:2:3", "damping=1:nan:3"])
def test_a_wrong_sweep_is_wrong_input(sweep, capsys):
    """Source: the public contract: exit code 2, one line."""
    assert main(["modes", "chain", f"--sweep={sweep}"]) == 2
    assert capsys.readouterr().err.startswith(f"error: --sweep: found '{sweep}'")
