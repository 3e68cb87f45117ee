"""Contract for every input: it is accepted, or refused with a message, within limits of time and memory.
`judge` returns the result and raises no exception; a violation begins with ``WRONG``. The limits of time and
of memory are kept by the process around it (`apart`).
"""

from __future__ import annotations

import contextlib
import io
import re
import shutil
import traceback
import warnings
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from kingpost.errors import KingpostError, KingpostWarning

LONGEST_CASE_S = 10.0
"""Processor time from which on a case counts as hanging, s."""
MEMORY_BYTES = 2 << 30
EXIT_CODES = (0, 1, 2)
LONGEST_TEXT = 2500
MOST_DIGITS = 40
"""Largest number of digits of a printed number, unless the input contains a longer one."""
PANIC = "the engine failed"
# Messages of the Rust runtime do not help the author of a file.
NOT_FOR_READERS = re.compile(
    r"\bSome\(|\bNone\b|\bErr\(|unwrap|panick|RefCell|overflow|invalid (type|value|length)"
    r"|\busize|\b[iu](8|16|32|64)\b|f64|index out of"
)
DIGITS = re.compile(rf"\d{{{MOST_DIGITS + 1},}}")
# Control characters of a terminal, except line ends: output contains none.
CONTROL = re.compile(r"[\x00-\x09\x0b-\x1f\x7f-\x9f]")


@dataclass(frozen=True)
class Case:
    """One input: files in one folder, and arguments as on a command line."""

    kind: str
    files: dict[str, bytes]
    arguments: tuple[str, ...] = ()


class WrongError(Exception):
    """A violation of the contract."""


Use = Callable[[Case, Path], str]


def judge(use: Use, case: Case, folder: Path) -> str:
    """Judge a case: return ``refused``, another word of its kind, or ``WRONG`` with the violation."""
    for name, content in case.files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_bytes(content)
    shown = io.StringIO()
    try:
        with (
            contextlib.redirect_stdout(shown),
            contextlib.redirect_stderr(shown),
            warnings.catch_warnings(),
        ):
            warnings.simplefilter("ignore", KingpostWarning)
            says = _used(use, case, folder)
        check_shown(shown.getvalue(), case)
    except WrongError as wrong:
        says = f"WRONG: {wrong}"
    finally:
        for path in folder.iterdir():
            shutil.rmtree(path) if path.is_dir() else path.unlink()
    return says


def _used(use: Use, case: Case, folder: Path) -> str:
    try:
        return use(case, folder)
    except KingpostError as error:
        check_refusal(str(error), case)
        return f"refused: {error}"
    except WrongError:
        raise
    except KeyboardInterrupt:
        raise
    except BaseException as error:
        at = traceback.extract_tb(error.__traceback__)[-1]
        place = f"{Path(at.filename).name}:{at.lineno}"
        raise WrongError(f"{type(error).__name__} at {place}: {error}"[:600]) from error


def check_refusal(says: str, case: Case) -> None:
    """Check that an error is helpful and short."""
    if PANIC in says:
        raise WrongError(f"a panic: {says}")
    if len(says.strip()) < 10:
        raise WrongError(f"an error that says nothing: {says!r}")
    if len(says) > LONGEST_TEXT:
        raise WrongError(f"an error of {len(says)} characters: {says[:300]}")
    check_digits(says, case)


def check_shown(shown: str, case: Case) -> None:
    """Check the output on a terminal."""
    if PANIC in shown:
        raise WrongError(f"a panic: {shown[-600:]}")
    if "Traceback (most recent call last)" in shown or "Exception ignored in" in shown:
        raise WrongError(f"a traceback: {shown[-600:]}")
    if "Warning: " in shown:
        raise WrongError(f"a library's warning: {shown[:600]}")
    if control := CONTROL.search(shown):
        raise WrongError(f"a control character {control[0]!r}: {shown[:300]!r}")
    check_digits(shown, case)


def check_digits(text: str, case: Case) -> None:
    """Refuse a printed number of hundreds of digits, unless it is in the input."""
    for found in DIGITS.finditer(text):
        given = found[0].encode()
        if not any(given in part for part in (*case.files.values(), " ".join(case.arguments).encode())):
            raise WrongError(f"a number of {len(found[0])} digits: {text[:300]}")


def check_exit(code: object) -> None:
    """Check the exit code of the command line."""
    if code not in EXIT_CODES:
        raise WrongError(f"exit code {code}")
