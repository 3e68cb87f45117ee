"""Report of a study: one file of HTML, or a PDF printed by an installed browser."""

from __future__ import annotations

import hashlib
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from .. import output
from ..engine import engine
from ..errors import KingpostError
from ..reports.limiting import accepted_text
from ..study.design.plan import Plan
from ..study.limiting.runs import limiting_heights
from ..study.screening.cases import of_plan
from ..study.seeds import SeedCount, kind_of_runs, too_few
from ..study.store import layout
from ..study.store.reading import open_results
from ..study.summary import of_results, unfinished_operations
from . import extremes, limiting, model, origin, pdf, runs, steps
from .blocks import Report, html

if TYPE_CHECKING:
    import xarray

    from ..scenario import Scenario

ENDINGS = (".html", ".pdf")
APP = "http://127.0.0.1:8000/"
"""Default address of the app: that of `kingpost serve`."""


def write(plan: Plan, folder: str | Path, path: str | Path, app: str = APP) -> Path:
    """Write the report of a study by the file's ending.

    The report contains the model, the sea, the limiting sea by runs and by linear response, operability, the
    results of limits, the worst runs with links to the app, statistics, extremes, fatigue, verification, and
    the origin of each number. The page needs no network.

    Parameters
    ----------
    plan
        Of the study.
    folder
        Of its results; they may be incomplete.
    path
        The file, ``.html`` or ``.pdf``.
    app
        The address of an app, for the links to runs.

    Returns
    -------
    pathlib.Path
        `path`.

    Raises
    ------
    KingpostError
        If there are no results, the ending is not allowed, or there is no browser for a PDF.
    """
    path = output.check(path, ENDINGS)
    page = html(of_study(plan, Path(folder), app), engine.__version__)
    if path.suffix.lower() == ".html":
        return output.write_text(path, page)
    with tempfile.TemporaryDirectory() as beside:
        written = output.write_text(Path(beside) / "report.html", page)
        return pdf.write(written, path)


def of_study(plan: Plan, folder: Path, app: str = APP) -> Report:
    """Build the report as blocks."""
    results, about = open_results(folder), layout.about_of(folder)
    if about is None:
        raise KingpostError(f"{folder}: found no study, allowed: the folder of a study")
    content, names = plan.file.content, list(plan.cases.names)
    by_runs, by_screen = _by_runs(results), _by_screen(plan)

    def scenario_of(run: int) -> Scenario:
        return plan.scenario.with_overrides(dict(plan.overrides(run)))

    sections = [
        limiting.section(by_runs, by_screen),
        limiting.operability_section(plan, by_runs, by_screen),
        runs.section(results, names, of_results(folder, plan), scenario_of, app),
        *filter(None, [steps.section(results, names)]),
        extremes.section(results, names),
        model.section(plan.scenario),
        model.sea_section(plan.scenario),
        origin.verification_section(folder),
        origin.section(folder, about, dict(_digests(folder))),
    ]
    lead = (
        f"{content.get('description') or plan.scenario.title}. {plan.runs} runs: {plan.cases.count} cases, "
        f"{len(plan.seeds)} seeds of each. Statistics: {kind_of_runs(plan)}. "
        f"Seeds: {'; '.join(SeedCount.of(plan).sentences())}."
    )
    return Report(
        content["title"], lead, list(_verdict(plan, results, by_runs)), sections, list(_doubts(plan, results))
    )


def _by_runs(results: xarray.Dataset) -> xarray.Dataset | str:
    try:
        return limiting_heights(results)
    except KingpostError as error:
        return str(error)


def _by_screen(plan: Plan) -> xarray.Dataset | str:
    try:
        found = of_plan(plan)
    except KingpostError as error:
        return str(error)
    return (
        found
        if "limiting_height_of_all" in found
        else "the study has no axis of the significant height or no limits"
    )


def _verdict(plan: Plan, results: xarray.Dataset, by_runs: xarray.Dataset | str) -> Iterator[str]:
    """Yield the verdict of the study in one or two sentences."""
    if "limit" not in results.sizes:
        yield "The study has no limits: it says what the runs came to, not whether to go."
        return
    held = results["limit_held"].values
    whole = (held == 1).all(axis=1)
    yield f"All limits hold in {int(whole.sum())} of {len(whole)} runs."
    if isinstance(by_runs, str):
        return
    heights = by_runs["limiting_height_of_all"].values
    governs, counts = np.unique(by_runs["governs"].values, return_counts=True)
    finite = heights[np.isfinite(heights)]
    axis = by_runs[plan.sea["significant_height"]]
    smallest, largest = float(axis.min()), float(axis.max())
    accepted = accepted_text(by_runs.attrs)
    if finite.size and not finite.any():
        yield f"In every case a limit fails at {smallest:g} m, the smallest significant height of the study."
    elif finite.size:
        least = f"{finite.min():.2f} m" if finite.min() > 0 else f"below {smallest:g} m"
        most = f"{finite.max():.2f} m" if finite.max() < largest else f"above {largest:g} m"
        both = least if least == most else f"{least} to {most}"
        yield (
            f"The limiting significant height, at an accepted probability of {accepted}, is {both}; "
            f"{governs[counts.argmax()]} governs most often."
        )


def _doubts(plan: Plan, results: xarray.Dataset) -> Iterator[str]:
    """Yield the reservations that a reader must know before the numbers."""
    status = results["status"].values
    missing = int((status == -1).sum())
    if missing:
        yield f"The study is not complete: {missing} of {status.size} runs have not run."
    if cut_short := unfinished_operations(results):
        yield f"{cut_short}."
    if few := too_few(plan):
        yield f"{few[0].upper()}{few[1:]}."
    yield (
        "The numbers hold for the model described here; no measurement of this ship with her crane was "
        "compared. Inputs, limits and the accepted probability are the user's."
    )


def _digests(folder: Path) -> Iterator[tuple[str, str]]:
    for name in (layout.STUDY, layout.SCENARIO, layout.ABOUT):
        with open(folder / name, "rb") as file:
            yield name, hashlib.file_digest(file, "sha256").hexdigest()
