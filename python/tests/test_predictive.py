"""Predictive control: the regulator without active limits, other solvers, limits in the engine, mistakes."""

from __future__ import annotations

import kingpost
import numpy as np
import pytest
from kingpost import KingpostError
from kingpost.analysis.regulator import column_of
from scipy.optimize import lsq_linear
from test_regulator import TROLLEY, cage, scenario, trolley

WEIGHTS = {"inputs": ["push"], "states": TROLLEY, "Q": [1.0, 2.0, 0.0, 0.5], "R": [0.1], "period_s": 0.2}
DRIVEN = ["slewing.target_offset", "luffing.target_offset"]


@pytest.mark.parametrize("horizon", [1, 5, 60])
def test_without_an_active_limit_the_plan_is_that_of_the_linear_quadratic_regulator(horizon) -> None:
    """Source: Bellman's principle: with the terminal cost x' P x of Riccati's equation the plan of any
    length is that of the infinite one. Tolerance: rounding of the matrices' powers."""
    found = kingpost.mpc(scenario(trolley()), **WEIGHTS, horizon=horizon)
    gains = kingpost.lqr(scenario(trolley()), **WEIGHTS).gains.values
    for x in np.random.default_rng(3).normal(size=(5, 4)):
        assert found.action(x) == pytest.approx(-gains @ x, rel=1e-8, abs=1e-8)


def test_without_active_limits_the_gallerys_crane_gets_the_actions_of_the_linear_quadratic_regulator() -> (
    None
):
    """Source: as above, with two inputs and the gains that are in the gallery's file."""
    weights = {"slew": 1, "luff": 1, "pendant.first": 20, "pendant.second": 20}
    given = {"inputs": DRIVEN, "Q": weights, "R": [1, 1], "period_s": 0.1}
    found = kingpost.mpc("slew_without_swing", **given, horizon=30)
    gains = kingpost.lqr("slew_without_swing", **given).gains.values
    x = np.random.default_rng(4).normal(size=len(found.states)) * 0.01
    assert found.action(x) == pytest.approx(-gains @ x, rel=1e-8, abs=1e-8)


def test_the_plan_is_the_models_response_and_its_cost_that_of_the_regulator() -> None:
    """Source: x_(k+1) = held x_k + moved u_k by recursion; J = x0' P x0 (Anderson & Moore, 1990)."""
    found = kingpost.mpc(scenario(trolley()), **WEIGHTS, horizon=12)
    start = np.array([0.3, -0.1, 0.0, 0.2])
    plan = found.plan(start)
    q, cross, r, p = found._cost
    x, cost = start, 0.0
    for u, ahead in zip(plan.inputs, plan.states, strict=True):
        cost += x @ q @ x + 2 * x @ cross @ u + u @ r @ u
        x = found.held @ x + found.moved @ u
        assert ahead == pytest.approx(x, abs=1e-12)
    assert cost + x @ p @ x == pytest.approx(kingpost.lqr(scenario(trolley()), **WEIGHTS).cost(start))


def test_a_plan_with_input_limits_equals_bounded_least_squares() -> None:
    """Source: J / 2 = |C u + C^-T F x|^2 / 2 with H = C' C, solved by SciPy's active sets within the same
    bounds. Tolerance: the gap of 1e-9 at which Clarabel stops, over the least eigenvalue of H."""
    limited = {"input_limits": {"push": (-0.5, 0.8)}, "horizon": 25}
    found = kingpost.mpc(scenario(trolley()), **WEIGHTS, **limited)
    start = np.array([2.0, 0.2, 0.0, 0.0])
    weight, by_state = found._condensed
    root = np.linalg.cholesky(weight).T
    peer = lsq_linear(root, -np.linalg.solve(root.T, by_state @ start), (-0.5, 0.8), tol=1e-14)
    plan = found.plan(start)
    assert plan.inputs.min() == pytest.approx(-0.5, abs=1e-6)
    assert plan.inputs.ravel() == pytest.approx(peer.x, abs=1e-5)


