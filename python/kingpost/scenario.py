"""Scenarios: descriptions of runs, read and validated by the engine."""

from __future__ import annotations

import difflib
import hashlib
import json
import math
from collections.abc import Mapping
from copy import copy
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from types import NoneType
from typing import Any, TypeAlias

import numpy as np

from . import gallery, markup
from .engine import engine
from .errors import KingpostError, ScenarioError

Overrides = Mapping[str, object]
ParameterValue: TypeAlias = bool | float | str
Json: TypeAlias = "bool | float | str | list[Json] | dict[str, Json] | None"
DEEPEST = 64
"""Largest nesting depth of an override, equal to that of a file."""


@dataclass
class Scenario:
    """A validated description of one run: the text of a file and the values that override it.

    Made by `load`. Two scenarios are equal if their text, file and overrides are equal.

    Parameters and fields are read and set by name, as with ``--set`` on the command line. A `Simulation`
    keeps a copy of the scenario that it was made from.

    >>> scenario = load("paper")
    >>> scenario["crane_x_m"], scenario["bodies.ship.mass_kg"]
    (-10.0, 10000.0)
    >>> scenario["bodies.ship.mass_kg"] = 12000
    >>> scenario.resolved["bodies"]["ship"]["mass_kg"]
    12000.0
    """

    text: str
    file: str
    overrides: tuple[tuple[str, Json], ...] = ()

    def __post_init__(self) -> None:
        # Validate on creation: every existing scenario can run.
        try:
            _ = self._built
        except ScenarioError as error:
            raise _with_place(error, self.file) from None

    @property
    def _overrides_json(self) -> str:
        return json.dumps(self.overrides)

    @cached_property
    def _built(self) -> engine.Scenario:
        """The engine's scenario, built once and shared by simulations, descriptions and analyses."""
        return engine.Scenario(self.text, self.file, self._overrides_json, self.files)

    def __copy__(self) -> Scenario:
        copied = object.__new__(type(self))
        vars(copied).update(vars(self))
        return copied

    def __getstate__(self) -> dict[str, object]:
        # The engine's scenario is not pickled: another process builds it again.
        return {name: value for name, value in vars(self).items() if name != "_built"}

    @cached_property
    def json(self) -> str:
        """The resolved scenario as JSON text: parameters applied, units SI."""
        return self._built.json()

    @cached_property
    def files(self) -> dict[str, str]:
        """Texts of the files that the scenario names, and of the files that these name, by name. Missing
        files are left out. Names that begin with ``gallery:`` are files of the gallery.

        >>> load("paper").files
        {}
        >>> list(load("knuckle_boom_crane").files)
        ['gallery:parts/knuckle_boom_crane.yaml']
        """
        return gallery.texts(self.text, self.file, self._overrides_json)

    @cached_property
    def resolved(self) -> dict[str, Any]:
        """The resolved scenario as a dictionary.

        >>> load("paper", motor_1=False).resolved["drives"]["motor_1"]["motor"]["enabled"]
        False
        """
        return json.loads(self.json)

    @cached_property
    def digests(self) -> dict[str, str]:
        """SHA-256 of each of `files`, by name.

        >>> len(load("knuckle_boom_crane").digests["gallery:parts/knuckle_boom_crane.yaml"])
        64
        """
        return {name: hashlib.sha256(text.encode()).hexdigest() for name, text in self.files.items()}

    @property
    def title(self) -> str:
        """The scenario's title."""
        return str(self.resolved.get("title") or Path(self.file).stem)

    @cached_property
    def model(self) -> dict[str, Any]:
        """Description of the model: bodies, joints, parameters with their values, step sizes.

        >>> [body["name"] for body in load("paper").model["bodies"]]
        ['ship', 'tower', 'arm']
        """
        return json.loads(self._built.model_json())

    @cached_property
    def hydrostatics(self) -> dict[str, Any]:
        """Hydrostatics of the hulls at rest in still water, with the crane at the start of a run: ``hulls``,
        one for each force `hydrodynamics`, and ``warnings``. This is a property; for the present crane
        position of a `Simulation` use the method ``simulation.hydrostatics()``.

        For each hull, with units in the names (docs/afloat.md): displacement, draught, heel to starboard,
        trim by the bow, KB, BM, KM and KG; GM with each hanging load at its suspension point and reduced by
        slack tanks (``metacentric_height_m``), and GM as if all were fixed; the hanging loads; the free
        surfaces of tanks; and the righting arms (``righting_arm``, `None` without a mesh) at constant
        displacement, free to trim, to the side of the list. Of a pair, the first value is transverse and the
        second longitudinal.

        Raises
        ------
        KingpostError
            If a hull weighs more than the water it displaces when fully submerged.

        >>> barge = load("barge").hydrostatics["hulls"][0]
        >>> round(barge["draught_m"], 3), round(barge["metacentric_height_m"][0], 2)
        (2.0, 2.67)
        """
        return json.loads(self._built.hydrostatics_json())

    @property
    def parameters(self) -> dict[str, ParameterValue]:
        """The values of the scenario's parameters by name.

        >>> load("paper", crane_x_m=5).parameters["crane_x_m"]
        5.0
        """
        return {one["name"]: one["value"] for one in self.model["parameters"]}

    def __getitem__(self, name: str) -> Any:
        """The value of a parameter, or of a field of the resolved scenario by its dotted path.

        Raises
        ------
        KingpostError
            If there is no such name.
        """
        if name in self.parameters:
            return self.parameters[name]
        value: object = self.resolved
        for k, key in enumerate(keys := name.split(".")):
            entries = dict(enumerate(value)) if isinstance(value, list) else value
            at = int(key) if isinstance(value, list) and key.isdigit() else key
            if not isinstance(entries, dict) or at not in entries:
                place = ".".join(keys[:k]) or self.title
                allowed = ", ".join(map(str, entries)) if isinstance(entries, dict) else "nothing below it"
                raise KingpostError(f"{name}: found no {key} in {place}, allowed: {allowed}")
            value = entries[at]
        return value

    def __contains__(self, name: object) -> bool:
        """Whether there is a parameter, or a field, of this name."""
        try:
            self[str(name)]
        except KingpostError:
            return False
        return True

    __iter__ = None
    """Not iterable: iterate over `parameters` or `resolved`."""

    def __setitem__(self, name: str, value: object) -> None:
        """Set a parameter, or a field by its dotted path.

        Raises
        ------
        ScenarioError
            If the name or the value is wrong; the scenario is then unchanged.
        """
        changed = self.with_overrides({name: value})
        vars(self).clear()
        vars(self).update(vars(changed))

    def _repr_html_(self) -> str:
        described = self.model
        parameters = [
            (one["name"], one["value"], one["unit"], one["label"]) for one in described["parameters"]
        ]
        bodies = [(body["name"], body["parent"] or "", body["mass_kg"]) for body in described["bodies"]]
        elements = [
            (one["name"], one["kind"], "on" if one["enabled"] else "off") for one in described["elements"]
        ]
        return "".join([
            markup.figure(self),
            markup.table(self.title, [("file", self.file)]),
            markup.table("Parameters", parameters, ("name", "value", "unit", "")) if parameters else "",
            markup.table("Bodies", bodies, ("body", "parent", "mass, kg")),
            markup.table("Forces, drives and sensors", elements) if elements else "",
        ])  # fmt: skip

    def with_overrides(self, overrides: Overrides | None = None, **parameters: object) -> Scenario:
        """Return the scenario with further overrides; the last value of a name counts.

        Parameters
        ----------
        overrides
            Values by parameter name or by dotted field path.
        parameters
            Values by parameter name.

        Returns
        -------
        Scenario
            A new scenario; this one is unchanged.

        Raises
        ------
        ScenarioError
            If a name or a value is wrong.

        >>> load("paper").with_overrides(crane_x_m=0).resolved["bodies"]["tower"]["joint"][
        ...     "revolute"]["position_m"][0]
        0.0
        """
        added = _pairs(overrides, parameters)
        return Scenario(self.text, self.file, self.overrides + added) if added else copy(self)


