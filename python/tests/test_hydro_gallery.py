"""The stored databases of the gallery equal the present results of the commands in their README."""

import re
import shlex
from argparse import ArgumentParser, Namespace
from pathlib import Path

import hydro_samples as samples
import numpy as np
import pandas
import pytest
from kingpost import cli
from kingpost.analysis.displacement_raos import SENSES
from kingpost.hydro import checks, command, radiation_fit, read
from kingpost.hydro.airy import wave_number
from kingpost.hydro.build import database_hull, default_frequencies
from kingpost.hydro.database import Water
from kingpost.hydro.hull_options import parse_shape
from kingpost.hydro.meshes import HullMeshes, parametric
from lanes import sampled

FOLDER = Path(__file__).resolve().parents[2] / "scenarios" / "hydro"
ENDING = ".hydro.json"
# Of coefficients: seven digits are kept.
DIGITS = 1e-6


def written() -> list[list[str]]:
    """The commands of the README, their words after `kingpost`."""
    blocks = re.findall(r"```\n(.*?)```", (FOLDER / "README.md").read_text(), re.DOTALL)
    lines = "".join(blocks).replace("\\\n", " ").strip().splitlines()
    return [shlex.split(line)[1:] for line in lines]


def commands() -> dict[str, Namespace]:
    """The options of each command that makes a database, by the file that it writes."""
    parser = ArgumentParser()
    command.add_options(parser)
    found = [parser.parse_args(words[1:]) for words in written() if words[0] == "hydro"]
    for options in found:
        (options.hull,) = options.hull
    return {options.output: options for options in found}


COMMANDS = commands()
NAMES = sorted(COMMANDS)


def water(options: Namespace) -> Water:
    return Water(options.density_kg_m3 or Water.density_kg_m3, depth_m=options.water_depth_m)


def hull(options: Namespace) -> HullMeshes:
    return parametric(parse_shape(options.hull), options.hull, options.panels or command.PANELS)


def test_every_database_of_the_gallery_has_its_command():
    assert sorted(path.name for path in FOLDER.glob(f"*{ENDING}")) == NAMES


@pytest.mark.parametrize("name", NAMES)
def test_a_stored_database_passes_every_check(name):
    found = read(FOLDER / name)
    checks.check(found)
    damping = np.diagonal(found.radiation_damping, axis1=1, axis2=2)
    resolved = found.frequencies_rad_s <= checks.highest_resolved(found)
    assert resolved.sum() >= 20
    difference = np.abs(damping - checks.haskind_damping(found)) / checks.damping_scale(found)
    assert difference[resolved].max() < 0.05


@pytest.mark.parametrize("name", sampled(NAMES, keep=["barge.hydro.json"]))
def test_a_stored_hull_is_that_of_its_command(name):
    stored, options = read(FOLDER / name), COMMANDS[name]
    made = hull(options)
    today, plane = database_hull(made), stored.hull.waterplane
    assert stored.title == options.title
    assert stored.provenance.source == options.hull
    assert stored.provenance.panels == made.panel_count
    assert stored.water == water(options)
    for part in ("draught_m", "length_m", "beam_m", "volume_m3"):
        assert getattr(stored.hull, part) == pytest.approx(getattr(today, part), rel=DIGITS)
    size = today.length_m
    np.testing.assert_allclose(
        stored.hull.centre_of_buoyancy_m, today.centre_of_buoyancy_m, atol=DIGITS * size
    )
    for power, part in enumerate(("area_m2", "first_moments_m3", "second_moments_m4")):
        allowed = DIGITS * today.waterplane.area_m2 * size**power
        np.testing.assert_allclose(getattr(plane, part), getattr(today.waterplane, part), atol=allowed)
    np.testing.assert_allclose(stored.hull.mesh.vertices_m, today.mesh.vertices_m, atol=DIGITS * size)
    assert (stored.hull.mesh.triangles == today.mesh.triangles).all()
    np.testing.assert_allclose(
        stored.frequencies_rad_s, default_frequencies(made, water(options)), rtol=DIGITS
    )
    assert len(stored.wave_directions_rad) == options.directions
    assert (stored.mean_drift is None) == (options.loading is None)


