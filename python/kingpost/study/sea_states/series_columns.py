"""Columns of a file with a series of sea states: names, units, and the meaning of unknown names."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from ...errors import flag
from .periods import MOMENTS, PEAK, kind_of
from .series import SeriesError

TIMES = ("time", "valid_time", "datetime", "date", "timestamp")
HEIGHTS = ("hs", "hm0", "swh", "vhm0", "significant_height_m", "hs_m")
FROM, TO = ("mwd", "dp", "vmdr", "direction_from_deg"), ("direction_to_deg",)
UNIT = re.compile(r"^(.*?)\s*[(\[]\s*([^)\]]*?)\s*[)\]]$")
METRES = ("", "m", "metre", "meter", "metres", "meters")
SECONDS = ("", "s", "sec", "second", "seconds")
RADIANS = ("rad", "radian", "radians")
DEGREES = ("", "deg", "degree", "degrees", "degree true", "degrees true", "degree_true", "\u00b0")
DIRECTION_IS = f"{flag('direction_is')} from or to, direction= in Python"
PERIOD_IS = f"{flag('period_is')} {', '.join((PEAK, *MOMENTS))}, period= in Python"
KINDS = (PEAK, *MOMENTS)


@dataclass(frozen=True)
class Said:
    """Meanings of columns given by the caller, for those that the file does not define."""

    direction: str | None = None
    period: str | None = None
    direction_unit: str | None = None

    def __post_init__(self) -> None:
        for field, allowed in (
            ("direction", ("from", "to")),
            ("period", KINDS),
            ("direction_unit", ("deg", "rad")),
        ):
            value = getattr(self, field)
            if value is not None and value not in allowed:
                raise SeriesError(field, repr(value), ", ".join(allowed))


@dataclass(frozen=True)
class Columns:
    """Names of the columns that are read. `direction_unit` is ``deg``, ``rad``, or empty if unknown."""

    time: str
    height: str
    period: str
    direction: str | None
    is_from: bool
    kind: str
    direction_unit: str = ""

    @classmethod
    def of(
        cls,
        names: Sequence[str],
        given: Mapping[str, str],
        said: Said,
        file: str,
        line: int | None = None,
    ) -> Columns:
        """Find the columns by the names that the caller gives, otherwise by known names."""
        for name in given.values():
            if name not in names:
                raise SeriesError("columns", repr(name), ", ".join(names), file, line)

        def known(what: str, wanted: Sequence[str]) -> str | None:
            found = [name for name in names if plain(name)[0] in wanted]
            if len(found) > 1:
                raise SeriesError(what, ", ".join(found), "one column of these", file, line)
            return found[0] if found else None

        periods = [name for name in names if kind_of(plain(name)[0]) is not None]
        periods.sort(key=lambda name: kind_of(plain(name)[0]) != PEAK)
        time, height = given.get("time") or known("time", TIMES), given.get("height") or known("Hs", HEIGHTS)
        period = given.get("period") or (periods[0] if periods else None)
        where = given.get("direction") or known("direction", (*FROM, *TO))
        for what, column, example in (("time", time, "time"), ("Hs", height, "hs"), ("period", period, "tp")):
            if column is None:
                raise SeriesError(
                    what, ", ".join(names), f"a column of it, as {example}, or its name given", file, line
                )
        assert time is not None
        assert height is not None
        assert period is not None
        if where is not None and said.direction is None and plain(where)[0] not in (*FROM, *TO):
            raise SeriesError(
                "direction", f"the column {where}", f"what it means: {DIRECTION_IS}", file, line
            )
        is_from = (
            said.direction == "from" if said.direction else where is not None and plain(where)[0] in FROM
        )
        kind = said.period or kind_of(plain(period)[0])
        if kind is None:
            raise SeriesError(
                "period", f"the column {period}", f"which period it is: {PERIOD_IS}", file, line
            )
        return cls(time, height, period, where, is_from, kind, said.direction_unit or "")

    def with_units(self, units: Mapping[str, str], file: str, line: int | None = None) -> Columns:
        """Return these columns with the unit of the directions from the file; the other units are checked."""
        directions = (*DEGREES, *RADIANS)
        for name, allowed in ((self.height, METRES), (self.period, SECONDS), (self.direction, directions)):
            if name is not None and units[name].lower() not in allowed:
                raise SeriesError(f"unit of {name}", repr(units[name]), allowed[1], file, line)
        written = "" if self.direction is None else units[self.direction].lower()
        if self.direction is None or not (written or self.direction.lower().endswith("_deg")):
            return self
        return replace(self, direction_unit="rad" if written in RADIANS else "deg")


def plain(name: str) -> tuple[str, str]:
    """Split a column's name into the lower-case name and the unit."""
    found = UNIT.match(name.strip())
    return (found[1].strip().lower(), found[2]) if found else (name.strip().lower(), "")
