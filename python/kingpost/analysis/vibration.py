"""Linear analysis: equilibrium and the modes about it, for one scenario or along a sweep."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from .. import output, results
from ..errors import KingpostError
from ..given import lists, number
from ..scenario import Overrides, Scenario, as_scenario
from ..simulation.linear import Equilibrium
from ..simulation.python_warnings import record_warnings
from ..simulation.records import State
from ..simulation.simulate import Simulation
from .eigenmodes import FREE, Mode, eigenmodes
from .tracking import tracks

if TYPE_CHECKING:
    import pandas
    import xarray

ENDINGS = (".nc", ".csv")
MOST_IN_SWEEP = 10_000
NOTHING = complex(np.nan, np.nan)

VARIABLES = {
    "kind": ("", "zero, oscillation, decay or unstable"),
    "named_after": ("", "the free coordinate, or the one with the largest share of the kinetic energy"),
    "multiplicity": ("1", "eigenvalues of A that the mode stands for"),
    "eigenvalue_real": ("1/s", "rate of growth of the amplitude"),
    "eigenvalue_imaginary": ("rad/s", "damped angular frequency"),
    "angular_frequency": ("rad/s", "undamped angular frequency, the eigenvalue's modulus"),
    "frequency": ("Hz", "undamped frequency"),
    "damped_period": ("s", "time between maxima"),
    "damping_ratio": ("1", "damping as a fraction of critical damping"),
    "time_constant": ("s", "time in which the amplitude falls e-fold; negative: grows e-fold"),
    "memory_share": ("1", "share of the memory of radiated waves in the mode"),
}


def equilibrium(
    scenario_or_path: Scenario | str | Path, overrides: Overrides | None = None, **parameters: Any
) -> xarray.Dataset:
    """Results at an equilibrium of a scenario: all rates and accelerations are zero.

    Newton's iteration starts from the scenario's initial positions, with drives as at the start, and first
    moves downhill. Coordinates without a restoring force, such as the heading of a free ship, keep their
    values.

    Parameters
    ----------
    scenario_or_path
        A scenario, a file or a name of the gallery.
    overrides
        Values by parameter name or by dotted field path.
    parameters
        Values by parameter name.

    Returns
    -------
    xarray.Dataset
        The variables of `run` without ``time``, joint reactions among them.

    Raises
    ------
    KingpostError
        If there is no equilibrium near: a body falls, or a drive keeps moving one.

    >>> rest = equilibrium("chain", hold_rotation=True)
    >>> bool(abs(rest.joint_position).max() < 1e-9)
    True
    """
    simulation = Simulation(as_scenario(scenario_or_path, overrides, parameters))
    status = at_rest(simulation.settle())
    rows = simulation.row()[None, :]
    recorded = results.dataset(simulation.scenario, simulation.channels, rows, status)
    return recorded.isel(time=0, drop=True)


def at_rest(found: Equilibrium) -> str:
    """One line of text on how an equilibrium was found."""
    plural = "" if found.iterations == 1 else "s"
    return (
        f"at rest after {found.iterations} iteration{plural}; "
        f"largest acceleration {found.residual:.1e} m/s2 or rad/s2"
    )


def modes(
    scenario_or_path: Scenario | str | Path,
    overrides: Overrides | None = None,
    *,
    sweep: Mapping[str, Sequence[float]] | None = None,
    state: State | None = None,
    **parameters: Any,
) -> xarray.Dataset:
    """Modes of small motion about an equilibrium, from the exact A of `Simulation.linearize`.

    Parameters
    ----------
    scenario_or_path, overrides, parameters
        Scenario and overrides, as in `run`.
    sweep
        One parameter, or path of a field, and its values: a further dimension of the result. The equilibrium
        is found at each value separately, and modes are tracked from value to value by their shapes.
    state
        State at which to linearise instead of the equilibrium.

    Returns
    -------
    xarray.Dataset
        Dimension ``mode``, numbered from 1: zero modes, then by frequency. By mode:

        ``kind``
            ``zero``: no force opposes this motion, such as the heading of a free ship;
            ``oscillation``; ``decay``: a motion without oscillation, such as that of an overdamped
            coordinate; ``unstable``: it grows.
        ``named_after``
            The free coordinate, or the one with the largest share of the kinetic energy.
        ``frequency``, ``angular_frequency``, ``damped_period``, ``damping_ratio``
            For pairs of complex eigenvalues, stable or not; the frequencies of zero modes are 0.
        ``time_constant``
            s; positive for decaying modes, negative for growing ones.
        ``memory_share``
            Share of the memory of radiated waves, from 0 to 1: near 1 the mode is a motion of the water, not
            of the hull that gives its name.
        ``eigenvalue_real``, ``eigenvalue_imaginary``, ``multiplicity``
            The eigenvalues of A.
        ``shape``, ``shape_imaginary``
            By ``coordinate``: amplitudes, the largest 1, each in the unit given by ``shape_unit``. ``moves``
            is true for positions and angles, false for states of a control or of the water. With eigenvalue s
            + i w the motion is ``exp(s t) (shape cos(w t) - shape_imaginary sin(w t))``.

        The attribute ``warning`` is present if a prescribed coordinate moves or accelerates: the modes then
        hold at that instant only (`Linearization.warning`).

    Raises
    ------
    KingpostError
        If there is no equilibrium near, or nothing is free to move.

    >>> found = modes("chain", hold_rotation=True)
    >>> float(found.frequency[0].round(4))
    0.1897
    """
    scenario = as_scenario(scenario_or_path, overrides, parameters)
    if sweep is None:
        point = _point(scenario, state)
        return _dataset(scenario, [point.modes], [point]).isel(point=0)
    name, values = _one(sweep)
    points = []
    for value in values:
        try:
            points.append(_point(scenario.with_overrides({name: value}), state))
        except KingpostError as error:
            raise KingpostError(f"{name} = {value:g}: {error}") from error
    if any(point.names != points[0].names for point in points):
        raise KingpostError(f"{name}: found other free coordinates, allowed: the same at each value")
    order = tracks([point.modes for point in points], [point.mass_matrix for point in points])
    swept = _dataset(scenario, order, points)
    return swept.rename(point=name).assign_coords({name: np.asarray(values, float)})


def _one(sweep: Mapping[str, Sequence[float]]) -> tuple[str, list[float]]:
    if len(sweep) != 1:
        raise KingpostError(f"sweep: found {len(sweep)} names, allowed: one")
    ((name, values),) = lists("sweep", sweep).items()
    if not values:
        raise KingpostError(f"sweep: found no values for {name}, allowed: at least one")
    return name, [number(f"sweep of {name}", value) for value in values]


def parse_sweep(text: str) -> dict[str, list[float]]:
    """A sweep as the command line writes it: ``name=from:to:n``.

    >>> parse_sweep("mass=1:2:3")
    {'mass': [1.0, 1.5, 2.0]}
    """
    name, _, values = text.partition("=")
    try:
        start, stop, count = values.split(":")
        with np.errstate(all="ignore"):
            spaced = np.linspace(float(start), float(stop), min(int(count), MOST_IN_SWEEP + 1)).tolist()
    except ValueError:
        spaced = []
    if not (name and 0 < len(spaced) <= MOST_IN_SWEEP and np.isfinite(spaced).all()):
        allowed = f"name=from:to:n, such as load_mass_kg=100:2000:20, n up to {MOST_IN_SWEEP}"
        raise KingpostError(f"--sweep: found {text!r}, allowed: {allowed}")
    return {name: spaced}


class _Point(NamedTuple):
    """Modes of one scenario, its mass matrix, the names and units of a shape's entries, which entries are
    memory states, and a description of the state of the linearisation."""

    modes: list[Mode]
    mass_matrix: np.ndarray
    names: list[str]
    units: list[str]
    memory: np.ndarray
    status: str
    warning: str | None


def _point(scenario: Scenario, state: State | None) -> _Point:
    simulation = Simulation(scenario)
    if state is None:
        status = at_rest(simulation.settle())
    else:
        simulation.set_state(state.q, state.v, state.s)
        status = "about a given state"
    linear, mass = simulation.linearize(), simulation.mass_matrix()
    free = len(linear.coordinates)
    if not linear.states:
        raise KingpostError("modes: found no free coordinate, allowed: one or more")
    of_shape = [*range(free), *range(2 * free, len(linear.states))]
    names, units = ([of[i] for i in of_shape] for of in (linear.states, linear.units))
    found = eigenmodes(linear, mass, simulation.constraint_matrix())
    return _Point(found, mass, names, units, linear.remembers[of_shape], status, linear.warning)


def _dataset(
    scenario: Scenario, modes: Sequence[Sequence[Mode | None]], points: Sequence[_Point]
) -> xarray.Dataset:
    """Build the data set by point and mode; where a track has no mode, texts are empty and numbers are
    NaN."""
    import xarray

    names = points[0].names
    table = {name: [[_entry(mode, name) for mode in point] for point in modes] for name in VARIABLES}
    blank = np.full(len(names), NOTHING)
    shapes = [[blank if mode is None else mode.shape for mode in point] for point in modes]
    shape = np.array(shapes, complex).reshape(len(points), -1, len(names))
    variables: dict[str, Any] = {}
    for name, (unit, long_name) in VARIABLES.items():
        values = np.array(table[name], float if unit else str)
        variables[name] = (("point", "mode"), values, {"units": unit, "long_name": long_name})
    for name, part in (("shape", shape.real), ("shape_imaginary", shape.imag)):
        about = {"long_name": "amplitude by coordinate, the largest 1"}
        variables[name] = (("point", "mode", "coordinate"), part, about)
    units = ("coordinate", np.array(points[0].units, str))
    coordinates = {
        "mode": np.arange(1, shape.shape[1] + 1),
        "coordinate": np.array(names, str),
        "memory": ("coordinate", points[0].memory),
        "moves": ("coordinate", np.arange(len(names)) < len(points[0].mass_matrix)),
        **{results.unit_coordinate(name): units for name in ("shape", "shape_imaginary")},
    }
    attributes = results.attributes(scenario, points[-1].status)
    record_warnings(
        attributes, [*scenario.model["warnings"], *(point.warning for point in points if point.warning)]
    )
    return xarray.Dataset(variables, coordinates, attributes)


def _entry(mode: Mode | None, variable: str) -> str | float:
    if mode is None:
        return np.nan if VARIABLES[variable][0] else ""
    value, size = mode.eigenvalue, abs(mode.eigenvalue)
    pair = value.imag > 0
    swinging = np.nan if not (pair or mode.kind == FREE) else size
    entries: dict[str, str | float] = {
        "kind": mode.kind,
        "named_after": mode.coordinate,
        "multiplicity": mode.multiplicity,
        "eigenvalue_real": value.real,
        "eigenvalue_imaginary": value.imag,
        "angular_frequency": swinging,
        "frequency": swinging / (2 * np.pi),
        "damped_period": 2 * np.pi / value.imag if pair else np.nan,
        "damping_ratio": (0.0 - value.real) / size if pair else np.nan,
        "time_constant": -1 / value.real if value.real else np.nan,
        "memory_share": mode.memory_share,
    }
    return entries[variable]


def frame(found: xarray.Dataset) -> pandas.DataFrame:
    """Modes as a flat table: a row for each mode, at each point of a sweep.

    Columns are the sweep's parameter, if there is one, ``mode``, the variables, and the shapes, such as
    ``shape.slew`` and ``shape_imaginary.slew``.
    """
    import pandas

    rows = found.stack(row=[*found["kind"].dims])  # the first column is the sweep's parameter
    columns = {dim: rows[dim].values for dim in found["kind"].dims}
    columns |= {name: rows[name].values for name in VARIABLES}
    for name in ("shape", "shape_imaginary"):
        columns |= {f"{name}.{at}": rows[name].sel(coordinate=at).values
                    for at in found["coordinate"].values}  # fmt: skip
    return pandas.DataFrame(columns)


def write(found: xarray.Dataset, path: str | Path) -> Path:
    """Write modes; the file's ending decides the format: ``.nc`` (NetCDF) or ``.csv``."""
    path = output.check(path, ENDINGS)
    if path.suffix.lower() == ".nc":
        return output.write_netcdf(found, path)
    return output.write_csv(frame(found), path)
