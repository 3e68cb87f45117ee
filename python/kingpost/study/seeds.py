"""Number of seeds that a study needs for what it is to show."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from ..analysis.extremes import seeds_for_interval, seeds_without_exceedance
from .design.plan import Plan
from .limiting.runs import fewest_seeds

CONFIDENCE = 0.9


@dataclass(frozen=True)
class SeedCount:
    """Seeds of each case of a study, and the numbers that its accepted probability needs.

    Attributes
    ----------
    found
        Seeds of each case.
    acceptance
        Accepted probability of exceedance.
    one_off
        Whether a run happens once.
    for_estimate
        Number from which there is an estimate at the accepted probability.
    without_exceedance
        Number that shows the accepted probability at 90 % confidence, if no run exceeds the limit.
    for_interval
        Number from which the estimate has a 90 % interval with two finite ends.
    """

    found: int
    acceptance: float
    one_off: bool
    for_estimate: int
    without_exceedance: int
    for_interval: int

    @classmethod
    def of(cls, plan: Plan) -> SeedCount:
        """Count the seeds of a plan.

        >>> from kingpost import Study
        >>> found = SeedCount.of(Study({"version": 1, "title": "x", "scenario": "lift_off_from_barge",
        ...     "seeds": {"count": 10}}).plan)
        >>> found.for_estimate, found.without_exceedance, found.for_interval
        (7, 22, 29)
        """
        acceptance, once = plan.file.content["acceptance"], plan.parts.one_off
        fewest = fewest_seeds(acceptance, once)
        without, interval = (
            (seeds_without_exceedance(acceptance, CONFIDENCE), seeds_for_interval(acceptance, CONFIDENCE))
            if once
            else (fewest, fewest)
        )
        return cls(len(plan.seeds), acceptance, once, fewest, without, interval)

    def sentences(self) -> Iterator[str]:
        """Yield what the seeds are enough for."""
        if not self.one_off:
            yield (
                f"{self.found} of each case; {self.for_estimate} or more give an extreme of a stationary "
                "run, 10 or more a useful interval"
            )
            return
        accepted, sure = f"{100 * self.acceptance:g} %", f"{100 * CONFIDENCE:g} %"
        yield (
            f"{self.found} of each case; {self.for_estimate} give the value that is exceeded with "
            f"{accepted}, {self.for_interval} its {sure} interval"
        )
        yield (
            f"{self.without_exceedance} without an exceedance show at most {accepted} at {sure} confidence; "
            f"{self.found} show it at {100 * (1 - (1 - self.acceptance) ** self.found):.0f} %"
        )


def too_few(plan: Plan) -> str:
    """Describe that a study with limits has too few seeds for an interval; empty if it has enough, or asks
    for no statistics: one seed of each case, without an axis of the significant height.

    >>> from kingpost import Study
    >>> too_few(Study({"version": 1, "title": "x", "scenario": "paper", "record": ["ship.roll"]}).plan)
    ''
    """
    count = SeedCount.of(plan)
    asks = bool(plan.limits) and (count.found > 1 or "significant_height" in plan.sea)
    if not asks or count.found >= count.for_interval:
        return ""
    return (
        f"seeds: found {count.found} of each case, {count.for_interval} give the value that is exceeded "
        f"with {100 * count.acceptance:g} % an interval at {100 * CONFIDENCE:g} % confidence"
    )


def kind_of_runs(plan: Plan) -> str:
    """Describe which parts of a run happen once, and to which durations others are extrapolated."""
    parts = plan.parts
    if not parts.one_off:
        content, settings = plan.file.content, plan.scenario.resolved["simulation"]
        length_s = settings["duration_s"] - content["after_s"]
        return f"stationary, extrapolated from {length_s:g} s to {content.get('operation_s', length_s):g} s"
    held = plan.file.content.get("stationary_steps", {})
    words = "a run happens once: its largest value is a sample, without an extrapolation"
    if not held:
        return words
    return f"{words}; but {', '.join(f'{name} to {duration_s:g} s' for name, duration_s in held.items())}"
