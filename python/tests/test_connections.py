"""Loops that are released and engaged: snapshots, batches and changes of a run keep their bits."""

from __future__ import annotations

import kingpost
import numpy as np
import pytest

TEXT = """
version: 1
title: A ball that is caught
simulation: {step_s: 0.01, duration_s: 1.5}
bodies:
  bar:
    mass_kg: 300
    inertia: {tensor: {moments_kg_m2: [5, 100, 100]}}
    joint: {floating: {initial: {angular_velocity_deg_s: [0, 0, 20]}}}
  ball:
    mass_kg: 100
    shape: {sphere: {radius_m: 0.3}}
    joint: {floating: {initial: {position_m: [1.5, 3, 0.02], velocity_m_s: [0.1, -3, 0]}}}
loops:
  grip:
    first: {body: bar, position_m: [1.5, 0, 0]}
    second: {body: ball}
    constraints: [x, y, z]
    connection: {begins_released: true, engages: {within: {distance_m: 0.6}}}
operation:
  steps:
    - {name: wait, until: {after_s: 0.2}}
    - name: catch
      set: [{input: grip, to: 0}]
      until: {value: {column: grip.connection_engaged, above: 0.5}}
    - {name: hold, until: {after_s: 0.3}}
    - {name: throw, set: [{input: grip, to: 1}]}
"""


BALL = "bodies.ball.mass_kg"


def scenario(mass_kg: float = 100.0) -> kingpost.Scenario:
    return kingpost.Scenario(TEXT, "ball.yaml", ((BALL, mass_kg),))


def test_the_ball_is_caught_held_and_thrown() -> None:
    run = kingpost.Simulation(scenario()).run()
    events = run.kingpost.events
    told = [str(code) for code in events.event_code.values[events.event_element.values == "grip"]]
    assert told == ["out_of_tolerance", "engages", "released"]


@pytest.mark.parametrize("at_step", [10, 40, 70, 100])
def test_a_snapshot_of_a_connection_resumes_to_the_same_bits(at_step: int) -> None:
    """Source: identity. At these steps it is free, waits, holds, and is free again."""
    one = kingpost.Simulation(scenario())
    one.step(at_step)
    taken = one.snapshot()
    one.step(150 - at_step)
    other = kingpost.Simulation(scenario())
    other.restore(taken)
    other.step(150 - at_step)
    assert np.array_equal(one.row(), other.row())


def test_a_batch_of_connections_equals_single_runs_bit_for_bit() -> None:
    """Source: identity. The balls are caught at different times."""
    masses = [80.0, 100.0, 130.0]
    batch = kingpost.Batch(scenario(), {BALL: masses}).run()
    for k, mass in enumerate(masses):
        single = kingpost.Simulation(scenario(mass)).run()
        for name in ("position", "linear_momentum", "connection_impulse", "energy_dissipated"):
            assert np.array_equal(batch[name].isel(run=k).values, single[name].values), name
