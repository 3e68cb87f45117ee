"""`kingpost.teach`: its results are right, and wrong input is refused with a reason."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from kingpost import KingpostError, Scenario, Simulation, load, teach

RUST_TESTS = Path(__file__).parents[2] / "crates/kingpost/tests/common"


@pytest.fixture(scope="module")
def moving() -> Simulation:
    """The paper's ship with load, centre free, both motors and gravity on, in its motion."""
    simulation = Simulation(load("paper", motor_2=True, load=True, hold_centre=False, gravity=True))
    simulation.step(400)
    return simulation


def turning(t: float) -> np.ndarray:
    """A rotation about an axis that moves."""
    return teach.rodrigues([0.3 * t, 1.0, 0.0]) @ teach.rodrigues([0.0, np.sin(t), t * t])


def displacement(t: float) -> list[float]:
    return [np.cos(2 * t), 0.3 * t, np.sin(t)]


@pytest.mark.parametrize("time_s", [0.0, 0.7, 2.0])
def test_the_variation_of_omega_is_the_restricted_one(time_s):
    """Source: paper eq. 55; central differences are of order 2, one-sided ones of order 1."""
    found = teach.restricted_variation(turning, displacement, time_s)
    slope = found.slope.sel(form="restricted")
    assert slope.sel(difference="central").item() == pytest.approx(2, abs=0.05)
    assert slope.sel(difference="one-sided").item() == pytest.approx(1, abs=0.05)
    assert found.error.sel(form="restricted", difference="central")[-1] < 1e-5


@pytest.mark.parametrize("time_s", [0.0, 0.7, 2.0])
def test_the_naive_variation_is_off_by_omega_cross_the_displacement(time_s):
    """Source: paper eq. 55, its second term; no epsilon removes it."""
    found = teach.restricted_variation(turning, displacement, time_s)
    missing = np.cross(found.angular_velocity, found.virtual_rotation)
    last = found.error.sel(form="naive", difference="central")[-1].item()
    assert last == pytest.approx(np.linalg.norm(missing), rel=1e-4)
    assert np.abs(found.slope.sel(form="naive")).max() < 0.2


def test_the_restricted_variation_holds_for_the_ship_in_its_motion(moving):
    """Source: the engine's own rotation matrices and angular velocity; the simulation stays as it was."""
    before = moving.row()
    found = teach.restricted_variation_of_body(moving, "ship", displacement)
    assert np.array_equal(moving.row(), before)
    assert found.slope.sel(form="restricted", difference="central").item() == pytest.approx(2, abs=0.05)
    ahead = Simulation(moving.scenario)
    ahead.restore(moving.snapshot())
    ahead.step(2)
    assert found.attrs["time_s"] == pytest.approx(ahead.time_s)
    # The differences in time have an error of the fourth order in the step, 1e-12 s4.
    assert found.angular_velocity.values == pytest.approx(ahead.state.v[3:6], abs=1e-9)


@pytest.mark.parametrize("angle_rad", [1e-3, 0.7, np.pi, -2.0, 9.0])
def test_partial_sums_collapse_to_rodrigues_formula(angle_rad):
    """Source: the series' remainder; the Cayley-Hamilton theorem, S^3 = -S."""
    axis = np.array([2.0, -1.0, 0.5])
    sums = teach.exponential_sums(axis, angle_rad, terms=45)
    s = teach.skew(axis / np.linalg.norm(axis))
    assert s @ s @ s == pytest.approx(-s, abs=1e-15)
    # Rounding is a part of the largest term of the series.
    rounding = 1e-15 * np.exp(abs(angle_rad))
    assert (sums.error <= sums.bound + rounding).all()
    for power in sums.power.values:
        row = sums.sel(power=power)
        folded = np.eye(3) + row.sine.item() * s + row.versine.item() * s @ s
        assert folded == pytest.approx(row.partial_sum.values, abs=rounding)
    last = sums.isel(power=-1)
    assert last.sine.item() == pytest.approx(np.sin(angle_rad), abs=rounding)
    assert last.versine.item() == pytest.approx(1 - np.cos(angle_rad), abs=rounding)


@pytest.mark.parametrize("angle", [1e-12, 1e-5, 9.99e-5, 1.01e-4, 1.0, np.pi])
def test_rodrigues_formula_gives_rotations(angle):
    """Source: R^T R = I, det R = 1, and R e = e; trace 1 + 2 cos t."""
    e = np.array([1.0, 2.0, -2.0]) / 3
    r = teach.rodrigues(angle * e)
    assert r.T @ r == pytest.approx(np.eye(3), abs=1e-15)
    assert np.linalg.det(r) == pytest.approx(1, abs=1e-15)
    assert r @ e == pytest.approx(e, abs=1e-15)
    assert teach.unskew(r) == pytest.approx(np.sin(angle) * e, abs=1e-15)


def test_virtual_work_is_the_same_in_both_sets_of_coordinates(moving):
    """Source: F*^T dq = F^T B dq (paper eqs. 56, 60c)."""
    random = np.random.default_rng(3)
    for _ in range(20):
        dq = dict(zip(moving.coordinates, random.normal(size=8), strict=True))
        work = teach.virtual_work(moving, dq)
        scale = float(np.abs(work.work).max())
        assert work.work_in_q.item() == pytest.approx(work.work_in_x.item(), abs=1e-12 * scale)
        assert work.work.sum().item() == pytest.approx(work.work_in_x.item(), abs=1e-12 * scale)


def test_reactions_do_no_virtual_work_though_each_body_feels_them(moving):
    """Source: d'Alembert's principle; q'' is from the recursive form, the matrices from the other."""
    work = teach.virtual_work(moving, {"slew": 0.1, "luff": -0.2, "ship.roll": 0.05})
    largest = float(np.abs(work.work_of_reactions).max())
    assert largest > 100
    assert abs(work.reactions.item()) < 1e-10 * largest


