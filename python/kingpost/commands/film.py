"""`kingpost film`: a film of a run, made by the app in a browser of this machine."""

from __future__ import annotations

import argparse

from .common import DONE, FAILED, add_output, add_scenario, fail, note, only_errors_of, scenario_of

HELP = "a film of a run, by an installed browser"


def add_options(command: argparse.ArgumentParser) -> None:
    """The command's options."""
    add_scenario(command)
    add_output(command)
    command.add_argument(
        "-o",
        "--output",
        metavar="FILE",
        required=True,
        help="the film: .webm, or .mp4 where the browser encodes it",
    )
    command.add_argument(
        "--size", default="1280x720", metavar="WxH", help="size, even numbers (default: 1280x720)"
    )
    command.add_argument(
        "--fps", type=float, default=30.0, metavar="N", help="frames per second (default: 30)"
    )
    command.add_argument(
        "--from",
        type=float,
        default=0.0,
        dest="from_s",
        metavar="T",
        help="first time of the run, s (default: 0)",
    )
    command.add_argument(
        "--to", type=float, dest="to_s", metavar="T", help="last time of the run, s (default: its duration)"
    )
    command.add_argument(
        "--speed", type=float, default=1.0, metavar="X",
        help="seconds of the run in one of the film (default: 1)",
    )  # fmt: skip
    command.add_argument(
        "--plots", action="store_true", help="with the scenario's plots over time beside the ship"
    )
    command.add_argument("--caption", default="", metavar="TEXT", help="text below the title")
    command.add_argument(
        "--camera", default="free", metavar="VIEW",
        help="free, load, cab, bridge, top, section, or six numbers: eye and target from the first body, m",
    )  # fmt: skip


def run(options: argparse.Namespace) -> int:
    """Write the film."""
    from ..film.make import make
    from ..film.order import Order
    from ..progress import bar

    order = Order(
        options.size, options.fps, options.from_s, options.to_s,
        options.speed, options.plots, options.caption, options.camera,
    )  # fmt: skip
    # The run is the first half of the bar, the frames are the other.
    halves = {"run": 0.0, "film": 50.0}
    # Suppress log lines about a browser that waits for a thread.
    with bar(100.0, "%") as shown, only_errors_of("waitress.queue"):
        written, why = make(
            scenario_of(options), options.output, order,
            lambda stage, done, of: shown(halves.get(stage, 0.0) + 50.0 * done / of),
        )  # fmt: skip
    note(options, f"written  {written}")
    return fail(f"the film ends early, because the run did: {why}", FAILED) if why else DONE
