"""`kingpost study`: many runs of one scenario, stored in a folder."""

from __future__ import annotations

import argparse
import re
from collections.abc import Callable, Iterator
from concurrent.futures import Executor
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from ..errors import KingpostError, OutputError
from ..output import check as check_output
from .common import DONE, FAILED, INTERRUPTED, WARNING, add_output, fail, note, show, warn

if TYPE_CHECKING:
    import xarray

    from ..study.study import Study

HELP = "run every case of a study with every seed, and keep the results"
REPORTS = (".html", ".pdf")
CONNECT_S = 20
"""Time limit for the answer of a cluster's scheduler, s."""


def add_options(command: argparse.ArgumentParser) -> None:
    """The command's options."""
    command.add_argument("study", metavar="FILE", help="the file of a study")
    command.add_argument("-o", "--output", metavar="DIR",
                         help="folder of the results (default: only print the planned runs)")  # fmt: skip
    command.add_argument("--resume", action="store_true", help="continue the study in the folder")
    command.add_argument("--workers", type=int, metavar="N",
                         help="processes (default: as many as there are processors)")  # fmt: skip
    command.add_argument("--scheduler", metavar="ADDRESS",
                         help="Dask cluster that computes, as tcp://host:8786")  # fmt: skip
    command.add_argument("--part", metavar="K/N",
                         help="every Nth unit from the Kth on: one task of an array of N")  # fmt: skip
    command.add_argument("--screen", action="store_true",
                         help="limits by linear response instead of runs; takes seconds")  # fmt: skip
    command.add_argument(
        "--report", metavar="FILE", help="write the report: .html, or .pdf by an installed browser"
    )
    command.add_argument("--app", metavar="ADDRESS",
                         help="app of the report's links (default: kingpost serve's)")  # fmt: skip
    command.add_argument("--repeat", type=int, metavar="RUN",
                         help="repeat one run and write all of it to run_RUN.nc in -o")  # fmt: skip
    add_output(command)


def run(options: argparse.Namespace) -> int:
    """Run the missing units and print the results."""
    from ..study.study import Study
    from ..study.summary import of_plan, plan_lines

    part = _part(options.part)
    _check(options)
    if options.report is not None:
        _check_report(options.report)
    study = Study(options.study)
    warn(f"{WARNING}{words}" for words in study.scenario.model["warnings"])
    if options.screen:
        return _screen(study, options)
    if options.repeat is not None:
        return _repeat(study, options)
    if options.output is None:
        about = of_plan(study.plan)
        show(options, lambda: "\n".join(plan_lines(about)), lambda: about)
        note(options, f"\nto run it       kingpost study {options.study} -o DIR")
        return DONE
    folder = Path(options.output)
    again = f"kingpost study {options.study} -o {folder} --resume goes on"
    try:
        with ExitStack() as held:
            executor = held.enter_context(_cluster(options.scheduler)) if options.scheduler else None
            _run(study, folder, options, executor, part)
    except OutputError as error:
        kept = f"; what is finished is kept: {again}" if (folder / "study.json").exists() else ""
        return fail(f"{error}{kept}", FAILED)
    except KeyboardInterrupt:
        return fail(f"interrupted, what is finished is kept: {again}", INTERRUPTED)
    done = _report(study, folder, options)
    if options.report and not part:
        note(options, f"written         {_write_report(study, folder, options)}")
    return done


def _screen(study: Study, options: argparse.Namespace) -> int:
    """Print the limiting sea by linear response, and the operable share of the scatter table."""
    from ..reports.limiting import screen
    from ..study.screening.cases import of_plan

    found = of_plan(study.plan)
    shares = _shares(study, found) if "limiting_height" in found else []
    show(options, lambda: "\n".join([screen(found), *shares]), found.to_dict)
    return DONE


def _repeat(study: Study, options: argparse.Namespace) -> int:
    """One run of the study again, whole."""
    from .. import results
    from ..simulation.simulate import run

    if not 0 <= options.repeat < len(study):
        raise KingpostError(f"--repeat: found {options.repeat}, allowed: a run from 0 to {len(study) - 1}")
    path = check_output(Path(options.output) / f"run_{options.repeat}.nc", results.ENDINGS)
    recorded = run(study.scenario.with_overrides(study.overrides(options.repeat)))
    note(options, f"written         {results.write(recorded, path)}")
    return DONE


