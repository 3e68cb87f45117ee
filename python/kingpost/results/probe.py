"""Test that libraries can read files to their end, in a separate process that reports each file it has read.

Run as a program, with the paths as JSON on its input. On a damaged file the HDF5 library may hang or crash:
here only this process ends.
"""

from __future__ import annotations

import contextlib
import io
import json
import sys

MESH_MEMORY_BYTES = 2 << 30
"""Largest memory for reading a mesh, bytes."""


def main(paths: list[str]) -> None:
    """Read each file and print a word after each."""
    for path in paths:
        try:
            # Discard the output of libraries: standard output carries the reports.
            with contextlib.redirect_stdout(io.StringIO()):
                read(path)
        except (Exception, SystemExit):
            print("failed", flush=True)
        else:
            print("read", flush=True)


def read(path: str) -> None:
    """Read all of a file by its ending: a data set, HDF5 array by array, else a mesh."""
    ending = path.lower().rpartition(".")[2]
    if ending == "nc":
        import xarray

        xarray.load_dataset(path, engine="h5netcdf")
        return
    if ending != "h5":
        import meshio

        _limit_memory()
        meshio.read(path)
        return
    import h5py

    def load(_: str, held: object) -> None:
        if isinstance(held, h5py.Dataset):
            held[()]

    with h5py.File(path) as file:
        file.visititems(load)


def _limit_memory() -> None:
    """Limit the memory of this process, so that a wrong count in a mesh cannot fill the machine's memory."""
    with contextlib.suppress(ImportError, AttributeError, ValueError):
        import resource

        resource.setrlimit(resource.RLIMIT_DATA, (MESH_MEMORY_BYTES, MESH_MEMORY_BYTES))


if __name__ == "__main__":
    main(json.load(sys.stdin))
