"""Content of a study's file, with the engine's defaults."""

from __future__ import annotations

from typing import Literal, NotRequired, TypedDict

from ...scenario import Json, ParameterValue

Interval = TypedDict("Interval", {"from": float, "to": float})
EvenRange = TypedDict("EvenRange", {"from": float, "to": float, "count": int})


class Axis(TypedDict, total=False):
    """Values of an axis, given in one of these forms."""

    values: list[ParameterValue]
    range: EvenRange
    latin_hypercube: Interval
    scatter: Literal["significant_height", "peak_period"]


class Samples(TypedDict):
    """Samples of a Latin hypercube."""

    count: int
    seed: int


class Seeds(TypedDict):
    """Seeds of every case."""

    first: int
    count: int


class Rainflow(TypedDict):
    """Columns whose cycles are counted, and exponents of the damage sums."""

    columns: list[str]
    slopes: list[float]


class Peaks(TypedDict):
    """Columns whose largest peaks are kept, and the number of peaks."""

    columns: list[str]
    keep: int


class Content(TypedDict):
    """Fields of a study."""

    version: int
    title: str
    description: str
    scenario: str
    set: dict[str, Json]
    axes: dict[str, Axis]
    samples: NotRequired[Samples]
    seeds: Seeds
    after_s: float
    record: list[str]
    rainflow: NotRequired[Rainflow]
    peaks: NotRequired[Peaks]
    limits: dict[str, dict[str, Json]]
    operation_s: NotRequired[float]
    one_off: NotRequired[bool]
    stationary_steps: NotRequired[dict[str, float]]
    acceptance: float
    scatter: NotRequired[str]
    sea: dict[str, str]
