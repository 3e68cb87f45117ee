"""Variables of events, warnings and limits in a data set, along the dimensions ``event``, ``warning`` and
``limit``: their keys, types and attributes."""

from __future__ import annotations

from dataclasses import dataclass

MODEL = "model"
"""Code of the warnings about the model, from before the run; they have no time and no name."""
HELD = "held"
OF_RUNS = ("limit_held", "limit_worst", "limit_worst_time")
"""Variables with a value for each run of a `Batch`."""
BOUNDS = ("limit_at_least", "limit_at_most", "limit_percentile")
"""Variables with a value for each run of a `Batch` whose runs differ in it."""


@dataclass(frozen=True)
class Field:
    """Variable of a table: its key in an entry, its type, its attributes, and whether NaN stands for a
    missing value. Files of earlier versions may lack a later one."""

    key: str
    kind: type
    about: dict[str, str]
    optional: bool = False
    later: bool = False


def _text(key: str, long_name: str, description: str) -> Field:
    return Field(key, str, {"long_name": long_name, "description": description})


def _number(key: str, long_name: str, description: str, optional: bool = False) -> Field:
    return Field(key, float, {"long_name": long_name, "description": description}, optional)


def _time(key: str, long_name: str, description: str, optional: bool = False) -> Field:
    about = {"units": "s", "long_name": long_name, "description": description}
    return Field(key, float, about, optional)


TABLES: dict[str, dict[str, Field]] = {
    "event": {
        "event_time": _time("time_s", "time", "time of the event"),
        "event_code": _text("code", "code", "kind of event, in words joined by _"),
        "event_element": _text("element", "element", "element that watches for it, or parameter"),
        "event_what": _text("what", "event", "name of the event"),
    },
    "warning": {
        "warning_time": _time("time_s", "time", "time of the warning; NaN before the run"),
        "warning_code": _text("code", "code", "cause, in words joined by _; model: about the model"),
        "warning_name": _text("name", "name", "a joint, closed loop, body, force or drive"),
        "warning_value": _number("value", "value", "value beyond its bound; NaN without number", True),
        "warning_bound": _number("bound", "bound", "bound of the value; NaN without number", True),
        "warning_unit": _text("unit", "unit", "unit of value and bound"),
        "warning_text": _text("text", "warning", "text of the warning"),
        "warning_run": Field("run", int, {"long_name": "run", "description": "-1 for every run"}),
    },
    "limit": {
        "limit_name": _text("name", "limit", "name of the limit in the scenario"),
        "limit_column": _text("column", "column", "column of the results"),
        "limit_unit": _text("unit", "unit", "unit of bounds and worst value"),
        "limit_at_least": _number("at_least", "lower bound", "smallest allowed value; NaN: no bound", True),
        "limit_at_most": _number("at_most", "upper bound", "largest allowed value; NaN: no bound", True),
        "limit_percentile": Field("percentile", float, {
            "units": "%", "long_name": "percentile", "description": "rows that must be within the bounds",
        }, later=True),
        "limit_held": Field(HELD, bool, {
            "long_name": "held", "description": "1: held, 0: exceeded, -1: unknown, no row counted"}),
        "limit_worst": _number("worst", "worst value", "nearest to a bound or farthest beyond it", True),
        "limit_worst_time": _time("worst_time_s", "time", "time of the worst value", True),
    },
}  # fmt: skip
"""Fields by name of the variable, for each dimension."""

NAMES = frozenset(name for fields in TABLES.values() for name in fields)
"""Names of the variables, which are no columns over time."""
