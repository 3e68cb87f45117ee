"""Lines with mass at rest and dragged slowly: closed forms of current, seabed and catenary."""

from __future__ import annotations

import itertools
from functools import cache

import kingpost
import numpy as np
import pytest
from kingpost.verify.models import G, scenario, settings, value
from kingpost.verify.mooring import elastic_span
from line_cases import between, of_two_ends, section
from scipy.integrate import solve_ivp
from scipy.optimize import brentq, root

DENSITY = 1025.0

# Umbilical of 50 mm from a point 10 m under the surface.
CABLE_M, CABLE_EA_N, FROM_M = 200.0, 1e7, np.array([0.0, 0.0, -10.0])
CABLE = {
    "mass_kg_per_m": 8.0,
    "diameter_m": 0.05,
    "axial_stiffness_N": CABLE_EA_N,
    "drag_across": 1.2,
    "drag_along": 0.02,
}
CABLE_N_M = (8.0 - DENSITY * np.pi / 4 * 0.05**2) * G
POINTS = 11


def drags(current_m_s: float) -> tuple[float, float]:
    """Drag across and along the cable at right angles to the current and along it, N/m."""
    pressure = 0.5 * DENSITY * current_m_s**2 * 0.05
    return pressure * 1.2, pressure * np.pi * 0.02


def critical(current_m_s: float) -> tuple[float, float]:
    """Critical angle to the current, w cos a = R sin^2 a, and tension per length, w sin a + F cos^2 a."""
    across, along = drags(current_m_s)
    angle = brentq(lambda a: CABLE_N_M * np.cos(a) - across * np.sin(a) ** 2, 1e-6, np.pi / 2, xtol=1e-15)
    return angle, CABLE_N_M * np.sin(angle) + along * np.cos(angle) ** 2


def towed(current_m_s: float, load_kg: float, load_m: np.ndarray, elements: int) -> kingpost.Simulation:
    """A cable in uniform current, with a load without water at its free end; settled from this place."""
    place = {"position_m": list(FROM_M + load_m)}
    load = {
        "mass_kg": load_kg,
        "shape": {"point": {}},
        "joint": {"floating": {"hold_rotation": True, "initial": place}},
    }
    part = section(CABLE_M, elements, **CABLE)
    found = kingpost.Simulation(
        scenario(
            {"load": load},
            between(list(FROM_M), "load", part, points_along=POINTS),
            simulation=settings(0.01, 1.0),
            sea={"depth_m": 1000, "density_kg_m3": DENSITY, "current_m_s": [current_m_s, 0]},
        )
    )
    found.settle()
    return found


def at_critical_angle(current_m_s: float, elements: int) -> None:
    """Compares a cable with a load of 1 g with the straight line at the critical angle."""
    angle, per_length = critical(current_m_s)
    stretched = CABLE_M + per_length * CABLE_M**2 / 2 / CABLE_EA_N
    way = np.array([np.cos(angle), 0.0, -np.sin(angle)]) * stretched
    found = towed(current_m_s, 1e-3, way + np.array([0.0, 0.0, 0.5]), elements)
    # The load is 1e-6 of the cable's weight, and pulls its end downwards; drag is per unstretched length.
    assert np.linalg.norm(found.state.q[:3] - FROM_M - way) < 2e-6 * CABLE_M
    for k in range(POINTS):
        tension = value(found, "line_tension_along", f"line.point_{k + 1}")
        below = per_length * CABLE_M * (1 - k / (POINTS - 1))
        assert tension == pytest.approx(below, abs=2e-6 * per_length * CABLE_M), k


@pytest.mark.parametrize("current_m_s", [0.5, 1.0, 1.25])
def test_a_towed_cable_with_a_free_end_is_straight_at_the_critical_angle(current_m_s):
    """Source: Pode, Tables for Computing the Equilibrium Configuration of a Flexible Cable in a Uniform
    Stream, David Taylor Model Basin report 687, 1951. A straight line is exact in any number of elements."""
    at_critical_angle(current_m_s, 8)