def _check_report(path: str) -> None:
    """Check the ending and, of a PDF, that a browser can print it: before the runs, which may take hours."""
    from ..study_report import pdf

    if check_output(path, REPORTS).suffix.lower() == ".pdf":
        pdf.needed_browser()


def _write_report(study: Study, folder: Path, options: argparse.Namespace) -> Path:
    from ..study_report import report

    return report.write(study.plan, folder, options.report, options.app or report.APP)


def _run(
    study: Study,
    folder: Path,
    options: argparse.Namespace,
    executor: Executor | None,
    part: tuple[int, int] | None,
) -> None:
    from .. import progress
    from ..study.running.run import run
    from ..study.seeds import too_few

    with ExitStack() as shown:

        def begin(runs: int) -> Callable[[float], None]:
            if few := too_few(study.plan):
                warn([f"{WARNING}{few}"])
            return shown.enter_context(progress.bar(runs, "runs"))

        run(study.plan, folder, executor, options.workers, options.resume, part, begin)


def _report(study: Study, folder: Path, options: argparse.Namespace) -> int:
    from ..study.summary import of_plan, of_results, plan_lines, result_lines, warning_lines

    about, found = of_plan(study.plan), of_results(folder, study.plan)
    runs = about["runs"]
    show(
        options,
        lambda: "\n".join([*plan_lines(about), "", *result_lines(found, runs), *_limiting(study, folder)]),
        lambda: {**about, **found},
    )
    warn(warning_lines(found, runs))
    note(options, f"\nwritten         {folder}")
    if found["not_run"]:
        note(options, f"to go on        kingpost study {options.study} -o {folder} --resume")
    failed = found["finished"] == 0 and found["not_run"] < runs
    return fail("no run finished", FAILED) if failed else DONE


def _limiting(study: Study, folder: Path) -> list[str]:
    """Limiting heights and the operable share; empty if the results of the study do not give them."""
    from ..reports import limiting
    from ..study.limiting.runs import limiting_heights
    from ..study.store.reading import open_results

    if "significant_height" not in study.plan.sea or not study.plan.limits:
        return []
    try:
        heights = limiting_heights(open_results(folder))
    except KingpostError as error:
        return ["", f"limiting significant height: none: {error}"]
    return ["", *limiting.heights(heights), *_shares(study, heights)]


def _shares(study: Study, heights: xarray.Dataset) -> list[str]:
    """Operable share of the study's scatter table, by limiting heights; empty without a scatter table."""
    from ..reports import limiting
    from ..study.limiting.operable_share import of_plan

    lines = []
    for direction, share in of_plan(study.plan, heights):
        lines += [f"all waves with  {direction}"] if direction else []
        lines += limiting.operable(share)
    return ["", *lines] if lines else []


def _check(options: argparse.Namespace) -> None:
    """Refuse options that would have no effect, before anything is computed."""
    for name in ("resume", "workers", "scheduler", "part", "report", "repeat"):
        if options.output is None and getattr(options, name) not in (None, False):
            raise KingpostError(f"--{name}: found no -o, allowed: with -o DIR alone")


def _part(given: str | None) -> tuple[int, int] | None:
    if given is None:
        return None
    found = re.fullmatch(r"(\d{1,6})/(\d{1,6})", given)
    part = (int(found[1]), int(found[2])) if found else (0, 0)
    if not 1 <= part[0] <= part[1]:
        raise KingpostError(f"--part: found {given!r}, allowed: K/N, K from 1 to N")
    return part


@contextmanager
def _cluster(address: str) -> Iterator[Executor]:
    """The executor of a Dask cluster."""
    try:
        from distributed import Client
    except ModuleNotFoundError:
        raise KingpostError(
            "--scheduler: found no package distributed; install it with: pip install 'kingpost[cluster]'"
        ) from None
    try:
        # A client that finds no scheduler would stay the default one.
        client = Client(address, timeout=CONNECT_S, set_as_default=False)
    except (OSError, ValueError, TypeError) as error:
        raise KingpostError(
            f"--scheduler: found no scheduler at {address} ({error}), allowed: an address as tcp://host:8786"
        ) from None
    with client:
        threads = sum(client.ncores().values())
        if not threads:
            raise KingpostError(f"--scheduler: found no worker at {address}, allowed: one worker or more")
        executor = client.get_executor()
        executor._max_workers = threads  # type: ignore[attr-defined]
        yield executor
