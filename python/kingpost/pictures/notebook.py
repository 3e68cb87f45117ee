"""Stills of scenarios, simulations and runs as the value of a cell in a notebook."""

from __future__ import annotations

import base64
import re
from html import escape
from typing import Any

from .. import link, markup
from ..errors import KingpostError, shortened
from ..scenario import Scenario
from ..simulation.simulate import Simulation
from .picture import picture, png, scenario_of_run

CELL_PX = (640, 400)
"""Size of a still: 16 : 10 as in the element of the app."""
ELEMENT = "kingpost-figure.js"
"""Script of the element in the app's folder."""
ADDRESS = re.compile(r"https?://[^\s\"'<>#?]+")

_app: str | None = None
"""Address of the app's folder."""


def use_app(address: str | None) -> None:
    """Let an app play the figures in notebooks, and open their scenarios by a link.

    Without an app, or where it does not answer, a figure is a still, also in an exported notebook.
    `kingpost serve --embed-in ORIGIN` lets pages from the notebook's origin show figures of the app.

    Parameters
    ----------
    address
        Address of the app, such as that which `kingpost serve` prints; `None` for stills alone.

    Raises
    ------
    KingpostError
        If it is no address of a page.

    >>> use_app("http://127.0.0.1:8000/")
    >>> use_app(None)
    """
    global _app
    if address is not None and not (isinstance(address, str) and ADDRESS.fullmatch(address)):
        raise KingpostError(
            f"address: found {shortened(repr(address))}, allowed: an address such as http://127.0.0.1:8000/"
        )
    _app = None if address is None else f"{address.rstrip('/')}/"


def figure(of: Any) -> str:
    """Figure of a scenario, of a simulation, or of the data set of a run, as HTML that needs no other file.

    It shows the start of a scenario or a run, and the present state of a simulation. It is empty for a
    `Batch`, and if the scenario cannot be drawn: for example, a file that it names has changed since the run.

    >>> from kingpost import load
    >>> '<img src="data:image/png;base64,' in figure(load("paper"))
    True
    """
    try:
        drawn = png(picture(of, size_px=CELL_PX))
        scenario, time_s = _shown(of)
    except KingpostError:
        return ""
    words = escape(f"{scenario.title}, at {time_s:g} s")
    data = base64.b64encode(drawn).decode()
    # No height is given: within the element the picture fills the place of the run.
    size = f'width="{CELL_PX[0]}" style="max-width:100%"'
    image = f'<img src="data:image/png;base64,{data}" {size} alt="{words}" />'
    played, opened = _in_app(scenario, image)
    style = f"margin:0;max-width:{CELL_PX[0]}px"
    return f'<figure style="{style}">{played}<figcaption>{words}{opened}</figcaption></figure>'


def _shown(of: Any) -> tuple[Scenario, float]:
    """Scenario and time of what is drawn."""
    if isinstance(of, Simulation):
        return of.scenario, of.time_s
    if isinstance(of, Scenario):
        return of, 0.0
    return scenario_of_run(of), float(of["time"][0])


def _in_app(scenario: Scenario, image: str) -> tuple[str, str]:
    """The picture as a figure that the app plays, and a link to the app. Without an app, and for a scenario
    that no link can hold, it is the picture alone."""
    if _app is None:
        return image, ""
    try:
        run = escape(link.fragment(scenario))
    except KingpostError:
        return image, ""
    app = escape(_app)
    script = f'<script defer="defer" src="{app}{ELEMENT}"></script>'
    played = f'{script}<kingpost-figure src="{app}" run="{run}">{image}</kingpost-figure>'
    return played, f' <a href="{app}{run}" target="_blank" rel="noopener">Open in the app</a>'


markup.draw_figures_by(figure)
