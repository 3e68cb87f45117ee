"""A figure as a folder: its page, its still, its scenario in one file, and the app."""

from __future__ import annotations

import re
import shutil
from collections.abc import Sequence
from dataclasses import dataclass
from importlib.resources import files
from pathlib import Path, PurePosixPath

from .. import output
from ..errors import KingpostError, OutputError
from ..gallery import GALLERY
from ..pictures import ELEMENT, Viewpoint, picture
from ..results.columns import nearest
from ..scenario import Scenario
from ..server import serve
from ..simulation.simulate import Simulation

PAGE = "figure.html"
"""Page of a figure in the app's folder."""
APP, STILL, INDEX = "app", "still.png", "index.html"
STILL_PX = (1280, 800)
"""Size of the still: that of a figure's picture, 16 : 10, on a dense screen."""
CAMERAS: dict[str, Viewpoint] = {
    "free": "free",
    "load": "load",
    "cab": "free",
    "bridge": "free",
    "top": "top",
    "section": "side",
}
"""Viewpoints of a figure, and those of its still: it shows no view of a person on board."""


@dataclass(frozen=True)
class Choice:
    """Choices of the author of a figure.

    Attributes
    ----------
    controls
        Names of parameters and inputs that the reader can set.
    plot
        Columns that are plotted; none for no plot.
    camera
        ``free``, ``load``, ``cab``, ``bridge``, ``top``, ``section``, or six numbers: the positions of the
        eye and its target relative to the first body, m.
    caption
        Caption; none if empty.
    time_s
        Time of the still, s.
    app
        Address of the app's folder, as seen from the page; if empty, the app is copied into the folder.
    """

    controls: Sequence[str] = ()
    plot: Sequence[str] = ()
    camera: str = "free"
    caption: str = ""
    time_s: float = 0.0
    app: str = ""


def write(scenario: Scenario, folder: str | Path, choice: Choice) -> Path:
    """Write a folder that any static host can show, and return the path of its page.

    The folder has the page, a still that is drawn without a browser, the resolved scenario with its overrides
    and the files that it names, and the app.

    Parameters
    ----------
    scenario
        The scenario of the run.
    folder
        The folder; created if it is missing.
    choice
        What the author chooses.

    Raises
    ------
    KingpostError
        If a control, a column, a viewpoint or the time is unknown, the app is not built or has no figures, or
        the folder cannot be written.
    """
    folder = Path(folder)
    view = checked(Simulation(scenario), choice)
    app = None if choice.app else app_with_figures()
    own = _own_files(scenario)
    _check_folder(folder)
    picture(scenario, choice.time_s, camera=view, size_px=STILL_PX, path=folder / STILL)
    if app is not None:
        _copy_app(app, folder / APP, scenario)
    for name, text in own.items():
        _write_below(folder / name, text)
    return output.write_text(folder / INDEX, page(scenario, choice))


def checked(simulation: Simulation, choice: Choice) -> Viewpoint:
    """Viewpoint of the still, once all that an author chooses is known to exist.

    Raises
    ------
    KingpostError
        If a control, a column or the viewpoint is unknown.

    >>> checked(Simulation("paper"), Choice(["load"], ["ship.roll"], "top"))
    'top'
    """
    _check_names("--controls", choice.controls, settable(simulation))
    _check_names("--plot", choice.plot, [name for one in simulation.channels for name in one["columns"]])
    return still_view(choice.camera)


def settable(simulation: Simulation) -> list[str]:
    """Names of the parameters and of the free inputs of a scenario.

    >>> settable(Simulation("lowering_by_winch"))[-1]
    'hoist'
    """
    free = [name for name, one in simulation.inputs.items() if one.signal is None]
    return [*simulation.scenario.parameters, *free]


def app_with_figures() -> Path:
    """Folder of the built app, which has the page and the element of figures.

    Raises
    ------
    KingpostError
        If the app is not built, or was built without figures.
    """
    found = serve.app_folder()
    for name in (PAGE, ELEMENT):
        if not (found / name).is_file():
            raise KingpostError(f"{found}: found no {name}, allowed: an app with figures; run: make web")
    return found


