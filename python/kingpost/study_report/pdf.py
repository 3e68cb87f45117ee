"""Printing of a page as PDF by an installed browser."""

from __future__ import annotations

import subprocess
import tempfile
from pathlib import Path

from .. import browser, output
from ..errors import KingpostError

TIME_LIMIT_S = 120.0
OPTIONS = ("--disable-gpu", "--no-pdf-header-footer")


def needed_browser() -> str:
    """Find a browser that prints.

    Raises
    ------
    KingpostError
        If there is none.
    """
    return browser.needed_browser("PDF", "the HTML file prints from any browser")


def write(page: str | Path, path: str | Path) -> Path:
    """Print a page of HTML as a PDF of A4 pages.

    Parameters
    ----------
    page
        The file ``.html``.
    path
        The file ``.pdf``.

    Returns
    -------
    pathlib.Path
        `path`.

    Raises
    ------
    KingpostError
        If there is no browser, or it writes no file.
    """
    program = needed_browser()
    with output.whole(path) as beside, tempfile.TemporaryDirectory() as profile:
        command = [program, *browser.options(), *OPTIONS, f"--user-data-dir={profile}",
                   f"--print-to-pdf={beside}", Path(page).resolve().as_uri()]  # fmt: skip
        try:
            done = subprocess.run(command, capture_output=True, timeout=TIME_LIMIT_S, check=False)
        except (OSError, subprocess.TimeoutExpired) as error:
            raise KingpostError(f"PDF: {program}: {error}") from None
        if done.returncode or not beside.stat().st_size:
            lines = done.stderr.decode(errors="replace").strip().splitlines() or ["no message"]
            raise KingpostError(f"PDF: {program} ended with {done.returncode}: {lines[-1]}")
    return Path(path)
