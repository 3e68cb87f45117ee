"""Tension along lines with mass: labels, range graphs, fatigue by arc length, pictures."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import kingpost
import numpy as np
import pytest
from kingpost import cli, fatigue
from kingpost.study_report.blocks import Picture
from kingpost.study_report.runs import range_graphs
from line_samples import chain

POINTS = 11
LENGTH = "forces.chain.line.sections.0.unstretched_length_m"


def loaded(folder: Path, scenario: dict[str, Any]) -> kingpost.Scenario:
    path = folder / "chain.yaml"
    path.write_text(json.dumps(scenario))
    return kingpost.load(path)


@pytest.fixture(scope="module")
def scenario(tmp_path_factory: pytest.TempPathFactory) -> kingpost.Scenario:
    return loaded(tmp_path_factory.mktemp("along"), chain(points_along=POINTS))


@pytest.fixture(scope="module")
def ds(scenario):
    return kingpost.run(scenario)


def test_points_along_a_line_have_its_name_and_their_arc_length(ds):
    tension = ds["line_tension_along"]
    assert tension.dims == ("time", "line_point")
    assert tension.attrs["units"] == "N"
    assert set(ds["line_point_line"].values) == {"chain"}
    np.testing.assert_allclose(ds["line_point_share"], np.linspace(0, 1, POINTS), rtol=1e-15)
    np.testing.assert_allclose(ds["line_point_arc_length"], np.linspace(0, 850, POINTS), rtol=1e-15)
    assert ds["line_point_arc_length"].attrs["units"] == "m"
    for point, end in ((0, "line_tension"), (-1, "line_end_tension")):
        np.testing.assert_array_equal(tension.isel(line_point=point), ds[end].squeeze("line"))
    assert ds.kingpost["chain.point_1.line_tension_along"].equals(tension.isel(line_point=0))


def test_a_file_keeps_the_places_of_the_points(ds, tmp_path):
    kingpost.results.write(ds, tmp_path / "run.nc", ["chain.point_3.*"])
    again = kingpost.results.read(tmp_path / "run.nc")
    for name in ("line_tension_along", "line_point_line", "line_point_arc_length"):
        np.testing.assert_array_equal(again[name], ds[name])
    assert kingpost.range_graph(again, "chain").equals(kingpost.range_graph(ds, "chain"))


def test_a_line_without_points_has_no_range_graph(tmp_path):
    found = kingpost.run(loaded(tmp_path, chain(points_along=0)), {"simulation.duration_s": 0.25})
    assert "line_tension_along" not in found
    assert "line_touchdown" in found
    with pytest.raises(kingpost.KingpostError, match="no line of the run has points_along"):
        kingpost.range_graph(found, "chain")


def test_a_range_graph_is_the_statistics_of_each_point(ds):
    graph = kingpost.range_graph(ds, "chain", after_s=1.0)
    kept = ds["line_tension_along"].sel(time=slice(1.0, None)).values
    np.testing.assert_array_equal(graph["arc_length"], ds["line_point_arc_length"])
    np.testing.assert_array_equal(graph["least"], kept.min(axis=0))
    np.testing.assert_array_equal(graph["largest"], kept.max(axis=0))
    np.testing.assert_allclose(graph["mean"], kept.mean(axis=0), rtol=1e-14)
    np.testing.assert_allclose(graph["standard_deviation"], kept.std(axis=0), rtol=1e-12)
    assert graph.attrs["line"] == "chain"
    assert graph.attrs["first_time_s"] == 1.0
    with pytest.raises(kingpost.KingpostError, match="'wire', allowed: chain"):
        kingpost.range_graph(ds, "wire")


def test_lines_of_other_lengths_in_a_batch_are_over_their_share(scenario):
    lengths = [848, 851]
    found = kingpost.Batch(scenario, {LENGTH: lengths}).run()
    assert found["line_point_arc_length"].dims == ("run", "line_point")
    graph = kingpost.range_graph(found, "chain")
    assert graph["largest"].dims == ("run", "share")
    for run, length in enumerate(lengths):
        alone = kingpost.range_graph(kingpost.run(scenario, {LENGTH: length}), "chain")
        np.testing.assert_array_equal(graph["largest"].isel(run=run), alone["largest"])
        np.testing.assert_allclose(graph["arc_length"].isel(run=run), alone["arc_length"], rtol=1e-15)


def test_fatigue_by_arc_length_is_that_of_each_column(ds):
    found = kingpost.line_fatigue(ds, "chain", (3.0, 4.0))
    assert found["damage"].dims == ("arc_length", "slope")
    for point in range(POINTS):
        column = ds["line_tension_along"].isel(line_point=point)
        cycles = fatigue.rainflow(column.values)
        assert found["cycles"][point] == cycles.count
        for slope in (3.0, 4.0):
            one = found.isel(arc_length=point).sel(slope=slope)
            assert float(one["damage"]) == cycles.damage(slope)
            # Source: the same power by another formula.
            assert float(one["equivalent_range"]) == pytest.approx(cycles.equivalent_range(slope), rel=1e-12)


def test_the_main_columns_leave_the_points_out(ds):
    assert not any("point_" in name for name in ds.kingpost.statistics()["channel"])


def test_the_command_draws_a_range_graph(ds, tmp_path, capsys):
    kingpost.results.write(ds, tmp_path / "run.nc")
    run, picture = str(tmp_path / "run.nc"), tmp_path / "chain.svg"
    assert cli.main(["plot", run, "--range-graph", "chain", "-o", str(picture)]) == 0
    assert "<svg" in picture.read_text()
    assert cli.main(["plot", run, "--range-graph", "wire", "-o", str(picture)]) == 2
    assert "'wire'" in capsys.readouterr().err
    assert cli.main(["plot", run, "--after-s", "1", "-o", str(picture)]) == 2
    assert cli.main(["plot", run, "--range-graph", "--channels", "chain.*", "-o", str(picture)]) == 2


def test_the_picture_has_a_panel_for_each_line(ds):
    drawn = ds.kingpost.range_graph(after_s=1.0)
    assert [axes.get_ylabel() for axes in drawn.axes] == ["chain, kN"]
    mean = drawn.axes[0].lines[0]
    np.testing.assert_allclose(mean.get_ydata(), kingpost.range_graph(ds, "chain", 1.0)["mean"] / 1e3)


def test_the_report_of_a_study_has_the_range_graphs_of_a_worst_run(ds):
    (picture,) = range_graphs(3, ds)
    assert isinstance(picture, Picture)
    assert "run_3.nc --range-graph" in picture.origin
    assert range_graphs(3, kingpost.run("paper", {"simulation.duration_s": 0.001})) == []