def still_view(camera: str) -> Viewpoint:
    """Viewpoint of the still for that of a figure.

    Raises
    ------
    KingpostError
        If the viewpoint is neither a name nor six numbers.

    >>> still_view("section"), still_view("30 -40 25 0 0 5")
    ('side', (30.0, -40.0, 25.0, 0.0, 0.0, 5.0))
    """
    if camera in CAMERAS:
        return CAMERAS[camera]
    parts = re.split(r"[\s,]+", camera.strip())
    try:
        numbers = tuple(float(part) for part in parts)
    except ValueError:
        numbers = ()
    if len(numbers) != 6:
        allowed = f"{', '.join(CAMERAS)}, or six numbers: eye and target, m"
        raise KingpostError(f"--camera: found {camera!r}, allowed: {allowed}")
    return numbers


def page(scenario: Scenario, choice: Choice) -> str:
    """Page of a figure, as HTML."""
    import jinja2

    environment = jinja2.Environment(
        loader=jinja2.PackageLoader(__package__, ""), autoescape=True, undefined=jinja2.StrictUndefined
    )
    name = _file_name(scenario)
    attributes = {
        "scenario": name,
        "controls": ", ".join(choice.controls),
        "plot": ", ".join(choice.plot),
        "camera": "" if choice.camera == "free" else choice.camera,
        "caption": choice.caption,
    }
    given = {
        "title": scenario.title,
        "description": scenario.resolved.get("description") or "",
        "style": files(__package__).joinpath("figure.css").read_text(encoding="utf-8"),
        "app": f"{(choice.app or APP).rstrip('/')}/",
        "element": ELEMENT,
        "attributes": {name: value for name, value in attributes.items() if value},
        "still": STILL,
        "width": STILL_PX[0],
        "height": STILL_PX[1],
        "alt": f"{scenario.title}, at {choice.time_s:g} s",
        "scenario": name,
    }
    return environment.get_template("figure.html.j2").render(given) + "\n"


def _check_names(option: str, given: Sequence[str], known: Sequence[str]) -> None:
    for name in given:
        if name not in known:
            allowed = f"such as {nearest(name, known)}" if known else "none: this scenario has none"
            raise KingpostError(f"{option}: found {name!r}, allowed: {allowed}")


def _check_folder(folder: Path) -> None:
    """Make a folder, and refuse one in which the app would replace other files."""
    if folder.exists() and not folder.is_dir():
        raise KingpostError(f"{folder}: found a file, allowed: a folder")
    app = folder / APP
    if app.exists() and not (app / ELEMENT).is_file():
        raise KingpostError(
            f"{app}: found other files than those of the app, allowed: a folder without {APP}"
        )
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise OutputError(folder, error) from None


def _copy_app(app: Path, to: Path, scenario: Scenario) -> None:
    """Copy the app, with the gallery's files that the scenario names."""
    try:
        if to.exists():
            shutil.rmtree(to)
        shutil.copytree(app, to)
    except OSError as error:
        raise OutputError(to, error) from None
    for name, text in scenario.files.items():
        if name.startswith(GALLERY):
            _write_below(to / "scenarios" / name.removeprefix(GALLERY), text)


def _own_files(scenario: Scenario) -> dict[str, str]:
    """The resolved scenario and the files that it names beside itself, by their paths in the folder."""
    # Parts are resolved: only tables and databases are left.
    named = Scenario(scenario.json, scenario.file).files
    own = {name: text for name, text in named.items() if not name.startswith(GALLERY)}
    taken = (APP, INDEX, STILL, _file_name(scenario))
    for name in own:
        path = PurePosixPath(name)
        if path.is_absolute() or ".." in path.parts:
            raise KingpostError(f"{name}: found a file outside the scenario's folder, allowed: one within it")
        if path.parts[0] in taken:
            raise KingpostError(f"{name}: found a name of the figure's files, allowed: none of {taken}")
    return {**own, _file_name(scenario): scenario.json}


def _file_name(scenario: Scenario) -> str:
    """Name of the resolved scenario: JSON, without characters that an address would have to encode."""
    stem = re.sub(r"[^\w-]", "-", Path(scenario.file).stem) or "scenario"
    return f"{stem}.json"


def _write_below(path: Path, text: str) -> None:
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise OutputError(path.parent, error) from None
    output.write_text(path, text)
