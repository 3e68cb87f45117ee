"""Layout of a study's folder: names of its files, the description, and the markers of finished units."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import NotRequired, TypedDict

from ...errors import KingpostError
from ...scenario import ParameterValue
from ..design.job import WarningCount

STUDY, SCENARIO, ABOUT, RESULTS, UNITS = "study.yaml", "scenario.json", "study.json", "results.zarr", "units"
FORMAT = 1


class About(TypedDict):
    """Description of a study; `frame` is the digest of coordinates and attributes."""

    version: int
    title: str
    fingerprint: str
    depends_on: dict[str, str]
    runs: int
    runs_of_unit: int
    axes: dict[str, list[ParameterValue]]
    seeds: list[int]
    columns: dict[str, str]
    limits: list[dict[str, ParameterValue | None]]
    files: dict[str, str]
    frame: NotRequired[str]
    versions: dict[str, str]


class Marker(TypedDict):
    """Marker of a finished unit; `ends` gives, by the number of a run, the reason why it ended early."""

    unit: int
    runs: list[int]
    fingerprint: str
    sha256: str
    ends: dict[str, str]
    warnings: list[WarningCount]


def about_of(folder: Path) -> About | None:
    """Read the description of the study in a folder; None if there is none.

    Raises
    ------
    KingpostError
        If the description is damaged, or of a later version.
    """
    path = folder / ABOUT
    try:
        found = json.loads(path.read_text(encoding="utf-8"))
        if found["version"] == FORMAT and isinstance(found["depends_on"], dict):
            return found
    except FileNotFoundError:
        return None
    except (OSError, ValueError, TypeError, KeyError) as error:
        raise KingpostError(f"{path}: found {error}, allowed: the description of a study") from None
    raise KingpostError(f"{path}: found version {found['version']}, allowed: {FORMAT}")


def markers(folder: Path) -> Iterator[Marker]:
    """Yield the content of the markers of finished units, in order."""
    for path in sorted((folder / UNITS).glob("[0-9]*.json")):
        try:
            yield json.loads(path.read_text(encoding="utf-8"))
        except (OSError, ValueError):
            continue
