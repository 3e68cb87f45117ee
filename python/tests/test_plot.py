"""Pictures of recorded runs: content, units, and refused input."""

from __future__ import annotations

import kingpost
import numpy as np
import pytest
from kingpost.cli import main
from kingpost.reports import plot
from kingpost.results import columns

SHORT = {"simulation.duration_s": 12.0}


@pytest.fixture(scope="module")
def lift():
    return kingpost.run("slew_and_land", SHORT)


def test_a_picture_has_a_panel_for_each_unit_with_the_numbers_in_it(lift) -> None:
    axes = plot.figure(lift, ["hull.roll", "*.rope_tension"]).axes
    assert [one.get_ylabel() for one in axes] == ["deg", "kN"]
    shown = {line.get_label(): line.get_ydata() for one in axes for line in one.get_lines()}
    roll = dict(columns(lift))["hull.roll"]
    np.testing.assert_allclose(shown["hull.roll"], np.rad2deg(roll))
    np.testing.assert_allclose(shown["hoist_rope.rope_tension"], lift.rope_tension.values[:, 0] / 1e3)


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("title", ["A \x1b[31mred ship", "Costs $\\frac{5$"])
def test_a_title_is_drawn_literally(lift, title: str, tmp_path) -> None:
    """Control characters have no glyph, and matplotlib reads text between two $ as mathematics."""
    plot.figure(lift.assign_attrs(title=title), ["hull.roll"]).savefig(tmp_path / "run.svg")


def test_limits_and_steps_of_the_operation_are_lines(lift) -> None:
    """Of the gallery's own file: a heel within 5 deg, at most 60 kN on the hook, "lift off" from 10 s on."""
    angle, force = plot.figure(lift, ["hull.roll", "hoist_rope.rope_tension"]).axes
    level = [
        [line.get_ydata()[0] for line in one.get_lines() if line.get_linestyle() == "--"]
        for one in (angle, force)
    ]
    assert level == [[-5.0, 5.0], [60.0]]
    upright = [line.get_xdata()[0] for line in force.get_lines() if line.get_linestyle() == ":"]
    assert upright == [0.0, 10.0]
    assert [text.get_text() for text in angle.texts] == ["wait with a slack rope", "lift off"]


def test_several_runs_share_a_panel() -> None:
    runs = [kingpost.run("paper", {"simulation.duration_s": 0.2}, crane_x_m=x) for x in (-10, 0)]
    (axes,) = plot.figure(runs, ["ship.roll"]).axes
    assert len(axes.get_lines()) == 2
    assert len(axes.get_legend().get_texts()) == 1


def test_by_default_columns_with_limits_come_before_the_main_columns(lift) -> None:
    names = [text.get_text() for text in plot.figure(lift).axes[0].get_legend().get_texts()]
    assert names[0] == "hull.roll"
    assert len(names) == plot.MOST_LINES
    (axes, *_) = plot.figure(kingpost.run("barge", SHORT)).axes
    assert axes.get_lines()


@pytest.mark.parametrize(("channels", "said"), [
    (["hull.rol"], "found 'hull.rol', allowed: columns"),
    (["*"], "columns in m, allowed: at most 8 of a unit"),
])  # fmt: skip
def test_an_unknown_column_and_too_many_columns_are_refused(lift, channels, said) -> None:
    with pytest.raises(kingpost.KingpostError, match=said.replace("*", r"\*")):
        plot.figure(lift, channels)


def test_the_command_line_writes_pictures_of_a_run_and_of_its_file(tmp_path, capsys) -> None:
    short = ["--set", "simulation.duration_s=0.2"]
    picture, results = tmp_path / "run.png", tmp_path / "run.nc"
    assert main(["run", "paper", *short, "-o", str(picture)]) == 0
    assert picture.read_bytes().startswith(b"\x89PNG")
    assert main(["run", "paper", *short, "-o", str(results)]) == 0
    vector = tmp_path / "run.svg"
    assert main(["plot", str(results), "--channels", "ship.roll", "-o", str(vector)]) == 0
    assert "<svg" in vector.read_text(encoding="utf-8")
    assert f"written  {vector}" in capsys.readouterr().out
    assert main(["plot", str(results), "-o", str(tmp_path / "run.gif")]) == 2
    assert "unknown ending, allowed: .png, .svg, .pdf" in capsys.readouterr().err
