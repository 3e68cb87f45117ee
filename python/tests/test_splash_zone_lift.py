"""The lowering of docs/checked: forces in waves, slack and a snap agree with formulas by hand."""

from __future__ import annotations

from math import atan, cos, exp, hypot, pi, sqrt
from pathlib import Path

import kingpost
import numpy as np
import pytest

FILE = Path(__file__).resolve().parents[2] / "docs" / "checked" / "splash_zone.yaml"
RHO, G = 1.025, 9.80665
MASS_T, STEEL_M3, HEIGHT_M, SHADOW_M2 = 60.0, 12.0, 3.0, 24.0
ADDED_T = RHO * 0.8 * SHADOW_M2 * HEIGHT_M * (0.7 + 0.3 * cos(pi * 15 / 34))


def by_hand(
    draught_m: float, amplitude_m: float, period_s: float, lowering_m_s: float
) -> tuple[float, float]:
    """F_static and F_hyd of the simplified method of DNV-RP-N103, kN, with the tip at rest."""
    share = min(draught_m / HEIGHT_M, 1.0)
    centre_m = draught_m - HEIGHT_M / 2 if share == 1 else draught_m / 2
    w = 2 * pi / period_s
    water = amplitude_m * w * exp(-(w**2) * centre_m / G)
    square = 0.5 * RHO * (lowering_m_s + water) ** 2
    cut = draught_m < HEIGHT_M
    along = square * (2.5 * SHADOW_M2 * share + (50 if cut else 0))
    inertia = (RHO * STEEL_M3 + ADDED_T) * share * water * w
    buoyancy = RHO * G * STEEL_M3 / HEIGHT_M * amplitude_m if cut else 0.0
    return (MASS_T - RHO * STEEL_M3 * share) * G, hypot(along, inertia - buoyancy)


def test_the_simplified_method_on_the_structure_is_that_by_hand() -> None:
    """Source: DNV-RP-N103, sec. 4.3; an object that touches is immersed by 1e-6 of its height."""
    found = kingpost.splash_zone(FILE).isel(object=0)
    amplitude, period = found.attrs["wave_amplitude_m"], found.attrs["zero_up_crossing_period_s"]
    assert amplitude == pytest.approx(0.9 * 2, rel=1e-4)
    hands = [by_hand(draught, amplitude, period, 0.5) for draught in (0, 1.5, 3)]
    assert found.static_force.values / 1e3 == pytest.approx([static for static, _ in hands], rel=1e-5)
    assert found.hydrodynamic_force.values / 1e3 == pytest.approx([force for _, force in hands], rel=1e-5)


def test_drag_and_inertia_in_a_deep_regular_wave_add_as_the_root_of_their_squares() -> None:
    """Source: Morison's equation on circular orbits, whose speed is constant. A peak between rows at 40 ms of
    a wave of 8 s is higher by (2 pi 0.02 / 8)^2 / 2 = 1.2e-4 at most."""
    wave = {
        "sea.waves.wind_sea": {"regular": {"height_m": 5, "period_s": 8, "direction_deg": 0}},
        "bodies.structure.joint.prismatic.mode": "held",
        "bodies.structure.joint.prismatic.initial_extension_m": -5,
        "bodies.drum.joint.revolute.mode.prescribed.rate_rad_s": 0,
        "simulation.duration_s": 56,
    }
    run = kingpost.run(FILE, wave).sel(time=slice(40, None))
    force = run.submerged_force.sel(submerged="water", component="force_z").values / 1e3
    assert np.ptp(force) / 2 == pytest.approx(by_hand(6.5, 2.5, 8, 0)[1], rel=1.5e-4)


