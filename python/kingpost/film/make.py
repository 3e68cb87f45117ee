"""Making of a film: the app in a browser that no one sees, and the file that it sends."""

from __future__ import annotations

import json
import os
import queue
import re
import secrets
import signal
import subprocess
import tempfile
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import BinaryIO

from .. import browser, output
from ..errors import KingpostError, printable, shortened
from ..gallery import GALLERY
from ..scenario import Scenario
from ..server import serve
from ..server.application import Application
from ..server.listening import LOOPBACK, Server
from .order import ENDINGS, Order
from .receiver import LARGEST_PART, Message, Receiver

OPTIONS = (
    "--enable-unsafe-swiftshader",
    "--disable-background-timer-throttling",
    "--disable-renderer-backgrounding",
    "--hide-scrollbars",
    "--window-size=640,400",
    "--lang=en",
)
"""Options of the browser: WebGL without a graphics card, and no slower clock for a page that no one sees."""
LARGEST_BYTES = 600_000_000
"""Largest file that is taken; the page stops before."""
SILENT_S = 300.0
"""Longest time without a word of the page, s: software draws a frame of a large film in a minute."""
LONGEST_WORDS = 1000
"""Longest message of the page that is repeated, characters."""
END_S = 10.0
"""Time that the browser gets to end, s."""

Tell = Callable[[str, float, float], None]
"""Called with the stage, ``run`` or ``film``, and how much of it is done, of how much."""


def make(
    scenario: Scenario, path: str | Path, order: Order, tell: Tell | None = None, silent_s: float = SILENT_S
) -> tuple[Path, str]:
    """Run a scenario in the app, in a browser of this machine, and write its film.

    Parameters
    ----------
    scenario
        The scenario of the run.
    path
        The file, ``.webm`` or ``.mp4``.
    order
        Choices of the film.
    tell
        Hears how far it is.
    silent_s
        Longest time without a word of the page, s.

    Returns
    -------
    tuple
        `path`, and why the run stopped before the last time; empty if it did not.

    Raises
    ------
    KingpostError
        If a choice is not allowed, the app is not built, there is no browser, or the browser makes no film.
    """
    ending = output.check(path, ENDINGS).suffix.lower()
    ordered = order.for_page(scenario, ending)
    program = browser.needed_browser("film", "install one, or use Export, Film in the app")
    token = secrets.token_urlsafe(24)
    with (
        _listening(scenario, token, ordered) as (receiver, address),
        output.whole(path) as beside,
        beside.open("wb") as file,
        _browser(program, f"{address}#film={token}") as process,
    ):
        why = _taken(receiver, file, process, tell or (lambda *_: None), silent_s)
    return Path(path), why


@contextmanager
def _listening(scenario: Scenario, token: str, order: bytes) -> Iterator[tuple[Receiver, str]]:
    """Serve the app with this scenario alone, resolved, on a free port of the loopback address."""
    name = re.sub(r"[^\w-]", "-", Path(scenario.file).stem) or "scenario"
    named = Scenario(scenario.json, scenario.file).files
    own = {file: text for file, text in named.items() if not file.startswith(GALLERY)}
    pages = serve.pages(serve.app_folder(), {f"{name}.json": scenario.json}, serve.databases(None) | own)
    receiver = Receiver(Application(serve.app_folder(), pages, LOOPBACK), token, order)
    with Server((LOOPBACK, 0), receiver.app, receiver, LARGEST_PART) as server:
        thread = threading.Thread(target=server.serve_forever, args=(0.05,), daemon=True)
        thread.start()
        try:
            yield receiver, f"http://{LOOPBACK}:{server.server_port}/?scenario={name}"
        finally:
            server.shutdown()
            thread.join()


@contextmanager
def _browser(program: str, address: str) -> Iterator[subprocess.Popen[bytes]]:
    """Open an address in a browser that no one sees, with a temporary profile; end it after the block."""
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
        command = [program, *browser.options(), *OPTIONS, f"--user-data-dir={profile}", address]
        try:
            process = subprocess.Popen(
                command,
                stdout=subprocess.DEVNULL,
                stderr=subprocess.DEVNULL,
                start_new_session=os.name == "posix",
            )
        except OSError as error:
            raise KingpostError(f"film: {program}: {error}") from None
        try:
            yield process
        finally:
            _end(process)


def _end(process: subprocess.Popen[bytes]) -> None:
    """End a browser with the processes that it started."""
    for sent in ("SIGTERM", "SIGKILL"):
        with suppress(ProcessLookupError, PermissionError):
            if os.name == "posix":
                os.killpg(process.pid, getattr(signal, sent))
            else:
                process.kill()
        with suppress(subprocess.TimeoutExpired):
            process.wait(END_S)
            return


def _taken(
    receiver: Receiver, file: BinaryIO, process: subprocess.Popen[bytes], tell: Tell, silent_s: float
) -> str:
    """Write what the page sends until it is done; return why its run stopped early."""
    last, size = "nothing", 0
    while True:
        message = _next(receiver, process, last, silent_s)
        if message.kind == "part":
            size += len(message.body)
            if size > LARGEST_BYTES:
                raise KingpostError(f"film: found more than {LARGEST_BYTES} bytes, allowed: a shorter film")
            file.write(message.body)
            continue
        words = shortened(printable(message.body.decode(errors="replace")), LONGEST_WORDS)
        if message.kind == "done":
            return words
        if message.kind == "failed":
            raise KingpostError(f"film: {words}")
        last = words
        with suppress(ValueError, KeyError):
            done = json.loads(words)
            tell(done["stage"], float(done["done"]), float(done["of"]))


def _next(receiver: Receiver, process: subprocess.Popen[bytes], last: str, silent_s: float) -> Message:
    """The next message; an error with the last words if the browser ends or is silent for too long."""
    waited_s, step_s = 0.0, 0.5
    while waited_s < silent_s:
        with suppress(queue.Empty):
            return receiver.heard.get(timeout=step_s)
        waited_s += step_s
        if process.poll() is not None:
            why = f"the browser ended with {process.returncode}"
            raise KingpostError(f"film: {why}; the page said last: {last}")
    raise KingpostError(f"film: the page said nothing for {silent_s:g} s; before that: {last}")
