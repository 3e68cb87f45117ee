"""`kingpost serve`: the app in a browser."""

from __future__ import annotations

import argparse

from .common import only_errors_of

HELP = "serve the browser app"


def add_options(command: argparse.ArgumentParser) -> None:
    """The command's options."""
    command.add_argument("scenario", nargs="?", metavar="SCENARIO", help="a file or a gallery name")
    command.add_argument("--port", type=int, metavar="N", help="port (default: 8000, or the next free)")
    command.add_argument("--host", metavar="H", help="address to listen on (default: this machine only)")
    command.add_argument(
        "--embed-in",
        action="append",
        default=[],
        metavar="ORIGIN",
        help="origin of pages that may frame figures of the app, as https://example.org; repeatable",
    )
    command.add_argument("--check", action="store_true", help="start, fetch the app once, and end")


def run(options: argparse.Namespace) -> int:
    """Serve until Ctrl-C."""
    from ..server import serve

    # Suppress log lines about a browser that waits for a thread.
    with only_errors_of("waitress.queue"):
        return serve.command(options.scenario, options.port, options.host, options.check, options.embed_in)
