"""Response of every column to regular waves: runs in time, closed forms, reasons, errors."""

from __future__ import annotations

import kingpost
import numpy as np
import pytest
import xarray
from kingpost.analysis import response, wave_response
from kingpost.results.columns import columns

HELD = {"bodies.pedestal.joint.revolute.mode": "held"}
# Damped so that what the growing waves have stirred is gone when it is measured.
PENDULUM = HELD | {
    "bodies.load.joint.universal.first.damping_N_m_s": 1e6,
    "bodies.load.joint.universal.second.damping_N_m_s": 1e6,
    "simulation.begin_at_equilibrium": True,
}
# A module of 200 t on eight falls, free of the deck, its timeline off: rope, drives and load chart.
ROPE = {
    "timeline": False,
    "forces.hoist_rope.rope.unstretched_length_m": 340,
    "bodies.module.joint.floating.initial.position_m": [-4.8, -1.57, 16.0],
    "forces.deck.contact.enabled": False,
    "forces.swing.viscous_damping.linear_N_s_m": [1e5, 1e5, 1e5],
}
PERIOD_S, DIRECTION_DEG, HEIGHT_M = 7.0, 120.0, 0.02


@pytest.mark.parametrize(
    ("name", "still", "least"), [("offshore_vessel", PENDULUM, 120), ("barge_crane_200t", ROPE, 190)]
)
def test_every_column_of_a_run_in_a_small_regular_wave_has_its_amplitude_phase_and_mean(
    name, still, least
) -> None:
    """Source: the engine in time, over whole periods when all else has died away; a least-squares sine.

    At 1 cm what is of second order is a thousandth; it is all that some energies have.
    """
    swell = {"height_m": HEIGHT_M, "period_s": PERIOD_S, "direction_deg": DIRECTION_DEG}
    sea = {"sea.waves": {"swell": {"regular": swell}}, "sea.ramp_s": 60, "simulation.duration_s": 200}
    omega = 2 * np.pi / PERIOD_S
    found = kingpost.wave_response(name, None, [np.deg2rad(DIRECTION_DEG)], [omega], still)
    h = response.complex_amplitude(found, "response").isel(direction=0, omega=0)
    run = kingpost.run(name, still | sea)
    last = run.isel(time=run.time.values > run.time.values[-1] - 4 * PERIOD_S)
    measured = dict(columns(last))
    wave = sine(measured["water.wave_elevation"], omega)
    compared = [
        (str(one.item()), complex(h.sel(column=one).item()), str(unit.item()))
        for one, unit, linear in zip(found.column, found.mean_unit, found.linear, strict=True)
        if linear and unit != "J"
    ]
    assert len(compared) > least
    largest: dict[str, float] = {}
    for _, expected, unit in compared:
        largest[unit] = max(largest.get(unit, 0.0), abs(expected))
    for column, expected, unit in compared:
        off = abs(sine(measured[column], omega) / wave - expected)
        assert off < 2e-3 * abs(expected) + 1e-5 * largest[unit], (column, expected)
        rest = float(found["mean"].sel(column=column))
        assert abs(float(measured[column].mean()) - rest) < 1e-3 * (abs(rest) + largest[unit]), column


def sine(series: xarray.DataArray, omega: float) -> complex:
    """A of Re{A e^(-i w t)} beside a mean and a drift, by least squares."""
    t = series.time.values
    basis = np.stack([np.cos(omega * t), np.sin(omega * t), np.ones_like(t), t, t**2], axis=1)
    (a, b, *_), *_ = np.linalg.lstsq(basis, series.values, rcond=None)
    return complex(a, b)


def test_places_angles_and_coordinates_are_those_of_the_motions() -> None:
    """Source: `kingpost.rao`, by the bodies' Jacobians instead of the rows of results: to rounding."""
    waves = ([0.5, 2.0], [0.4, 0.8, 1.3])
    motions = kingpost.rao("offshore_vessel", *waves)
    names = ["hull.position.x", "load.position.y", "boom.tip.point_position.z", "hull.roll", "load.pitch"]
    names += ["pendant.first.joint_position"]
    h = response.complex_amplitude(kingpost.wave_response("offshore_vessel", names, *waves), "response")
    places = response.complex_amplitude(motions, "displacement")
    angles = response.complex_amplitude(motions, "rotation")
    joints = response.complex_amplitude(motions, "joint_position")
    expected = [
        places.sel(point="hull", axis="x"),
        places.sel(point="load", axis="y"),
        places.sel(point="boom.tip", axis="z"),
        angles.sel(body="hull", angle="roll"),
        angles.sel(body="load", angle="pitch"),
        joints.sel(coordinate="pendant.first"),
    ]
    for name, motion in zip(names, expected, strict=True):
        assert np.allclose(h.sel(column=name), motion, rtol=1e-9, atol=1e-12), name


def test_a_resonance_has_frequencies_as_close_as_its_peak_is_narrow() -> None:
    """Source: |H|^2 of one motion falls to half at a decay beside its peak."""
    found = kingpost.wave_response("offshore_vessel", ["hull.roll"], [np.pi / 2], overrides=HELD)
    omega = found.omega.values
    pairs = zip(found.attrs["resonances_rad_s"], found.attrs["resonance_decays_per_s"], strict=True)
    narrow = [(w, d) for w, d in pairs if omega[0] < w < omega[-1] and d < 0.03]
    assert len(narrow) >= 3, "roll and both swings of the load"
    for resonance, decay in narrow:
        nearest = np.sort(np.abs(omega - resonance))[:3]
        assert nearest[0] < 1e-6, resonance
        assert nearest[-1] <= 0.5 * decay, (resonance, decay)


def test_columns_without_linear_response_have_a_reason() -> None:
    names = [
        "time",
        "kinetic_energy",
        "work_done",
        "momentum_error",
        "water.drift_force.force_x",
        "hull.roll",
    ]
    found = kingpost.wave_response("offshore_vessel", names, [0.5], [0.8])
    assert found.linear.values.tolist() == [False, False, False, False, False, True]
    reasons = wave_response.REASONS
    expected = ["over_time", "second_order", "over_time", "not_smooth", "second_order"]
    assert found.reason.values[:-1].tolist() == [reasons[reason] for reason in expected]
    assert np.isnan(found.response.values[:-1]).all()
    assert np.isfinite(found.response.values[-1]).all()


def test_effects_left_out_at_rest_give_a_warning() -> None:
    drag = {"quadratic_damping": {"body": "hull", "angular_N_m_s2": [1e8, 0, 0]}}
    found = kingpost.wave_response("offshore_vessel", ["hull.roll"], [0.5], [0.8], {"forces.bilges": drag})
    assert "leaves out quadratic damping" in found.attrs["warning"]


def test_columns_are_named_by_patterns_and_unknown_ones_are_refused() -> None:
    found = kingpost.wave_response("offshore_vessel", ["hull.position.*", "hull.position.z"], [0.5], [0.8])
    assert found.column.values.tolist() == ["hull.position.x", "hull.position.y", "hull.position.z"]
    with pytest.raises(kingpost.KingpostError, match=r"columns: found 'hull.rol', allowed: .* as hull.roll"):
        kingpost.wave_response("offshore_vessel", ["hull.rol"])
    with pytest.raises(kingpost.KingpostError, match="overrides: found some for a simulation"):
        kingpost.wave_response(kingpost.Simulation("barge"), ["ship.roll"], overrides={"waves": True})
