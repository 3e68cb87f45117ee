"""Response amplitude operators of the gallery's ships: limits, symmetry, runs, files."""

from __future__ import annotations

import re

import kingpost
import numpy as np
import pytest
import xarray
from kingpost.analysis import response
from kingpost.cli import main

GRAVITY = 9.80665
# From rest at once on: the crane stands still, and the pendulum comes to rest.
STILL = {
    "bodies.tower.joint.revolute.mode": "held",
    "bodies.load.joint.universal.first.damping_N_m_s": 8000,
    "bodies.load.joint.universal.second.damping_N_m_s": 8000,
}


def test_long_waves_lift_a_ship_by_their_height_and_tilt_it_by_their_slope() -> None:
    """Source: a wave much longer than the ship is a plane that it lies on."""
    omega = 0.3
    slope = omega**2 / GRAVITY
    found = kingpost.rao("barge", [0.0, np.pi / 2], [omega], ["ship"], STILL)
    heave = response.complex_amplitude(found, "displacement").sel(point="ship", axis="z")
    turns = response.complex_amplitude(found, "rotation").sel(body="ship")
    # Dynamics are of order (w / w_n)^2, below 7 % (roll, at 1.2 rad/s or so), 3 % (heave, pitch).
    assert abs(heave.values.ravel() - 1).max() < 0.03
    # Waves to +x: the water rises ahead where the wave falls back, pitch (bow down) is -d zeta/dx.
    ahead = turns.sel(angle="pitch").isel(direction=0).item()
    aside = turns.sel(angle="roll").isel(direction=1).item()
    assert ahead == pytest.approx(-1j * slope, abs=0.1 * slope)
    assert aside == pytest.approx(1j * slope, abs=0.1 * slope)


def test_a_symmetric_ship_does_not_roll_in_a_head_sea() -> None:
    """Source: the vessel and its crane, along the middle line, are alike on both sides."""
    found = kingpost.rao("offshore_vessel", [np.pi])
    heave = found.displacement.sel(point="hull", axis="z")
    assert float(heave.max()) > 0.5
    assert float(found.displacement.sel(point="hull", axis="y").max()) < 1e-6
    assert np.rad2deg(found.rotation.sel(body="hull", angle=["roll", "yaw"]).max()) < 1e-5


@pytest.mark.parametrize("direction_deg", [180, 120])
def test_runs_in_a_small_regular_wave_have_the_amplitude_and_phase(direction_deg: float) -> None:
    """Source: the engine in time, from rest, when all else has died away; a least-squares sine."""
    period, height = 7.0, 0.02
    swell = {"height_m": height, "period_s": period, "direction_deg": direction_deg}
    overrides = STILL | {"sea.waves.swell": {"regular": swell}, "sea.ramp_s": 60,
                         "simulation.duration_s": 240, "simulation.step_s": 0.05}  # fmt: skip
    omega = 2 * np.pi / period
    found = kingpost.rao("barge", [np.deg2rad(direction_deg)], [omega], None, STILL)
    run = kingpost.run("barge", overrides)
    last = run.isel(time=run.time.values > run.time.values[-1] - 4 * period)
    wave = sine(last.wave_elevation.isel(hull=0), omega)
    assert abs(wave) == pytest.approx(height / 2, rel=1e-3)
    h = response.complex_amplitude(found, "displacement").squeeze()
    turns = response.complex_amplitude(found, "rotation").squeeze()
    joints = response.complex_amplitude(found, "joint_position").squeeze()
    for measured, expected in [
        (last.position.sel(body="ship", axis="z"), h.sel(point="ship", axis="z")),
        (last["pitch"].sel(body="ship"), turns.sel(body="ship", angle="pitch")),
        (last.point_position.sel(point="arm.tip", axis="z"), h.sel(point="arm.tip", axis="z")),
        (last.position.sel(body="load", axis="x"), h.sel(point="load", axis="x")),
        (last.joint_position.sel(coordinate="pendant.second"), joints.sel(coordinate="pendant.second")),
    ]:
        ratio = sine(measured, omega) / wave
        assert abs(ratio - expected.item()) < 0.01 * abs(expected.item()), measured.name


