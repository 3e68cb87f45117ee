"""Events and warnings of a run, as tables."""

from __future__ import annotations

from typing import TYPE_CHECKING

from .entries import table

if TYPE_CHECKING:
    import xarray


def events(results: xarray.Dataset) -> xarray.Dataset:
    """Events of a run, in order of time: ``event_time`` (s), ``event_code``, ``event_element`` and
    ``event_what``.

    Parameters
    ----------
    results
        A data set of a run.

    Returns
    -------
    xarray.Dataset
        Along ``event``; of size 0 for a `Batch`, whose events are not recorded.

    >>> from kingpost import run
    >>> events(run("paper", {"simulation.duration_s": 0.001})).sizes["event"]
    0
    """
    return table(results, "event")


def warnings(results: xarray.Dataset) -> xarray.Dataset:
    """Warnings of a run: ``warning_time`` (s), ``warning_code``, ``warning_name``, ``warning_value`` and
    ``warning_bound`` in ``warning_unit``, and ``warning_text``.

    Warnings from before the run come first, with the code ``model``, without time and name. For a `Batch`,
    ``warning_run`` is the number of the run.

    Parameters
    ----------
    results
        A data set of a run.

    Returns
    -------
    xarray.Dataset
        Along ``warning``.

    >>> from kingpost import run
    >>> warnings(run("paper", {"simulation.duration_s": 0.001})).sizes["warning"]
    0
    """
    return table(results, "warning")
