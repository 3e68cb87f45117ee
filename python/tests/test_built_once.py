"""A scenario is read and built once: its simulations and analyses share this setup, and nothing else."""

from __future__ import annotations

import copy
import pickle
import threading
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import kingpost
import numpy as np
import pytest
from kingpost import KingpostError, Scenario, ScenarioError, Simulation, cli, load
from kingpost.engine import engine

SHORT = {"simulation.duration_s": 1.0}


@pytest.fixture
def counted(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Files of the scenarios that the engine has read and built since the test began."""
    found: list[str] = []

    def counting(made: Callable[..., Any]) -> Callable[..., Any]:
        def count(text: str, file: str, *others: Any) -> Any:
            found.append(file)
            return made(text, file, *others)

        return count

    for name in ("Scenario", "read"):
        monkeypatch.setattr(engine, name, counting(getattr(engine, name)))
    return found


def test_all_simulations_of_a_scenario_share_one_engine_object() -> None:
    scenario = load("barge", SHORT, waves=True)
    simulation = Simulation(scenario)
    assert simulation.scenario is not scenario
    assert simulation.scenario._built is scenario._built
    assert scenario.with_overrides()._built is scenario._built
    assert scenario.with_overrides(significant_height_m=1)._built is not scenario._built


def test_a_run_its_warnings_and_its_hydrostatics_build_once(counted: list[str]) -> None:
    scenario = load("barge", SHORT, waves=True)
    simulation = Simulation(scenario)
    assert simulation.model_warnings == []
    assert scenario.model["bodies"]
    assert scenario.hydrostatics["hulls"]
    simulation.linearize()
    simulation.run()
    kingpost.run(scenario)
    kingpost.modes(scenario)
    assert counted == [scenario.file]


def test_a_gradient_builds_once(counted: list[str]) -> None:
    kingpost.gradient("paper", "crane_x_m", SHORT)
    assert len(counted) == 1


@pytest.mark.parametrize("command", ["run", "check"])
def test_a_command_builds_once(command: str, counted: list[str], capsys) -> None:
    assert cli.main([command, "barge", "--set", "simulation.duration_s=1"]) == 0
    assert len(counted) == 1


def test_simulations_of_one_scenario_that_step_in_turn_run_as_each_does_alone() -> None:
    scenario = load("barge", SHORT, waves=True)
    alone = Simulation(load("barge", SHORT, waves=True))
    alone.step(10)
    one, other = Simulation(scenario), Simulation(scenario)
    for _ in range(10):
        one.step()
        assert other.time_s == 0
    for _ in range(10):
        other.step()
    assert one.snapshot() == other.snapshot() == alone.snapshot()
    one.step(3)
    other.restore(one.snapshot())
    assert (other.row() == one.row()).all()


def test_setting_a_live_parameter_changes_only_one_simulation() -> None:
    scenario = load("barge", SHORT, waves=True)
    expected = Simulation(load("barge", SHORT, waves=True)).run()
    one, other = Simulation(scenario), Simulation(scenario)
    one.set_parameter("significant_height_m", 0.5)
    assert one.scenario["significant_height_m"] == 0.5
    assert other.scenario["significant_height_m"] == scenario["significant_height_m"] != 0.5
    with pytest.raises(KingpostError, match="snapshot"):
        other.restore(one.snapshot())
    assert other.run().equals(expected)
    assert kingpost.run(scenario).equals(expected)
    one.reset()
    assert not one.run().equals(expected)


def test_setting_a_value_in_a_scenario_does_not_change_its_simulations() -> None:
    scenario = load("paper", SHORT)
    simulation = Simulation(scenario)
    scenario["crane_x_m"] = 5
    assert simulation.scenario["crane_x_m"] == -10
    assert simulation.run().equals(kingpost.run("paper", SHORT))
    assert Simulation(scenario).run().equals(kingpost.run("paper", SHORT, crane_x_m=5))


def test_another_seed_builds_a_new_sea(counted: list[str]) -> None:
    scenario = load("barge", SHORT, waves=True)
    simulation, sibling = Simulation(scenario), Simulation(scenario)
    simulation.reset(seed=7)
    assert len(counted) == 2
    assert simulation.snapshot() != sibling.snapshot()
    sibling.restore(Simulation(scenario).snapshot())


@pytest.mark.parametrize("used", [False, True])
def test_a_pickled_scenario_is_built_again_after_unpickling(used: bool, counted: list[str]) -> None:
    scenario = load("knuckle_boom_crane", {"simulation.duration_s": 0.1})
    if used:
        assert scenario.model
        assert scenario.json
    again: Scenario = pickle.loads(pickle.dumps(scenario))
    assert again == scenario
    assert again.files == scenario.files
    assert len(counted) == 1
    assert kingpost.run(again).equals(kingpost.run(scenario))
    assert len(counted) == 2
    assert copy.deepcopy(scenario) == scenario
    assert copy.copy(scenario)._built is scenario._built


def test_threads_share_a_scenario() -> None:
    scenario = load("barge", SHORT, waves=True)
    expected = Simulation(load("barge", SHORT, waves=True)).linearize().A
    begin = threading.Barrier(4)

    def use(_: int) -> Any:
        begin.wait()
        simulation = Simulation(scenario)
        return scenario.model, simulation.linearize().A, simulation.run()

    with ThreadPoolExecutor(4) as pool:
        found = list(pool.map(use, range(4)))
    assert all(model == found[0][0] for model, _, _ in found)
    assert all(np.array_equal(a, expected) for _, a, _ in found)
    assert all(run.equals(found[0][2]) for _, _, run in found)


def test_an_interrupted_run_does_not_change_the_scenario() -> None:
    scenario = load("paper", {"simulation.duration_s": 5.0})

    def interrupt(time_s: float) -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        Simulation(scenario).run(interrupt)
    assert kingpost.run(scenario).equals(kingpost.run("paper", {"simulation.duration_s": 5.0}))


def test_a_scenario_that_does_not_build_is_refused_on_reading() -> None:
    with pytest.raises(ScenarioError, match="mass_kg: found -1, allowed: a number greater than 0") as refused:
        load("paper", {"bodies.arm.mass_kg": -1})
    assert refused.value.field == "bodies.arm.mass_kg"
    scenario = load("paper")
    with pytest.raises(ScenarioError):
        scenario["bodies.arm.parent"] = "mast"
    assert scenario.overrides == ()
    assert Simulation(scenario).time_s == 0
