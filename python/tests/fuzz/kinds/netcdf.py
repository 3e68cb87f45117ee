"""Results in NetCDF, as input of statistics and pictures."""

from __future__ import annotations

import copy
import json
import os
import random
import tempfile
import warnings
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from functools import cache
from pathlib import Path

import kingpost
import xarray
from kingpost.cli import main
from kingpost.results import files, probe
from kingpost.results.entry_tables import NAMES as OF_ENTRIES
from lift_mutations import NUMBERS, OTHERS

from ..contract import Case, check_exit
from ..mutations import damaged, damaged_bytes, damaged_tree

SHORT = {"simulation.duration_s": 0.05, "simulation.record_every_s": 0.01}

FEW = ("roll", "position", "energy_residual", "rope_tension")


@cache
def samples() -> list[bytes]:
    """A short run, and one afloat with limits and waves; few columns of each."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", kingpost.KingpostWarning)
        runs = [kingpost.run(name, SHORT) for name in ("paper", "container_to_quay")]
    found = []
    for run in runs:
        names = [str(name) for name in run.data_vars if str(name) in FEW or str(name) in OF_ENTRIES]
        found.append(bytes(run[names].to_netcdf(engine="h5netcdf")))
    return found


@cache
def data_sets() -> list[xarray.Dataset]:
    """The samples as data sets."""
    found = []
    with tempfile.TemporaryDirectory() as folder:
        for content in samples():
            path = Path(folder) / "run.nc"
            path.write_bytes(content)
            found.append(xarray.load_dataset(path, engine="h5netcdf"))
    return found


def drawn(draw: random.Random) -> Case:
    """Draw a file with damaged bytes, or with attributes, dimensions and values that no run has."""
    if draw.random() < 0.6:
        content = damaged_bytes(draw, draw.choice(samples()))
    else:
        content = _changed(draw, draw.choice(data_sets()).copy(deep=True))
    how = draw.choices(["statistics", "read", "plot"], [6, 3, 1])[0]
    return Case("netcdf", {"run.nc": content}, (how,))


def _changed(draw: random.Random, run: xarray.Dataset) -> bytes:
    for _ in range(draw.randrange(1, 4)):
        if not run.variables or not run.attrs:
            break
        run = draw.choice([_attribute, _attribute, _values, _shape, _of_variable])(draw, run)
    try:
        return bytes(run.to_netcdf(engine="h5netcdf"))
    except Exception:
        # A data set that cannot be written gives no case.
        return samples()[0]


def _attribute(draw: random.Random, run: xarray.Dataset) -> xarray.Dataset:
    name = draw.choice(sorted(run.attrs))
    held = run.attrs[name]
    way = draw.randrange(5)
    if way == 0:
        run.attrs.pop(name)
    elif way == 1:
        run.attrs[name] = draw.choice(
            [0, -1, 1.5, "", "x", "{}", "[]", "null", "[null]", "[[1]]", '{"a": 1}']
        )
    elif way == 2:
        run.attrs[name] = damaged(draw, str(held))
    else:
        try:
            tree = json.loads(held)
            run.attrs[name] = json.dumps(damaged_tree(draw, copy.deepcopy(tree)))
        except (TypeError, ValueError):
            run.attrs[name] = str(draw.choice(OTHERS))
    return run


def _values(draw: random.Random, run: xarray.Dataset) -> xarray.Dataset:
    name = draw.choice(sorted(map(str, run.variables)))
    values = run[name].values.copy()
    if values.dtype.kind != "f" or not values.size:
        return run
    values.flat[draw.randrange(values.size)] = draw.choice(
        [float(x) for x in NUMBERS if abs(x) <= 1e308 or x != x]
    )
    if draw.random() < 0.3:
        values[...] = draw.choice([float("nan"), 0.0, 1e308, float("inf"), -1.0])
    return run.assign_coords({name: (run[name].dims, values)}) if name in run.coords else run.assign(
        {name: (run[name].dims, values, run[name].attrs)})  # fmt: skip


def _shape(draw: random.Random, run: xarray.Dataset) -> xarray.Dataset:
    way = draw.randrange(6)
    if way == 0:
        return run.isel(time=slice(0, draw.randrange(3)), missing_dims="ignore")
    if way == 1:
        dimension = draw.choice(sorted(map(str, run.dims)))
        return run.rename({dimension: "another"} if "another" not in run.variables else {})
    if way == 2:
        return run.drop_vars(draw.choice(sorted(map(str, run.variables))))
    if way == 3:
        return run.isel(time=slice(None, None, -1), missing_dims="ignore")
    if way == 4:
        return run.expand_dims(draw.choice(["run", "x"]))
    return run[[]]


def _of_variable(draw: random.Random, run: xarray.Dataset) -> xarray.Dataset:
    name = draw.choice(sorted(map(str, run.variables)))
    attributes = run[name].attrs
    key = draw.choice([*attributes, "units", "column", "long_name", "standard_name"])
    attributes[key] = draw.choice(
        ["", "{", "{x}", "{time}", "a.{body}.b", "m\x1b[31m", "rad", "x" * 500, 1, "kN\n"]
    )
    if draw.random() < 0.1:
        kind = draw.choice(["i4", "S4", "f4"])
        if run[name].dtype.kind == "f":
            return run.assign({name: (run[name].dims, run[name].values.astype(kind))})
    return run


@contextmanager
def quick_probe() -> Iterator[None]:
    """Test files in a fork of this process, if the system supports it."""
    before = files._probe
    files._probe = _probe_in_a_child if hasattr(os, "fork") else before
    try:
        yield
    finally:
        files._probe = before


def _probe_in_a_child(paths: Sequence[str], time_limit_s: float) -> None:
    """Replace the package's separate process for reading files by a fork, which starts at once."""
    for path in paths:
        child = os.fork()
        if child == 0:
            os.dup2(os.open(os.devnull, os.O_WRONLY), 2)
            _read_and_leave(path)
        if os.waitpid(child, 0)[1] != 0:
            raise files._unreadable(path)


def _read_and_leave(path: str) -> None:
    import signal

    # A fork does not inherit the timer.
    signal.setitimer(signal.ITIMER_PROF, 3.0)
    signal.signal(signal.SIGPROF, signal.SIG_DFL)
    code = 1
    try:
        probe.read(path)
        code = 0
    finally:
        os._exit(code)


def use(case: Case, folder: Path) -> str:
    """Compute statistics, draw a picture, or read the data set."""
    with quick_probe():
        if case.arguments[0] == "read":
            with files.open_all([folder / "run.nc"])[0] as found:
                found.kingpost.statistics()
            return "taken"
        picture = ["-o", str(folder / "run.svg")] if case.arguments[0] == "plot" else []
        code = main([case.arguments[0], str(folder / "run.nc"), *picture])
    check_exit(code)
    return f"exit {code}"
