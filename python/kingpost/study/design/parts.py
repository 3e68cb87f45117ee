"""Parts of a run that happen once, and parts that are stationary."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import nan
from typing import Any

from ...results.operation_steps import happens_once, step_names
from .file import StudyFile


@dataclass(frozen=True)
class Parts:
    """Statistical kind of a run and of the steps of its operation.

    Attributes
    ----------
    one_off
        Whether a run happens once: its largest value is a sample, which is not extrapolated. Otherwise the
        whole run is stationary and its largest value is extrapolated to the study's `operation_s`.
    steps
        Names of the steps of the operation; the time after its end counts as one.
    stationary_s
        Duration to which the largest value of each step is extrapolated, s; NaN for a step that happens once.
    """

    one_off: bool
    steps: tuple[str, ...] = ()
    stationary_s: tuple[float, ...] = ()


def parts(file: StudyFile, scenario: Mapping[str, Any]) -> Parts:
    """Find the parts of a study's runs: a scenario with an enabled operation happens once, except for the
    steps in `stationary_steps`; `one_off` in the study decides otherwise.

    Parameters
    ----------
    file
        The study.
    scenario
        Its resolved scenario.

    Raises
    ------
    ScenarioError
        If the study extrapolates a run that happens once, or names a step that is not there.
    """
    content, steps = file.content, step_names(scenario)
    given = content.get("one_off")
    one_off = happens_once(scenario) if given is None else given
    stationary = content.get("stationary_steps", {})
    for name in stationary:
        path = f"stationary_steps.{name}"
        if not one_off:
            raise file.error(path, "a step of a stationary run", "steps of a run that happens once")
        if name not in steps:
            raise file.error(
                path, repr(name), f"a step of the operation: {', '.join(steps) or 'it has none'}"
            )
        if steps.count(name) > 1:
            raise file.error(path, f"{steps.count(name)} steps of this name", "one step of this name")
    if one_off and "operation_s" in content:
        hold = (
            f"stationary_steps: {{{steps[-1]}: {content['operation_s']:g}}} for a step that is stationary, "
        )
        allowed = f"none, {hold if steps else ''}or one_off: false"
        raise file.error("operation_s", f"{content['operation_s']:g} s of what happens once", allowed)
    return Parts(one_off, tuple(steps), tuple(stationary.get(name, nan) for name in steps))
