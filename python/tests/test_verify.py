"""`kingpost verify`: its rows pass, a failing row is reported, every format contains every row."""

from __future__ import annotations

import json
import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from kingpost import KingpostError, verify
from kingpost.cli import main
from kingpost.verify import cylinders, flume_forces, report, rolling, rows, running
from kingpost.verify import spheres as measured_spheres
from roll_samples import ikeda_cylinders, kvlcc2_sections

FEWEST = 60
QUICK = ("multibody", "paper", "loops")
DOCS = Path(__file__).resolve().parents[2] / "docs"
PAGE, CONTROL = ((DOCS / name).read_text(encoding="utf-8") for name in ("validation.md", "control.md"))


@pytest.fixture(scope="module")
def measured() -> list[verify.Row]:
    """Every row, measured once."""
    return verify.run()


@pytest.fixture(scope="module")
def quick() -> list[verify.Row]:
    """The rows of the areas that take no panel method."""
    return [row for area in QUICK for row in verify.run(area)]


def test_the_rows_without_a_panel_method_pass(quick) -> None:
    assert {row.area for row in quick} == set(QUICK)
    assert [(row.id, row.error, row.message) for row in quick if row.verdict == verify.FAILED] == []


def swap(monkeypatch, one: verify.Check, measure) -> None:
    """Let a row be measured by another function."""
    changed = [replace(check, measure=measure) if check is one else check for check in rows.CHECKS]
    monkeypatch.setattr(running, "CHECKS", changed)


@pytest.mark.thorough
def test_there_are_enough_rows_and_every_one_passes(measured) -> None:
    counted = [row for row in measured if row.verdict != verify.ABSENT]
    assert len(counted) >= FEWEST
    assert [(row.id, row.error, row.message) for row in counted if row.verdict != verify.PASSED] == []


@pytest.mark.thorough
def test_every_area_has_a_row_with_a_source_and_a_reason_for_its_tolerance(measured) -> None:
    assert {row.area for row in measured} == set(verify.AREAS)
    assert len({row.id for row in measured}) == len(measured)
    for row in measured:
        assert row.source, row.id
        assert row.why, row.id
        # Two instruments of one test are a sixth apart: half of that, and the wave.
        assert 0 < row.tolerance < 0.12, row.id


def test_a_wrong_row_fails_and_so_does_the_command(monkeypatch, capsys) -> None:
    one = next(check for check in running.checks("loops") if check.id == "stay-force")

    def spoilt() -> verify.Compared:
        found = one.measure()
        return replace(found, theirs=1.01 * found.theirs)

    swap(monkeypatch, one, spoilt)
    assert main(["verify", "--only", "loops"]) == 1
    assert re.search(r"FAIL stay-force: off by 0\.0099, allowed 1e-09", capsys.readouterr().out)


def test_a_row_that_raises_fails_and_names_the_exception(monkeypatch, capsys) -> None:
    def broken() -> verify.Compared:
        raise ZeroDivisionError("no wave")

    one = running.checks("loops")[0]
    swap(monkeypatch, one, broken)
    assert main(["verify", "--only", "loops"]) == 1
    assert f"FAIL {one.id}: ZeroDivisionError: no wave" in capsys.readouterr().out


def test_a_program_that_is_not_installed_is_reported_and_not_counted(monkeypatch, capsys) -> None:
    def absent() -> verify.Compared:
        raise verify.NotInstalledError("mujoco")

    one = running.checks("loops")[0]
    swap(monkeypatch, one, absent)
    assert main(["verify", "--only", "loops"]) == 0
    shown = capsys.readouterr().out
    assert f"not installed {one.id}: mujoco" in shown
    assert "1 not counted" in shown


def test_a_nan_does_not_pass() -> None:
    one = running.checks("loops")[0]
    found = rows.measured(replace(one, measure=lambda: verify.Compared(float("nan"), 1.0)))
    assert found.verdict == verify.FAILED


@pytest.mark.parametrize("chosen", ["quick", pytest.param("measured", marks=pytest.mark.thorough)])
def test_markdown_json_html_and_text_contain_every_row(chosen, request) -> None:
    measured = request.getfixturevalue(chosen)
    names = [row.id for row in measured]
    kept = json.loads(report.as_json(measured))
    assert [row["id"] for row in kept["rows"]] == names
    assert kept["counts"]["pass"] == sum(row.verdict == verify.PASSED for row in measured)
    markdown, page, text = report.markdown(measured), report.page(measured), report.text(measured)
    for row in measured:
        assert f"| {row.id} |" in markdown
        assert f'<tr id="{row.id}">' in page
        assert re.search(rf"^{re.escape(row.id)} ", text, re.MULTILINE)
    assert "src=" not in page
    assert "<link" not in page


