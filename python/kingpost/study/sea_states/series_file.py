"""Reading of time series of sea states, hindcasts and forecasts, from CSV and NetCDF.

Known names, in upper or lower case, optionally followed by a unit, such as ``Hs (m)``:

- time: ``time``, ``valid_time``, ``datetime``, ``date``, ``timestamp``, in ISO 8601; UTC if no zone is given;
- significant height: ``hs``, ``hm0``, ``swh``, ``VHM0``, ``significant_height_m``;
- period: ``tp``, ``pp1d``, ``VTPK``, ``peak_period_s``, or a mean one: ``tz``, ``tm02``, ``mp2``,
  ``VTM02`` (zero up-crossing), ``mwp``, ``te``, ``tm10``, ``VTM10`` (energy, T(-1, 0)), ``tm01``,
  ``mp1``; the peak period counts if there are both;
- direction that waves come from, in degrees clockwise from north: ``mwd``, ``dp``, ``VMDR``,
  ``direction_from_deg``; that they go to: ``direction_to_deg``. For any other name the meaning must be given.

ERA5 has swh, pp1d, mwp and mwd (ECMWF parameters 140229, 140231, 140232, 140230), mwd as waves come from.
"""

from __future__ import annotations

import csv
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from ...errors import flag
from ...output import irregular
from ...reading import CSV_TEXT, decimal, text_of
from .series import Series, SeriesError, moment
from .series_columns import TIMES, Columns, Said, plain

if TYPE_CHECKING:
    import xarray
    from numpy.typing import NDArray

PLACES = {"latitude": ("latitude", "lat"), "longitude": ("longitude", "lon")}
NETCDF = (".nc", ".nc4", ".cdf", ".netcdf")
DIRECTION_UNIT_IS = f"{flag('direction_unit')} deg or rad, direction_unit= in Python"
QUANTITIES = ("time", "height", "period", "direction")
MOST_HEIGHT_M, MOST_PERIOD_S = 30.0, 40.0
"""Upper bounds of a sea: the highest measured significant height is 19 m (WMO, North Atlantic, 4 February
2013), and swell is shorter than 30 s. Larger values are in centimetres, feet or milliseconds."""


def read(
    path: str | Path,
    columns: Mapping[str, str] | None = None,
    direction: str | None = None,
    at: tuple[float, float] | None = None,
    *,
    period: str | None = None,
    direction_unit: str | None = None,
) -> Series:
    """Read a series from a CSV or a NetCDF file.

    Parameters
    ----------
    path
        File: NetCDF with an ending such as ``.nc``, otherwise CSV with commas, semicolons or tabs.
    columns
        Names in the file of ``time``, ``height``, ``period``, ``direction``, if they are not among the known
        names.
    direction
        ``from`` or ``to``: meaning of a direction under an unknown name.
    at
        Latitude and longitude, degrees: the nearest point is taken from a file with several points.
    period
        ``peak``, ``zero_up_crossing``, ``energy`` or ``mean``: kind of a period under an unknown name.
    direction_unit
        ``deg`` or ``rad``, if the file has no unit and all its directions are between 0 and 2 pi.

    Returns
    -------
    Series
        The series in the file.

    Raises
    ------
    SeriesError
        If the file cannot be read or is not a series of sea states; for a text file the error names the line.
    """
    path = Path(path)
    given = dict(columns or {})
    for name in given:
        if name not in QUANTITIES:
            raise SeriesError("columns", repr(name), ", ".join(QUANTITIES))
    said = Said(direction, period, direction_unit)
    if not path.is_file():
        raise SeriesError("file", irregular(path) or "none", "a file that can be read", str(path))
    if path.suffix.lower() in NETCDF:
        return _of_netcdf(path, given, said, at)
    return _of_csv(path, given, said)


def _of_csv(path: Path, given: Mapping[str, str], said: Said) -> Series:
    file = str(path)
    try:
        text = text_of(path)
    except (OSError, UnicodeDecodeError) as error:
        raise SeriesError(
            "file", getattr(error, "strerror", None) or "bytes that are no text", CSV_TEXT, file
        ) from None
    lines = [(number, line) for number, line in enumerate(text.splitlines(), 1)
             if line.strip(" ,;\t") and not line.startswith("#")]  # fmt: skip
    if len(lines) < 2:
        raise SeriesError("rows", max(len(lines) - 1, 0), "a header and one row or more", file)
    sign = next(sign for sign in ";\t," if sign in lines[0][1] or sign == ",")
    cells = [
        (number, [cell.strip() for cell in next(csv.reader([line], delimiter=sign))])
        for number, line in lines
    ]
    line, header = cells[0]
    columns = Columns.of(header, given, said, file, line)
    columns = columns.with_units({name: plain(name)[1] for name in header}, file, line)
    for number, row in cells[1:]:
        if len(row) != len(header):
            raise SeriesError("cells", len(row), f"{len(header)}, as the header has", file, number)
    rows = [number for number, _ in cells[1:]]

    def column(name: str) -> list[str]:
        return [row[header.index(name)] for _, row in cells[1:]]

    def numbers(name: str) -> NDArray[np.float64]:
        return np.array([_number(cell, name, sign, file, number)
                         for cell, number in zip(column(name), rows, strict=True)])  # fmt: skip

    time = np.array(
        [moment(cell, "time", file, number) for cell, number in zip(column(columns.time), rows, strict=True)]
    )
    where = None if columns.direction is None else numbers(columns.direction)
    return _checked(time, numbers(columns.height), numbers(columns.period), where, columns, file, rows)


