"""Digests that verify the numbers of a study and their frame (coordinates and attributes)."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray


def digest(arrays: Mapping[str, NDArray[np.generic]]) -> str:
    """SHA-256 of the numbers of a unit, with their names, types and shapes."""
    found = hashlib.sha256()
    for name in sorted(arrays):
        array = np.ascontiguousarray(arrays[name])
        array = array.astype(array.dtype.newbyteorder("<"), copy=False)
        found.update(f"{name} {array.dtype.str} {array.shape};".encode())
        found.update(array.tobytes())
    return found.hexdigest()


def frame_digest(coordinates: Mapping[str, NDArray[np.generic]], attributes: Mapping[str, object]) -> str:
    """SHA-256 of the coordinates and attributes, which give the numbers of a study their meaning."""
    texts = {name: np.array(values.tolist(), str) if values.dtype.kind == "T" else values
             for name, values in coordinates.items()}  # fmt: skip
    said = np.array(json.dumps(dict(attributes), sort_keys=True))
    return digest(texts | {"attributes": said})
