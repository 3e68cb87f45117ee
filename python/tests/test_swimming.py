"""Bodies that swim: a robot with a tail fin, and a vehicle with two arms."""

from __future__ import annotations

import kingpost
import numpy as np
import pytest
from kingpost.verify import swimming
from kingpost.verify.swimming import by_impulse, chain

BEAT_S = 0.7
RECORD_S = 0.025
BEATS = round(10 * BEAT_S / RECORD_S)
"""Samples of ten beats at the end of a run."""


def gains(run, *columns: str) -> list[float]:
    """By how much columns grow over the last ten beats."""
    return [float(run.kingpost[name].values[-1] - run.kingpost[name].values[-1 - BEATS]) for name in columns]


def test_the_work_of_a_robots_drives_at_steady_speed_is_the_energy_given_to_the_water() -> None:
    """Source: conservation of energy and of momentum over ten beats; each beat has 28 samples, so that means
    of smooth columns have no error beyond that of the steady state, reached within 10 s."""
    run = kingpost.run("caudal_fin_swimmer", {"simulation.duration_s": 28.0})
    columns = run.kingpost
    assert float(abs(run.energy_error).max()) < 1e-6 * float(run.energy_scale.max())
    drives, heat, kinetic = gains(run, "work_by_drives", "energy_dissipated", "kinetic_energy")
    assert drives == pytest.approx(heat, rel=1e-3)
    assert abs(kinetic) < 1e-3 * drives
    along = [
        float(np.mean(columns[name].values[-BEATS:]))
        for name in (
            "trailing_edge.trailing_edge_force.x",
            "robot_in_water.submerged_drag.x",
            "tail_in_water.submerged_drag.x",
            "fin_in_water.submerged_drag.x",
        )
    ]
    assert along[0] > 0
    assert sum(along) == pytest.approx(0.0, abs=2e-3 * along[0])


def test_a_robot_swims_at_the_strouhal_number_of_fish() -> None:
    """Source: Taylor, Nudds & Thomas, Nature 425, 2003, p. 707: animals that cruise have 0.2 to 0.4.
    Coefficients were chosen without it."""
    run = kingpost.run("caudal_fin_swimmer")
    columns = run.kingpost
    excursion_m = np.ptp(columns["fin.edge.point_position.y"].values[-BEATS:])
    (way_m,) = gains(run, "robot.position.x")
    assert 0.2 < excursion_m / (way_m / 10) < 0.4


@pytest.mark.parametrize("sign", [1, -1])
def test_a_tail_offset_to_one_side_steers_to_that_side(sign: int) -> None:
    """Source: symmetry of port and starboard; a tail to starboard turns the bow to starboard."""
    run = kingpost.run("caudal_fin_swimmer", {"simulation.duration_s": 5.0}, rudder_deg=sign * 10)
    other = kingpost.run(
        "caudal_fin_swimmer",
        {
            "simulation.duration_s": 5.0,
            "bodies.tail.joint.revolute.mode.oscillation.amplitude_deg": -20,
            "bodies.fin.joint.revolute.mode.oscillation.amplitude_deg": -30,
        },
        rudder_deg=-sign * 10,
    )
    yaw = run.kingpost["robot.yaw"].values[-1]
    assert yaw * sign < -0.3
    assert other.kingpost["robot.yaw"].values[-1] == pytest.approx(-yaw, abs=1e-9)


@pytest.mark.thorough
def test_without_wake_and_drag_the_distance_of_a_stroke_is_independent_of_its_speed() -> None:
    """Source: Kanso et al. 2005: the way of a stroke is a geometric phase, whatever its pace."""

    def way(pace: float) -> np.ndarray:
        motions = [swimming.Oscillation(1.0, pace, phase, 2 * pace) for phase in (0.0, 1.6)]
        return by_impulse(chain(motions), 6 * pace)

    assert way(3.0) == pytest.approx(way(1.0), abs=1e-8)
    assert np.hypot(*way(1.0)[:2]) > 0.1


def test_a_vehicle_pitches_until_its_righting_moment_carries_its_arms() -> None:
    """Source: moments of weights and buoyancies about the vehicle's centre; it still drifts by then, by a few
    thousandths."""
    run = kingpost.run("underwater_vehicle", {"simulation.duration_s": 34.0})
    scenario = kingpost.load("underwater_vehicle").resolved
    columns, net = run.kingpost, np.zeros(3)
    at = {axis: columns[f"vehicle.position.{axis}"].values[-1] for axis in "xyz"}
    for name, body in scenario["bodies"].items():
        place = np.array([columns[f"{name}.position.{axis}"].values[-1] - at[axis] for axis in "xyz"])
        buoyant_kg = 1025 * scenario["forces"][f"{name}_in_water"]["submerged"]["displaced_volume_m3"]
        if name == "vehicle":
            pitch = columns["vehicle.pitch"].values[-1]
            lever = np.array([0.101, 0.0, 0.3])  # from the centre of mass to that of buoyancy
            place_of_foam = _pitched(pitch) @ lever
            net -= buoyant_kg * place_of_foam
        else:
            net += (body["mass_kg"] - buoyant_kg) * place
    assert np.degrees(pitch) == pytest.approx(7.6, abs=0.3)
    righting = 1025 * scenario["forces"]["vehicle_in_water"]["submerged"]["displaced_volume_m3"] * 0.3
    assert abs(net[0]) < 5e-3 * righting


def _pitched(angle: float) -> np.ndarray:
    cos, sin = np.cos(angle), np.sin(angle)
    return np.array([[cos, 0, sin], [0, 1, 0], [-sin, 0, cos]])


def test_arms_that_slew_together_turn_a_vehicle_the_other_way_and_arms_that_spread_do_not() -> None:
    """Source: angular momentum; mirrored motions have none about the vertical."""
    run = kingpost.run("underwater_vehicle")
    heading = np.degrees(run.kingpost["vehicle.yaw"].interp(time=[34.0, 49.0, 64.0, 79.0]).values)
    together, back, spread = np.diff(heading)
    assert together < -8
    assert back > 8
    assert abs(spread) < 0.3