def test_rate_limits_of_an_input_hold_from_the_last_input_on() -> None:
    found = kingpost.mpc(scenario(trolley()), **WEIGHTS, horizon=20, input_rates={"push": 0.5})
    plan = found.plan([2.0, 0, 0, 0], before=[0.3])
    changes = np.diff(plan.inputs.ravel(), prepend=0.3)
    assert np.abs(changes).max() == pytest.approx(0.1, abs=1e-7)


def held(limits: dict[str, tuple[float, float]]) -> tuple[np.ndarray, np.ndarray]:
    """States at the samples and inputs of the engine's trolley, which the regulator moves by 1 mm in 20 s."""
    start = scenario(trolley(1e-3), step_s=0.01)
    regulator = kingpost.mpc(
        start.with_overrides({"bodies.cart.joint.prismatic.initial_extension_m": 0}),
        **{**WEIGHTS, "R": [1e-3]},
        horizon=30,
        input_limits={"push": (-2e-3, 2e-3)},
        state_limits=limits,
    )
    simulation = kingpost.Simulation(start)
    names = [name for channel in simulation.channels for name in channel["columns"]]
    places = [names.index(column_of(state)) for state in regulator.states]
    seen, given = [], []
    for _ in range(100):
        seen.append(simulation.row()[places])
        given.append(regulator.action(seen[-1])[0])
        simulation.set_input("push", given[-1])
        simulation.step(20)
    return np.array(seen), np.array(given)


def test_limits_of_inputs_and_of_states_are_held_in_the_engine() -> None:
    """Source: the limits. The model is linear to 1e-6 of the swing of 1e-4 rad; RK4 errs less."""
    free, _ = held({})
    assert np.abs(free[:, 1]).max() > 1e-4
    seen, given = held({"swing": (-5e-5, 5e-5)})
    assert np.abs(seen[:, 1]).max() < 5e-5 * (1 + 1e-4)
    assert np.abs(given).max() < 2e-3 * (1 + 1e-6)
    assert np.abs(seen[-1]).max() < 1e-5


def test_a_state_that_no_input_can_hold_exceeds_its_limit_as_little_as_possible() -> None:
    """Source: a mass of 1 kg that moves at 1 m/s passes a limit by the same at least as at full braking of
    a = 0.5 m/s2, v^2 / 2 a = 1 m, at t = 2 s, which is the end of a period."""
    brakes = {"input_limits": {"push": (-0.5, 0.5)}, "state_limits": {"trolley": (-9.0, 0.0)}}
    weights = {
        "inputs": ["push"],
        "states": ["trolley", "trolley.rate"],
        "Q": [1, 0],
        "R": [1],
        "period_s": 0.5,
    }
    found = kingpost.mpc(scenario(cage()), **weights, horizon=12, **brakes)
    plan = found.plan([0.0, 1.0])
    assert plan.beyond == pytest.approx(1.0, abs=1e-5)
    assert plan.inputs[:4].ravel() == pytest.approx([-0.5] * 4, abs=1e-4)


@pytest.mark.parametrize(
    ("given", "expected"),
    [
        ({"horizon": 0}, "horizon: found 0, allowed: a whole number from 1 on"),
        ({"period_s": -1.0}, "period_s: found -1.0, allowed: a number greater than 0"),
        ({"input_limits": {"pull": (0, 1)}}, "input_limits: found 'pull', allowed: push"),
        (
            {"state_limits": {"swing": (1, 0)}},
            "state_limits swing: found 1 to 0, allowed: from lower to upper",
        ),
        ({"input_rates": {"push": -1.0}}, "input_rates push: found 1.0 to -1.0"),
        ({"states": ["heave"]}, "states: found 'heave'"),
    ],
)
def test_errors_name_the_wrong_input_and_the_allowed_ones(given, expected) -> None:
    with pytest.raises(KingpostError) as caught:
        kingpost.mpc(scenario(trolley()), **{**WEIGHTS, "horizon": 5, **given})
    assert expected in str(caught.value)


def test_states_that_are_not_numbers_are_refused() -> None:
    found = kingpost.mpc(scenario(trolley()), **WEIGHTS, horizon=5)
    with pytest.raises(KingpostError, match="allowed: 4 finite numbers"):
        found.action([0, np.nan, 0, 0])
    with pytest.raises(KingpostError, match="allowed: 4 finite numbers"):
        found.action([0, 0])
