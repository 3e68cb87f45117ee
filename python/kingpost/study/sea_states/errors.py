"""Error of a file with sea states, with its place."""

from __future__ import annotations

from ...errors import KingpostError


class SeaFileError(KingpostError):
    """A file with sea states that is wrong.

    Attributes
    ----------
    file, line
        Where; `None` where there is no such place.
    field, found, allowed
        What is wrong, what stands there and what may stand there.
    """

    def __init__(
        self, field: str, found: object, allowed: str, file: str | None = None, line: int | None = None
    ) -> None:
        place = "".join(f"{part}:" for part in (file, line) if part is not None)
        super().__init__(f"{place} {field}: found {found}, allowed: {allowed}".strip())
        self.file, self.line, self.field, self.found, self.allowed = file, line, field, found, allowed
