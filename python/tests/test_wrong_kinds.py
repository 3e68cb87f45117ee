"""Values of a wrong kind are named with what is allowed; no error of another library reaches the caller."""

from __future__ import annotations

from collections.abc import Callable

import kingpost
import numpy as np
import pytest
from kingpost import KingpostError, Simulation

WITH_LEVER = "lowering_by_winch"


@pytest.mark.parametrize(
    ("act", "message"),
    [
        (lambda sim: sim.step(10**30), "n: found 10{30}, allowed: a whole number from 0 to 1e.15"),
        (lambda sim: sim.set_input("hoist", None), "input hoist: found None, allowed: a number"),
        (lambda sim: sim.set_input("hoist", "fast"), "input hoist: found 'fast', allowed: a number"),
        (lambda sim: sim.set_input(None, 0.0), "None"),
        (lambda sim: sim.restore("yesterday"), "snapshot: found 'yesterday', allowed: the bytes"),
        (lambda sim: sim.restore(bytearray(b"x")), "not a Kingpost snapshot"),
        (lambda sim: sim.set_state([1j], [0.0]), r"q: found \[1j\], allowed: real numbers"),
        (lambda sim: sim.set_state("here", [0.0]), "q: found 'here', allowed: real numbers"),
        (
            lambda sim: sim.set_state([[1], [2, 3]], [0.0]),
            r"q: found \[\[1\], \[2, 3\]\], allowed: real numbers",
        ),
        (lambda sim: sim.acceleration(["push"]), r"tau: found \['push'\], allowed: real numbers"),
        (lambda _: kingpost.Batch("paper", None), "parameters: found None, allowed: lists of values by name"),
        (
            lambda _: kingpost.Batch("paper", {"crane_x_m": 1.0}),
            "parameters: found 1.0 for crane_x_m, allowed: a list",
        ),
        (
            lambda _: kingpost.modes("paper", sweep={"damping": 5}),
            "sweep: found 5 for damping, allowed: a list",
        ),
    ],
)
def test_a_value_of_a_wrong_kind_is_named(act: Callable[[Simulation], object], message: str) -> None:
    with pytest.raises(KingpostError, match=message):
        act(Simulation(kingpost.load(WITH_LEVER)))


def test_a_snapshot_is_accepted_as_any_bytes_like_object() -> None:
    simulation = Simulation(kingpost.load("paper"))
    kept = simulation.snapshot()
    simulation.step(3)
    simulation.restore(bytearray(kept))
    assert simulation.time_s == 0
    assert np.array_equal(simulation.state.q, Simulation(kingpost.load("paper")).state.q)
