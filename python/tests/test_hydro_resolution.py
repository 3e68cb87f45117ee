"""Number of wave directions and panels that a hull needs, and messages if there are too few."""

from __future__ import annotations

import re

import hydro_writers as writers
import numpy as np
import pytest
from kingpost.cli import main
from kingpost.errors import HydrodynamicsError
from kingpost.hydro import build, database_file, resolution
from kingpost.hydro.airy import wave_number
from kingpost.hydro.database import Water
from kingpost.hydro.hull_options import parse_shape
from kingpost.hydro.meshes import HullMeshes, parametric

BARGE = "box:length_m=20,beam_m=10,draught_m=2,depth_m=5"


def barge(panels: int) -> HullMeshes:
    return parametric(parse_shape(BARGE), BARGE, panels)


@pytest.mark.parametrize("length_m", [5.0, 80.0, 120.0])
@pytest.mark.parametrize("depth_m", [None, 20.0])
def test_the_directions_by_default_resolve_the_shortest_wave_and_twelve_fewer_do_not(length_m, depth_m):
    """Source: the rule itself, N >= k L, between its ends."""
    water, highest = Water(depth_m=depth_m), 1.8
    count = resolution.default_directions(length_m, highest, water)
    assert count % 12 == 0
    wave_m = 2 * np.pi / wave_number(highest, water)
    assert resolution.shortest_resolved_m(length_m, count) <= wave_m
    assert count == 24 or resolution.shortest_resolved_m(length_m, count - 12) > wave_m


@pytest.mark.parametrize("kr", [6.0, 12.0, 24.0])
def test_half_of_the_rules_directions_lose_a_wave_at_a_hull_and_one_and_a_half_times_resolve_it(kr):
    """Source: Jacobi and Anger: exp(i k R cos b) is the sum of i^n J_n(k R) exp(i n b), and J_n falls off
    fast beyond n = k R. Halfway between N directions the values are those of their N / 2 harmonics."""

    def error(count: int) -> float:
        angles = 2 * np.pi * np.arange(count) / count
        half = np.pi / count
        at, between = (np.exp(1j * kr * np.cos(angles + turned)) for turned in (0.0, half))
        harmonics = np.fft.fft(at) * np.exp(1j * half * np.fft.fftfreq(count, 1 / count))
        return np.abs(np.fft.ifft(harmonics) - between).max()

    rule = round(2 * kr)
    assert error(rule // 2) > 0.5
    assert error(3 * rule // 2) < 0.1


def test_the_command_prints_its_number_of_directions_and_uses_a_given_number(tmp_path, capsys, monkeypatch):
    """Source: the public contract; two frequencies of a barge of 20 m, the waves of the higher are 3.9 m."""
    taken = []

    def solve(_hull, _water, _frequencies, directions, *_others):
        taken.append(directions)
        raise HydrodynamicsError("solve", "a test", "no more than what is before it")

    monkeypatch.setattr(build, "solve", solve)
    words = ["hydro", BARGE, "-o", str(tmp_path / "a.hydro.json"), "--frequencies-rad-s", "0.5:4:9"]
    assert main([*words, "--panels", "900"]) == 2
    shown = capsys.readouterr().out
    assert re.search(r"wave directions +36\n", shown)
    assert "warning" not in shown
    assert main([*words, "--panels", "900", "--directions", "8"]) == 2
    shown = capsys.readouterr().out
    assert (
        "warning: 8 wave directions of the database resolve waves of 15.7 m and more about its 20.0 m"
        in shown
    )
    assert taken == [36, 8]


def test_an_imported_file_with_few_directions_gives_a_warning(tmp_path, capsys):
    """Source: the same rule; the sample has four directions about a hull of 12 m, 18.8 m."""
    base, source = writers.database(30.0, 40), tmp_path / "hull.h5"
    writers.write_bemio(source, base)
    given = ["--draught-m", "5", "--length-m=12", "--beam-m", "10", "--restoring-includes-weight", "yes"]
    assert main(["hydro", str(source), "-o", str(tmp_path / "hull.hydro.json"), *given]) == 0
    shown = re.search(
        r"warning: 4 wave directions of the database resolve waves of 18\.8 m and more about its 12\.0 m: "
        r"those from ([\d.]+) rad/s on are shorter",
        capsys.readouterr().out,
    )
    found = database_file.read(tmp_path / "hull.hydro.json")
    lengths_m = 2 * np.pi / np.array([wave_number(w, found.water) for w in found.frequencies_rad_s])
    first = found.frequencies_rad_s[lengths_m < 2 * np.pi * 12 / 4][0]
    assert float(shown[1]) == pytest.approx(first, rel=1e-3)


@pytest.mark.thorough
def test_the_error_for_too_few_panels_proposes_a_number_that_passes():
    """Source: the advice, taken."""
    pytest.importorskip("capytaine")
    frequencies = np.array([1.0, 1.819, 2.5])
    with pytest.raises(HydrodynamicsError, match=r"320 panels may be too few: try --panels \d+") as refused:
        build.build(barge(300), Water(), "barge", frequencies, 4)
    count = int(re.search(r"--panels (\d+)", str(refused.value))[1])
    assert build.build(barge(count), Water(), "barge", frequencies, 4).provenance.panels >= count


@pytest.mark.parametrize(
    ("panels", "draught_m", "has_lid", "says"),
    [
        (600, 2.0, True, "panels may be too few: try --panels 1300"),
        (600, 2.0, False, "without a lid (--lid) too: try --panels 1300"),
        # Panels of 0.49 m for a draught of 0.1 m: a lid wants them of 0.2 m.
        (600, 0.1, False, "leave no room for a lid: try --panels 5200"),
        (20_000, 2.0, True, "keep to lower frequencies"),
    ],
)
def test_the_advice_on_unphysical_coefficients_names_more_panels_or_a_lid(panels, draught_m, has_lid, says):
    """Source: twice the panels; a lid wants panels of twice the draught; 6000 are solved for at most."""
    text = f"box:length_m=20,beam_m=10,draught_m={draught_m},depth_m=5"
    assert says in build._remedy(parametric(parse_shape(text), text, panels), has_lid)