def sine(series: xarray.DataArray, omega: float) -> complex:
    """A of Re{A e^(-i w t)} beside a mean and a drift, by least squares."""
    t = series.time.values
    basis = np.stack([np.cos(omega * t), np.sin(omega * t), np.ones_like(t), t, t**2], axis=1)
    (a, b, *_), *_ = np.linalg.lstsq(basis, series.values, rcond=None)
    return complex(a, b)


def test_velocities_and_accelerations_are_those_of_the_displacement() -> None:
    found = kingpost.rao("barge", [1.0], [0.7, 1.4])
    omega = found.omega
    for k, rates in enumerate((found.velocity, found.acceleration), start=1):
        assert np.allclose(rates, (found.displacement * omega**k).transpose(*rates.dims))
    by_phase = response.complex_amplitude(found, "velocity")
    expected = -1j * omega * response.complex_amplitude(found, "displacement")
    assert np.allclose(by_phase, expected.transpose(*by_phase.dims))


def test_the_present_position_of_the_crane_is_used() -> None:
    """Source: the load's moment about the middle line changes as the crane swings out."""
    simulation = kingpost.Simulation("barge")
    before = kingpost.rao(simulation, [np.pi], [0.9])
    simulation.step(int(35 / 0.02))
    after = kingpost.rao(simulation, [np.pi], [0.9])
    assert kingpost.rao("barge", [np.pi], [0.9]).equals(before)
    tip = {"point": "arm.tip", "axis": "z"}
    # From astern, ten metres behind midships and more, to abeam of there: pitch lifts it less.
    assert float(after.displacement.sel(tip).item()) != pytest.approx(
        before.displacement.sel(tip).item(), rel=0.05
    )


def test_the_command_rao_writes_and_prints_the_values_of_the_data_set_and_writes_a_png(
    tmp_path, capsys
) -> None:
    grid = [
        "--directions-deg",
        "180",
        "210",
        "--frequencies-rad-s",
        "0.5:1.5:5",
        "--points",
        "ship",
        "arm.tip",
    ]
    files = {ending: str(tmp_path / f"rao.{ending}") for ending in ("nc", "csv", "png")}
    for file in files.values():
        assert main(["rao", "barge", *grid, "-o", file]) == 0
    shown = capsys.readouterr().out
    expected = kingpost.rao("barge", np.deg2rad([180, 210]), np.linspace(0.5, 1.5, 5), ["ship", "arm.tip"])
    stored = xarray.load_dataset(files["nc"], engine="h5netcdf")
    xarray.testing.assert_allclose(stored, expected)
    with open(files["csv"]) as lines:
        names, first = (line.strip().split(",") for line in (next(lines), next(lines)))
        assert {line.split(",")[0] for line in lines} == {"180.0", "210.0"}
    row = dict(zip(names, map(float, first), strict=True))
    assert (row["direction_deg"], row["frequency_rad_s"]) == (180, 0.5)
    tip = expected.displacement.sel(point="arm.tip", axis="z")
    assert row["arm.tip.displacement.z [m/m]"] == pytest.approx(float(tip[0, 0]))
    pitch = {"body": "ship", "angle": "pitch"}
    for name, quantity in (
        ("rotation_phase.pitch [deg]", "rotation_phase"),
        ("rotation.pitch [deg/m]", "rotation"),
    ):
        degrees = np.rad2deg(float(expected[quantity].sel(pitch)[0, 0]))
        assert row[f"ship.{name}"] == pytest.approx(degrees), "all angles of the file are in degrees"
    with open(files["png"], "rb") as picture:
        assert picture.read(4) == b"\x89PNG"
    line = re.search(r"^ *0\.500 +12\.57 +(.*)$", shown, re.MULTILINE)
    heave = float(line[1].split()[2])
    assert heave == pytest.approx(float(expected.displacement.sel(point="ship", axis="z")[0, 0]), abs=6e-4)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["paper"], "found no hull that waves act on"),
        (["barge", "--points", "mast.top"], "points: found 'mast.top', allowed: ship, "),
        (["barge", "--frequencies-rad-s", "1:90:3"], "which the database covers"),
        (["barge", "--frequencies-rad-s", "1:2"], "--frequencies-rad-s: found '1:2', allowed: from:to:n"),
        (["barge", "-o", "rao.txt"], "rao.txt: unknown ending, allowed: .nc, .csv, .png"),
    ],
)
def test_wrong_input_of_the_command_rao_is_refused_with_the_allowed_values(
    arguments: list[str], message: str, capsys
) -> None:
    assert main(["rao", *arguments]) == 2
    assert message in capsys.readouterr().err


