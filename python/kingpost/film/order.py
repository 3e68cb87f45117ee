"""Choices of a film, checked before a browser is started."""

from __future__ import annotations

import json
import re
from dataclasses import asdict, dataclass

from ..errors import KingpostError
from ..scenario import Scenario

ENDINGS = (".webm", ".mp4")
EDGE_PX = (64, 8192)
"""Smallest and largest width and height."""
FPS = (1.0, 120.0)
SPEED = (0.01, 1000.0)
LONGEST_CAPTION = 300
CAMERAS = ("free", "load", "cab", "bridge", "top", "section")


@dataclass(frozen=True)
class Order:
    """A film.

    Attributes
    ----------
    size
        Width and height, as ``1280x720``; even numbers.
    fps
        Frames per second of the film.
    from_s, to_s
        First and last time of the run, s; the duration of the scenario if the last is None.
    speed
        Simulated time over the time of the film.
    plots
        Whether the scenario's plots over time are beside the ship.
    caption
        Text below the title.
    camera
        ``free``, ``load``, ``cab``, ``bridge``, ``top``, ``section``, or six numbers: the positions of the
        eye and its target relative to the first body, m.
    """

    size: str = "1280x720"
    fps: float = 30.0
    from_s: float = 0.0
    to_s: float | None = None
    speed: float = 1.0
    plots: bool = False
    caption: str = ""
    camera: str = "free"

    def for_page(self, scenario: Scenario, ending: str) -> bytes:
        """The order as JSON for the page that makes the film.

        Raises
        ------
        KingpostError
            If a choice is not allowed.

        >>> import kingpost
        >>> json.loads(Order(size="640x360").for_page(kingpost.load("paper"), ".webm"))["to_s"]
        3.0
        """
        duration_s = float(scenario.resolved["simulation"]["duration_s"])
        width, height = edges(self.size)
        _check("--fps", self.fps, FPS)
        _check("--speed", self.speed, SPEED)
        to_s = duration_s if self.to_s is None else self.to_s
        if not 0 <= self.from_s < to_s <= duration_s:
            allowed = f"a first and a later last time, 0 to {duration_s:g} s"
            raise KingpostError(f"--from, --to: found {self.from_s:g} to {to_s:g} s, allowed: {allowed}")
        if len(self.caption) > LONGEST_CAPTION:
            found = f"{len(self.caption)} characters"
            raise KingpostError(f"--caption: found {found}, allowed: up to {LONGEST_CAPTION}")
        _check_camera(self.camera)
        given = asdict(self)
        picture = {"size": {"width": width, "height": height}, "hasPlots": self.plots}
        times = {"from_s": self.from_s, "to_s": to_s, "frames_per_s": self.fps, "speed": self.speed}
        words = {name: given[name] for name in ("caption", "camera")}
        return json.dumps({"format": ending.removeprefix("."), **picture, **times, **words}).encode()


def edges(size: str) -> tuple[int, int]:
    """Width and height of a size.

    Raises
    ------
    KingpostError
        If it is not two even numbers in the allowed range.

    >>> edges("1080x1350")
    (1080, 1350)
    """
    found = re.fullmatch(r"(\d{1,5})x(\d{1,5})", size)
    numbers = [int(edge) for edge in found.groups()] if found else []
    least, most = EDGE_PX
    if not numbers or any(edge % 2 or not least <= edge <= most for edge in numbers):
        allowed = f"WIDTHxHEIGHT, even numbers of {least} to {most} pixels, as 1280x720"
        raise KingpostError(f"--size: found {size[:20]!r}, allowed: {allowed}")
    return numbers[0], numbers[1]


def _check(option: str, value: float, allowed: tuple[float, float]) -> None:
    least, most = allowed
    if not least <= value <= most:
        raise KingpostError(f"{option}: found {value:g}, allowed: {least:g} to {most:g}")


def _check_camera(camera: str) -> None:
    if camera in CAMERAS:
        return
    try:
        count = len([float(part) for part in re.split(r"[\s,]+", camera.strip())])
    except ValueError:
        count = 0
    if count != 6:
        allowed = f"{', '.join(CAMERAS)}, or six numbers: eye and target, m"
        raise KingpostError(f"--camera: found {camera!r}, allowed: {allowed}")
