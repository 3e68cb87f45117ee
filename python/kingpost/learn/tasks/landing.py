"""Set a load down on the deck of a boat in the sea."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import astuple, dataclass
from pathlib import Path

import numpy as np

from ...scenario import Scenario, load
from ..task import Columns, Goal, Observation, Task

SCENARIOS = Path(__file__).parents[1] / "scenarios"
TIP, TIP_RATE = "boom.tip.point_position.z", "boom.tip.point_velocity.z"
DECK, DECK_RATE = "boat.berth.point_position.z", "boat.berth.point_velocity.z"
LOAD_RATE = "lift.velocity.z"
FALLS = 4
SLACK_M = 0.5
"""Slack of each fall from which on the load counts as landed, m."""
CLEAR_M = 0.02
"""Height over the deck from which on a load counts as lifted again after it touched the deck, m."""


def column(scenario: Scenario, element: str, quantity: str) -> str:
    """Name of an element's column: the engine puts the element's kind before the quantity.

    >>> column(landing().based_on, "cargo_deck", "gap").startswith("cargo_deck.")
    True
    """
    (kind,) = scenario.resolved["forces"][element]
    return f"{element}.{kind}_{quantity}"


@dataclass(frozen=True)
class _Landing:
    """Observations, reward and end, from the columns of deck and rope."""

    gap: str
    impulse: str
    press: str
    stretch: str
    tension: str

    def observations(self) -> list[Observation]:
        return [
            Observation("height_over_deck", 2.0, "m", lambda columns, goal: columns[self.gap]),
            Observation(
                "relative_speed", 0.5, "m/s", lambda columns, goal: columns[LOAD_RATE] - columns[DECK_RATE]
            ),
            Observation("hook_load", 2e5, "N", lambda columns, goal: FALLS * columns[self.tension]),
            Observation("deck_force", 2e5, "N", lambda columns, goal: columns[self.press]),
            Observation("has_touched", 1.0, "1", lambda columns, goal: 1.0 * (columns[self.impulse] > 0.0)),
            Observation(
                "slack", 0.5, "m", lambda columns, goal: np.maximum(-columns[self.stretch] / FALLS, 0.0)
            ),
            Observation("deck_heave", 1.0, "m", lambda columns, goal: columns[DECK] - goal[:, 1]),
            Observation("deck_heave_rate", 0.5, "m/s", lambda columns, goal: columns[DECK_RATE]),
            Observation("tip_heave", 1.0, "m", lambda columns, goal: columns[TIP] - goal[:, 0]),
            Observation("tip_heave_rate", 0.5, "m/s", lambda columns, goal: columns[TIP_RATE]),
            Observation("winch.joint_velocity", 4.0),
            Observation("hull.roll", 0.05),
        ]

    def reward(self, columns: Columns, goal: Goal, actions: np.ndarray) -> np.ndarray:
        gap, impulse, stretch = columns[self.gap], columns[self.impulse], columns[self.stretch]
        gap_before, impulse_before, stretch_before = (
            columns[f"before.{name}"] for name in (self.gap, self.impulse, self.stretch)
        )
        touched = impulse_before > 0.0
        meets = (gap_before > 0.0) & (impulse > impulse_before)
        closing = np.maximum(columns[f"before.{DECK_RATE}"] - columns[f"before.{LOAD_RATE}"], 0.0)
        waiting = 0.01 + 0.005 * np.maximum(gap, 0.0)
        lifted, taut = touched & (gap > CLEAR_M), touched & (stretch_before <= 0.0) & (stretch > 0.0)
        return -waiting - 20.0 * np.where(meets, closing * closing, 0.0) - 0.1 * lifted - 0.5 * taut

    def done(self, columns: Columns, goal: Goal) -> np.ndarray:
        """Whether the load pressed on the deck in this control step and its rope is slack."""
        pressed = columns[self.impulse] > columns[f"before.{self.impulse}"]
        return pressed & (columns[self.stretch] <= -FALLS * SLACK_M)


def _goal(random: np.random.Generator, start: Mapping[str, float]) -> Sequence[float]:
    """Heights of tip and deck in calm water, m: at the start the sea is calm."""
    return start[TIP], start[DECK]


def landing(randomised: bool = True) -> Task:
    """Set a load down on the deck of a supply boat in the sea by the speed of the winch.

    The load hangs some 6 to 10 m over the deck. With its height h over the deck and the speed v at which the
    two close, a control step of 0.1 s gives

        -0.01 - 0.005 h / 1 m - 20 (v / 1 m/s)^2 [it meets the deck] - 0.1 [it is off the deck again, by 2 cm]
        - 0.5 [its rope, slack after the deck was met, comes taut]

    An episode ends with the load on the deck and half a metre of slack on each fall, or after 90 s.

    Parameters
    ----------
    randomised
        Whether each episode draws the significant wave height, 1 to 2.5 m, the peak period, 7 to 11 s, the
        direction of the sea, 150 to 210 degrees, the load, 10 to 30 t, and its height. The seed of the sea is
        drawn in any case.

    Returns
    -------
    Task
        One action, the speed of the winch; 12 observations.

    >>> landing().observation_names[:3]
    ('height_over_deck', 'relative_speed', 'hook_load')
    """
    scenario = load(SCENARIOS / "landing.yaml")
    deck = [column(scenario, "cargo_deck", name) for name in ("gap", "impulse", "normal_force")]
    rules = _Landing(*deck, *(column(scenario, "hoist_rope", name) for name in ("stretch", "tension")))
    drawn = {
        "significant_height_m": (1.0, 2.5),
        "peak_period_s": (7.0, 11.0),
        "sea.waves.wind_sea.jonswap.direction_deg": (150.0, 210.0),
        "load_t": (10.0, 30.0),
        "load_height_m": (10.0, 14.0),
    }
    return Task(
        scenario,
        ["hoist"],
        rules.observations(),
        rules.reward,
        columns=[*astuple(rules), TIP, TIP_RATE, DECK, DECK_RATE, LOAD_RATE],
        before=[rules.gap, rules.impulse, rules.stretch, DECK_RATE, LOAD_RATE],
        done=rules.done,
        control_period_s=0.1,
        duration_s=90.0,
        goal=_goal,
        randomised=drawn if randomised else {},
        seeded=True,
    )
