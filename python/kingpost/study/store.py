"""The folder of a study: a Zarr group of results, and a marker for each unit that is whole.

A unit is done when its marker is there and the hash in it is that of the numbers in the arrays; whatever else
stands there, after a power cut or on a full disk, is computed again.
"""

from __future__ import annotations

import json
import shutil
import tempfile
import uuid
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from importlib.metadata import version
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..engine import engine
from ..errors import KingpostError, OutputError
from ..output import write_text
from . import fingerprint
from .compute import Result
from .digests import digest, frame_digest
from .plan import Plan
from .reduce import HELD_MEANINGS, STATISTICS, STATUS, variables

STUDY, SCENARIO, ABOUT, RESULTS, UNITS = "study.yaml", "scenario.json", "study.json", "results.zarr", "units"
FORMAT = 1
BEGINNING = ".beginning-"
"""How the name of a folder begins that is gone once a study has begun."""
PARTIAL = ".partial"
"""How the name of a file ends, here and in Zarr, that is not yet in its place."""


class Store:
    """The folder of a study that runs.

    Parameters
    ----------
    folder
        Where.
    plan
        What runs.
    """

    def __init__(self, folder: Path, plan: Plan) -> None:
        self.folder = folder
        self.plan = plan
        self.variables = variables(plan.kept)
        self._arrays: dict[str, Any] = {}

    def begin(self, resume: bool, alone: bool = False) -> None:
        """Lay out the folder, or find the same study in it; what of its frame is damaged is written anew.

        Where nobody else is at work, `alone`, what a process that was killed left half written is removed.

        Raises
        ------
        KingpostError
            When there is a study and `resume` is not given, another study, or a file of another with the
            name of a study's.
        OutputError
            When the folder cannot be written.
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
                # The one file without which a study is lost.
                write_text(self.folder / ABOUT, json.dumps(about, indent=1))
            self._lay_out()

    def _check_foreign(self) -> None:
        """Refuse to write over files of others that have the names of a study's."""
        own = {STUDY: self.plan.file.text.encode(), SCENARIO: self.plan.scenario.json.encode()}
        for name, content in own.items():
            path = self.folder / name
            # The same content is that of a study that was stopped while it began.
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

    def _about(self) -> dict[str, Any]:
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
            "limits": plan.limits,
            "files": plan.scenario.digests,
            "frame": self._frame_digest(),
            "versions": {"kingpost": engine.__version__, **versions},
        }

    def _frame_digest(self) -> str:
        coordinates = {name: values for name, (_, values, _) in _coordinates(self.plan).items()}
        return frame_digest(coordinates, _group_attributes(self.plan))

    def _check_same(self, found: dict[str, Any]) -> None:
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
        """Write the frame of the results beside them, and what of it differs into its place."""
        with tempfile.TemporaryDirectory(dir=self.folder, prefix=BEGINNING) as beside:
            frame = Path(beside) / RESULTS
            _frame(frame, self.plan)
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
            When the disk is full, or takes it not for another reason.
        """
        runs = self.plan.runs_in(result.unit)
        with _written(self.folder / RESULTS):
            for name in self.variables:
                self._array(name)[runs.start : runs.stop] = result.arrays[name]
        marker = {
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
        """The file that says that a unit is done."""
        return self.folder / UNITS / f"{unit:06d}.json"

    def done(self, unit: int) -> bool:
        """Whether a unit is whole: its marker, and numbers with the hash that the marker has."""
        runs = self.plan.runs_in(unit)
        try:
            marker = json.loads(self.marker(unit).read_text(encoding="utf-8"))
            expected = (marker["fingerprint"], marker["runs"], marker["sha256"])
        except (OSError, ValueError, TypeError, KeyError):
            return False
        if expected[:2] != (self.plan.fingerprint, [runs.start, runs.stop]):
            return False
        try:
            arrays = {name: self._array(name)[runs.start : runs.stop] for name in self.variables}
        except Exception:
            # Whatever a damaged chunk leads to, in the library or its codecs: the unit runs again.
            return False
        return digest(arrays) == expected[2]

    def _array(self, name: str) -> Any:
        import zarr

        if name not in self._arrays:
            self._arrays[name] = zarr.open_array(str(self.folder / RESULTS / name), mode="r+")
        return self._arrays[name]


def about_of(folder: Path) -> dict[str, Any] | None:
    """Read the description of the study in a folder; None where there is none.

    Raises
    ------
    KingpostError
        When its description is damaged, or of a later version.
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


def markers(folder: Path) -> Iterator[dict[str, Any]]:
    """Yield the content of the markers of units that are done, in order."""
    for path in sorted((folder / UNITS).glob("[0-9]*.json")):
        try:
            yield json.loads(path.read_text(encoding="utf-8"))
        except (OSError, ValueError):
            continue