def load(path_or_name: str | Path, overrides: Overrides | None = None, **parameters: object) -> Scenario:
    """Read and validate a scenario.

    Parameters
    ----------
    path_or_name
        A YAML or JSON file, or a name of the gallery.
    overrides
        Values by parameter name or by dotted field path.
    parameters
        Values by parameter name.

    Returns
    -------
    Scenario
        A validated scenario, which can run.

    Raises
    ------
    ScenarioError
        With file, line, column, field, the value found and the allowed values.

    >>> load("paper", {"simulation.duration_s": 0.5}, damping=True).title
    'Crane ship of Jardim et al. (2019)'
    """
    path = gallery.find(path_or_name)
    return Scenario(gallery.read_text(path), str(path), _pairs(overrides, parameters))


def as_scenario(
    scenario_or_path: Scenario | str | Path, overrides: Overrides | None, parameters: Overrides
) -> Scenario:
    """Return a given scenario, or one read from its file, with further overrides."""
    if isinstance(scenario_or_path, Scenario):
        return scenario_or_path.with_overrides(overrides, **parameters)
    return load(scenario_or_path, overrides, **parameters)


def _with_place(error: ScenarioError, file: str) -> ScenarioError:
    """Add the searched places, which the engine does not know, to the error for a missing file."""
    name = (error.found or "").removeprefix("no file ")
    if name == error.found or not name:
        return error
    looked = f"{error}; looked for {gallery.place(file, name)}"
    wanted = Path(name).stem
    if (error.field or "").endswith(".part"):
        near = difflib.get_close_matches(wanted, gallery.parts(), n=1)
        looked += f"; did you mean {near[0]}?" if near else f"; the gallery has {', '.join(gallery.parts())}"
    return ScenarioError(
        looked, error.file, error.line, error.column, error.field, error.found, error.allowed
    )


def _pairs(overrides: Overrides | None, parameters: Overrides) -> tuple[tuple[str, Json], ...]:
    if not isinstance(overrides, Mapping | NoneType):
        raise KingpostError(f"overrides: found {overrides!r}, allowed: a dictionary of names and values")
    given = (*(overrides or {}).items(), *parameters.items())
    return tuple((str(name), _plain(value, str(name))) for name, value in given)


def _plain(value: object, name: str, level: int = 0) -> Json:
    """Convert the value of an override to JSON; the engine's reader validates it."""
    if level > DEEPEST:
        raise KingpostError(f"{name}: found fields that are too deep, allowed: at most {DEEPEST} levels")
    if isinstance(value, np.generic | np.ndarray):
        value = value.tolist()
    if isinstance(value, Mapping):
        return {str(key): _plain(entry, name, level + 1) for key, entry in value.items()}
    if isinstance(value, list | tuple):
        return [_plain(entry, name, level + 1) for entry in value]
    # JSON cannot express infinity and NaN; the reader quotes the text in its error.
    if isinstance(value, float) and not math.isfinite(value):
        return str(value)
    return value if isinstance(value, bool | int | float | str | NoneType) else repr(value)