@pytest.mark.thorough
def test_the_pictures_are_those_of_the_pages(measured, tmp_path, capsys) -> None:
    """Those measured before are not measured again."""
    assert main(["verify", "--plots", str(tmp_path)]) == 0
    drawn = {path.name for path in tmp_path.iterdir()}
    assert drawn == set(re.findall(r"\(validation/(\w+\.png)\)", PAGE + CONTROL))
    assert all((tmp_path / name).read_bytes().startswith(b"\x89PNG") for name in drawn)


@pytest.mark.thorough
def test_the_page_agrees_with_the_present_measurements(measured) -> None:
    """Source: the rows; the page has three decimals."""
    found = {row.id: row for row in measured}
    ours = re.search(r"^\| ours \| (.*) \|$", PAGE, re.MULTILINE)[1].split(" | ")
    for number, printed in enumerate(ours, start=1):
        row = found[f"sphere-extremum-{number}"]
        assert row.ours is None or abs(float(printed) - row.ours) < 6e-4
    for name, label in (("flume-heave", "heave period, s"), ("flume-gm", "GM, m")):
        theirs, printed = re.search(rf"^\| {label} \| (\S+) \| (\S+) \|", PAGE, re.MULTILINE).groups()
        row = found[name]
        assert row.ours is None or (float(theirs), abs(float(printed) - row.ours) < 1e-3) == (
            row.theirs,
            True,
        )


def numbers_of(heading: str, label: str) -> list[float]:
    """The numbers of a line of a table of the page, under a heading."""
    under = PAGE.split(f"### {heading}")[1].split("\n### ")[0]
    line = next(line for line in under.splitlines() if line.startswith(f"| {label} |"))
    return [float(cell) for cell in re.findall(r"(?<=\| )-?[\d.]+(?= \|)|(?<=\| )-?[\d.]+(?= %)", line)]


@pytest.mark.thorough
def test_the_page_agrees_with_the_present_results_of_the_held_section(measured) -> None:
    for omega in (4.143, 5.194, 6.065, 8.578):
        period = f"{2 * np.pi / omega:.3f}"
        _, *printed = numbers_of("Forces and mean drift of that section, held", period)
        ours = flume_forces.held(omega)
        np.testing.assert_allclose(printed[0::2], flume_forces.HELD[omega], atol=6e-4)
        np.testing.assert_allclose(printed[1::2], ours, atol=6e-4)


@pytest.mark.thorough
def test_the_page_agrees_with_the_present_results_of_the_cylinders(measured) -> None:
    names = (
        "sway added mass",
        "sway damping",
        "heave added mass",
        "heave damping",
        "sway force",
        "heave force",
    )
    for name, quantity in zip(names, ("a22", "b22", "a33", "b33", "F2", "F3"), strict=True):
        printed = numbers_of("Vugts' cylinders: added mass, damping and wave forces", name)
        for i, shape in enumerate(cylinders.VUGTS):
            share, theirs = cylinders.VUGTS[shape][quantity][1]
            ours = cylinders.section(shape).at(quantity, share)
            assert printed[4 * i : 4 * i + 3] == pytest.approx([share, theirs, ours], abs=3e-3)
            points = cylinders.VUGTS[shape][quantity]
            missed = [abs(cylinders.section(shape).at(quantity, at) - value) for at, value in points]
            largest = max(missed) / max(value for _, value in points)
            assert printed[4 * i + 3] == pytest.approx(100 * largest, abs=0.6)


@pytest.mark.thorough
def test_the_page_lists_every_excluded_point_of_the_cylinders_with_its_error(measured) -> None:
    under = PAGE.split("### Vugts' cylinders")[1].split("\n### ")[0]
    printed = re.findall(r"^\| (\w+), ([\w ]+) \| ([\d.]+) \| (-?[\d.]+) % \|$", under, re.MULTILINE)
    rows_of = {row.id for row in measured}
    found = {
        (shape, cylinders.WHAT[quantity].removesuffix(" of beam waves"), share):
            100 * cylinders.miss(shape, quantity, number)
        for shape, curves in cylinders.VUGTS.items()
        for quantity, points in curves.items()
        for number, (share, _) in enumerate(points)
        if f"vugts-{shape}-{quantity}-{number + 1}" not in rows_of
    }  # fmt: skip
    assert all(abs(value) > 100 * cylinders.TOLERANCE for value in found.values())
    named = {(shape, name, float(share)): float(value) for shape, name, share, value in printed}
    assert named == pytest.approx(found, abs=0.1)


