"""Report of the outcomes of runs: limits and warnings.

For several runs with different seeds, each limit and each warning is printed once.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from ..analysis import pooling
from ..errors import KingpostError
from ..results.entries import limits_of_runs, warnings_of_runs
from ..results.kept import has_entries
from ..simulation.outcomes import Outcome, in_words, of_run, with_partings
from .tables import of_the_time, table, unit_cell

if TYPE_CHECKING:
    import xarray


def of_runs(runs: Sequence[xarray.Dataset]) -> list[Outcome]:
    """The outcomes of recorded runs; a data set may hold a `Batch`.

    Raises
    ------
    KingpostError
        If events, warnings or limits of several runs are those of one run.
    """
    found = []
    for run in runs:
        seeds = pooling.seeds(run)
        if "run" not in run.sizes:
            found.append(of_run(run, seeds[0]))
            continue
        if not has_entries(run):
            raise KingpostError(
                f"{pooling.file_of(run)}: found events, warnings or limits of another form, "
                f"allowed: those of each of {len(seeds)} runs"
            )
        each = zip(seeds, limits_of_runs(run), warnings_of_runs(run), strict=True)
        found += [with_partings(*one) for one in each]
    return found


def blocks(outcomes: Sequence[Outcome]) -> list[list[str]]:
    """Blocks of text on parted ropes, limits and other warnings."""
    of_parting, others = warnings(outcomes)
    return [lines for lines in (of_parting, limits(outcomes), others) if lines]


def limits(outcomes: Sequence[Outcome]) -> list[str]:
    """A table of the scenario's limits: a row for each limit, with the worst value of all runs."""
    several = len(outcomes) > 1
    judged = [outcome for outcome in outcomes if outcome.limits]
    if not judged:
        return []
    rows = [
        _in_runs(("limit", "held", "in runs", "worst", "unit", "seed", "at, s", "allowed", "column"), several)
    ]
    for same in zip(*(outcome.limits for outcome in judged), strict=True):
        with_row = [
            (limit, one.seed) for limit, one in zip(same, judged, strict=True) if limit["held"] is not None
        ]
        worst, seed = min(with_row, key=lambda one: _margin(one[0]), default=(same[0], "-"))
        count = sum(limit["held"] for limit, _ in with_row)
        held = ("yes" if count == len(with_row) else "NO") if with_row else "no row"
        value, time = (
            "-" if worst[key] is None else f"{worst[key]:.4g}" for key in ("worst", "worst_time_s")
        )
        in_runs, unit = f"{count} of {len(with_row)}", unit_cell(worst["unit"])
        row = (worst["name"], held, in_runs, value, unit, str(seed), time, _allowed(worst), worst["column"])
        rows.append(_in_runs(row, several))
    return [*_distrust(outcomes), *table(rows, "".join(_in_runs("<<<><>><<", several)))]


def _distrust(outcomes: Sequence[Outcome]) -> list[str]:
    """Heading for limits that are unreliable, otherwise empty."""
    off = [str(outcome.seed) for outcome in outcomes if outcome.is_off_balance]
    of = f" in {len(off)} of {len(outcomes)} runs, seeds {', '.join(off)}" if len(outcomes) > 1 else ""
    return [f"limits, NOT reliable: the energy does not balance{of}"] if off else []


def _in_runs(cells: Sequence[str], several: bool) -> tuple[str, ...]:
    """Cells of a limit; for a single run without the count of runs and the seed."""
    return tuple(cells) if several else (*cells[:2], *cells[3:5], *cells[6:])


def _margin(limit: Mapping[str, Any]) -> float:
    """Margin of the worst value to its bounds; negative if it is outside.

    >>> _margin({"worst": 5.5, "at_least": None, "at_most": 5.0})
    -0.5
    """
    least = -math.inf if limit["at_least"] is None else limit["at_least"]
    most = math.inf if limit["at_most"] is None else limit["at_most"]
    return min(limit["worst"] - least, most - limit["worst"])


def _allowed(limit: Mapping[str, Any]) -> str:
    """The bounds of a limit.

    >>> _allowed({"at_least": None, "at_most": 5.0}), _allowed({"at_least": -2.0, "at_most": 2.0})
    ('at most 5', '-2 to 2')
    >>> _allowed({"at_least": None, "at_most": 5.0, "percentile": 95.0})
    'at most 5 for 95 % of the time'
    """
    least, most = limit["at_least"], limit["at_most"]
    share = of_the_time(limit.get("percentile", 100.0))
    if least is None:
        return f"at most {most:g}{share}"
    return (f"at least {least:g}" if most is None else f"{least:g} to {most:g}") + share


def warnings(outcomes: Sequence[Outcome]) -> tuple[list[str], list[str]]:
    """Warnings of the engine, one per line: those of parted ropes, and the others."""
    begin = "warning, " if len(outcomes) > 1 else "warning: "
    of_parting, others = in_words(outcomes)
    return [begin + words for words in of_parting], [begin + words for words in others]
