"""`kingpost verify`: measure every row and report whether all are within their tolerances."""

from __future__ import annotations

import argparse
from collections.abc import Callable, Sequence
from pathlib import Path

from .. import output, progress
from ..errors import KingpostError
from . import report
from .rows import AREAS, FAILED, Row
from .running import checks, run

FORMATS: dict[str, Callable[[Sequence[Row]], str]] = {
    "markdown": report.markdown,
    "json": report.as_json,
    "html": report.page,
}


def add_options(command: argparse.ArgumentParser) -> None:
    """The command's options."""
    command.add_argument("--only", metavar="AREA", choices=list(AREAS), help=f"one of {', '.join(AREAS)}")
    for name in FORMATS:
        command.add_argument(f"--{name}", metavar="FILE", help=f"also write the rows as {name}")
    command.add_argument(
        "--control",
        action="store_true",
        help="only the controllers, on their standard seas, with and without",
    )
    command.add_argument(
        "--plots", metavar="DIR", help="only draw the pictures of docs/validation.md and docs/control.md"
    )


def command(options: argparse.Namespace) -> int:
    """Measure, print, write; return 1 if a row fails."""
    if options.plots is not None:
        return _draw(Path(options.plots))
    if options.control:
        return _control()
    wanted = {name: Path(path) for name in FORMATS if (path := getattr(options, name)) is not None}
    for path in wanted.values():
        # Refuse before the measurements, not after them.
        if not path.parent.is_dir():
            raise KingpostError(f"{path}: found no folder {path.parent}, allowed: an existing folder")
    with progress.bar(len(checks(options.only)), "rows") as update:
        rows = run(options.only, update)
    print(report.text(rows))
    for name, path in wanted.items():
        output.write_text(path, FORMATS[name](rows))
        print(f"written  {path}")
    return int(any(row.verdict == FAILED for row in rows))


def _control() -> int:
    from . import control

    with progress.bar(control.count(), "runs") as update:
        found = list(control.tables(update))
    print("\n\n".join(text for text, _ in found))
    return int(any(failed for _, failed in found))


def _draw(folder: Path) -> int:
    from . import plots

    if not folder.is_dir():
        raise KingpostError(f"{folder}: found no folder, allowed: an existing folder")
    for path in plots.draw(folder):
        print(f"written  {path}")
    return 0
