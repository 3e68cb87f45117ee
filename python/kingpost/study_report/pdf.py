"""Printing of a page as PDF by an installed browser."""

from __future__ import annotations

import os
import shutil
import subprocess
import tempfile
from pathlib import Path

from .. import output
from ..errors import KingpostError

BROWSERS = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome", "msedge")
VARIABLE = "CHROMIUM"
"""Environment variable that names another browser."""
TIME_LIMIT_S = 120.0
OPTIONS = (
    "--headless",
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--no-pdf-header-footer",
)


def find_browser() -> str | None:
    """Find the first browser of Chromium's family on this machine; None if there is none."""
    given = os.environ.get(VARIABLE)
    return given or next((found for name in BROWSERS if (found := shutil.which(name))), None)


def needed_browser() -> str:
    """Find a browser that prints.

    Raises
    ------
    KingpostError
        If there is none.
    """
    browser = find_browser()
    if browser is None:
        raise KingpostError(
            f"PDF: found no browser, allowed: Chromium, Chrome or Edge on the path, or named by {VARIABLE}; "
            "the HTML file prints from any browser"
        )
    return browser


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
    browser = needed_browser()
    # Chromium refuses its sandbox to root, as in a container.
    is_root = hasattr(os, "geteuid") and os.geteuid() == 0
    with output.whole(path) as beside, tempfile.TemporaryDirectory() as profile:
        command = [browser, *OPTIONS, *(["--no-sandbox"] if is_root else []), f"--user-data-dir={profile}",
                   f"--print-to-pdf={beside}", Path(page).resolve().as_uri()]  # fmt: skip
        try:
            done = subprocess.run(command, capture_output=True, timeout=TIME_LIMIT_S, check=False)
        except (OSError, subprocess.TimeoutExpired) as error:
            raise KingpostError(f"PDF: {browser}: {error}") from None
        if done.returncode or not beside.stat().st_size:
            lines = done.stderr.decode(errors="replace").strip().splitlines() or ["no message"]
            raise KingpostError(f"PDF: {browser} ended with {done.returncode}: {lines[-1]}")
    return Path(path)
