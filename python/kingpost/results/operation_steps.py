"""Steps of an operation, from the resolved scenario of a run."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

COLUMN = "operation.operation_step"
"""Column with the number of the current step."""
AFTER = "after the operation"
"""Name of the time after the end of the last step."""


def steps_of(scenario: Mapping[str, Any]) -> list[Mapping[str, Any]]:
    """List the steps of a resolved scenario's operation; empty without an enabled one.

    >>> steps_of({"operation": {"enabled": True, "steps": [{"name": "hold"}]}})
    [{'name': 'hold'}]
    """
    return list(scenario["operation"]["steps"]) if happens_once(scenario) else []


def happens_once(scenario: Mapping[str, Any]) -> bool:
    """Whether a run is an operation that happens once: the scenario has an enabled operation. The largest
    value of a run is then a sample, and is not extrapolated to another duration.

    >>> happens_once({"operation": None}), happens_once({"operation": {"steps": [{"name": "lift off"}]}})
    (False, True)
    """
    operation = scenario.get("operation")
    return operation is not None and bool(operation.get("enabled", True))


def step_names(scenario: Mapping[str, Any]) -> list[str]:
    """Names of the steps, and `AFTER` if the last step ends: one without moves and a condition lasts to the
    end of the run.

    >>> step_names({"operation": {"steps": [{"name": "lift", "until": {"after_s": 5}}, {"name": "hold"}]}})
    ['lift', 'hold']
    """
    steps = steps_of(scenario)
    ends = bool(steps) and bool(steps[-1].get("set") or steps[-1].get("until"))
    return [str(step["name"]) for step in steps] + [AFTER] * ends


def rows_of_step(number: NDArray[np.float64], k: int, steps: int) -> NDArray[np.intp]:
    """Places of the rows of a step, from the number of the step in each row.

    Parameters
    ----------
    number
        The column `COLUMN`.
    k
        Place of the step among `step_names`.
    steps
        Number of these names; the last one has all rows to the end of the run.

    Returns
    -------
    numpy.ndarray
        Places, rising.

    >>> rows_of_step(np.array([1.0, 1.0, 3.0]), 1, 2).tolist()
    [2]
    """
    return np.flatnonzero(number >= k + 1 if k + 1 == steps else number == k + 1)
