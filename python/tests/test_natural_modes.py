"""The oscillations found in the app are those of `kingpost.modes`."""

import json
import re

import kingpost
import numpy as np
import pytest
import xarray
from kingpost import gallery
from kingpost.engine import engine
from kingpost.errors import KingpostError
from lanes import sampled

SAME = 2e-3
"""Of a period and of a damping ratio: the browser takes differences, and the slowest yaw of a ship beside a
stiff rope, whose rates are a millionth of the rope's, has three digits left; what swings in seconds, six."""
QUICK = 1e-5
QUICK_S = 50
SLOWEST_S = 1e4
KEPT = [
    "a_frame_over_the_stern",
    "anti_heeling_tank",
    "chain",
    "dual_draglink_crane",
    "flexible_boom",
    "heave_compensation",
    "offshore_vessel_moored_quasi_static",
    "offshore_vessel_on_dp",
]
"""A rope, a tank, hinges, loops with cylinders, a boom that bends, a controller, moorings, thrusters."""
MEMORY_SHARE = 0.3
"""What the water's memory takes part in a mode of bodies at most."""


def of_the_browser(name: str) -> list[dict]:
    scenario = kingpost.load(name)
    simulation = engine.Simulation(engine.Scenario(scenario.text, scenario.file, "[]", scenario.files))
    return json.loads(simulation.natural_modes_json())


def simulation_has_controllers(modes: xarray.Dataset) -> bool:
    return any("filter" in str(name) for name in modes.coordinate.values)


@pytest.mark.parametrize("name", sampled(gallery.names(), keep=KEPT))
def test_the_oscillations_in_the_app_equal_those_of_the_package(name: str) -> None:
    try:
        expected = kingpost.modes(name)
    except KingpostError as error:
        with pytest.raises(KingpostError, match=re.escape(str(error).rpartition(": ")[2])):
            of_the_browser(name)
        return
    swings = expected.damped_period.values < SLOWEST_S
    pairs = expected.isel(mode=np.flatnonzero(swings))
    found = of_the_browser(name)
    periods = [mode["period_s"] for mode in found]
    assert periods == sorted(periods, reverse=True)
    for mode in found:
        # What moves as prescribed is held in the browser; the package has it as at the start, and says so.
        same = QUICK if mode["period_s"] < QUICK_S and "warning" not in expected.attrs else SAME
        beside = np.abs(pairs.damped_period.values / mode["period_s"] - 1) < same
        assert beside.any(), mode
        assert np.abs(pairs.damping_ratio.values[beside] - mode["damping_ratio"]).min() < same, mode
    # No mode of bodies is missing: only those of the water's memory, a controller or a line.
    if simulation_has_controllers(expected):
        return
    is_missing = [
        np.abs(period / np.array(periods) - 1).min(initial=1) > SAME for period in pairs.damped_period.values
    ]
    of_water = pairs.memory_share.values > MEMORY_SHARE
    of_line = np.array([".node_" in str(name) for name in pairs.named_after.values], dtype=bool)
    missing = np.array(is_missing, dtype=bool) & ~of_water & ~of_line
    assert not missing.any(), pairs.isel(mode=missing)
