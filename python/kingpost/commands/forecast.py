"""`kingpost forecast`: go or no-go decision and weather windows from a forecast of the sea."""

from __future__ import annotations

import argparse
import math
from typing import TYPE_CHECKING

from ..errors import KingpostError, flag
from ..study.sea_states.periods import MOMENTS, PEAK
from .common import DONE, add_output, scenario_of, show

if TYPE_CHECKING:
    from ..study.limiting.sea import LimitingHeight
    from ..study.sea_states.series import Series

HELP = "go or no-go and weather windows, from a forecast of the sea"


def add_options(command: argparse.ArgumentParser) -> None:
    """The command's options."""
    _add_limits(command)
    _add_forecast(command)
    command.add_argument("--alpha", type=float, required=True, metavar="A",
                         help="allowed forecast height as a share of the limiting height")  # fmt: skip
    command.add_argument("--operation-hours", type=float, default=6.0, metavar="H",
                         help="planned operation period (default: 6)")  # fmt: skip
    command.add_argument("--contingency-hours", type=float, metavar="H",
                         help="time for contingencies (default: as long as the planned period)")  # fmt: skip
    command.add_argument("--now", metavar="TIME", help="decision time, UTC (default: the first record)")
    command.add_argument("--ahead-hours", type=float, default=72.0, metavar="H",
                         help="time ahead to search for windows (default: 72)")  # fmt: skip
    add_output(command)


def _add_limits(command: argparse.ArgumentParser) -> None:
    command.add_argument("scenario", metavar="SCENARIO", nargs="?",
                         help="a file or a gallery name: limiting heights by the screen")  # fmt: skip
    command.add_argument("--set", action="append", default=[], metavar="name=value",
                         help="set a parameter or a field; may be repeated")  # fmt: skip
    command.add_argument("--study", metavar="FOLDER", help="limiting heights by the runs of a study instead")
    command.add_argument("--at", action="append", default=[], metavar="name=value",
                         help="value of a further axis of the study; may be repeated")  # fmt: skip
    command.add_argument("--acceptance", type=float, metavar="P",
                         help="accepted probability (default: the study's, or 0.1)")  # fmt: skip
    command.add_argument("--exposure-s", type=float, metavar="T",
                         help="duration for P (default: the study's, or 1800)")  # fmt: skip


def _add_forecast(command: argparse.ArgumentParser) -> None:
    command.add_argument("--series", required=True, metavar="FILE",
                         help="the forecast: .nc, as of ERA5, or CSV with time, hs, tp, mwd")  # fmt: skip
    command.add_argument("--heading-deg", type=float, metavar="H",
                         help="direction of the scenario's x axis, from north")  # fmt: skip
    command.add_argument("--direction-deg", type=float, metavar="D",
                         help="instead: one direction of all waves; 180 is a head sea")  # fmt: skip
    command.add_argument("--place", nargs=2, type=float, metavar=("LATITUDE", "LONGITUDE"),
                         help="deg: position; the nearest of several points is taken")  # fmt: skip
    command.add_argument("--columns", action="append", default=[], metavar="what=NAME",
                         help="column of time, height, period or direction; may be repeated")  # fmt: skip
    command.add_argument("--direction-is", choices=("from", "to"),
                         help="meaning of a direction under an unknown name")  # fmt: skip
    command.add_argument("--direction-unit", choices=("deg", "rad"),
                         help="unit of directions that all lie between 0 and 2 pi")  # fmt: skip
    command.add_argument("--period-is", choices=(PEAK, *MOMENTS),
                         help="kind of a period under an unknown name")  # fmt: skip
    command.add_argument("--peak-enhancement", type=float, default=3.3, metavar="G",
                         help="gamma to convert mean periods to peak periods (default: 3.3)")  # fmt: skip


