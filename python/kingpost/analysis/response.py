"""Response amplitude operators (RAOs) of ship and crane in small regular waves, about equilibrium."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import output, results
from ..errors import KingpostError
from ..lettering import as_written
from ..scenario import Overrides, Scenario, as_scenario
from ..simulation.python_warnings import record_warnings
from ..simulation.simulate import Simulation

if TYPE_CHECKING:
    import pandas
    import xarray
    from numpy.typing import ArrayLike, NDArray

ENDINGS = (".nc", ".csv", ".png")
DIRECTIONS_DEG = tuple(range(0, 360, 45))
PRINTED_RAD_S = 0.5e-4 * (1 + 1e-9)
"""Half of the last digit of a frequency in messages."""
MOST_IN_RANGE = 10_000
FULL_TURN_RAD = 2 * np.pi
AXES, ANGLES = ("x", "y", "z"), ("roll", "pitch", "yaw")
PHASE = "_phase"
"""Suffix of the name of a phase."""

QUANTITIES = {
    "displacement": ("point", "m/m", "displacement of a point in the world"),
    "velocity": ("point", "m/s/m", "velocity of a point in the world"),
    "acceleration": ("point", "m/s^2/m", "acceleration of a point in the world"),
    "rotation": ("body", "rad/m", "roll, pitch and yaw of a body"),
    "joint_position": ("coordinate", "", "joint angle or extension"),
}


def rao(
    scenario_or_simulation: Scenario | Simulation | str | Path,
    directions_rad: ArrayLike | None = None,
    frequencies_rad_s: ArrayLike | None = None,
    points: Sequence[str] | None = None,
    overrides: Overrides | None = None,
    **parameters: Any,
) -> xarray.Dataset:
    """Response amplitude operators from the exact linearisation about equilibrium in still water.

    All degrees of freedom of ship and crane respond; held and prescribed joints are fixed.

    Parameters
    ----------
    scenario_or_simulation
        A scenario, with the crane at the start of a run; or a simulation, with the crane in its present
        state.
    directions_rad
        Directions that the waves travel towards, rad, counter-clockwise from the world's x: at heading 0, pi
        is a head sea. Default: every 45 degrees.
    frequencies_rad_s
        Angular frequencies. Default: those of the first hull's database and three between each two, over the
        range that the databases of all hulls cover.
    points
        Bodies, for their centres of mass, and named points such as ``arm.tip``; default: all.
    overrides, parameters
        Values that override those of a scenario.

    Returns
    -------
    xarray.Dataset
        By ``direction`` (rad) and ``omega`` (rad/s): amplitudes for each metre of wave amplitude of
        ``displacement``, ``velocity`` and ``acceleration`` (of ``point``, along ``axis``), ``rotation`` (of
        ``body``, by ``angle``) and ``joint_position`` (of ``coordinate``); for each its phase, such as
        ``displacement_phase``: the lag behind the crest at the origin of the first hull's data, rad.
        ``place`` of each point at rest, and as attributes the hull's ``reference_m`` and ``heading_rad``.

    Raises
    ------
    KingpostError
        If there is no equilibrium, no waves act, or a database does not cover a frequency.

    >>> found = rao("offshore_vessel", directions_rad=[np.pi], frequencies_rad_s=[0.3])
    >>> round(float(found.displacement.sel(point="hull", axis="z").item()), 2)
    0.99
    """
    if isinstance(scenario_or_simulation, Simulation):
        if overrides or parameters:
            raise KingpostError("overrides: found some for a simulation, allowed: for a scenario only")
        simulation = scenario_or_simulation
    else:
        simulation = Simulation(as_scenario(scenario_or_simulation, overrides, parameters))
    given = np.deg2rad(DIRECTIONS_DEG) if directions_rad is None else np.atleast_1d(directions_rad)
    directions = within_one_turn(np.asarray(given, float))
    covered = frequencies_that_all_cover(simulation.scenario)
    frequencies_rad_s = covered if frequencies_rad_s is None else onto_ends(frequencies_rad_s, covered)
    found = simulation.wave_response(directions, np.atleast_1d(np.asarray(frequencies_rad_s, float)))
    return _dataset(simulation, found, points)


def frequencies_that_all_cover(scenario: Scenario) -> NDArray[np.float64]:
    """The frequencies of the first hull's database and three between each two, because resonances are
    narrower than the spacing of the data; only those that the databases of all hulls in waves cover."""
    fields = (of_kind for force in scenario.resolved.get("forces", {}).values() for of_kind in force.values())
    hulls = (given for given in fields if given.get("enabled") and given.get("excitation"))
    names = [hull["database"] for hull in hulls if "database" in hull]
    grids = [np.array(json.loads(scenario.files[name])["frequencies_rad_s"], float) for name in names]
    if not grids:
        return np.array([])
    first = grids[0]
    ends = max(grid[0] for grid in grids), min(grid[-1] for grid in grids)
    between = first[:-1, None] + 0.25 * np.arange(4) * np.diff(first)[:, None]
    refined = np.concatenate([between.ravel(), first[-1:], ends])
    return np.unique(refined[(ends[0] <= refined) & (refined <= ends[1])])


def onto_ends(frequencies_rad_s: ArrayLike, covered: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the frequencies without repetitions. A frequency within the printed digits of the lowest or
    highest of the data is replaced by it."""
    asked = np.atleast_1d(np.asarray(frequencies_rad_s, float))
    for end in covered[[0, -1]] if covered.size else ():
        asked = np.where(np.abs(asked - end) <= PRINTED_RAD_S, end, asked)
    return each_once(asked)


