"""Files of results: NetCDF, CSV, Parquet."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from .. import output
from ..errors import KingpostError
from .columns import columns, frame, unit_of
from .events import events, warnings

if TYPE_CHECKING:
    import xarray

ENDINGS = (".nc", ".csv", ".parquet")


def check_output(path: str | Path) -> Path:
    """Make sure, before a run, that results can be written to `path`."""
    return output.check(path, ENDINGS)


def write(results: xarray.Dataset, path: str | Path) -> Path:
    """Write results by the file's ending: ``.nc`` (NetCDF), ``.csv`` or ``.parquet``.

    A CSV holds the numbers alone; units and attributes are in the other two: in Parquet the unit of a
    column is in the metadata of its field. Where anything happened, its table (`events`) stands beside a
    CSV, as ``<name>.events.csv``, and so does that of the warnings (`warnings`), ``<name>.warnings.csv``; one
    of an earlier run that is there is written anew in any case.
    """
    path = check_output(path)
    ending = path.suffix.lower()
    if ending == ".nc":
        return output.write_netcdf(results, path)
    if ending == ".csv":
        output.write_csv(frame(results), path)
        for of, table in (("event", events(results)), ("warning", warnings(results))):
            beside = path.with_suffix(f".{of}s.csv")
            if table.sizes[of] or beside.exists():
                output.write_csv(table.to_dataframe(), beside)
    else:
        with output.whole(path) as beside:
            _write_parquet(results, beside)
    return path


def _write_parquet(results: xarray.Dataset, path: Path) -> None:
    import pyarrow
    import pyarrow.parquet

    table = pyarrow.Table.from_pandas(frame(results), preserve_index=False)
    units = {"time": unit_of(results["time"]), **{name: unit_of(series) for name, series in columns(results)}}
    fields = [field.with_metadata({"units": units[field.name]}) for field in table.schema]
    attributes = {key: str(value) for key, value in results.attrs.items()}
    metadata = {**(table.schema.metadata or {}), **attributes}
    pyarrow.parquet.write_table(table.cast(pyarrow.schema(fields, metadata)), path)


def read(path: str | Path) -> xarray.Dataset:
    """A data set that `kingpost run -o FILE.nc` wrote, or `Batch`."""
    import xarray

    allowed = "allowed: results in NetCDF, as kingpost run -o FILE.nc writes them"
    if not Path(path).is_file():
        raise KingpostError(f"{path}: {'is a folder' if Path(path).is_dir() else 'no such file'}, {allowed}")
    try:
        found = xarray.load_dataset(path, engine="h5netcdf")
    except PermissionError as error:
        raise KingpostError(f"{path}: {error.strerror}, {allowed}") from None
    except (OSError, ValueError):
        raise KingpostError(f"{path}: found a file that is not NetCDF, {allowed}") from None
    if "time" not in found.dims:
        raise KingpostError(f"{path}: found no dimension time, {allowed}")
    return found