@pytest.mark.parametrize("name", sampled(NAMES, keep=["barge.hydro.json"]))
def test_a_fit_to_the_stored_coefficients_is_the_stored_memory(name):
    stored = read(FOLDER / name)
    today = radiation_fit.fit(stored, highest_rad_s=COMMANDS[name].highest_rad_s)
    assert today.fit_error == pytest.approx(stored.radiation.fit_error, rel=1e-3)
    omega = np.append(stored.frequencies_rad_s, [0.0, 100.0])
    first, second = (radiation_fit.evaluate(model, omega) for model in (today, stored.radiation))
    peaks = np.abs(np.einsum("nii->ni", second)).max(axis=0)
    # The poles of the barge follow rounding 10^5 times enlarged; other libraries of linear algebra round
    # otherwise. This is a two-hundredth of what the fit may miss.
    assert (np.abs(first - second) <= 1e-4 * np.sqrt(np.outer(peaks, peaks))).all()


def test_the_stored_raos_equal_the_present_results_of_their_command(tmp_path, monkeypatch):
    """A motion that symmetry leaves out has rounding for its amplitude and any lag: amplitudes with their
    phases are compared."""
    (words,) = (words for words in written() if words[0] == "rao")
    monkeypatch.chdir(tmp_path)
    assert cli.main(words) == 0
    name = "supply_boat.raos.csv"
    stored, today = (pandas.read_csv(path, comment="#") for path in (FOLDER / name, tmp_path / name))
    assert list(stored) == list(today)
    np.testing.assert_allclose(stored.iloc[:, :2], today.iloc[:, :2], rtol=DIGITS)
    for sense in SENSES:
        (amplitude,) = (column for column in stored if column.startswith(sense))
        lag = f"{sense.split('_')[0]}_lag_deg"
        one, other = (table[amplitude] * np.exp(1j * np.deg2rad(table[lag])) for table in (stored, today))
        assert np.abs(one - other).max() < DIGITS * np.abs(other).max()


def cubic(x: np.ndarray, y: np.ndarray, at: np.ndarray) -> np.ndarray:
    """Through the four nearest points."""
    found = []
    for point in at:
        first = np.clip(np.searchsorted(x, point) - 2, 0, len(x) - 4)
        nodes, values = x[first : first + 4], y[first : first + 4]
        found.append(np.polynomial.Polynomial.fit(nodes, values, 3)(point))
    return np.array(found)


def test_the_stored_sphere_has_the_coefficients_of_hulmes_table():
    found, radius = read(FOLDER / "sphere.hydro.json"), 5.0
    mass = found.water.density_kg_m3 * 2 / 3 * np.pi * radius**3
    ka, added_mass, damping = samples.HULME.T
    omega = np.sqrt(found.water.gravity_m_s2 * ka / radius)
    stored = cubic(found.frequencies_rad_s, found.added_mass[:, 2, 2], omega) / mass
    np.testing.assert_allclose(stored, added_mass, rtol=0.02)
    stored = cubic(found.frequencies_rad_s, found.radiation_damping[:, 2, 2], omega) / mass / omega
    assert (np.abs(stored - damping) <= np.maximum(0.02 * damping, 0.005)).all()
    assert found.added_mass_infinite[2, 2] / mass == pytest.approx(samples.HULME_INFINITE, rel=0.02)


def test_the_stored_barge_floats_as_a_block_and_head_seas_lift_it_as_a_box():
    found = read(FOLDER / "barge.hydro.json")
    hull, plane, weight = found.hull, found.hull.waterplane, 1025 * 9.80665
    length, beam, draught = 20.0, 10.0, 2.0
    volume = length * beam * draught
    assert hull.volume_m3 == pytest.approx(volume, rel=1e-3)
    bm = plane.second_moments_m4[[2, 0]] / hull.volume_m3
    np.testing.assert_allclose(bm, [beam**2 / (12 * draught), length**2 / (12 * draught)], rtol=1e-3)
    # Of buoyancy alone: C33 = rho g L B, C44 = rho g V (BM + z_B), C55 alike.
    assert weight * plane.area_m2 == pytest.approx(weight * length * beam, rel=1e-3)
    lever = bm + hull.centre_of_buoyancy_m[2]
    closed = [beam**2 / (12 * draught) - draught / 2, length**2 / (12 * draught) - draught / 2]
    np.testing.assert_allclose(weight * hull.volume_m3 * lever, weight * volume * np.array(closed), rtol=1e-3)
    head = found.froude_krylov[:, len(found.wave_directions_rad) // 2, 2]
    k = np.array([wave_number(omega, found.water) for omega in found.frequencies_rad_s])
    exact = np.exp(-k * draught) * np.sinc(k * length / (2 * np.pi))
    assert (np.abs(head / (weight * length * beam) - exact) < 0.01).all()