def run(options: argparse.Namespace) -> int:
    """Read the forecast, decide and print."""
    import numpy as np

    from ..reports.forecast import text
    from ..study.sea_states import series_file
    from ..study.sea_states.series import moment
    from ..study.weather_windows.decision import decide
    from ..study.weather_windows.windows import reference_period_h

    reference_h = reference_period_h(options.operation_hours, options.contingency_hours)
    found = series_file.read(
        options.series,
        dict(_pair(given, "columns") for given in options.columns),
        options.direction_is,
        None if options.place is None else (options.place[0], options.place[1]),
        period=options.period_is,
        direction_unit=options.direction_unit,
    ).with_peak_periods(options.peak_enhancement)
    if options.heading_deg is None and options.direction_deg is None:
        heading, one = flag("heading_deg"), flag("direction_deg")
        allowed = f"{heading}, for the forecast's directions, or {one}, for one of all waves"
        raise KingpostError(f"direction: found neither, allowed: {allowed}")
    direction = None if options.direction_deg is None else math.radians(options.direction_deg)
    limiting, of = _limiting(options, found, direction)
    decision = decide(
        found,
        limiting,
        options.alpha,
        reference_h,
        None if options.now is None else np.datetime64(moment(options.now, flag("now"))),
        options.ahead_hours,
        x_axis_deg=options.heading_deg,
        direction_rad=direction,
    )
    show(options, lambda: text(decision, of), decision.to_dict)
    return DONE


def _limiting(
    options: argparse.Namespace, series: Series, direction: float | None
) -> tuple[LimitingHeight, list[str]]:
    """Limiting heights, and lines of text on their origin."""
    import numpy as np

    if (options.study is None) == (options.scenario is None):
        found = "both" if options.study is not None else "neither"
        raise KingpostError(f"SCENARIO, --study: found {found}, allowed: one of them")
    if options.study is not None:
        return _of_study(options)
    from ..study.screening.screened_sea import of_screen

    scenario = scenario_of(options)
    exposure_s = 1800.0 if options.exposure_s is None else options.exposure_s
    acceptance = 0.1 if options.acceptance is None else options.acceptance
    directions = (
        series.directions_rad(options.heading_deg)
        if direction is None
        else np.full(len(series.time), direction)
    )
    limiting = of_screen(scenario, series.period_s, directions, exposure_s, acceptance)
    return limiting, [
        str(scenario.resolved.get("title", options.scenario)),
        f"limiting heights by linear response: {_accepted(acceptance, exposure_s)}",
        *([f"warning: {limiting.refused}"] if limiting.refused else []),
    ]


def _of_study(options: argparse.Namespace) -> tuple[LimitingHeight, list[str]]:
    from ..study.limiting.runs import limiting_heights
    from ..study.limiting.sea import LimitingSea
    from ..study.study import open_study

    results = open_study(options.study)
    found = limiting_heights(results, options.acceptance, options.exposure_s)
    at = dict(_pair(given, "at") for given in options.at)
    values = {
        name: _like(value, results[name].values) if name in results.coords else value
        for name, value in at.items()
    }
    return LimitingSea.of(found, values), [
        str(results.attrs.get("title", options.study)),
        f"limiting heights of the study {options.study}: "
        + _accepted(found.attrs["acceptance"], found.attrs["operation_s"]),
    ]


def _accepted(acceptance: float, exposure_s: float) -> str:
    return f"each limit exceeded in {exposure_s:g} s with a probability of {acceptance:g} at most"


def _pair(given: str, name: str) -> tuple[str, str]:
    first, is_given, second = given.partition("=")
    if not (is_given and first and second):
        raise KingpostError(f"--{name}: found {given!r}, allowed: name=value")
    return first.strip(), second.strip()


def _like(text: str, values: object) -> float | str:
    """Return the value of an axis that matches a text."""
    import numpy as np

    array = np.asarray(values)
    if np.issubdtype(array.dtype, np.number):
        try:
            return float(text)
        except ValueError:
            return text
    return text