def test_arrows_are_small_motions_of_the_bodies(moving):
    """Source: differences of the bodies' positions under the displacement, second order."""
    size = 1e-4
    work = teach.virtual_work(moving, {"luff": size})
    ends = []
    for sign in (1, -1):
        other = Simulation(moving.scenario)
        state = moving.state
        q = state.q.copy()
        q[-1] += sign * size  # luff is the last coordinate; the load is fixed to the arm
        other.set_state(q, state.v)
        ends.append(other.poses()[:, :3])
    moved = (ends[0] - ends[1]) / 2
    assert work.displacement.values == pytest.approx(moved, abs=size**2)
    assert work.point.values == pytest.approx(moving.poses()[:, :3], abs=1e-12)


def test_the_load_on_a_body_is_its_weight_and_the_reactions_of_its_joints():
    """Source: statics: at rest under gravity the joint carries the weight."""
    scenario = load("paper", motor_1=False, gravity=True)
    work = teach.virtual_work(Simulation(scenario), {"slew": 1.0})
    assert work.force.sel(body="tower", axis="z").item() == pytest.approx(-500 * 9.80665)
    total = (work.force + work.reaction_force).sel(body="ship")
    assert total.values == pytest.approx(np.zeros(3), abs=1e-6)


def test_reactions_do_no_virtual_work_with_prescribed_motions_and_rotors():
    """Source: d'Alembert's principle; F* differs by what the prescribed motions take (paper eq. 60c)."""
    text = (RUST_TESTS / "everything.yaml").read_text(encoding="utf-8")
    rotor = {
        "bodies.boom.joint.revolute.rotor_inertia_kg_m2": 2.0,
        "bodies.boom.joint.revolute.gear_ratio": 3,
    }
    simulation = Simulation(Scenario(text, "everything.yaml").with_overrides(rotor))
    simulation.step(100)
    frame = simulation.moving_frame()
    assert np.abs(frame["q_ddot_given"]).max() > 0
    formulas = frame.formulas()
    assert r"\mathrm{diag}(J_r)" in formulas["M_star"].latex()
    assert r"\ddot{q}_g" in formulas["F_star"].latex()
    random = np.random.default_rng(5)
    dq = dict(zip(simulation.coordinates, random.normal(size=len(simulation.coordinates)), strict=True))
    work = teach.virtual_work(simulation, dq)
    assert abs(work.reactions.item()) < 1e-10 * float(np.abs(work.work_of_reactions).max())
    assert work.work_in_q.item() != pytest.approx(work.work_in_x.item(), rel=1e-3)


def test_a_closed_loop_does_no_virtual_work_if_the_displacement_keeps_it_closed():
    """Source: phi' = J q', so J dq = 0 keeps the loops; any other displacement makes them work."""
    text = (RUST_TESTS / "tied_ships.yaml").read_text(encoding="utf-8")
    simulation = Simulation(Scenario(text, "tied_ships.yaml"))
    simulation.step(50)
    j = simulation.moving_frame()["J"]
    assert list(j["row"].values) == ["hook.x", "hook.y", "hook.z", "hook.yaw"]
    assert list(j["row_unit"].values) == ["m/s", "m/s", "m/s", "rad/s"]
    assert j.values @ simulation.state.v == pytest.approx(np.zeros(4), abs=1e-9)
    any_dq = np.random.default_rng(7).normal(size=j.shape[1])
    keeps = any_dq - np.linalg.lstsq(j.values, j.values @ any_dq, rcond=None)[0]
    totals = []
    for dq in (keeps, any_dq):
        work = teach.virtual_work(simulation, dict(zip(simulation.coordinates, dq, strict=True)))
        totals.append(abs(work.reactions.item()) / float(np.abs(work.work_of_reactions).max()))
    assert totals[0] < 1e-9
    assert totals[1] > 1e-3


def test_without_d_energy_closes_and_momentum_does_not():
    """Source: an independent code: 28,700 N m s after 1 s, both motors, crane at the centre."""
    case = {"crane_x_m": 0, "crane_y_m": 0, "simulation.duration_s": 1}
    runs = teach.with_and_without_d("paper", case, motor_2=True)
    last = runs.isel(time=-1)
    assert list(runs.form.values) == ["with D", "without D"]
    assert (np.abs(last.energy_error / last.work_done) < 1e-8).all()
    assert last.momentum_error.sel(form="with D").item() < 1e-3
    assert last.momentum_error.sel(form="without D").item() == pytest.approx(28_700, abs=50)


def test_wrong_input_is_refused_with_the_allowed_values(moving):
    """Source: the public contract: one base exception, found and allowed."""
    for call, message in (
        (lambda: teach.virtual_work(moving, {"sluice": 1}), "found sluice, allowed: ship.x"),
        (lambda: teach.virtual_work(moving, {"slew": np.nan}), "not finite"),
        (
            lambda: teach.restricted_variation_of_body(moving, "mast", displacement),
            "found mast, allowed: ship",
        ),
        (lambda: teach.restricted_variation(turning, lambda t: [t], 0.0), "three finite numbers"),
        (lambda: teach.restricted_variation(turning, displacement, 0.0, [0.1]), "two or more"),
        (lambda: teach.exponential_sums([0, 0, 0], 1.0), "zero vector"),
        (lambda: teach.exponential_sums([0, 0, 1], 1.0, terms=500), "0 to 170"),
        (lambda: teach.skew([1, 2]), "three finite numbers"),
    ):
        with pytest.raises(KingpostError, match=message):
            call()
