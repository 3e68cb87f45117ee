"""Rainflow counts and damage sums: the standard's own example, a sinusoid, narrow-banded noise."""

from __future__ import annotations

import math
from collections import Counter

import numpy as np
import pytest
import xarray
from kingpost import KingpostError
from kingpost.analysis import fatigue


def test_the_example_of_the_standard_is_counted_as_in_the_standard() -> None:
    """ASTM E1049-85, Fig. 6 and its table: the history A to I."""
    cycles = fatigue.rainflow([-2, 1, -3, 5, -1, 3, -4, 4, -2])
    counted: Counter[float] = Counter()
    for size, count in zip(cycles.ranges, cycles.counts, strict=True):
        counted[float(size)] += float(count)
    assert counted == {3.0: 0.5, 4.0: 1.5, 6.0: 0.5, 8.0: 1.0, 9.0: 0.5}


def test_values_between_reversals_and_flat_parts_change_nothing() -> None:
    turning = np.array([-2, 1, -3, 5, -1, 3, -4, 4, -2.0])
    fine = np.interp(np.arange(0, 8.01, 0.125), np.arange(9), turning)
    for record in (fine, np.repeat(turning, 3), np.repeat(fine, 2)):
        assert fatigue.rainflow(record).damage(3) == pytest.approx(fatigue.rainflow(turning).damage(3))
    assert fatigue.rainflow(np.full(100, 7.0)).count == 0


def test_a_record_that_only_rises_is_half_a_cycle() -> None:
    """ASTM E1049-85, 5.4.4: what is left over counts a half."""
    for record in ([0.0, 2.0], [0.0, 0.5, 0.5, 2.0]):
        cycles = fatigue.rainflow(record)
        assert (cycles.ranges.tolist(), cycles.count, cycles.damage(3)) == ([2.0], 0.5, 4.0)


@pytest.mark.parametrize("slope", [1.0, 3.0, 4.5])
def test_a_sinusoid_has_one_cycle_of_twice_its_amplitude_in_each_period(slope: float) -> None:
    """Source: arithmetic. The record begins and ends on a crest, and its rows have every crest and trough."""
    amplitude, periods, rows = 2.5, 40, 64
    record = 10 + amplitude * np.cos(2 * np.pi * np.arange(periods * rows + 1) / rows)
    cycles = fatigue.rainflow(record)
    assert cycles.count == pytest.approx(periods)
    assert cycles.damage(slope) == pytest.approx(periods * (2 * amplitude) ** slope, rel=1e-12)
    assert cycles.equivalent_range(slope) == pytest.approx(2 * amplitude, rel=1e-12)
    assert cycles.equivalent_range(slope, cycles=2 * periods) == pytest.approx(
        2 * amplitude * 0.5 ** (1 / slope), rel=1e-12
    )
    assert np.allclose(cycles.means, 10)


@pytest.mark.parametrize("slope", [3.0, 5.0])
def test_noise_with_a_narrow_band_has_the_damage_of_rayleigh_peaks(slope: float) -> None:
    """Gamma(1 + m/2): of the spectrum of a band 2 % wide. The sampling error is that of 20 records, found by
    their scatter; neighbouring ranges are alike, so that it is larger than that of as many free cycles."""
    duration_s, step_s, centre, width = 4000.0, 0.25, 0.8, 0.016
    rows = round(duration_s / step_s)
    omega = 2 * np.pi * np.fft.rfftfreq(rows, step_s)
    size = np.sqrt(np.exp(-0.5 * ((omega - centre) / width) ** 2) / (width * np.sqrt(2 * np.pi)) * omega[1])
    rng = np.random.default_rng(12)
    sums = []
    for _ in range(20):
        phasors = size * (rng.standard_normal(len(omega)) - 1j * rng.standard_normal(len(omega)))
        sums.append(fatigue.rainflow(3.0 * np.fft.irfft(phasors, rows) * rows / 2).damage(slope))
    mean, error = fatigue.expected(sums, duration_s, duration_s)
    closed = fatigue.narrow_band(3.0, 2 * np.pi / np.hypot(centre, width), duration_s, slope)
    assert closed == pytest.approx(
        duration_s * 0.8 / (2 * np.pi) * (2 * math.sqrt(2) * 3) ** slope * math.gamma(1 + slope / 2), rel=1e-3
    )
    assert error < 0.12 * closed
    assert abs(mean - closed) < 3 * error


def test_rayleigh_ranges_have_the_closed_form_to_their_sampling_error() -> None:
    """The same sum over drawn peaks: a million free cycles, each up and down."""
    peaks = np.random.default_rng(3).rayleigh(2.0, 200_000)
    cycles = fatigue.Cycles(2 * peaks, np.zeros_like(peaks), np.ones_like(peaks))
    for slope in (3.0, 5.0):
        closed = fatigue.narrow_band(2.0, 1.0, len(peaks), slope)
        deviation = math.sqrt(math.gamma(1 + slope) / math.gamma(1 + slope / 2) ** 2 - 1)
        assert cycles.damage(slope) == pytest.approx(closed, rel=4 * deviation / math.sqrt(len(peaks)))


def test_the_damage_of_each_run_is_summed_separately_and_is_nan_for_a_stopped_run() -> None:
    time = np.arange(0.0, 101.0)
    rows = np.stack([np.cos(np.pi * time), 2 * np.cos(np.pi * time), np.where(time < 50, 1.0, np.nan)])
    series = xarray.DataArray(
        rows, {"time": time, "seed": ("run", [1, 2, 3])}, ("run", "time"), "rope_tension", {"units": "N"}
    )
    found = fatigue.damage(series, (3, 5), after_s=20.0)
    assert found.dims == ("run", "slope")
    assert found.sel(slope=3).values[:2] == pytest.approx([40 * 2**3, 40 * 4**3])
    assert found.sel(slope=5).values[:2] == pytest.approx([40 * 2**5, 40 * 4**5])
    assert np.isnan(found.values[2]).all()
    assert found["cycles"].values[:2].tolist() == [40, 40]
    assert found["seed"].values.tolist() == [1, 2, 3]
    assert found.attrs == {"units": "(N)^m", "long_name": "damage sum of rope_tension", "duration_s": 80.0}


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: fatigue.rainflow([1.0]), "values: found 1, of them 0 NaN, allowed: two or more"),
        (lambda: fatigue.rainflow([1.0, np.nan]), "values: found 2, of them 1 NaN"),
        (lambda: fatigue.rainflow([1.0, 2.0]).damage(0), "slope: found 0, allowed"),
        (lambda: fatigue.rainflow([1.0, 1.0]).equivalent_range(3), "cycles: found 0, allowed"),
        (lambda: fatigue.expected([1.0], 1.0, 1.0), "sums: found 1 values, allowed: 2"),
        (lambda: fatigue.expected([1.0, 2.0], 0.0, 1.0), "record_s: found 0, allowed"),
    ],
)
def test_records_that_cannot_be_counted_are_refused_with_the_reason(call, message: str) -> None:
    with pytest.raises(KingpostError, match=message):
        call()
