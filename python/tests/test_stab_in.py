"""The stab-in of docs/checked: its lateral catch, touch, push on the flank and place by hand; its bits in a
batch and after a snapshot."""

from __future__ import annotations

from math import atan, radians, sin
from pathlib import Path
from typing import Any

import kingpost
import numpy as np
import pytest
import xarray
from lanes import sampled

FILE = Path(__file__).resolve().parents[2] / "docs" / "checked" / "stab_in.yaml"
RIM_M, BAR_M, PIN_M = 0.45, 0.05, 0.38
HALF_ANGLE, FRICTION = radians(30), 0.2
WEIGHT_N = 20_000 * 9.80665
STAB, LANDED = 3, 5
"""Steps of the operation."""


@pytest.fixture(scope="module")
def run() -> xarray.Dataset:
    return kingpost.run(FILE)


def step(run: xarray.Dataset) -> np.ndarray:
    return np.asarray(run.kingpost["operation.operation_step"])


@pytest.mark.parametrize("friction", sampled([0.2, 0.3], keep=[0.2]))
def test_the_socket_catches_a_tip_up_to_the_crest_of_its_rim_where_friction_holds(friction: float) -> None:
    """Source: geometry. The slope b of a bar of radius r at x from the axis has sin b = (R - x) / r, and a
    tip slides down a slope above atan mu. 0.3 s after the touch it has slid by 20 mm, or holds to 2 mm
    (measured)."""
    catch = RIM_M - BAR_M * sin(atan(friction))
    short: dict[str, Any] = {
        "simulation.duration_s": 9,
        "simulation.record_every_s": 0.1,
        "friction": friction,
    }
    offsets = [catch - 0.005, catch + 0.005]
    runs = kingpost.Batch(FILE, {"offset": offsets}, short).run()
    moved_m = runs.point_position.sel(point="column.tip", axis="x").values[:, -1] - offsets
    assert moved_m[0] < -0.01
    assert abs(moved_m[1]) < 0.003


def test_the_cone_touches_with_the_part_of_the_hooks_speed_across_its_flank(run: xarray.Dataset) -> None:
    """Source: 0.64 rad/s, a drum of 0.5 m, four falls, a flank at 30 degrees. The hook swings up and down by
    1 mm/s from its start (measured)."""
    touched = run.contact_impact_speed.sel(contact="cone").values
    first = float(touched[np.flatnonzero(touched)[0]])
    assert first == pytest.approx(0.64 * 0.5 / 4 * sin(HALF_ANGLE), rel=0.02)


def sliding_in(run: xarray.Dataset) -> tuple[xarray.Dataset, np.ndarray]:
    """The cone's contact in the rows in which its one point slides into the socket, and its flank's angle."""
    cone = run.sel(contact="cone")
    angle = HALF_ANGLE + np.asarray(run.kingpost["column.pitch"])
    limit = FRICTION * cone.contact_normal_force.values
    moves_in = run.point_velocity.sel(point="column.tip", axis="x").values < -0.02
    at_limit = cone.contact_friction_force.values > (1 - 1e-9) * limit
    # Below, the bar is on the edge of the cone's base: R - r cos a - 0.381 m, and the lean of the cone.
    on_flank = run.point_position.sel(point="column.tip", axis="x").values > 0.05
    rows = (cone.contact_points.values == 1) & moves_in & at_limit & on_flank
    return cone.isel(time=rows), angle[rows]


def test_the_rim_pushes_by_the_normal_force_less_friction(run: xarray.Dataset) -> None:
    """Source: statics on the flank, N (cos a - mu sin a) aside, N (sin a + mu cos a) up."""
    cone, angle = sliding_in(run)
    assert cone.sizes["time"] > 20
    normal = cone.contact_normal_force.values
    push, carried = -cone.contact_force.values[:, 0], cone.contact_force.values[:, 2]
    assert push == pytest.approx(normal * (np.cos(angle) - FRICTION * np.sin(angle)), rel=1e-3)
    assert carried == pytest.approx(normal * (np.sin(angle) + FRICTION * np.cos(angle)), rel=1e-3)


def test_the_column_stands_within_the_clearance_of_its_pin(run: xarray.Dataset) -> None:
    """Source: geometry, and the weight on the base alone once the rope is slack."""
    place_m = run.contact_position.sel(contact="seat", axis="x").values[-1]
    depth_m = float(run.contact_penetration.sel(contact="pin").values[-1])
    assert 0 < place_m <= RIM_M - BAR_M - PIN_M + depth_m
    carried = run.contact_force.sel(axis="z").values[-1].sum()
    assert carried == pytest.approx(WEIGHT_N, rel=1e-6)


def test_every_step_ends_and_every_limit_holds(run: xarray.Dataset) -> None:
    assert step(run)[-1] == LANDED + 1
    assert all(limit["held"] for limit in run.kingpost.limits)


def test_a_batch_of_stab_ins_has_the_bits_of_single_runs() -> None:
    """Source: identity. They touch at different times and places."""
    short = {"simulation.duration_s": 15.0, "simulation.record_every_s": 0.1}
    offsets = [0.1, 0.2, 0.3]
    batch = kingpost.Batch(FILE, {"offset": offsets}, short).run()
    for k, offset in enumerate(offsets):
        single = kingpost.run(FILE, short, offset=offset)
        for name in ("position", "contact_force", "contact_impulse", "contact_tilt", "energy_dissipated"):
            np.testing.assert_array_equal(batch[name].isel(run=k).values, single[name].values, err_msg=name)


@pytest.mark.parametrize("at_s", [8, 12, 24])
def test_a_snapshot_of_a_stab_in_resumes_to_the_same_bits(at_s: int) -> None:
    """Source: identity. At these times it hangs, slides in, stands."""
    one = kingpost.Simulation(kingpost.load(FILE))
    one.step(at_s * 250)
    taken = one.snapshot()
    one.step(500)
    other = kingpost.Simulation(kingpost.load(FILE))
    other.restore(taken)
    other.step(500)
    assert np.array_equal(one.row(), other.row())
