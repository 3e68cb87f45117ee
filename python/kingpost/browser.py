"""Browsers of Chromium's family on this machine."""

from __future__ import annotations

import os
import shutil

from .errors import KingpostError

BROWSERS = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome", "msedge")
VARIABLE = "CHROMIUM"
"""Environment variable that names another browser."""
ALLOWED = f"Chromium, Chrome or Edge on the path, or named by {VARIABLE}"
OPTIONS = (
    "--headless",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
)
"""Options of a browser that no one sees."""


def find_browser() -> str | None:
    """Find the first browser of Chromium's family on this machine; None if there is none."""
    given = os.environ.get(VARIABLE)
    return given or next((found for name in BROWSERS if (found := shutil.which(name))), None)


def needed_browser(what: str, instead: str) -> str:
    """Find a browser for a task; the error names the task and what serves instead.

    Raises
    ------
    KingpostError
        If there is none.
    """
    found = find_browser()
    if found is None:
        raise KingpostError(f"{what}: found no browser, allowed: {ALLOWED}; {instead}")
    return found


def options() -> list[str]:
    """Options of a browser that no one sees. Chromium refuses its sandbox to root, as in a container."""
    is_root = hasattr(os, "geteuid") and os.geteuid() == 0
    return [*OPTIONS, *(["--no-sandbox"] if is_root else [])]