def within_one_turn(directions_rad: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the directions without repetitions; refuse values beyond one turn, which are probably in another
    unit."""
    beyond = directions_rad[~(np.abs(directions_rad) <= FULL_TURN_RAD * (1 + 1e-9))]
    if beyond.size:
        raise KingpostError(
            f"directions: found {beyond[0]:g} rad ({np.degrees(beyond[0]):g} deg), allowed: one turn at "
            "most, 2 pi rad or 360 deg to either side"
        )
    return each_once(directions_rad)


def each_once(values: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the values without repetitions, in the order of their first occurrence.

    >>> each_once(np.array([0.5, 0.2, 0.5]))
    array([0.5, 0.2])
    """
    return np.array(list(dict.fromkeys(values.tolist())))


def _dataset(simulation: Simulation, found: dict[str, Any], points: Sequence[str] | None) -> xarray.Dataset:
    import xarray

    omega = np.array(found["frequencies_rad_s"])
    h = np.array(found["real"], complex) + 1j * np.array(found["imaginary"])
    h = h.reshape(len(found["directions_rad"]), len(omega), -1)
    places, bodies = found["places"], found["bodies"]
    displacement = h[..., : 3 * len(places)].reshape(*h.shape[:2], len(places), 3)
    rotation = h[..., 3 * len(places) : 3 * (len(places) + len(bodies))]
    chosen = [_place(places, point) for point in points] if points is not None else range(len(places))
    displacement = displacement[..., chosen, :]
    rate = -1j * omega[:, None, None]
    # A floating body has position and angles instead of joint coordinates.
    unit_of = _joint_units(simulation)
    joints = [i for i, name in enumerate(found["coordinates"]) if name in unit_of]
    names = [found["coordinates"][i] for i in joints]
    values = {
        "displacement": displacement,
        "velocity": rate * displacement,
        "acceleration": rate**2 * displacement,
        "rotation": rotation.reshape(*h.shape[:2], len(bodies), 3),
        "joint_position": h[..., 3 * (len(places) + len(bodies)) :][..., joints],
    }
    across = {"point": ("point", "axis"), "body": ("body", "angle"), "coordinate": ("coordinate",)}
    variables: dict[str, Any] = {}
    for name, (dim, units, long_name) in QUANTITIES.items():
        dims = ("direction", "omega", *across[dim])
        columns = [
            ".".join([f"{{{dim}}}", of, *(f"{{{k}}}" for k in across[dim][1:])])
            for of in (name, name + PHASE)
        ]
        about = {"units": units} if units else {}
        about |= {"long_name": f"amplitude of the {long_name}", "column": columns[0]}
        variables[name] = (dims, np.abs(values[name]), about)
        about = {
            "units": "rad",
            "long_name": f"lag of the {long_name} behind the crest",
            "column": columns[1],
        }
        variables[name + PHASE] = (dims, np.angle(values[name]), about)
    attributes = results.attributes(simulation.scenario, "about rest in still water")
    attributes["reference_m"] = found["reference_m"]
    attributes["heading_rad"] = found["heading_rad"]
    record_warnings(attributes, [*simulation.scenario.model["warnings"], *found["warnings"]])
    rad_s = {"units": "rad/s", "long_name": "angular frequency"}
    rad = {"units": "rad", "long_name": "direction that the waves go to, from x counter-clockwise"}
    metre = {"units": "m", "long_name": "place of a point at rest, world"}
    coordinates = {
        "direction": ("direction", np.array(found["directions_rad"]), rad),
        "omega": ("omega", omega, rad_s),
        "point": np.array([places[i] for i in chosen], str),
        "axis": list(AXES),
        "body": np.array(bodies, str),
        "angle": list(ANGLES),
        "place": (("point", "axis"), np.array(found["places_m"])[chosen], metre),
        "coordinate": np.array(names, str),
        results.unit_coordinate("joint_position"): (
            "coordinate",
            np.array([f"{unit_of[k]}/m" for k in names], str),
        ),
    }
    return xarray.Dataset(variables, coordinates, attributes)


def _place(places: Sequence[str], point: str) -> int:
    if point not in places:
        raise KingpostError(f"points: found {point!r}, allowed: {', '.join(places)}")
    return places.index(point)


def _joint_units(simulation: Simulation) -> dict[str, str]:
    """The unit of each joint coordinate, from the engine's channels."""
    channel = next((one for one in simulation.channels if one["variable"] == "joint_position"), None)
    return dict(zip(channel["labels"][0], channel["units"], strict=True)) if channel else {}


def complex_amplitude(found: xarray.Dataset, quantity: str) -> xarray.DataArray:
    """H of ``Re{a H e^(-i w t)}`` from an amplitude and its phase.

    >>> found = rao("barge", directions_rad=[0.0], frequencies_rad_s=[1.0])
    >>> complex_amplitude(found, "rotation").dtype
    dtype('complex128')
    """
    return found[quantity] * np.exp(1j * found[quantity + PHASE])


def frame(found: xarray.Dataset) -> pandas.DataFrame:
    """A row for each direction (deg) and frequency (rad/s); columns with their units, such as
    ``arm.tip.displacement.z [m/m]``, ``ship.rotation.roll [deg/m]`` and ``ship.rotation_phase.roll [deg]``.

    Angles are in degrees, as in the printed tables; the data set and NetCDF have radians, as their units say.
    """
    import pandas

    directions, frequencies = np.meshgrid(found["direction"], found["omega"], indexing="ij")
    columns: dict[str, NDArray] = {
        # Round degrees that were converted to radians and back: 210.00000000000003.
        "direction_deg": np.round(np.rad2deg(directions), 9).ravel(),
        "frequency_rad_s": frequencies.ravel(),
    }
    for values in found.data_vars.values():
        dims = [dim for dim in values.dims if dim not in ("direction", "omega")]
        flat = values.stack(entry=dims)
        for entry in range(flat.sizes["entry"]):
            labels = {dim: flat[dim].values[entry] for dim in dims}
            column = flat.isel(entry=entry)
            unit = results.unit_of(column)
            turned = np.rad2deg(column.values) if unit.startswith("rad") else column.values
            heading = f"{results.column_name(values, labels)} [{unit.replace('rad', 'deg')}]"
            columns[heading] = turned.ravel()
    return pandas.DataFrame(columns)


def write(found: xarray.Dataset, path: str | Path) -> Path:
    """Write a file; its ending decides the format: ``.nc`` (NetCDF), ``.csv``, or ``.png`` for a picture."""
    path = output.check(path, ENDINGS)
    ending = path.suffix.lower()
    if ending == ".nc":
        return output.write_netcdf(found, path)
    if ending == ".csv":
        return output.write_csv(frame(found), path)
    with output.whole(path) as beside:
        _plot(found, beside)
    return path


def _plot(found: xarray.Dataset, path: Path) -> None:
    """Plot the displacement of each point and the rotation of each floating body against the frequency."""
    from matplotlib.figure import Figure

    rows = [("displacement", "point", point, "axis") for point in found["point"].values]
    floating = results.floating_bodies(found)
    rows += [("rotation", "body", body, "angle") for body in found["body"].values if body in floating]
    figure = Figure(figsize=(10, 2.4 * len(rows)), layout="constrained")
    axes = figure.subplots(len(rows), 3, sharex=True, squeeze=False)
    for row, (quantity, dim, label, across) in zip(axes, rows, strict=True):
        for axis, name in zip(row, found[across].values, strict=True):
            for direction in found["direction"].values:
                values = found[quantity].sel({dim: label, across: name, "direction": direction})
                values = values * (180 / np.pi) if quantity == "rotation" else values
                axis.plot(found["omega"], values, label=f"{np.rad2deg(direction):.0f} deg")
            axis.set_title(f"{label} {name}, {'deg/m' if quantity == 'rotation' else 'm/m'}", fontsize=9)
            axis.set_ylim(bottom=0)
            axis.grid(alpha=0.3)
    for axis in axes[-1]:
        axis.set_xlabel("rad/s")
    axes[0, 0].legend(fontsize=7, title="waves to", title_fontsize=7)
    figure.suptitle(found.attrs["title"], fontsize=11)
    as_written(figure)
    figure.savefig(path, dpi=120)


def parse_range(text: str) -> list[float]:
    """Frequencies as the command line writes them: ``from:to:n``.

    >>> parse_range("0.5:1:3")
    [0.5, 0.75, 1.0]
    """
    try:
        start, stop, count = text.split(":")
        with np.errstate(invalid="ignore", over="ignore"):
            spaced = np.linspace(float(start), float(stop), min(int(count), MOST_IN_RANGE + 1)).tolist()
    except ValueError:
        spaced = []
    if not (0 < len(spaced) <= MOST_IN_RANGE and np.isfinite(spaced).all()):
        allowed = f"from:to:n, such as 0.3:2:18, n up to {MOST_IN_RANGE}"
        raise KingpostError(f"--frequencies-rad-s: found {text!r}, allowed: {allowed}")
    return spaced


def main_points(scenario: Scenario) -> list[str]:
    """The bodies that float, and all named points.

    >>> from kingpost import load
    >>> main_points(load("barge"))
    ['ship', 'tower.top', 'arm.tip']
    """
    bodies = scenario.resolved["bodies"]
    floating = [body["name"] for body in scenario.model["bodies"] if body["floats"]]
    return floating + [
        f"{name}.{point}" for name, body in bodies.items() for point in body.get("points") or {}
    ]
