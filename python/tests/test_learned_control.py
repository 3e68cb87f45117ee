"""The trained policy as a controller of a scenario: agreement with NumPy, and the choice of four
controllers."""

from __future__ import annotations

import kingpost
import numpy as np
import pytest
from kingpost.analysis.regulator import column_of
from kingpost.learn import trained
from kingpost.learn.model_based import LQR_INPUT_WEIGHT, LUFF, load_weights
from kingpost.learn.tasks.anti_sway import SCENARIOS, anti_sway

GALLERY = "slew_by_policy"
TARGET = {"slew": 1.3, "luff": -0.9599}


@pytest.fixture(scope="module")
def policy():
    return trained("Kingpost/AntiSway-v0")


def controllers(**parameters: object) -> dict:
    return kingpost.load(GALLERY, **parameters).resolved["controllers"]


def test_the_weights_in_the_gallery_equal_those_of_the_trained_policy(policy) -> None:
    given = controllers()["learned"]["policy"]
    for layer, (weights, biases) in zip(given["layers"], policy.layers, strict=True):
        assert np.array_equal(layer["weights"], weights)
        assert np.array_equal(layer["biases"], biases)
    assert [read["scale"] for read in given["reads"]] == list(policy.scales)
    assert given["period_s"] == policy.control_period_s


def test_the_element_acts_as_the_policy_in_numpy_does(policy) -> None:
    """Source: `NeuralPolicy` on the columns of the run. Tolerance: tanh of NumPy and of libm differ by two
    units of rounding, which two layers of weights below 2 enlarge to 1e-13."""
    simulation = kingpost.Simulation(GALLERY)
    names = [name for channel in simulation.channels for name in channel["columns"]]
    task = anti_sway()
    goal = np.array([[TARGET["slew"], TARGET["luff"]]])
    for _ in range(120):
        row = dict(zip(names, simulation.row(), strict=True))
        columns = {name: np.array([row[name]]) for name in task.read}
        seen = [
            (columns[one.name] if one.value is None else one.value(columns, goal)) / one.scale
            for one in task.seen
        ]
        (actions,) = policy(np.stack(seen, axis=1))
        simulation.step(10)
        row = dict(zip(names, simulation.row(), strict=True))
        for action, drive, (low, high) in zip(actions, policy.actions, policy.bounds, strict=True):
            wanted = low + (action + 1) * 0.5 * (high - low)
            assert row[f"learned.choice.policy.{drive}.commanded_rate"] == pytest.approx(wanted, abs=1e-12)
            assert simulation.inputs[drive].value == row[f"learned.choice.policy.{drive}.commanded_rate"]


def test_the_gains_in_the_gallery_equal_those_of_the_regulator() -> None:
    """Source: `lqr` with the weights of the environment's regulator; the file has four decimals."""
    crane = kingpost.load(SCENARIOS / "anti_sway.yaml", {LUFF: -55.0})
    names = kingpost.Simulation(crane).linearize().states
    weights = load_weights(anti_sway(), -55.0, names)
    given = {"Q": weights, "R": [LQR_INPUT_WEIGHT] * 2, "period_s": 0.2}
    gains = kingpost.lqr(crane, inputs=["slewing", "luffing"], **given).gains.values
    regulator = controllers()["regulator"]["state_feedback"]
    assert [read["column"] for read in regulator["reads"]] == [
        name if name.split(".")[0] in ("slewing", "luffing") else column_of(name) for name in names
    ]
    for row, steer in zip(gains, regulator["steers"], strict=True):
        assert steer["gains"] == pytest.approx(row, abs=6e-5)


def rest_s(controller: str) -> float:
    """When the load stays within 0.5 m of its place at the end of the slew, s."""
    run = kingpost.run(GALLERY, controller=controller)
    radius = 30 * np.cos(TARGET["luff"])
    x, y = (run.kingpost[f"load.position.{axis}"].values for axis in "xy")
    away = np.hypot(x - radius * np.cos(TARGET["slew"]), y - radius * np.sin(TARGET["slew"]))
    return float(run.time.values[away > 0.5].max())


@pytest.mark.thorough
def test_one_switch_chooses_the_controller_and_the_policy_arrives_first() -> None:
    found = {name: rest_s(name) for name in ("none", "shaper", "lqr", "policy")}
    assert min(found, key=found.__getitem__) == "policy"
    assert found["none"] == pytest.approx(60, abs=1)
    assert found["policy"] < 20


def test_the_target_of_all_four_is_one_parameter() -> None:
    moved = controllers(slew_target_rad=0.9)
    references = [
        moved["plain"]["state_feedback"]["reads"][0]["reference"],
        moved["to_shape"]["state_feedback"]["reads"][0]["reference"],
        moved["regulator"]["state_feedback"]["reads"][0]["reference"],
        moved["regulator"]["state_feedback"]["reads"][12]["reference"],
        moved["learned"]["policy"]["reads"][0]["reference"],
    ]
    assert references == [0.9] * 5
