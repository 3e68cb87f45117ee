"""The stored databases of the gallery are what the commands of their README give with the code of today."""

import re
import shlex
from argparse import ArgumentParser, Namespace
from pathlib import Path

import numpy as np
import pytest
from kingpost.hydro import checks, command, radiation_fit, read
from kingpost.hydro.build import database_hull, default_frequencies
from kingpost.hydro.database import Water
from kingpost.hydro.meshes import HullMeshes, parametric

FOLDER = Path(__file__).resolve().parents[2] / "scenarios" / "hydro"
ENDING = ".hydro.json"
# Of coefficients: seven digits are kept.
DIGITS = 1e-6


def commands() -> dict[str, Namespace]:
    """The options of each command of the README, by the file that it writes."""
    block = re.search(r"```\n(.*?)```", (FOLDER / "README.md").read_text(), re.DOTALL).group(1)
    lines = block.replace("\\\n", " ").strip().splitlines()
    parser = ArgumentParser()
    command.add_options(parser)
    found = [parser.parse_args(shlex.split(line)[2:]) for line in lines]
    return {options.output: options for options in found}


COMMANDS = commands()
NAMES = sorted(COMMANDS)


def water(options: Namespace) -> Water:
    return Water(options.density_kg_m3 or Water.density_kg_m3, depth_m=options.water_depth_m)


def hull(options: Namespace) -> HullMeshes:
    return parametric(command.parse_shape(options.hull), options.hull, options.panels)


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


@pytest.mark.parametrize("name", NAMES)
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


@pytest.mark.parametrize("name", NAMES)
def test_a_fit_to_the_stored_coefficients_is_the_stored_memory(name):
    stored = read(FOLDER / name)
    today = radiation_fit.fit(stored)
    assert today.fit_error == pytest.approx(stored.radiation.fit_error, rel=1e-3)
    omega = np.append(stored.frequencies_rad_s, [0.0, 100.0])
    first, second = (radiation_fit.evaluate(model, omega) for model in (today, stored.radiation))
    peaks = np.abs(np.einsum("nii->ni", second)).max(axis=0)
    # The poles of the barge follow rounding 10^5 times enlarged; other libraries of linear algebra round
    # otherwise. This is a two-hundredth of what the fit may miss.
    assert (np.abs(first - second) <= 1e-4 * np.sqrt(np.outer(peaks, peaks))).all()
