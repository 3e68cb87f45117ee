"""Reads files of results to the end, in a separate process, and reports each file that it has read.

Run as a program, with the paths as JSON on its input. On a damaged file the HDF5 library may hang or crash:
here only this process ends.
"""

from __future__ import annotations

import json
import sys


def main(paths: list[str]) -> None:
    """Read each file and print a word when it is read."""
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
