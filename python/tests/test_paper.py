"""`kingpost paper`: its output is complete, computed by the engine, and agrees with its text."""

from __future__ import annotations

import contextlib
import io
import xml.etree.ElementTree as ElementTree
from html.parser import HTMLParser
from pathlib import Path

import kingpost
import numpy as np
import pandas
import pytest
from kingpost.cli import main
from samples import read_csv


@pytest.fixture(scope="module")
def command(tmp_path_factory) -> tuple[Path, str]:
    """One run of the README's command, shared: its folder and what it printed."""
    folder, printed = tmp_path_factory.mktemp("paper"), io.StringIO()
    with contextlib.redirect_stdout(printed), contextlib.chdir(folder):
        assert main(["paper", "-o", "results"]) == 0
    return folder / "results", printed.getvalue()


@pytest.fixture(scope="module")
def folder(command) -> Path:
    return command[0]


def test_the_summary_shows_the_largest_rates_and_the_path_of_the_page(command):
    """Source: the figures' own data; four decimals are printed."""
    folder, printed = command
    rates = read_csv(folder / "figure_11.csv")
    largest = [f"{rates[f'{name}_rate_damped_rad_s'].abs().max():.4f}" for name in ("pitch", "yaw", "roll")]
    line = next(
        line for line in printed.splitlines() if line.startswith("Fig. 11, both motors, with damping")
    )
    assert line.split()[-3:] == largest
    assert str(Path("results") / "index.html") in printed


def test_the_command_writes_every_file(folder):
    """Source: the public contract of the command."""
    expected = {"index.html", "table_2.csv", "table_2.md"}
    for name in ("figure_9", "figure_10", "figure_11", "integrators"):
        expected |= {f"{name}.{ending}" for ending in ("csv", "png", "svg")}
    assert {path.name for path in folder.iterdir()} == expected
    for path in folder.glob("*.png"):
        assert path.read_bytes().startswith(b"\x89PNG\r\n\x1a\n")
    for path in folder.glob("*.svg"):
        ElementTree.parse(path)


@pytest.mark.parametrize("number", [9, 10, 11])
def test_the_numbers_of_the_figures_are_those_of_the_engine(folder, number):
    """Source: the same run through the public interface."""
    motors = {9: (True, False), 10: (False, True), 11: (True, True)}[number]
    table = read_csv(folder / f"figure_{number}.csv")
    case = {"crane_x_m": 0, "crane_y_m": 0, "load": False, "motor_1": motors[0], "motor_2": motors[1]}
    case["simulation.record_every_s"] = 0.001
    for suffix, damping in (("", False), ("_damped", True)):
        rate = kingpost.run("paper", case, damping=damping)["angular_velocity"].sel(body="ship")
        for name, axis in (("pitch", "y"), ("yaw", "z"), ("roll", "x")):
            assert np.array_equal(table[f"{name}_rate{suffix}_rad_s"], rate.sel(axis=axis)), name


def test_figure_9_passes_through_the_calibration_row(folder):
    """Source: three independent codes at 0.5 s."""
    table = read_csv(folder / "figure_9.csv").set_index("time_s")
    row = table.iloc[np.argmin(np.abs(table.index - 0.5))]
    found = [row["pitch_rate_rad_s"], row["yaw_rate_rad_s"], row["roll_rate_rad_s"]]
    assert found == pytest.approx([0.19709, -0.12348, -0.07719], abs=1e-5)


def test_the_arm_motor_alone_only_pitches_the_ship(folder):
    """Source: symmetry: with the arm in the ship's middle plane nothing rolls or yaws it."""
    table = read_csv(folder / "figure_10.csv")
    assert table["pitch_rate_rad_s"].abs().max() > 0.1
    assert table[["yaw_rate_rad_s", "roll_rate_rad_s"]].abs().max().max() < 1e-9


def test_table_2_equals_that_of_the_paper(folder):
    """Source: the paper's Table 2, and the damping of its results section."""
    table = read_csv(folder / "table_2.csv").set_index("symbol")["value"]
    expected = {
        "m^{(1)}": 10_000, "m^{(2)}": 500, "m^{(3)}": 500, "m^{(4)}": 1000, "d^{(1)}": -10, "b^{(1)}": -5,
        "l^{(2)}": 3.5, "l^{(3)}": 3.5, "r^{(2)}": 0.5, "r^{(3)}": 0.5, "L_{ps}": 10, "L_{sb}": 20,
        "L_{h}": 5, "M^{(1)}": 100_000, "M^{(2)}": 70_000,
        r"\zeta_1": 500_000, r"\zeta_2": 25_000, r"\zeta_3": 0,
    }  # fmt: skip
    assert table.to_dict() == expected