def _frame(path: Path, plan: Plan) -> None:
    """A Zarr group with all arrays, the coordinates filled and the others empty."""
    import zarr

    coordinates = _coordinates(plan)
    group = zarr.create_group(str(path), zarr_format=3, attributes=_group_attributes(plan))
    for name, (dim, values, about) in coordinates.items():
        array = group.create_array(
            name,
            shape=values.shape,
            chunks=values.shape,
            dtype=values.dtype,
            dimension_names=(dim,),
            attributes=about,
        )
        array[:] = values
    for name, one in variables(plan.kept).items():
        group.create_array(
            name,
            shape=(plan.runs, *one.shape),
            chunks=(plan.runs_of_unit, *one.shape),
            dtype=one.dtype,
            fill_value=one.fill,
            dimension_names=("run", *one.dims),
            attributes={"long_name": one.long_name, **FLAGS.get(name, {})},
        )


def _flags(meanings: Mapping[int, str]) -> dict[str, Any]:
    return {"flag_values": list(meanings), "flag_meanings": " ".join(meanings.values())}


FLAGS = {"status": _flags(STATUS), "limit_held": _flags(HELD_MEANINGS), "limit_time": {"units": "s"}}


def _coordinates(plan: Plan) -> dict[str, tuple[str, NDArray[Any], dict[str, Any]]]:
    """Dimension, values and attributes of each coordinate."""
    seeds, count = plan.seeds, plan.cases.count
    texts = np.dtypes.StringDType()
    units = {one["name"]: one["unit"] for one in plan.scenario.model["parameters"]}
    found: dict[str, tuple[str, NDArray[Any], dict[str, Any]]] = {
        "run": ("run", np.arange(plan.runs), {}),
        "case": ("run", np.repeat(np.arange(count), len(seeds)), {}),
        "seed": ("run", np.tile(np.array(seeds, "u8"), count), {}),
    }
    for name in plan.cases.names:
        values = plan.cases.values[name]
        array = np.array(values, texts if isinstance(values[0], str) else None)
        about = {"units": units[name]} if units.get(name) else {}
        found[name] = ("run", np.repeat(array, len(seeds)), about)
    for name, draws in plan.cases.drawn.items():
        found[name] = ("run", np.repeat(np.array(draws), len(seeds)), {})
    found["column"] = ("column", np.array(list(plan.columns), texts), {})
    found["column_unit"] = ("column", np.array(list(plan.columns.values()), texts), {})
    found["statistic"] = ("statistic", np.array(STATISTICS, texts), {})
    if plan.limits:
        for name, key in (("limit", "name"), ("limit_column", "column"), ("limit_unit", "unit")):
            found[name] = ("limit", np.array([one[key] for one in plan.limits], texts), {})
        for key in ("at_least", "at_most"):
            bounds = [np.nan if one[key] is None else one[key] for one in plan.limits]
            found[key] = ("limit", np.array(bounds, float), {})
        of_scenario = plan.scenario.resolved["limits"]
        starts_s = [max(of_scenario[one["name"]]["from_s"], plan.kept.after_s) for one in plan.limits]
        found["limit_from_s"] = ("limit", np.array(starts_s, float), {"units": "s"})
    if plan.kept.peaks:
        found["peak"] = ("peak", np.arange(plan.kept.keep), {})
    if plan.kept.cycles:
        found["slope"] = ("slope", np.array(plan.kept.slopes), {})
    return found


def _group_attributes(plan: Plan) -> dict[str, Any]:
    named = " ".join(name for name, (dims, _, _) in _coordinates(plan).items() if dims != name)
    return {**_attributes(plan), "coordinates": named}


def _attributes(plan: Plan) -> dict[str, Any]:
    content, settings = plan.file.content, plan.scenario.resolved["simulation"]
    length_s = settings["duration_s"] - content["after_s"]
    return {
        "title": content["title"],
        "study": json.dumps(content),
        "scenario": plan.scenario.json,
        "source": plan.scenario.file,
        "files": json.dumps(plan.scenario.digests),
        "fingerprint": plan.fingerprint,
        "kingpost": engine.__version__,
        "axes": json.dumps(plan.cases.names),
        "sea": json.dumps(plan.sea),
        "after_s": content["after_s"],
        "duration_s": settings["duration_s"],
        "operation_s": content.get("operation_s", length_s),
        "acceptance": content["acceptance"],
    }


def _replace(path: Path, content: bytes) -> None:
    """Put a file in its place in one step, unless that stands there already.

    It does not wait for the disk, which may take a second: what a power cut damages is found and made anew.
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
    """Writing below a path: what the system refuses is one error."""
    try:
        yield
    except OSError as error:
        raise OutputError(path, error) from None
    except ExceptionGroup as errors:
        first = errors.exceptions[0]
        if isinstance(first, OSError):
            raise OutputError(path, first) from None
        raise