def test_a_towed_cable_with_more_drag_than_weight_is_at_the_critical_angle():
    """Source: Pode, as above; 2 m/s, a critical angle of 38 degrees."""
    at_critical_angle(2.0, 8)


def with_load(current_m_s: float, load_kg: float) -> np.ndarray:
    """Tension at the top, and the way from there to the load: T' = w sin a + F cos^2 a,
    T a' = w cos a - R sin^2 a, from a vertical end at the load upwards, each length stretched by T / EA."""
    across, along = drags(current_m_s)

    def rates(_: float, at: np.ndarray) -> list[float]:
        tension, angle = at[:2]
        sine, cosine, stretch = np.sin(angle), np.cos(angle), 1 + tension / CABLE_EA_N
        turn = (CABLE_N_M * cosine - across * sine**2) / tension
        return [CABLE_N_M * sine + along * cosine**2, turn, stretch * cosine, -stretch * sine]

    start = [load_kg * G, np.pi / 2, 0.0, 0.0]
    found = solve_ivp(rates, (0, CABLE_M), start, method="DOP853", rtol=1e-12, atol=1e-9)
    return found.y[[0, 2, 3], -1]


def test_a_towed_load_hangs_behind_on_a_curved_cable_to_second_order():
    """Source: Pode's equations, integrated to 1e-12."""
    tension, across, down = with_load(1.0, 500.0)
    errors = []
    for elements in (8, 16, 32):
        found = towed(1.0, 500.0, np.array([across, 0.0, down]), elements)
        off = found.state.q[[0, 2]] - FROM_M[[0, 2]] - [across, down]
        of_tension = value(found, "line_tension", "line") / tension - 1
        errors.append([abs(of_tension), float(np.abs(off).max()) / CABLE_M])
    # The drag takes the direction of the line at a node from its neighbours: an error of second order, which
    # the strong curvature above the load reduces to a factor of 3.3 at first.
    assert max(errors[0]) < 3e-4
    for before, after in itertools.pairwise(np.array(errors)):
        assert (after < before / 3.2).all(), errors


# A chain of 100 m along the seabed, soft so that it slides far; its ends lie at the height of the seabed.
LAID_M, LAID_KG_M, LAID_D_M, LAID_EA_N, FRICTION, SLIDING_M_S = 100.0, 50.0, 0.08, 1e6, 0.7, 0.01
HELD_N = FRICTION * (LAID_KG_M - DENSITY * np.pi / 4 * LAID_D_M**2) * G * LAID_M
SPEED_M_S = 0.3


@cache
def dragged(elements: int, duration_s: float, hold_s: float, step_s: float) -> tuple[np.ndarray, np.ndarray]:
    """Times, and the pull at the moving end less that at the anchor, over mu w L.

    The end is pulled away from the anchor at 0.3 m/s for this time."""
    pulse = {"rise_s": 0.5, "hold_s": hold_s}
    moves = {"prescribed": {"speed_m_s": SPEED_M_S, "history": "pulse", "pulse": pulse}}
    depth = 20.0
    end = {
        "mass_kg": 1.0,
        "shape": {"point": {}},
        "joint": {"prismatic": {"axis": [1, 0, 0], "position_m": [LAID_M, 0, -depth], "mode": moves}},
    }
    part = section(
        LAID_M,
        elements,
        mass_kg_per_m=LAID_KG_M,
        diameter_m=LAID_D_M,
        axial_stiffness_N=LAID_EA_N,
        damping_time_s=0.05,
        drag_across=0.0,
        added_mass_across=0.0,
    )
    # Ground so stiff that the chain sinks in by 0.02 mm.
    seabed = {"friction": FRICTION, "stiffness_N_per_m3": 3e8}
    ds = kingpost.run(
        scenario(
            {"end": end},
            between("end", [0.0, 0.0, -depth], part, seabed=seabed),
            simulation=settings(step_s, duration_s, integrator="rk4"),
            sea={"depth_m": depth, "density_kg_m3": DENSITY},
        )
    )
    return ds.time.values, (ds.line_tension - ds.line_end_tension).values.ravel() / HELD_N