def test_drag_and_inertia_under_a_moving_tip_have_the_largest_sum_of_a_square_and_a_sine() -> None:
    """Source: the largest F_D sin |sin| + F_M cos, F_D + F_M^2 / (4 F_D) with F_D over F_M / 2. The structure
    moves more than the tip by the stretch of the rope, that force over 12 MN/m or 11 mm of 2 m; force grows
    by its first to second power, and the harmonics of the drag stretch the rope a little more."""
    w = 2 * pi / 8
    inertia, drag = (MASS_T + ADDED_T) * 2 * w**2, 0.5 * RHO * 2.5 * SHADOW_M2 * (2 * w) ** 2
    motion = {"oscillation": {"amplitude_m": 2, "period_s": 8, "ramp_s": 24}}
    joint = {"prismatic": {"name": "tip_heave", "axis": [0, 0, 1], "position_m": [0, 0, 30], "mode": motion}}
    values = {"bodies.tip.joint": joint, "lowering_rad_s": 0, "height_m": -6.5, "simulation.duration_s": 72}
    run = kingpost.run(FILE, values, waves=False).sel(time=slice(40, None))
    hook_load = run.rope_tension.sel(rope="hoist_rope").values / 1e3
    exact = drag + inertia**2 / (4 * drag)
    assert drag > inertia / 2
    assert exact < np.ptp(hook_load) / 2 < exact * (1 + 2.2 * exact / 12e3 / 2)
    moved = {"tip_heave_m": 2.0, "tip_speed_m_s": 2 * w, "tip_acceleration_m_s2": 2 * w**2}
    method = kingpost.splash_zone(FILE, waves=False, lowering_speed_m_s=0, **moved)
    assert float(method.hydrodynamic_force[0, -1]) / 1e3 == pytest.approx(hypot(drag, inertia), rel=1e-5)


@pytest.mark.thorough
@pytest.mark.parametrize("height_m", [1.0, -3.5])
def test_the_least_hook_load_of_half_an_hour_is_near_that_of_the_simplified_method(height_m: float) -> None:
    """Source: DNV-RP-N103. The largest of half an hour scatters by about 10 % from sea to sea (the largest of
    300 Rayleigh amplitudes: Gumbel's deviation over its mean), and its force by up to twice that."""
    held = {"lowering_rad_s": 0, "height_m": height_m, "simulation.duration_s": 105}
    found = kingpost.splash_zone(FILE)
    at_rest = kingpost.equilibrium(FILE, held).position.sel(body="structure", axis="z")
    static, force = by_hand(
        HEIGHT_M / 2 - float(at_rest),
        found.attrs["wave_amplitude_m"],
        found.attrs["zero_up_crossing_period_s"],
        0,
    )
    runs = kingpost.Batch(FILE, {"simulation.seed": range(1, 21)}, held).run().sel(time=slice(15, None))
    least = runs.rope_tension.sel(rope="hoist_rope").values.min() / 1e3
    assert static - least == pytest.approx(force, rel=0.2)


@pytest.mark.thorough
def test_no_lowering_of_twenty_goes_slack_where_the_criterion_is_just_met() -> None:
    """Source: the criterion of DNV-RP-N103, for waves of half an hour; a lowering takes half a minute."""
    found = kingpost.splash_zone(FILE, significant_height_m=3.4)
    assert float(found.slack_utilisation.max()) == pytest.approx(1.0, abs=0.01)
    runs = kingpost.Batch(FILE, {"simulation.seed": range(1, 21)}, {"significant_height_m": 3.4}).run()
    assert float(runs.rope_tension.min()) > 0


def test_the_peak_after_a_snap_is_that_of_a_mass_caught_by_a_spring() -> None:
    """Source: energy, F + sqrt(F^2 + K (M + A) v^2), the second term damped over its part of a period. The
    force of the water changes in this time by a tenth of the peak."""
    finer = {"simulation.seed": 19, "simulation.step_s": 0.01, "simulation.record_every_s": 0.01}
    run = kingpost.run(FILE, finer | {"simulation.duration_s": 34}, significant_height_m=6)
    column = {
        name: run.kingpost[f"hoist_rope.{name}"].values
        for name in ("rope_tension", "rope_stretch", "rope_length")
    }
    stretch = column["rope_stretch"]
    taut = int(np.flatnonzero((stretch[1:] > 0) & (stretch[:-1] <= 0) & (run.time.values[1:] > 24))[0]) + 1
    speed = (stretch[taut] - stretch[taut - 1]) / 0.01
    stiffness = 1 / (column["rope_length"][taut] / 1e6 + 1 / 20e3)
    moved = MASS_T + ADDED_T
    pull = MASS_T * G - float(run.kingpost["water.submerged_force.force_z"][taut]) / 1e3
    caught = speed * sqrt(stiffness * moved)
    ratio = 0.01 * sqrt(stiffness / moved) / 2
    peak = pull + hypot(pull, caught) * exp(-ratio * (pi / 2 + atan(pull / caught)))
    assert caught > 3 * MASS_T * G
    assert column["rope_tension"][taut : taut + 40].max() / 1e3 == pytest.approx(peak, rel=0.1)
