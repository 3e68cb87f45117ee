"""Words for the case and the run of a number, and the share of a limit that a value takes."""

from __future__ import annotations

from collections.abc import Sequence
from math import inf, isfinite, nan
from typing import TYPE_CHECKING

from ..reports.tables import unit_cell

if TYPE_CHECKING:
    import xarray

STORE = "results.zarr"


def case_text(runs: xarray.Dataset, at: int, axes: Sequence[str]) -> str:
    """Describe the case of a run: the values of the axes and its seed.

    >>> import xarray
    >>> of = {"peak_period_s": ("run", [8.0]), "seed": ("run", [3])}
    >>> case_text(xarray.Dataset(coords=of), 0, ["peak_period_s"])
    'peak_period_s 8, seed 3'
    """
    return _named(runs, at, (*axes, "seed"))


def axes_text(runs: xarray.Dataset, at: int, axes: Sequence[str]) -> str:
    """Describe the case of a run without its seed.

    >>> import xarray
    >>> axes_text(xarray.Dataset(coords={"peak_period_s": ("run", [8.0])}), 0, ["peak_period_s"])
    'peak_period_s 8'
    """
    return _named(runs, at, axes) or "the only case"


def run_text(runs: xarray.Dataset, at: int, axes: Sequence[str], time_s: float = nan) -> str:
    """Describe a run by its number, its case, its seed and a time in it: all that a repetition needs.

    >>> import xarray
    >>> run_text(xarray.Dataset(coords={"seed": ("run", [3])}), 0, [], 12.5)
    'run 0: seed 3, 12.5 s'
    """
    when = f", {time_s:.6g} s" if isfinite(time_s) else ""
    return f"run {at}: {case_text(runs, at, axes)}{when}"


def bounds_text(least: float, most: float, unit: str) -> str:
    """Format the bounds of a limit; a missing bound is infinite or NaN.

    >>> bounds_text(-5.0, 5.0, "deg"), bounds_text(float("nan"), 1.3, "1")
    ('-5 to 5 deg', 'at most 1.3')
    """
    of_unit = f" {unit_cell(unit)}".rstrip()
    has_least, has_most = isfinite(least), isfinite(most)
    if has_least and has_most:
        return f"{least:g} to {most:g}{of_unit}"
    return f"at most {most:g}{of_unit}" if has_most else f"at least {least:g}{of_unit}"


def utilisation(value: float, least: float, most: float) -> float:
    """Share of a limit that a value takes, above 1 beyond the limit: the value over the largest allowed one,
    or the least allowed one over the value. It is infinite where the sign is wrong, and NaN for a bound of 0.

    >>> utilisation(4.0, -5.0, 5.0), utilisation(6.0, 3.0, nan), utilisation(0.0, 3.0, nan)
    (0.8, 0.5, inf)
    """
    shares = [_share(value, most)] if isfinite(most) else []
    shares += [_share(-value, -least)] if isfinite(least) else []
    return max((max(share, 0.0) for share in shares if share == share), default=nan)


def _named(runs: xarray.Dataset, at: int, names: Sequence[str]) -> str:
    values = [(name, runs[name].values[at].item()) for name in names]
    return ", ".join(f"{name} {value:.6g}" if isinstance(value, float) else f"{name} {value}"
                     for name, value in values)  # fmt: skip


def _share(value: float, most: float) -> float:
    """Share of an upper bound."""
    if most == 0 or value != value:
        return nan
    if most > 0:
        return value / most
    return most / value if value < 0 else inf
