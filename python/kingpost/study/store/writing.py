"""Writing of a study's folder: a Zarr group of results, and a marker for each finished unit. A unit is
finished if it has a marker whose digest matches the numbers in the arrays. All other units, for example after
a power cut or on a full disk, are computed again.
"""

from __future__ import annotations

import json
import shutil
import tempfile
import uuid
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import asdict
from importlib.metadata import version
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from ...engine import engine
from ...errors import KingpostError, OutputError
from ...output import write_text
from ..design import fingerprint
from ..design.job import Result
from ..design.plan import Plan
from ..reduce import variables
from .digests import digest, frame_digest
from .frame import coordinates, group_attributes, write_frame
from .layout import ABOUT, FORMAT, RESULTS, SCENARIO, STUDY, UNITS, About, Marker, about_of

if TYPE_CHECKING:
    import zarr

BEGINNING = ".beginning-"
"""Prefix of a temporary folder that exists only while a study is laid out."""
PARTIAL = ".partial"
"""Suffix of a temporary file, here and in Zarr, before it is renamed."""


class Store:
    """Folder of a running study.

    Parameters
    ----------
    folder
        Path of the folder.
    plan
        Plan of the study.
    """

    def __init__(self, folder: Path, plan: Plan) -> None:
        self.folder = folder
        self.plan = plan
        self.variables = variables(plan.kept)
        self._arrays: dict[str, zarr.Array] = {}

    def begin(self, resume: bool, alone: bool = False) -> None:
        """Lay out the folder, or find the same study in it and rewrite damaged parts of its frame. If no
        other process works there (`alone`), remove the temporary files of killed processes.

        Raises
        ------
        KingpostError
            If the folder holds a study and `resume` is not given, another study, or a foreign file with the
            name of a study's file.
        OutputError
            If the folder cannot be written.
        """
        about = self._about()
        found = about_of(self.folder)
        if found is not None and not resume:
            raise KingpostError(
                f"{self.folder}: found a study, allowed: an empty folder; --resume goes on with that study"
            )
        if found is not None:
            self._check_same(found)
        else:
            self._check_foreign()
        with _written(self.folder):
            if alone:
                self._clean()
            (self.folder / UNITS).mkdir(parents=True, exist_ok=True)
            _replace(self.folder / STUDY, self.plan.file.text.encode())
            _replace(self.folder / SCENARIO, self.plan.scenario.json.encode())
            if found != about:
                # A study cannot be resumed without this file.
                write_text(self.folder / ABOUT, json.dumps(about, indent=1))
            self._lay_out()

    def _check_foreign(self) -> None:
        """Refuse to overwrite foreign files that have the names of a study's files."""
        own = {STUDY: self.plan.file.text.encode(), SCENARIO: self.plan.scenario.json.encode()}
        for name, content in own.items():
            path = self.folder / name
            # A file of equal content comes from a study that was stopped at its beginning.
            if path.exists() and not (path.is_file() and path.read_bytes() == content):
                raise KingpostError(
                    f"{path}: found a file of something else, allowed: a folder without {name}, as the "
                    "study writes its own there"
                )

    def _clean(self) -> None:
        for path in self.folder.glob(f"{BEGINNING}*"):
            shutil.rmtree(path, ignore_errors=True)
        for below in (f".*{PARTIAL}", f".{ABOUT}.*", f"{UNITS}/.*{PARTIAL}", f"{RESULTS}/**/*{PARTIAL}"):
            for path in self.folder.glob(below):
                path.unlink(missing_ok=True)

    def _about(self) -> About:
        plan = self.plan
        versions = {name: version(name) for name in ("numpy", "scipy", "zarr")}
        return {
            "version": FORMAT,
            "title": plan.file.content["title"],
            "fingerprint": plan.fingerprint,
            "depends_on": plan.depends_on,
            "runs": plan.runs,
            "runs_of_unit": plan.runs_of_unit,
            "axes": {name: plan.cases.values[name] for name in plan.cases.names},
            "seeds": plan.seeds,
            "columns": plan.columns,
            "limits": [asdict(limit) for limit in plan.limits],
            "files": plan.scenario.digests,
            "frame": self._frame_digest(),
            "versions": {"kingpost": engine.__version__, **versions},
        }

    def _frame_digest(self) -> str:
        values = {name: one for name, (_, one, _) in coordinates(self.plan).items()}
        return frame_digest(values, group_attributes(self.plan))

    def _check_same(self, found: About) -> None:
        parts = fingerprint.differences(found["depends_on"], self.plan.depends_on)
        if not parts:
            return
        try:
            before = json.loads((self.folder / SCENARIO).read_text(encoding="utf-8"))
        except (OSError, ValueError):
            before = None
        fields = fingerprint.fields(before, self.plan.scenario.resolved) if before else []
        differ = fingerprint.in_words(parts, fields)
        raise KingpostError(
            f"{self.folder}: found a study that differs in {differ}; "
            "allowed: the same study, or another folder"
        )

    def _lay_out(self) -> None:
        """Write the frame of the results to a temporary folder, and replace the parts that differ."""
        with tempfile.TemporaryDirectory(dir=self.folder, prefix=BEGINNING) as beside:
            frame = Path(beside) / RESULTS
            write_frame(frame, self.plan)
            for path in sorted(frame.rglob("*")):
                if path.is_file():
                    target = self.folder / RESULTS / path.relative_to(frame)
                    target.parent.mkdir(parents=True, exist_ok=True)
                    _replace(target, path.read_bytes())

    def write(self, result: Result) -> None:
        """Write a unit: its numbers, then its marker.

        Raises
        ------
        OutputError
            If the unit cannot be written, for example on a full disk.
        """
        runs = self.plan.runs_in(result.unit)
        with _written(self.folder / RESULTS):
            for name in self.variables:
                self._array(name)[runs.start : runs.stop] = result.arrays[name]
        marker: Marker = {
            "unit": result.unit,
            "runs": [runs.start, runs.stop],
            "fingerprint": self.plan.fingerprint,
            "sha256": digest(result.arrays),
            "ends": {str(runs[k]): text for k, text in sorted(result.ends.items())},
            "warnings": result.warnings,
        }
        with _written(self.folder / UNITS):
            _replace(self.marker(result.unit), json.dumps(marker, indent=1).encode())

    def marker(self, unit: int) -> Path:
        """Path of the marker of a finished unit."""
        return self.folder / UNITS / f"{unit:06d}.json"

    def done(self, unit: int) -> bool:
        """Whether a unit is finished: it has a marker, and its numbers match the digest in the marker."""
        runs = self.plan.runs_in(unit)
        try:
            marker = json.loads(self.marker(unit).read_text(encoding="utf-8"))
            expected = (marker["fingerprint"], marker["runs"], marker["sha256"])
        except (OSError, ValueError, TypeError, KeyError):
            return False
        if expected[:2] != (self.plan.fingerprint, [runs.start, runs.stop]):
            return False
        try:
            arrays = {name: np.asarray(self._array(name)[runs.start : runs.stop]) for name in self.variables}
        except Exception:
            # After any exception of the library or its codecs on a damaged chunk the unit runs again.
            return False
        return digest(arrays) == expected[2]

    def _array(self, name: str) -> zarr.Array:
        import zarr

        if name not in self._arrays:
            self._arrays[name] = zarr.open_array(str(self.folder / RESULTS / name), mode="r+")
        return self._arrays[name]


def _replace(path: Path, content: bytes) -> None:
    """Replace a file in one step, unless it already has this content. It does not wait for the disk, which
    may take a second: damage by a power cut is found later and repaired.
    """
    try:
        if path.read_bytes() == content:
            return
    except OSError:
        pass
    beside = path.with_name(f".{path.name}.{uuid.uuid4().hex}{PARTIAL}")
    try:
        beside.write_bytes(content)
        beside.replace(path)
    finally:
        beside.unlink(missing_ok=True)


@contextmanager
def _written(path: Path) -> Iterator[None]:
    """Convert an error of the system on writing below a path into an `OutputError`."""
    try:
        yield
    except OSError as error:
        raise OutputError(path, error) from None
    except ExceptionGroup as errors:
        first = errors.exceptions[0]
        if isinstance(first, OSError):
            raise OutputError(path, first) from None
        raise
