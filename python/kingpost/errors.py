"""The exceptions of the package, all of which derive from `KingpostError`, and its warning."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from pathlib import Path

    import xarray


class KingpostWarning(UserWarning):
    """Category of all warnings of Kingpost, for `warnings.filterwarnings`; the run continues after a
    warning."""


def shortened(text: str, longest: int = 200) -> str:
    """Shorten a text from the input for a message.

    >>> shortened("barge" * 100, longest=8)
    'bargebar...'
    """
    return text if len(text) <= longest else f"{text[:longest]}..."


def printable(text: str) -> str:
    """Remove terminal control characters from a text: titles and names come from files.

    >>> printable("a\\x1b[31mred\\nline")
    'a?[31mred\\nline'
    """
    return "".join(sign if sign.isprintable() or sign == "\n" else "?" for sign in text)


def flag(name: str) -> str:
    """The command-line option of a parameter, as messages name it.

    >>> flag("water_depth_m")
    '--water-depth-m'
    """
    return f"--{name.replace('_', '-')}"


class KingpostError(Exception):
    """Base of every error that Kingpost raises on purpose."""


class ScenarioError(KingpostError):
    """A scenario, an override or an input that is wrong.

    Attributes
    ----------
    file, line, column
        Place of the value; `None` if it has none.
    field
        Dotted path of the value, such as ``bodies.ship.mass_kg``.
    found, allowed
        The value found and the allowed values.
    """

    def __init__(
        self,
        message: str,
        file: str | None = None,
        line: int | None = None,
        column: int | None = None,
        field: str | None = None,
        found: str | None = None,
        allowed: str | None = None,
    ) -> None:
        super().__init__(message)
        self.file = file
        self.line = line
        self.column = column
        self.field = field
        self.found = found
        self.allowed = allowed


class OutputError(KingpostError):
    """A file that cannot be written.

    Attributes
    ----------
    path, reason
        The file, and the reason that the operating system gives, such as "No space left on device".
    """

    def __init__(self, path: Path, error: OSError) -> None:
        self.path = path
        self.reason = error.strerror or str(error)
        super().__init__(f"{path}: cannot be written: {self.reason}")


class RunError(KingpostError):
    """A run that could not continue: most often because it diverged, or because its integrator cannot
    make a step.

    Attributes
    ----------
    time_s
        Time of the step that failed, s.
    body
        The body whose motion left its limits, or the closed loop that could not be kept closed;
        `None` if the integrator failed, a step of an operation did not end, or a result is NaN.
    coordinate, value, limit
        The coordinate, its rate and `simulation.rate_limit`, m/s or rad/s. For a closed loop: the constraint,
        its error (m or rad) or its pivot, and the allowed value. Otherwise `None`.
    results
        Results recorded until then; `None` if nothing was recorded.
    """

    def __init__(
        self,
        message: str,
        time_s: float | None = None,
        body: str | None = None,
        coordinate: str | None = None,
        value: float | None = None,
        limit: float | None = None,
    ) -> None:
        super().__init__(message)
        self.time_s = time_s
        self.body = body
        self.coordinate = coordinate
        self.value = value
        self.limit = limit
        self.results: xarray.Dataset | None = None


class HydrodynamicsError(KingpostError):
    """A hull, a hydrodynamic database or a result of the panel method that is wrong.

    Attributes
    ----------
    file
        The file it was read from; `None` if there is none.
    field
        The wrong field, option or quantity, such as ``hull.volume_m3``.
    found, allowed
        The value found and the allowed values.
    """

    def __init__(
        self,
        field: str,
        found: object,
        allowed: str,
        file: str | None = None,
    ) -> None:
        place = f"{file}: " if file is not None else ""
        field_place = f"{field}: " if field else ""
        super().__init__(f"{place}{field_place}found {found}, allowed: {allowed}")
        self.file = file
        self.field = field
        self.found = found
        self.allowed = allowed


class RollDampingError(HydrodynamicsError):
    """Sections of a hull, bilge keels or a record of decaying roll that are wrong.

    The attributes are those of `HydrodynamicsError`: `file`, `field`, `found`, `allowed`.
    """
