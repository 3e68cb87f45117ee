"""Error of a file with sea states, with its place."""

from __future__ import annotations

from ...errors import KingpostError


class SeaFileError(KingpostError):
    """An error in a file with sea states.

    Attributes
    ----------
    file, line
        Place of the error; `None` if it has none.
    field, found, allowed
        Wrong field, the value found and the allowed values.
    """

    def __init__(
        self, field: str, found: object, allowed: str, file: str | None = None, line: int | None = None
    ) -> None:
        place = "".join(f"{part}:" for part in (file, line) if part is not None)
        super().__init__(f"{place} {field}: found {found}, allowed: {allowed}".strip())
        self.file, self.line, self.field, self.found, self.allowed = file, line, field, found, allowed
