"""Reads HDF5 files to the end, in a separate process, and reports each file that it has read.

Run as a program, with the paths as JSON on its input. On a damaged file the HDF5 library may hang or crash:
here only this process ends.
"""

from __future__ import annotations

import json
import sys


def main(paths: list[str]) -> None:
    """Read each file and print a word when it is read."""
    for path in paths:
        try:
            read(path)
        except Exception:
            print("failed", flush=True)
        else:
            print("read", flush=True)


def read(path: str) -> None:
    """Read all of a file: as a data set, or where its name ends with .h5, array by array."""
    if not path.lower().endswith(".h5"):
        import xarray

        xarray.load_dataset(path, engine="h5netcdf")
        return
    import h5py

    def load(_: str, held: object) -> None:
        if isinstance(held, h5py.Dataset):
            held[()]

    with h5py.File(path) as file:
        file.visititems(load)


if __name__ == "__main__":
    main(json.load(sys.stdin))
