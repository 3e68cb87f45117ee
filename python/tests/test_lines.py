"""Lines with mass: what a user does with them, and mistakes."""

from __future__ import annotations

import copy
import json
from pathlib import Path
from typing import Any

import kingpost
import numpy as np
import pytest
import xarray
from line_samples import CHAIN, PAID_OUT, chain, with_section

LENGTH = "forces.chain.line.sections.0.unstretched_length_m"
STIFFNESS = "forces.chain.line.sections.0.axial_stiffness_N"
DRAG = "forces.chain.line.sections.0.drag_across"
ENDS = ("line_tension", "line_end_tension")
ALONG = ("line_tension_along", "line_touchdown", "line_length", "line_pay_out_rate")
HEIGHT = "sea.waves.swell.regular.height_m"


def written(folder: Path, scenario: dict[str, Any]) -> Path:
    """The scenario as a file."""
    path = folder / "chain.yaml"
    path.write_text(json.dumps(scenario))
    return path


@pytest.fixture(scope="module")
def scenario(tmp_path_factory: pytest.TempPathFactory) -> kingpost.Scenario:
    return kingpost.load(written(tmp_path_factory.mktemp("lines"), CHAIN))


@pytest.fixture(scope="module", params=[CHAIN, PAID_OUT], ids=["chain", "paid_out"])
def either(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> kingpost.Scenario:
    return kingpost.load(written(tmp_path_factory.mktemp("lines"), request.param))


def those_in(results: xarray.Dataset) -> list[str]:
    """Names of the variables along a line that these results have.

    The touchdown needs a seabed, the pay-out a path."""
    return [name for name in ALONG if name in results]


def test_each_run_of_a_batch_has_the_bits_of_the_run_alone(either):
    scenario, at_first = either, _value(either.resolved, LENGTH)
    lengths = [at_first * share for share in (0.998, 1, 1.001, 1.005, 0.99)]
    found = kingpost.Batch(scenario, {LENGTH: lengths}).run()
    for run, length in enumerate(lengths):
        alone = kingpost.run(scenario, {LENGTH: length})
        for name in (*ENDS, "line_grounded_length", "energy_error", *those_in(alone)):
            np.testing.assert_array_equal(found[name].isel(run=run).values, alone[name].values, err_msg=name)


@pytest.mark.parametrize("path", [STIFFNESS, LENGTH, DRAG, HEIGHT])
def test_derivatives_agree_with_central_differences(either, path):
    """Source: differences with steps h and 2 h, whose error is a third of their difference."""
    scenario, value = either, float(_value(either.resolved, path))
    step = 1e-5 * value
    found = kingpost.gradient(scenario, path)
    runs = kingpost.Batch(scenario, {path: [value + by * step for by in (1, -1, 2, -2)]}).run()
    for name in (*ENDS, *those_in(runs)):
        tension = runs[name].squeeze()
        fine = (tension.isel(run=0) - tension.isel(run=1)) / (2 * step)
        coarse = (tension.isel(run=2) - tension.isel(run=3)) / (4 * step)
        exact = found[f"{name}_derivative"].squeeze()
        # Newton's method leaves 1e-12 of the tension, over the step of 1e-5.
        bound = 2 * float(np.abs(fine - coarse).max()) + 1e-6 * float(np.abs(exact).max())
        bound += 1e-11 * float(tension.max()) / step
        assert float(np.abs(exact - fine).max()) <= bound, name
        is_given = name == "line_pay_out_rate" or (name == "line_length" and path != LENGTH)
        assert float(np.abs(exact).max()) > 0 or is_given, name


def test_the_range_graph_of_a_paid_out_line_is_over_shares_of_its_length(tmp_path):
    """Source: the length of the line over time; the ends have the tensions of the ends."""
    found = kingpost.run(written(tmp_path, PAID_OUT))
    graph = kingpost.range_graph(found, "chain")
    assert graph["largest"].dims == ("share",)
    length = float(found["line_length"].mean())
    np.testing.assert_allclose(graph["arc_length"], graph["share"] * length, rtol=1e-12)
    for end, name in ((0, "line_tension"), (-1, "line_end_tension")):
        assert float(graph["largest"][end]) == float(found[name].max())
    fatigue = kingpost.line_fatigue(found, "chain", slopes=[3])
    assert fatigue["damage"].sizes["share"] == graph.sizes["share"]


def _value(scenario: dict[str, Any], path: str) -> Any:
    found: Any = scenario
    for part in path.split("."):
        found = found[int(part)] if isinstance(found, list) else found.get(part, 1.2)
    return found


def test_a_run_goes_on_from_a_snapshot_with_the_same_bits(either):
    scenario = either
    simulation = kingpost.Simulation(scenario)
    simulation.step(40)
    snapshot = simulation.snapshot()
    simulation.step(20)
    again = kingpost.Simulation(scenario)
    again.restore(snapshot)
    again.step(20)
    assert again.snapshot() == simulation.snapshot()


def test_a_line_at_rest_stays_at_rest(tmp_path):
    """Source: without waves and with the fairlead held, nothing moves; the tension has a rounding of 1e-9."""
    still = json.loads(json.dumps(CHAIN))
    still["sea"].pop("waves")
    still["bodies"]["fairlead"]["joint"]["prismatic"].pop("mode")
    still["bodies"]["fairlead"]["joint"]["prismatic"]["mode"] = "held"
    found = kingpost.run(written(tmp_path, still))
    tension = found["line_tension"].squeeze()
    assert float(np.abs(tension / tension[0] - 1).max()) < 1e-6


def test_the_step_of_a_ship_is_not_too_long(scenario):
    assert kingpost.stable_step(scenario) is None
    assert kingpost.Simulation(scenario).model_warnings == []


def test_a_light_body_on_a_wire_needs_shorter_steps(tmp_path):
    """Source: runs. A body of 5 kg between two chains does not rest at 50 ms, beyond the estimate; at a
    ninth of it, it does. The estimate leaves out what body and line exchange within a step."""
    light = json.loads(json.dumps(CHAIN))
    light["sea"].pop("waves")
    light["bodies"]["fairlead"]["mass_t"] = 0.005
    joint = {"floating": {"hold_rotation": True, "initial": {"position_m": [0, 0, -150]}}}
    light["bodies"]["fairlead"]["joint"] = joint
    light["forces"]["above"] = json.loads(json.dumps(light["forces"]["chain"]))
    light["forces"]["above"]["line"]["second"] = {"body": "world", "position_m": [-700, 0, -14]}
    path = written(tmp_path, light)
    limit_s = kingpost.stable_step(path)
    assert limit_s is not None
    assert limit_s < 0.05
    assert any("too long" in text for text in kingpost.Simulation(path).model_warnings)
    for share, rests in ((0.05 / limit_s, False), (1 / 9, True)):
        run = kingpost.Simulation(kingpost.load(path, {"simulation.step_s": share * limit_s}))
        run.settle()
        run.step(round(4.5 / (share * limit_s)))
        assert (np.abs(run.state.v).max() < 1e-3) == rests


PATH = PAID_OUT["forces"]["chain"]["line"]["path"]


def over(path: list[dict[str, Any]]) -> dict[str, Any]:
    """The wire from a drum, with another path."""
    given = copy.deepcopy(PAID_OUT)
    given["forces"]["chain"]["line"]["path"] = path
    return given


MISTAKES = {
    "no stiffness": (with_section(axial_stiffness_N=0), "sections.0.axial_stiffness_N"),
    "no mass": (with_section(mass_kg_per_m=0), "sections.0.mass_kg_per_m"),
    "no diameter": (with_section(diameter_m=0), "sections.0.diameter_m"),
    "no elements": (with_section(elements=0), "sections.0.elements"),
    "too many elements": (with_section(elements=3000), "sections"),
    "no sections": (chain(sections=[]), "sections"),
    "negative drag": (with_section(drag_across=-1), "sections.0.drag_across"),
    "much too short": (with_section(unstretched_length_m=500), "sections.0.unstretched_length_m"),
    "an end below the seabed": (chain(second={"body": "world", "position_m": [779.6, 0, -230]}), "second"),
    "both ends on one body": (chain(second={"body": "fairlead", "position_m": [1, 0, 0]}), "second.body"),
    "an unknown body": (chain(first={"body": "ship", "position_m": [1, 0, 0]}), "first.body"),
    "one point along it": (chain(points_along=1), "points_along"),
    "too many points along it": (chain(points_along=201), "points_along"),
    "a seabed without friction": (chain(seabed={}), "seabed"),
    "ends and a path": (chain(path=PATH), "first"),
    "one end": (chain(second=None), "first"),
    "neither ends nor a path": (chain(first=None, second=None), "first"),
    "an unknown drum": (over([{"drum": {"joint": "wheel", "radius_m": 1}}, *PATH[1:]]), "path.0.drum.joint"),
    "a path of one place": (over(PATH[:1]), "path"),
    "two falls": (over([*PATH[:-1], {"point": {"body": "load", "falls": 2}}]), "path.2.point.falls"),
    "a clump weight at the end": (with_section(clump_weight={"mass_kg": 1}), "sections.0.clump_weight"),
}


@pytest.mark.parametrize("mistake", MISTAKES)
def test_a_mistake_is_refused_by_field(mistake, tmp_path):
    given, field = MISTAKES[mistake]
    with pytest.raises(kingpost.KingpostError) as refused:
        kingpost.Simulation(kingpost.load(written(tmp_path, given)))
    assert f"forces.chain.line.{field}" in str(refused.value)


def test_a_seabed_needs_a_depth(tmp_path):
    given = json.loads(json.dumps(CHAIN))
    given["sea"].pop("depth_m")
    with pytest.raises(kingpost.KingpostError, match=r"seabed\.depth_m"):
        kingpost.Simulation(kingpost.load(written(tmp_path, given)))