def test_the_page_lists_every_rolling_cylinder_beyond_the_tolerance_of_the_formulas() -> None:
    under = " ".join(PAGE.split("### Eddies of ten rolling cylinders")[1].split("\n### ")[0].split())
    named = {name: float(share) for name, share in re.findall(r"([A-L]) by (\d+) %", under)}
    ratios = {row[0]: rolling.eddies(i) / np.mean(row[-1]) for i, row in enumerate(rolling.CYLINDERS)}
    missed = {name: 100 * abs(ratio - 1) for name, ratio in ratios.items() if name not in rolling.MET}
    assert named == pytest.approx(missed, abs=0.6)
    # What a row takes is the scatter of the tests, by the curves of A and of B.
    spread = {row[0]: np.ptp(row[-1]) / np.mean(row[-1]) for row in rolling.CYLINDERS}
    tolerances = {name: tolerance for name, (tolerance, _) in rolling.MET.items()}
    expected = {"A": spread["A"] / 2, "B": spread["B"] / 2, "J": spread["B"], "K": spread["B"]}
    assert tolerances == pytest.approx(expected, abs=6e-4)
    assert all(value > 100 * spread["B"] for value in missed.values())


@pytest.mark.thorough
def test_the_page_agrees_with_the_present_results_of_the_tanker_and_the_rolling_cylinders(measured) -> None:
    heading = "A tanker's roll decay, its damping from its sections"
    for label, swing in (("amplitude after 10 swings, degrees", 10), ("after 20", 20), ("after 29", 29)):
        theirs, ours = numbers_of(heading, label)[:2]
        assert (theirs, ours) == pytest.approx((rolling.SWINGS[swing], rolling.decay()[1][swing]), abs=6e-3)
    amplitudes = np.radians([3.0, 5.0, 9.0])
    ours = rolling.tanker(amplitudes).total.values + rolling.RADIATED[1]
    theirs = rolling.tanker_measured(amplitudes)[1]
    for i, label in enumerate(("damping at 3 degrees, N m s", "at 5 degrees", "at 9 degrees")):
        assert numbers_of(heading, label)[:2] == pytest.approx([theirs[i], ours[i]], abs=6e-3)
    ratios = numbers_of("Eddies of ten rolling cylinders", "ours / measured")
    found = [rolling.eddies(i) / np.mean(row[-1]) for i, row in enumerate(rolling.CYLINDERS)]
    np.testing.assert_allclose(ratios, found, atol=6e-3)


@pytest.mark.thorough
def test_the_page_agrees_with_the_present_results_of_spheres(measured) -> None:
    printed = numbers_of("A sphere of 5 m let go from 1 m", "Kingpost")
    np.testing.assert_allclose(printed, measured_spheres.decay()[1][1:5], atol=6e-5)
    printed = numbers_of("Mean drift of a free hemisphere", "Kingpost")
    np.testing.assert_allclose(printed, measured_spheres.drift()[1:], atol=2e-3)


def test_the_table_of_the_tankers_sections_is_that_of_the_tests() -> None:
    ours = rolling.Sections.of_table({
        "x_m": [row[0] for row in rolling.SECTIONS], "beam_m": [row[1] for row in rolling.SECTIONS],
        "draught_m": [row[2] for row in rolling.SECTIONS], "area_m2": [row[3] for row in rolling.SECTIONS],
    })  # fmt: skip
    theirs = kvlcc2_sections()
    for name in ("x_m", "beam_m", "draught_m", "area_coefficient"):
        one = getattr(ours.scaled(1 / rolling.SCALE), name)
        np.testing.assert_allclose(one, getattr(theirs, name), rtol=1e-12)
    measured = [(row["section"], row["eddy_coefficient"]) for row in ikeda_cylinders()]
    assert measured == [(row[0], value) for row in rolling.CYLINDERS for value in row[-1]]


def test_the_command_writes_what_it_is_asked_for(tmp_path, capsys) -> None:
    files = {ending: tmp_path / f"rows.{ending}" for ending in ("markdown", "json", "html")}
    asked = [word for name, path in files.items() for word in (f"--{name}", str(path))]
    assert main(["verify", "--only", "loops", *asked]) == 0
    assert "rows, " in capsys.readouterr().out
    for path in files.values():
        assert "stay-force" in path.read_text(encoding="utf-8")


def test_an_unknown_area_and_a_missing_folder_are_refused(tmp_path, capsys) -> None:
    with pytest.raises(KingpostError, match="area: found 'magic', allowed: multibody, "):
        verify.run("magic")
    assert main(["verify", "--only", "loops", "--json", str(tmp_path / "none" / "rows.json")]) == 2
    assert "found no folder" in capsys.readouterr().err
