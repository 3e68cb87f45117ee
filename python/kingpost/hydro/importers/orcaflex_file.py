"""OrcaFlex's text data file: YAML, its entries by name, numbers checked as they are taken.

All values are read as text and converted to numbers here, because YAML 1.1 would read 30.8e3 as a string and
Yes as a boolean.
A table's key is the list of its columns, `RAOPeriodOrFrequency, RAOSurgeAmp, ...`: they are found by name.
"""

from __future__ import annotations

import re
import reprlib
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np

from ...errors import HydrodynamicsError, flag
from ...reading import text_of
from .foreign import reading_error

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from numpy.typing import NDArray

Meaning = TypeVar("Meaning")
ALLOWED = "OrcaFlex's text data file, .yml, with a vessel type's load RAOs, added mass and damping"
NOTHING = "~"
DEEPEST = 50


def load(path: str) -> tuple[Entry, str]:
    """The file's entries, and the name of the program in its header.

    Raises
    ------
    HydrodynamicsError
        If it cannot be read, is not YAML or not a mapping.
    """
    import yaml

    try:
        text = text_of(path)
        # Only texts, lists and mappings: nothing in the file is executed.
        loader = getattr(yaml, "CBaseLoader", yaml.BaseLoader)
        _check_depth(text, loader)
        found = yaml.load(text, Loader=loader)
    except (OSError, UnicodeDecodeError, RecursionError, yaml.YAMLError) as error:
        said = " ".join(str(error).split())
        raise reading_error(f"a file that cannot be read ({said})", ALLOWED, path) from None
    if not isinstance(found, dict):
        raise reading_error("no entries", ALLOWED, path)
    program = re.search(r"^# Program: (.+)$", text[:2000], re.MULTILINE)
    return Entry(found, "", path), program[1].strip() if program else "OrcaFlex"


def _check_depth(text: str, loader: type) -> None:
    """Refuse deep nesting: the library is recursive and its stack would overflow."""
    import yaml

    depth = 0
    for event in yaml.parse(text, Loader=loader):
        depth += isinstance(event, yaml.CollectionStartEvent)
        depth -= isinstance(event, yaml.CollectionEndEvent)
        if depth > DEEPEST:
            raise yaml.YAMLError(f"more than {DEEPEST} lists or mappings in each other")


@dataclass(frozen=True)
class Entry:
    """A mapping of the file and its path, such as `VesselTypes.Barge`."""

    value: dict[str, Any]
    place: str
    file: str

    def error(self, name: str, found: object, allowed: str) -> HydrodynamicsError:
        """An error about one of its fields."""
        # Shortened: a list can contain the same list many times.
        said = found if isinstance(found, str) else reprlib.repr(found)
        return HydrodynamicsError(
            f"{self.place}.{name}".lstrip("."), said[:80] or "nothing", allowed, self.file
        )

    def text(self, name: str) -> str | None:
        """Text of a field; `None` if it is missing or `~`."""
        found = self.value.get(name)
        return found if isinstance(found, str) and found not in ("", NOTHING) else None

    def choice(self, name: str, meanings: Mapping[str, Meaning]) -> Meaning:
        """The meaning of a field's keyword."""
        found = self.text(name)
        if found not in meanings:
            raise self.error(name, found or "nothing", " or ".join(meanings))
        return meanings[found]

    def entry(self, name: str) -> Entry:
        """The mapping with that name; empty if it is missing."""
        found = self.value.get(name)
        return Entry(found if isinstance(found, dict) else {}, f"{self.place}.{name}".lstrip("."), self.file)

    def entries(self, name: str) -> list[Entry]:
        """The mappings of a list; empty if it is missing."""
        found = self.value.get(name)
        listed = found if isinstance(found, list) else []
        place = f"{self.place}.{name}".lstrip(".")
        return [Entry(each, f"{place}[{n}]", self.file) for n, each in enumerate(listed, 1)
                if isinstance(each, dict)]  # fmt: skip

    def named(self, name: str, wanted: str | None, option: str) -> Entry:
        """One entry of a list by its `Name`: the wanted one, or the only one."""
        listed = self.entries(name)
        names = [entry.text("Name") or "" for entry in listed]
        chosen = [n for n, each in enumerate(names) if wanted in (None, each)]
        if len(chosen) != 1:
            if not listed:
                raise self.error(name, "nothing", ALLOWED)
            found = repr(wanted) if wanted is not None else f"{len(listed)} in {name}"
            allowed = f"one of {', '.join(repr(each) for each in names)}, given as {flag(option)}"
            raise HydrodynamicsError(option, found, allowed, self.file)
        place = f"{self.place}.{name}.{names[chosen[0]]}".lstrip(".")
        return Entry(listed[chosen[0]].value, place, self.file)

    def number(self, name: str, *, infinite: bool = False) -> float | None:
        """A number; `None` if it is missing or `~`."""
        found = self.text(name)
        if found is None:
            return None
        return float((self._floats if infinite else self._finite)(name, [found])[0])

    def vector(self, name: str, count: int = 3) -> NDArray[np.float64] | None:
        """Finite numbers; `None` if they are missing or all are `~`."""
        found = self.value.get(name)
        if found is None or found == NOTHING or found == [NOTHING] * count:
            return None
        if not isinstance(found, list) or len(found) != count:
            raise self.error(name, found, f"{count} numbers")
        return self._finite(name, found)

    def needed(self, name: str, count: int = 3) -> NDArray[np.float64]:
        """Required finite numbers."""
        found = self.vector(name, count)
        if found is None:
            raise self.error(name, "nothing", f"{count} numbers")
        return found

    def table(self, names: Sequence[str]) -> NDArray[np.float64]:
        """The rows of the table with these columns, in this order; the caller handles infinities."""
        for key, rows in self.value.items():
            columns = [column.strip() for column in key.split(",")]
            if set(names) <= set(columns):
                found = self._rows(key, rows, len(columns))
                return found[:, [columns.index(name) for name in names]]
        raise self.error(f"{names[0]}, ...", "nothing", f"a table of {', '.join(names)}")

    def _rows(self, key: str, rows: object, count: int) -> NDArray[np.float64]:
        if not isinstance(rows, list) or not rows:
            raise self.error(key[:40], "no rows", f"rows of {count} numbers")
        for row in rows:
            if not isinstance(row, list) or len(row) != count:
                raise self.error(key[:40], row, f"{count} numbers in a row")
        return np.stack([self._floats(key[:40], row) for row in rows])

    def _floats(self, name: str, cells: list[Any]) -> NDArray[np.float64]:
        try:
            found = np.array([float(cell) for cell in cells])
        except (TypeError, ValueError):
            raise self.error(name, cells, "numbers") from None
        if np.isnan(found).any():
            raise self.error(name, cells, "numbers")
        return found

    def _finite(self, name: str, cells: list[Any]) -> NDArray[np.float64]:
        found = self._floats(name, cells)
        if not np.isfinite(found).all():
            raise self.error(name, cells, "finite numbers")
        return found
