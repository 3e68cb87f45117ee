"""Report of modes."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray

from ..analysis.eigenmodes import DECAY, OSCILLATION, UNSTABLE
from .tables import table

# Amplitudes below this share of the largest are not printed, and at most this many.
SMALLEST_AMPLITUDE = 0.005
MOST_AMPLITUDES = 4
# A mode with a larger share of the memory of radiated waves counts as a mode of the water.
WATERS_SHARE = 2 / 3


def text(found: xarray.Dataset, all_modes: bool = False) -> str:
    """Modes of small motion as a table; for a sweep, a row for each value.

    Modes of the water's memory, which come from the fit of the radiation, and modes of controls alone are
    only counted, unless `all_modes` is set. The shapes of the other modes leave out these states.
    """
    lines = [found.attrs["title"], found.attrs["status"], ""]
    if not found.sizes["mode"]:
        return "\n".join([*lines, "no free coordinate, no modes"])
    sweep = _sweep(found)
    waters, controls = _of_water_and_controls(found)
    shown_ones = found if all_modes else of_ship_and_crane(found)
    shown_ones = shown_ones if all_modes else shown_ones.isel(coordinate=~found["memory"].values)
    lines += _modes_along(shown_ones, sweep) if sweep else _modes(shown_ones, all_modes)
    counts = (
        (waters, "modes of the water's memory of radiated waves"),
        (controls, "modes of the states of controls and drives"),
    )
    told = [f"and {int(those.sum())} {of} (--all shows them)" for those, of in counts if those.any()]
    lines += ["", *told] if told and not all_modes else []
    lines += _unstable(found, sweep)
    if "warning" in found.attrs:
        lines += ["", f"warning: {found.attrs['warning']}"]
    return "\n".join(line.rstrip() for line in lines)


def of_ship_and_crane(found: xarray.Dataset) -> xarray.Dataset:
    """Select the modes of ship and crane: without those of the memory of radiated waves and of the states of
    controls and drives.

    >>> import kingpost
    >>> of_ship_and_crane(kingpost.modes("chain")).sizes["mode"] > 0
    True
    """
    waters, controls = _of_water_and_controls(found)
    return found.isel(mode=~(waters | controls).values)


def _of_water_and_controls(found: xarray.Dataset) -> tuple[xarray.DataArray, xarray.DataArray]:
    sweep = _sweep(found)
    waters = (found["memory_share"] > WATERS_SHARE) & (found["kind"] != UNSTABLE)
    waters = waters.all(sweep) if sweep else waters
    return waters, _of_controls(found) & ~waters if not sweep else xarray.zeros_like(waters)


def _sweep(found: xarray.Dataset) -> str | None:
    """Dimension of the sweep, if there is one."""
    return next((str(dim) for dim in found["kind"].dims if dim != "mode"), None)


def _modes(found: xarray.Dataset, all_states: bool) -> list[str]:
    names = _names(found)
    rows = [("mode", "named after", "kind", "natural frequency, Hz", "natural period, s", "damping ratio",
             "time constant, s", "shape, m and rad")]  # fmt: skip
    for number in found["mode"].values:
        mode = found.sel(mode=number)
        rows.append((str(number), names[number], mode["kind"].item(),
                     *(shown(value) for value in (mode["frequency"].item(), _natural_period_s(mode),
                       mode["damping_ratio"].item(), mode["time_constant"].item())),
                     _shape(mode, all_states)))  # fmt: skip
    return table(rows, "><<>>>><")


def _natural_period_s(mode: xarray.Dataset) -> float:
    """Undamped period: 1 over the natural frequency."""
    frequency = mode["frequency"].item()
    return 1 / frequency if frequency > 0 else np.nan


def shown(value: float) -> str:
    """A number with five digits; an empty text for NaN.

    >>> shown(0.0012345678), shown(float("nan"))
    ('0.0012346', '')
    """
    return "" if np.isnan(value) else f"{value:.5g}"


def _of_controls(found: xarray.Dataset) -> xarray.DataArray:
    """Mark the modes of controls alone: named after a state that is neither a position nor an angle."""
    moving = found["coordinate"].values[found["moves"].values]
    return ~found["named_after"].isin(moving) & found["kind"].isin([OSCILLATION, DECAY])


def _names(found: xarray.Dataset) -> dict[int, str]:
    """Names of the modes; the second and further modes of one name are numbered."""
    given = found["named_after"].values.tolist()
    counts = [given[:k].count(name) for k, name in enumerate(given)]
    return {
        number: f"{name} ({count + 1})" if count else name
        for number, name, count in zip(found["mode"].values.tolist(), given, counts, strict=True)
    }


def _shape(mode: xarray.Dataset, all_states: bool) -> str:
    """The largest amplitudes of a mode. For a mode named after a position or an angle, only positions and
    angles count, because states of a control have another scale."""
    moves = mode["moves"]
    # States of controls and of the memory of radiated waves count only if all states are shown.
    if not all_states and mode["named_after"].item() in mode["coordinate"].values[moves.values]:
        mode = mode.isel(coordinate=moves.values)
    shape = mode["shape"].values + 1j * mode["shape_imaginary"].values
    shape = shape / max(1.0, np.abs(shape).max(initial=0.0))
    largest_first = sorted(range(len(shape)), key=lambda i: -round(float(abs(shape[i])), 9))
    entries = [i for i in largest_first if abs(shape[i]) > SMALLEST_AMPLITUDE]
    names = mode["coordinate"].values
    words = [f"{names[i]} {_amplitude(shape[i])}" for i in entries[:MOST_AMPLITUDES]]
    return ", ".join([*words, *(["..."] if len(entries) > MOST_AMPLITUDES else [])])


def _amplitude(value: complex) -> str:
    """An amplitude: real with its sign, complex with its phase.

    >>> _amplitude(-0.25 + 1e-12j), _amplitude(0.5j)
    ('-0.25', '0.5 at 90 deg')
    """
    if abs(value.imag) < SMALLEST_AMPLITUDE * abs(value):
        return f"{value.real:.3g}"
    return f"{abs(value):.3g} at {np.degrees(np.angle(value)):.0f} deg"


def _modes_along(found: xarray.Dataset, sweep: Any) -> list[str]:
    """Frequencies, Hz, by value of the sweep; the kind for a mode without oscillation."""
    rows = [(str(sweep), *(f"mode {number}" for number in found["mode"].values))]
    rows.append(("", *(_first(found["named_after"].sel(mode=n).values) for n in found["mode"].values)))
    for value in found[sweep].values:
        at = found.sel({sweep: value})
        rows.append((f"{value:g}", *(_entry(at.sel(mode=number)) for number in found["mode"].values)))
    return table(rows)


def _first(names: np.ndarray) -> str:
    return next((str(name) for name in names if name), "")


def _entry(mode: xarray.Dataset) -> str:
    kind = mode["kind"].item()
    if kind == OSCILLATION:
        return f"{mode['frequency'].item():.5g} Hz"
    return f"{kind} {shown(abs(mode['time_constant'].item()))} s" if kind in (DECAY, UNSTABLE) else kind


def _unstable(found: xarray.Dataset, sweep: Any) -> list[str]:
    unstable = found["kind"] == UNSTABLE
    if not unstable.any():
        return []
    if sweep:
        values = found[sweep].values[unstable.any("mode").values]
        return ["", f"unstable at {sweep} = {', '.join(f'{value:g}' for value in values)}"]
    lines = [""]
    for number in found["mode"].values[unstable.values]:
        mode = found.sel(mode=number)
        grows = f"grows e-fold in {shown(-mode['time_constant'].item())} s"
        lines.append(f"unstable: mode {number} ({mode['named_after'].item()}) {grows}")
    return lines
