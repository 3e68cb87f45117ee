"""Lines with mass compared with MoorDyn: its stored runs, closed forms, and the page."""

from __future__ import annotations

import json
import re
from pathlib import Path

import numpy as np
import pytest
from kingpost import verify
from kingpost.simulation.simulate import run
from kingpost.verify import chain_tensions, lines, moored_lines, rows, running

PAGE = Path(__file__).resolve().parents[2] / "docs" / "validation.md"
KEPT = lines.kept()


def test_a_line_rests_as_a_catenary_and_as_in_moordyn() -> None:
    """Source: the rows, at rest."""
    still = [one for one in running.checks("lines") if re.search("rest|hanging", one.id)]
    assert len(still) == 3
    assert {rows.measured(one).verdict for one in still} == {verify.PASSED}


def test_the_kept_run_of_the_wire_has_the_amplitude_of_a_bar() -> None:
    """Source: closed forms. Lumped masses: MoorDyn is 5e-5 low with 80 segments."""
    theirs = np.array(KEPT["wire"]["half"]["segments"]["80"]["tension_N"])
    amplitude, natural = lines.bar()
    assert amplitude == pytest.approx(383_079.6, abs=0.1)
    assert 2 * np.pi / natural == pytest.approx(6.781, abs=1e-3)
    assert lines.harmonic(lines.sampled(), theirs) == pytest.approx(amplitude, rel=1e-4)


def test_the_catenary_of_the_chain_is_that_of_its_equations() -> None:
    """Source: the forces, put in the equations of Irvine for a line on a solid bottom."""
    chain = KEPT["chain"]
    pull, lift = lines.catenary(chain, True)
    weight = (685 - 1025 * np.pi / 4 * 0.333**2) * 9.80665
    hanging = lift / weight
    across = 850 - hanging + pull / weight * np.arcsinh(lift / pull) + pull * 850 / 3.27e9
    up = (np.hypot(pull, lift) - pull) / weight + lift**2 / (2 * 3.27e9 * weight)
    assert (across, up) == pytest.approx((779.6, 186.0), abs=1e-7)
    assert np.hypot(pull, lift) == pytest.approx(2_435_559.7, abs=0.1)


@pytest.mark.parametrize("name", ["lines", "fairleads", "moored_lines"])
def test_the_stored_runs_name_their_origin(name) -> None:
    script = (Path(__file__).parent / "peers" / f"{name}.py").read_text(encoding="utf-8")
    assert json.dumps(moored_lines.kept(name)["command"])[1:-1] in script


@pytest.mark.parametrize("depth_m", chain_tensions.CASES)
def test_chains_at_rest_have_the_tension_of_their_equations_and_about_the_published_one(depth_m) -> None:
    """Source: elastic catenary, and MoorDyn's `quasi_static_chain`."""
    exact, published = chain_tensions.closed_form(depth_m), chain_tensions.CASES[depth_m]["published_N"]
    assert chain_tensions.massless(depth_m) == pytest.approx(exact, rel=1e-12)
    assert chain_tensions.with_mass(depth_m) == pytest.approx(exact, rel=2e-4)
    assert exact == pytest.approx(published, rel=1.1e-2)


@pytest.mark.parametrize("sea", moored_lines.kept("fairleads")["heights_m"])
@pytest.mark.parametrize("side", moored_lines.SIDES)
def test_more_segments_change_little_in_the_stored_runs_of_a_moored_ship(side, sea) -> None:
    """Source: the stored runs, with 40 and 80 segments."""
    coarse, fine = moored_lines.kept("moored_lines")["lines"][side][sea]["segments"].values()
    for figure, bound in (("std_N", 5e-3), ("max_N", 5e-3), ("min_N", 1.5e-2)):
        assert abs(coarse[figure] - fine[figure]) < bound * (
            coarse["mean_N"] if figure == "min_N" else coarse[figure]
        )


@pytest.mark.parametrize("figure", moored_lines.FIGURES)
def test_the_chain_of_a_moored_ship_pulls_as_in_moordyn(figure) -> None:
    """Source: the stored runs."""
    for segments in (40, 80):
        assert moored_lines.compared("leeward", "moderate", figure, segments).error < 5e-3


def test_a_motion_is_that_of_its_speeds() -> None:
    """Source: the integral of straight lines between the speeds."""
    given = moored_lines.kept("fairleads")
    motion = given["motions"]["high"]["leeward"]
    speeds = 1e-3 * np.array(motion["speed_z_mm_s"])
    ends = motion["start_m"][2] + given["every_s"] * (speeds.sum() - speeds[-1] / 2)
    found = run(moored_lines.moored("leeward", "high", elements=4))
    assert found["joint_position"].sel(coordinate="fairlead").values[-1] + motion["start_m"][2] == (
        pytest.approx(ends, abs=1e-9)
    )


@pytest.mark.thorough
def test_the_page_agrees_with_the_present_results_of_lines() -> None:
    """Source: the rows; the page has bounds of their differences."""
    page = PAGE.read_text(encoding="utf-8").split("### Lines with mass")[1].split("\n## ")[0]
    printed = dict(re.findall(r"^\| .*\| `([a-z0-9-]+)` \| ([\d.e-]+) \|$", page, re.MULTILINE))
    found = {one.id: one for one in running.checks("lines")}
    assert set(printed) == set(found)
    for name, bound in printed.items():
        assert found[name].measure().error < float(bound) <= found[name].tolerance, name
