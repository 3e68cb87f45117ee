"""Reads files of results to the end, in a process of its own: it says which it got through.

Run as a program, with the paths as JSON on its input. In a damaged file the HDF5 library may go round in
circles, or crash: here that ends nothing else.
"""

from __future__ import annotations

import json
import sys


def main(paths: list[str]) -> None:
    """Read each file and print a word when that is over."""
    import xarray

    for path in paths:
        try:
            xarray.load_dataset(path, engine="h5netcdf")
        except Exception:
            print("failed", flush=True)
        else:
            print("read", flush=True)


if __name__ == "__main__":
    main(json.load(sys.stdin))
