"""A hydrodynamic database's file, `NAME.hydro.json`: every field is checked on reading, and files are written
completely or not at all.

A file holds one hull (version 1), or several hulls that were solved together (version 2, `several_tree`).
Coefficients are stored with seven digits, the fitted memory with all digits. A file leaves out optional
fields without a value: the attitude of an upright hull, the loading of a mean drift.
"""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import Any, TypeVar

from .. import output
from ..errors import HydrodynamicsError, OutputError
from ..reading import text_of
from . import database_tree as parts
from . import several_tree
from .database import Database
from .fields import Fields
from .several import SeveralHulls

ENDING = ".hydro.json"
VERSION = 1
One = TypeVar("One", Database, SeveralHulls)


def read(path: str | Path) -> Database:
    """Read a database of one hull.

    Raises
    ------
    HydrodynamicsError
        If the file cannot be read, is not a database, is truncated, holds several hulls or a value that is
        not allowed; the message names the field, the value found and the allowed values.
    """
    return from_tree(_tree_of(path), str(path))


def read_several(path: str | Path) -> SeveralHulls:
    """Read a database of several hulls that were solved together.

    Raises
    ------
    HydrodynamicsError
        If the file cannot be read, is not a database, is truncated, holds one hull or a value that is not
        allowed.
    """
    return several_tree.from_tree(_tree_of(path), str(path))


def _tree_of(path: str | Path) -> dict[str, Any]:
    file = str(path)
    allowed = f"a hydrodynamic database, as `kingpost hydro` writes ({ENDING})"
    try:
        text = text_of(path, "utf-8")
    except UnicodeDecodeError:
        raise HydrodynamicsError("", "a file that is not text", allowed, file) from None
    except OSError as error:
        raise HydrodynamicsError("", error.strerror, allowed, file) from None
    try:
        tree = json.loads(text)
    except (ValueError, RecursionError) as error:
        ended = isinstance(error, json.JSONDecodeError) and error.pos >= len(text.rstrip())
        found = "a file that is cut short" if ended and text.strip() else "a file that is not JSON"
        raise HydrodynamicsError("", found, allowed, file) from None
    if not isinstance(tree, dict) or "format" not in tree:
        raise HydrodynamicsError("", "JSON of an unknown format", allowed, file)
    return tree


def write(database: Database | SeveralHulls, path: str | Path) -> Path:
    """Check a database and write it atomically: to a temporary file, which is then renamed.

    Raises
    ------
    HydrodynamicsError
        When a value is not allowed, or the file cannot be written.
    """
    target = check_output(path)
    if isinstance(database, SeveralHulls):
        tree = several_tree.to_tree(database)
        several_tree.from_tree(tree, str(target))
    else:
        tree = to_tree(database)
        from_tree(tree, str(target))
    text = json.dumps(tree, separators=(",", ":"), ensure_ascii=False, allow_nan=False) + "\n"
    try:
        output.write_text(target, text)
    except OutputError as error:
        raise HydrodynamicsError("", error.reason, "a path that can be written to", str(target)) from None
    return target


def rounded(database: One) -> One:
    """The database as read back from its file.

    The memory is fitted to these rounded numbers, so that a fit to the stored coefficients gives the stored
    memory: poles that the data hardly determine depend on the eighth digit.
    """
    if isinstance(database, SeveralHulls):
        return several_tree.from_tree(several_tree.to_tree(database))
    return from_tree(to_tree(database))


def check_output(path: str | Path) -> Path:
    """Check the output path before any computation."""
    target = Path(path)
    if not target.name.endswith(ENDING):
        raise HydrodynamicsError("", repr(target.name), f"a name that ends with {ENDING}")
    if not os.path.isdir(target.parent):
        raise HydrodynamicsError("", "no such folder", "a folder that exists", str(target.parent))
    if os.path.isdir(target):
        raise HydrodynamicsError("", "a folder", "a file", str(target))
    return target


_TOP = ("format", "version", "title", "provenance", "water", "hull", "frequencies_rad_s",
        "wave_directions_rad", "added_mass", "radiation_damping", "added_mass_infinite", "froude_krylov",
        "diffraction", "mean_drift", "radiation")  # fmt: skip


def from_tree(tree: dict[str, Any], file: str | None = None) -> Database:
    """The database that a tree of plain values describes, every field checked."""
    _refuse_several(tree, file)
    parts.check_format(tree, file, VERSION)
    # Older files have no loading.
    top = Fields.of(tree, "", file, _TOP, ("mean_drift_loading",))
    frequencies, directions = parts.grid(top)
    n, m = len(frequencies), len(directions)
    return Database(
        title=top.text("title"),
        provenance=parts.provenance(top),
        water=parts.water(top),
        hull=parts.hull(top),
        frequencies_rad_s=frequencies,
        wave_directions_rad=directions,
        added_mass=top.numbers("added_mass", n, 6, 6),
        radiation_damping=top.numbers("radiation_damping", n, 6, 6),
        added_mass_infinite=top.numbers("added_mass_infinite", 6, 6),
        froude_krylov=parts.complex_forces(top, "froude_krylov", n, m),
        diffraction=parts.complex_forces(top, "diffraction", n, m),
        mean_drift=parts.mean_drift(top, n, m),
        radiation=parts.radiation(top, 6),
        mean_drift_loading=parts.drift_loading(top),
    )


def _refuse_several(tree: dict[str, Any], file: str | None) -> None:
    """Refuse the hulls of a file of several by their names."""
    if tree.get("format") == parts.FORMAT and tree.get("version") == several_tree.VERSION and "hulls" in tree:
        names = ", ".join(several_tree.names_of(tree)) or "without names"
        allowed = "one hull: kingpost.hydro.read_several(file).of(name) gives one of several"
        raise HydrodynamicsError("hulls", f"several, {names}", allowed, file)


def to_tree(database: Database) -> dict[str, Any]:
    """The database as plain values, with seven digits except for the memory: the contents of its file."""
    tree = {
        **parts.head_tree(database, VERSION), "hull": parts.hull_tree(database.hull),
        **parts.matrices_tree(database), **parts.waves_tree(database),
    }  # fmt: skip
    return {**parts.plain(tree), "radiation": parts.radiation_tree(database.radiation)}