def _number(cell: str, name: str, sign: str, file: str, line: int) -> float:
    """Parse a number; an empty cell is NaN."""
    if cell.lower() in ("", "nan", "na", "null", "none", "-"):
        return np.nan
    try:
        return decimal(cell, sign)
    except ValueError:
        raise SeriesError(name, repr(cell), "a number, or nothing in a gap", file, line) from None


def _of_netcdf(path: Path, given: Mapping[str, str], said: Said, at: tuple[float, float] | None) -> Series:
    import xarray

    file = str(path)
    try:
        with xarray.open_dataset(path) as opened:
            names = [str(name) for name in opened.variables]
            columns = Columns.of(names, given, said, file)
            kept = [name for name in (columns.height, columns.period, columns.direction) if name is not None]
            found, place = _at_point(opened[kept], at, file)
            found = found.load()
            time = np.atleast_1d(opened[columns.time].values)
            dims = opened[columns.time].dims
    except (OSError, ValueError) as error:
        reason = " ".join(str(error).split())[:200]
        raise SeriesError("file", f"what xarray cannot open ({reason})", "NetCDF", file) from None
    if not np.issubdtype(time.dtype, np.datetime64):
        raise SeriesError(
            columns.time, f"values of the kind {time.dtype}", "times with units, as CF says", file
        )
    columns = columns.with_units({name: str(found[name].attrs.get("units", "")) for name in kept}, file)
    for name in kept:
        left = [f"{dim} ({found.sizes[dim]})" for dim in found[name].dims if dim not in dims]
        if left:
            raise SeriesError(name, f"the dimensions {', '.join(left)}", "time alone, or one point", file)
    values = {name: np.broadcast_to(np.asarray(found[name].values, float), time.shape) for name in kept}
    where = None if columns.direction is None else values[columns.direction]
    series = _checked(
        time.astype("datetime64[s]"), values[columns.height], values[columns.period], where, columns, file
    )
    return replace(series, place=place)


def _at_point(data: xarray.Dataset, at: tuple[float, float] | None, file: str) -> tuple[xarray.Dataset, str]:
    """Select the nearest point; drop dimensions with a single value."""
    said: list[str] = []
    for k, (what, names) in enumerate(PLACES.items()):
        name = next((name for name in names if name in data.dims), None)
        if name is None:
            continue
        values = np.asarray(data[name].values, float)
        if len(values) > 1 and at is None:
            found = f"{len(values)} values from {values.min():g} to {values.max():g}"
            raise SeriesError(what, found, "one point: give latitude and longitude", file)
        off = np.zeros(1) if at is None else np.abs(values - at[k])
        if what == "longitude":
            off = np.minimum(off % 360, 360 - off % 360)
        nearest = int(off.argmin())
        step = float(np.abs(np.diff(values)).max()) if len(values) > 1 else np.inf
        if off[nearest] > step:
            found = f"{at[k] if at else 0:g}, outside of {values.min():g} to {values.max():g}"
            raise SeriesError(what, found, "a point of the file", file)
        data = data.isel({name: nearest}, drop=True)
        said.append(f"{what} {values[nearest]:g}")
    return data.squeeze(
        [dim for dim in data.dims if dim not in TIMES and data.sizes[dim] == 1], drop=True
    ), ", ".join(said)


def _checked(
    time: NDArray[np.datetime64],
    height: NDArray[np.float64],
    period: NDArray[np.float64],
    direction: NDArray[np.float64] | None,
    columns: Columns,
    file: str,
    rows: Sequence[int] | None = None,
) -> Series:
    def line(k: int) -> int | None:
        return None if rows is None else rows[k]

    for k in np.flatnonzero(np.diff(time) <= np.timedelta64(0, "s")):
        raise SeriesError(
            "time", f"{time[k + 1]} after {time[k]}", "times that increase", file, line(int(k) + 1)
        )
    of_each = ((columns.height, height, MOST_HEIGHT_M, "m"), (columns.period, period, MOST_PERIOD_S, "s"))
    for name, values, most, unit in of_each:
        for k in np.flatnonzero(np.isinf(values) | (values < 0) | (values > most)):
            allowed = f"0 to {most:g} {unit}, or nothing in a gap"
            raise SeriesError(name, f"{values[k]:g} at {time[k]}", allowed, file, line(int(k)))
    if np.isnan(height).all():
        raise SeriesError(columns.height, "gaps alone", "one number or more", file)
    degrees = None if direction is None else _in_degrees(direction, columns, file)
    came_from = None if degrees is None else (degrees if columns.is_from else degrees + 180) % 360
    return Series(time, np.array(height), np.where(period > 0, period, np.nan), columns.kind, came_from)


def _in_degrees(direction: NDArray[np.float64], columns: Columns, file: str) -> NDArray[np.float64]:
    """Convert directions to degrees. Without a unit, directions that are all between 0 and 2 pi may be in
    radians."""
    known = direction[np.isfinite(direction)]
    if not columns.direction_unit and known.size and known.min() >= 0 and known.max() <= 2 * np.pi:
        found = f"no unit, and all values from {known.min():g} to {known.max():g}"
        raise SeriesError(str(columns.direction), found, DIRECTION_UNIT_IS, file)
    return np.degrees(direction) if columns.direction_unit == "rad" else direction
