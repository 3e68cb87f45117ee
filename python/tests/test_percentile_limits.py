"""Limits that must hold for a percentage of the time, in runs, batches, studies and linear responses.

Source: the order statistics of the rows themselves, and the Gaussian distribution.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import kingpost
import numpy as np
import pytest
import yaml
from kingpost.study.limiting.largest import Maxima
from kingpost.study.study import Study

PENDULUM = """version: 1
title: A pendulum
simulation: {step_s: 0.05, duration_s: 20, record_every_s: 0.1}
bodies:
  bob:
    mass_kg: 1
    shape: {point: {}}
    joint: {revolute: {name: pin, axis: [0, 1, 0], child_position_m: [0, 0, 1], initial_angle_deg: 10}}
forces: {gravity: {gravity: {}}}
"""
PERCENTILES = (50.0, 90.0, 95.0, 99.5, 100.0)


def limits(at_most_deg: float, **more: Any) -> dict[str, Any]:
    return {
        f"p{k}": {
            "column": "pin.joint_position",
            "at_most": at_most_deg,
            "unit": "deg",
            "percentile": p,
            **more,
        }
        for k, p in enumerate(PERCENTILES)
    }


@pytest.fixture
def pendulum(tmp_path: Path) -> Path:
    (tmp_path / "pendulum.yaml").write_text(PENDULUM, encoding="utf-8")
    return tmp_path / "pendulum.yaml"


def expected(values: np.ndarray, percentile: float) -> float:
    """Value that is exceeded in the allowed share of the rows."""
    allowed = int(np.floor((1 - percentile / 100) * len(values) * (1 + 1e-12)))
    return float(np.sort(values)[::-1][allowed])


def test_a_run_reports_the_value_that_its_percentile_of_the_rows_keeps(pendulum: Path) -> None:
    run = kingpost.run(pendulum, {"limits": limits(9.0)})
    angle = np.rad2deg(run.joint_position.sel(coordinate="pin").values)
    for k, percentile in enumerate(PERCENTILES):
        worst = expected(angle, percentile)
        assert float(run.limit_worst[k]) == pytest.approx(worst, rel=1e-12)
        assert int(run.limit_held[k]) == int(worst <= 9.0)
        at = int(np.argmin(abs(run.time.values - float(run.limit_worst_time[k]))))
        assert angle[at] == pytest.approx(worst, rel=1e-12)
    assert run.limit_percentile.values.tolist() == list(PERCENTILES)
    # A rigid pendulum at 10 degrees is above 9 for acos(0.9) / pi = 14 % of the time.
    assert run.limit_held.values.tolist() == [1, 0, 0, 0, 0]


def test_an_earlier_file_without_percentiles_is_of_all_rows(pendulum: Path, tmp_path: Path) -> None:
    from kingpost.results.entries import limits_of
    from kingpost.results.kept import is_of_a_run

    run = kingpost.run(pendulum, {"limits": limits(9.0)}).drop_vars("limit_percentile")
    assert is_of_a_run(run)
    assert {limit["percentile"] for limit in limits_of(run)} == {100.0}


@pytest.mark.parametrize("percentile", [0, 100.5, -5])
def test_a_percentile_beyond_its_range_is_refused(pendulum: Path, percentile: float) -> None:
    wrong = {"limits": {"swing": {"column": "pin.joint_position", "at_most": 1, "percentile": percentile}}}
    with pytest.raises(kingpost.KingpostError, match=r"limits\.swing\.percentile: .*allowed: "):
        kingpost.load(pendulum).with_overrides(wrong).model  # noqa: B018


def test_a_study_keeps_the_percentile_of_each_run_and_extrapolates_none(pendulum: Path) -> None:
    axes = {"bodies.bob.joint.revolute.initial_angle_rad": {"values": [0.1, 0.2]}}
    study = {"version": 1, "title": "Swing", "scenario": "pendulum.yaml", "seeds": {"count": 3}, "axes": axes}
    study["limits"] = limits(9.0)
    (pendulum.parent / "study.yaml").write_text(yaml.safe_dump(study), encoding="utf-8")
    runs = Study(pendulum.parent / "study.yaml").run(pendulum.parent / "out", workers=1)
    alone = kingpost.run(
        pendulum, {"limits": limits(9.0), "bodies.bob.joint.revolute.initial_angle_rad": 0.2}
    )
    assert runs["limit_worst"].values[-1] == pytest.approx(alone.limit_worst.values, rel=1e-12)
    maxima = Maxima.of_limits(runs)
    assert maxima.of_share.tolist() == [True, True, True, True, False]
    # Ten times the record does not change a share of the time.
    worst = np.array([[1.0], [2.0], [4.0]])
    shares = replace(maxima, of_run=worst, record_s=np.array([20.0]), of_share=np.array([True]))
    of = [shares.largest(np.arange(3), 0, operation_s) for operation_s in (20.0, 200.0)]
    assert of[0] is not None
    assert of[1] is not None
    assert of[0].quantile(0.5) == of[1].quantile(0.5) == pytest.approx(2.0)
