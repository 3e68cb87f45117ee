"""Report of a study: its numbers equal those of the store, and a browser shows it without a network."""

from __future__ import annotations

import html
import json
import re
import shutil
import subprocess
from pathlib import Path
from typing import Any

import kingpost
import numpy as np
import pytest
import xarray
from kingpost import browser, link
from kingpost.cli import main
from kingpost.study.limiting import runs as limiting_runs
from kingpost.study.screening.cases import of_plan
from kingpost.study.study import Study
from kingpost.study_report import limiting, pdf, report
from kingpost.study_report.blocks import Picture, Table

ROOT = Path(__file__).resolve().parents[2]
CHECK = ROOT / "web" / "tests" / "browser" / "report.mjs"
SCATTER = "# classes: centres\nHs\\Tp, 8, 10, 12\n0.5, 10, 20, 5\n1.5, 2, 15, 10\n2.5, 1, 5, 8\n"
STUDY: dict[str, Any] = {
    "version": 1,
    "title": "Crane over the stern",
    "scenario": "offshore_vessel",
    "set": {
        "waves": True,
        "simulation.duration_s": 60,
        "simulation.record_every_s": 0.5,
        "bodies.pedestal.joint.revolute.mode": "held",
    },
    "axes": {"significant_height_m": {"values": [0.5, 1, 3]}, "peak_period_s": {"values": [8, 12]}},
    "seeds": {"count": 5},
    "after_s": 30,
    "record": ["hull.pitch"],
    "limits": {
        "roll": {"column": "hull.roll", "within": 1, "unit": "deg"},
        "heave": {"column": "hull.position.z", "within": 30, "unit": "m"},
    },
    "operation_s": 600,
}


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> tuple[Study, Path, str]:
    """A study with its results and its report."""
    folder = tmp_path_factory.mktemp("study")
    (folder / "scatter.csv").write_text(SCATTER, encoding="utf-8")
    import yaml

    path = folder / "stern.yaml"
    path.write_text(yaml.safe_dump(STUDY | {"scatter": "scatter.csv"}, sort_keys=False), encoding="utf-8")
    study = Study(path)
    study.run(folder / "out", workers=1)
    page = report.write(study.plan, folder / "out", folder / "report.html")
    return study, folder, page.read_text(encoding="utf-8")


def cells(page: str, caption: str) -> list[list[str]]:
    """The rows of the table whose caption begins so."""
    table = re.search(rf"<caption>{re.escape(caption)}.*?</table>", page, re.DOTALL)
    assert table, caption
    rows = re.findall(r"<tr>(.*?)</tr>", table[0], re.DOTALL)
    return [[html.unescape(cell) for cell in re.findall(r"<td[^>]*>(.*?)</td>", row)] for row in rows[1:]]


def test_the_limits_of_the_report_equal_those_of_the_store(made: tuple[Study, Path, str]) -> None:
    """Source: the store, counted here once more."""
    _, folder, page = made
    runs = kingpost.open_study(folder / "out")
    for name, column, _, held, worst, where in cells(page, "Limits over all runs"):
        of = runs.sel(limit=name)
        assert column == of["limit_column"].item()
        assert held == f"{int((of['limit_held'] == 1).sum())} of 30"
        margin = np.minimum(of["limit_worst"] - of["at_least"], of["at_most"] - of["limit_worst"]).values
        assert float(worst) == pytest.approx(float(of["limit_worst"][int(margin.argmin())]), rel=1e-3)
        assert where.startswith(f"run {int(margin.argmin())}: ")


def test_limiting_heights_of_the_report_equal_those_of_both_methods(made: tuple[Study, Path, str]) -> None:
    study, folder, page = made
    by_runs = limiting_runs.limiting_heights(kingpost.open_study(folder / "out"))
    for period, height, _, governs in cells(page, "Limiting significant height by runs"):
        one = by_runs.sel(peak_period_s=float(period))
        assert governs == one["governs"].item()
        known = float(one["limiting_height_of_all"])
        assert height == (f"{known:.2f}" if 0.5 <= known < 3 else "below 0.5" if known == 0 else "above 3")
    screened = of_plan(study.plan)
    for period, height, _, governs in cells(page, "Limiting significant height by linear response"):
        one = screened.sel(peak_period_s=float(period))
        assert (height, governs) == (f"{float(one['limiting_height_of_all']):.2f}", one["governs"].item())


def test_many_limiting_heights_are_shown_in_a_table_of_two_axes_and_in_panels() -> None:
    """Source: the heights themselves, made up."""
    heights = np.arange(1, 31, dtype=float).reshape(3, 10) / 10
    dims = ("peak_period_s", "wave_direction_deg")
    found = xarray.Dataset(
        {"limiting_height_of_all": (dims, heights), "governs": (dims, np.full((3, 10), "roll"))},
        coords={"peak_period_s": [8.0, 8.72727, 10.0], "wave_direction_deg": np.arange(90, 190, 10)},
        attrs={"acceptance": 0.1, "operation_s": 1800.0, "sea_peak_period": "peak_period_s"},
    )
    blocks = limiting.section("none were run", found).blocks
    picture = next(block for block in blocks if isinstance(block, Picture))
    assert "10 panels" in picture.description
    matrix, whole = (block for block in blocks if isinstance(block, Table))
    assert matrix.head == ("peak_period_s", *(str(k) for k in range(90, 190, 10)))
    assert [row[0] for row in matrix.rows] == ["8", "8.727", "10"]
    assert [[float(cell) for cell in row[1:]] for row in matrix.rows] == heights.tolist()
    assert len(whole.rows) == 30