@pytest.mark.parametrize("name", ["two_ships", "lift_off_from_barge"])
def test_default_frequencies_for_several_hulls_are_those_that_all_databases_cover(name) -> None:
    """Source: the databases: of the vessel 0.05984 to 2.618 rad/s, of the barge 0.09229 to 4.038."""
    frequency = kingpost.rao(name, [0.0]).omega.values
    assert (frequency[0], frequency[-1]) == (0.09229, 2.618)
    assert len(frequency) > 100
    assert (np.diff(frequency) > 0).all()


def test_default_frequencies_for_a_hull_are_those_of_the_engine() -> None:
    """Source: the engine, which refines a database in the same way."""
    found = kingpost.Simulation("barge").wave_response([0.0], [])
    assert kingpost.rao("barge", [0.0]).omega.values.tolist() == found["frequencies_rad_s"]


def test_directions_beyond_one_turn_are_refused(capsys) -> None:
    """Source: degrees where radians are meant are the likeliest mistake."""
    with pytest.raises(kingpost.KingpostError, match=r"directions: found 180 rad .* allowed: one turn"):
        kingpost.rao("barge", directions_rad=[180])
    assert main(["rao", "barge", "--directions-deg", "180", "999"]) == 2
    assert re.search(r"directions: found \S+ rad \(999 deg\), allowed: one turn", capsys.readouterr().err)
    assert main(["rao", "barge", "--directions-deg", "nan"]) == 2


def test_the_printed_lowest_and_highest_frequencies_are_accepted(capsys) -> None:
    """Source: what a person types after the message that names the range."""
    assert main(["rao", "offshore_vessel", "--frequencies-rad-s", "0.01:1:3"]) == 2
    low, high = re.search(r"allowed: ([\d.]+) to ([\d.]+) rad/s", capsys.readouterr().err).groups()
    assert (
        main(["rao", "offshore_vessel", "--directions-deg", "180", "--frequencies-rad-s", f"{low}:{high}:2"])
        == 0
    )
    assert main(["rao", "offshore_vessel", "--frequencies-rad-s", f"{float(low) - 0.001}:{high}:2"]) == 2


def test_a_resonance_between_two_frequencies_gets_a_frequency(capsys) -> None:
    assert main(["rao", "offshore_vessel", "--directions-deg", "90"]) == 0
    lines = capsys.readouterr().out.splitlines()
    rolls = [line.split() for line in lines if re.match(r" +\d\.\d{3} ", line)]
    (largest,) = (line.split() for line in lines if line.strip().startswith("largest"))
    roll_column = -3
    assert max(float(row[roll_column]) for row in rolls) == float(largest[roll_column])


def test_a_direction_or_frequency_given_twice_is_computed_once(capsys) -> None:
    """Source: an attack on the command line; a table of the same rows twice says nothing more."""
    found = kingpost.rao("barge", [np.pi, np.pi, 0.0], [0.5, 0.5, 1.0], ["ship"], STILL)
    assert list(found["direction"].values) == [np.pi, 0.0]
    assert list(found["omega"].values) == [0.5, 1.0]
    assert main(["rao", "barge", "--directions-deg", "180", "180", "--frequencies-rad-s", "0.5:1:2"]) == 0
    assert capsys.readouterr().out.count("180 deg") == 1