def errors(folder: Path, integrator: str, column: str) -> pandas.Series:
    """Errors of an integrator on the paper's case, by step."""
    table = read_csv(folder / "integrators.csv")
    rows = table[(table["case"] == "paper") & (table["integrator"] == integrator)]
    return rows.set_index("step_s")[column]


def test_the_integrators_errors_fall_with_their_order(folder):
    """Source: the schemes' orders, between 5 and 10 ms."""
    for name, order in (
        ("forward_euler", 1), ("midpoint_euler", 1), ("semi_implicit_euler", 1), ("rk4", 4),
        ("newmark", 2), ("generalized_alpha", 2), ("implicit_midpoint", 2),
    ):  # fmt: skip
        for column in ("energy_error_relative", "momentum_error_N_m_s"):
            coarse, fine = errors(folder, name, column).loc[[0.01, 0.005]]
            assert np.log2(coarse / fine) == pytest.approx(order, abs=0.4), (name, column)


def test_dormand_princes_errors_fall_with_its_tolerance(folder):
    """Source: error control: the error goes with a power near one of the tolerance."""
    table = read_csv(folder / "integrators.csv")
    rows = table[(table["case"] == "paper") & (table["integrator"] == "dormand_prince")].set_index(
        "tolerance"
    )
    power = np.log10(rows["slew_error_rad"][1e-3] / rows["slew_error_rad"][1e-8]) / 5
    assert 0.7 < power < 1.3
    assert rows["evaluations_per_s"].is_monotonic_increasing


def test_only_implicit_integrators_step_over_the_stiff_spring(folder):
    """Source: stability limits: h omega of 2.83 for RK4 at 350 rad/s, none for implicit ones."""
    table = read_csv(folder / "integrators.csv")
    at_20_ms = table[(table["case"] == "stiff") & (table["step_s"] == 0.02)].set_index("integrator")
    for name in ("newmark", "generalized_alpha", "implicit_midpoint"):
        assert at_20_ms["slew_error_rad"][name] < 0.05, name
    for name in ("forward_euler", "semi_implicit_euler", "rk4"):
        assert name not in at_20_ms.index or not at_20_ms["energy_error_relative"][name] < 1, name


def test_forward_eulers_energy_error_is_the_known_one(folder):
    """Source: an independent code: +0.25 % at 1 ms, +2.4 % at 10 ms, both motors, no load."""
    error = errors(folder, "forward_euler", "energy_error_relative")
    assert error[0.001] == pytest.approx(0.0025, abs=2e-4)
    assert error[0.01] == pytest.approx(0.024, abs=2e-3)


def test_the_page_is_self_contained_and_has_all_ten_remarks(folder):
    """Source: the public contract; a page that loads nothing can be sent by mail."""
    page = Page((folder / "index.html").read_text(encoding="utf-8"))
    assert page.count["li", "remark"] == 10
    assert page.count["img", ""] == 4
    assert page.count["math", ""] > 20
    assert all(source.startswith("data:image/svg+xml;base64,") for source in page.sources)
    assert not page.problems


def test_the_page_states_that_the_arm_goes_down_and_how_to_lift_it(folder):
    """Source: eqs. 40 and 59 integrated by an independent code: pitch peaks at 1.292 and 0.905 rad/s with the
    torque of Table 2, at 1.347 and 0.869 rad/s with the opposite one."""
    page = (folder / "index.html").read_text(encoding="utf-8")
    assert "Pitch then peaks at 1.292 rad/s, with damping at 0.905 rad/s." in page
    assert "the peaks are 1.347 and 0.869 rad/s" in page


def test_an_unwritable_folder_is_exit_code_2(capsys):
    """Source: the public contract."""
    assert main(["paper", "-o", "/proc/paper"]) == 2
    assert capsys.readouterr().err.count("\n") == 1


class Page(HTMLParser):
    """Counts a page's elements and checks that they close in order."""

    VOID = ("meta", "img", "link", "br")

    def __init__(self, text: str) -> None:
        super().__init__()
        self.open: list[str] = []
        self.problems: list[str] = []
        self.sources: list[str] = []
        self.count: dict[tuple[str, str], int] = {}
        self.feed(text)
        self.problems += [f"{tag} is not closed" for tag in self.open]

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        key = (tag, attributes.get("class", "") if tag == "li" else "")
        self.count[key] = self.count.get(key, 0) + 1
        self.sources += [attributes[name] for name in ("src",) if name in attributes]
        if tag not in self.VOID:
            self.open.append(tag)

    def handle_endtag(self, tag):
        if not self.open or self.open.pop() != tag:
            self.problems.append(f"{tag} closes nothing")