def test_every_table_and_picture_states_the_origin_of_its_numbers(
    made: tuple[Study, Path, str],
) -> None:
    page = made[2]
    assert page.count("<table>") == page.count('<p class="origin">') > 8
    for text in re.findall(r'<p class="origin">(.*?)</p>|<figcaption>(.*?)</figcaption>', page):
        assert re.search(r"Files?:|Command:", "".join(text)), text


def test_the_link_of_a_worst_run_opens_the_same_run_in_the_app(made: tuple[Study, Path, str]) -> None:
    """Source: the scenario of the run, by its number."""
    study, _, page = made
    number, address = re.findall(r"<p>Run (\d+): .*?<a href=\"([^\"]*)\">Open this run", page, re.DOTALL)[0]
    scenario = study.scenario.with_overrides(study.overrides(int(number)))
    assert html.unescape(address) == report.APP + link.fragment(scenario)


def test_a_repeated_run_has_the_numbers_of_the_study(
    made: tuple[Study, Path, str], capsys: pytest.CaptureFixture[str]
) -> None:
    _, folder, _ = made
    words = ["study", str(folder / "stern.yaml"), "-o", str(folder / "out"), "--repeat", "7"]
    assert main(words) == 0
    assert "run_7.nc" in capsys.readouterr().out
    again = kingpost.results.read(folder / "out" / "run_7.nc")
    runs = kingpost.open_study(folder / "out")
    pitch = again.kingpost["hull.pitch"]
    expected = runs["statistics"].sel(run=7, column="hull.pitch", statistic="maximum")
    assert float(pitch[again["time"] >= 30].max()) == float(expected)


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["--report", "a.docx", "-o", "out"], "unknown ending, allowed: .html, .pdf"),
        (["--repeat", "30", "-o", "out"], "--repeat: found 30, allowed: a run from 0 to 29"),
        (["--report", "a.html"], "--report: found no -o, allowed: with -o DIR alone"),
    ],
)
def test_incompatible_options_of_a_report_are_refused(
    made: tuple[Study, Path, str],
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    words: list[str],
    message: str,
) -> None:
    monkeypatch.chdir(made[1])
    assert main(["study", "stern.yaml", *words]) == 2
    assert message in capsys.readouterr().err


def test_the_report_contains_the_measured_verification(made: tuple[Study, Path, str]) -> None:
    study, folder, page = made
    assert "The checks were not run for this report" in page
    row = {"id": "a", "area": "waves", "what": "b", "verdict": "pass", "message": ""}
    rows = [row, row | {"id": "c", "verdict": "FAIL", "message": "off by 1"}]

    counts = {"pass": 1, "FAIL": 1, "not installed": 0}
    written = json.dumps({"kingpost": "0.1.0", "counts": counts, "rows": rows})
    (folder / "out" / "verification.json").write_text(written, encoding="utf-8")
    again = report.write(study.plan, folder / "out", folder / "again.html").read_text(encoding="utf-8")
    assert cells(again, "Checks, measured") == [["waves", "1", "1"], ["all", "1", "1"]]
    assert cells(again, "Checks that failed") == [["c", "b", "off by 1"]]


@pytest.mark.parametrize("size", [("1280", "900"), pytest.param(("390", "844"), marks=pytest.mark.thorough)])
def test_the_report_is_accessible_in_a_browser_without_a_network(
    made: tuple[Study, Path, str], size: tuple[str, str]
) -> None:
    """Source: axe-core's rules, and that no table is cut on A4."""
    has_node = shutil.which("node") is not None and (ROOT / "web/node_modules").is_dir()
    if browser.find_browser() is None or not has_node:
        pytest.skip("no browser, or no Node, on this machine")
    command = ["node", str(CHECK), str(made[1] / "report.html"), *size]
    done = subprocess.run(command, capture_output=True, text=True, timeout=300, check=False)
    assert done.returncode == 0, done.stderr


def test_a_pdf_without_a_browser_is_refused_before_the_runs(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.delenv(browser.VARIABLE, raising=False)
    monkeypatch.setattr(browser, "BROWSERS", ())
    file = tmp_path / "study.yaml"
    limit = "{roll: {column: ship.roll, within: 5, unit: deg}}"
    file.write_text(f"version: 1\ntitle: Roll\nscenario: barge\nlimits: {limit}\n", encoding="utf-8")
    assert main(["study", str(file), "-o", str(tmp_path / "runs"), "--report", str(tmp_path / "a.pdf")]) == 2
    assert "PDF: found no browser" in capsys.readouterr().err
    assert not (tmp_path / "runs").exists()


@pytest.mark.thorough
def test_the_report_prints_to_pdf(made: tuple[Study, Path, str]) -> None:
    if browser.find_browser() is None:
        pytest.skip("no browser on this machine")
    path = pdf.write(made[1] / "report.html", made[1] / "report.pdf")
    assert path.read_bytes().startswith(b"%PDF-")