def test_a_chain_dragged_along_the_seabed_leaves_the_anchor_mu_w_l_less():
    """Source: Coulomb; the engine's law is mu w v / sqrt(v^2 + v_s^2). A chain that is stretched evenly moves
    with v = V s / L, which gives mu w L (sqrt(1 + r^2) - 1) / r with r = V / v_s: 3.3 % less at r = 30."""
    ratio = SPEED_M_S / SLIDING_M_S
    expected = (np.sqrt(1 + ratio**2) - 1) / ratio
    assert expected == pytest.approx(1 - 1 / ratio, abs=1e-3)
    errors = [float(dragged(elements, 12.0, 20.0, 0.02)[1][-1]) / expected - 1 for elements in (10, 20, 40)]
    for error, elements in zip(errors, (10, 20, 40), strict=True):
        # The seabed does not carry the sixth of an element at the moving end, which the body holds.
        assert error == pytest.approx(-1 / (6 * elements), rel=0.1)
    # Without the first order an error of second order remains, (1 / 20)^2 / 8.
    assert abs(2 * errors[2] - errors[1]) < 3e-4


def test_friction_of_a_chain_that_comes_to_rest_on_the_seabed_creeps_away():
    """Source: below v_s friction is mu w v / v_s, so stretch diffuses: the difference of the tensions at both
    ends decays with the rate pi^2 EA v_s / (mu w L^2), here in 31 s."""
    t, difference = dragged(10, 120.0, 8.0, 0.05)
    rate = np.pi**2 * LAID_EA_N * SLIDING_M_S / (HELD_N * LAID_M)
    late = [float(np.interp(time, t, difference)) for time in (80.0, 119.0)]
    # At 80 s v / v_s is 0.09 in the middle: friction is lower by half of its square, 4e-3, and by less later.
    # The inertia is m v_s / (mu w) = 2e-3 s of 31 s.
    assert np.log(late[0] / late[1]) / 39.0 == pytest.approx(rate, rel=4e-3)


CHAIN = {"mass_kg_per_m": 685.0, "axial_stiffness_N": 3.27e9}
CHAIN_N_M, CHAIN_EA_N = 685.0 * G, 3.27e9


def catenary(length_m: float, across_m: float, up_m: float) -> tuple[float, float]:
    """Horizontal and vertical force at the upper end of the elastic catenary, N."""

    def misses(force: np.ndarray) -> np.ndarray:
        forces = force[0] * CHAIN_N_M, force[1] * CHAIN_N_M
        span = elastic_span(forces, CHAIN_N_M, length_m, CHAIN_EA_N)
        return np.subtract(span, (across_m, up_m))

    found = root(misses, [across_m / 3, 0.7 * length_m], tol=1e-13).x * CHAIN_N_M
    return float(found[0]), float(found[1])


def test_two_meshes_of_a_hanging_line_extrapolate_to_1e_9_of_the_catenary():
    """Source: Irvine, Cable Structures, 1981, ch. 1; Richardson's extrapolation of fourth order."""
    length, across, up = 850.0, 779.6, 186.0
    exact = float(np.hypot(*catenary(length, across, up)))
    part = [section(length, elements, **CHAIN) for elements in (10, 20, 40)]
    runs = [kingpost.Simulation(of_two_ends([across, 0, -10], [0, 0, -10 - up], one)) for one in part]
    tensions = [value(run, "line_tension", "line") for run in runs]
    coarse, fine = ((16 * b - a) / 15 / exact - 1 for a, b in itertools.pairwise(tensions))
    # The next term is of sixth order: 64 times smaller with half the elements, and 4e-10 with 10 and 20.
    assert abs(coarse) < 1e-9
    assert abs(fine) < abs(coarse) / 20
