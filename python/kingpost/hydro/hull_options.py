"""Hulls, water, frequencies and loading from the options of `kingpost hydro`."""

from __future__ import annotations

import argparse
import math
import os
from dataclasses import MISSING, fields
from pathlib import Path

import numpy as np

from ..errors import HydrodynamicsError, flag
from . import attitude_command, inclined
from .checks import check_water
from .database import Water
from .drift import Loading
from .fit_data import FEWEST_FREQUENCIES
from .hull_files import HullFile
from .meshes import HullMeshes, parametric
from .shapes import Box, Hemisphere, Shape, Sphere, Wigley
from .vessel import OffshoreVessel

SHAPES: dict[str, type[Shape]] = {
    "box": Box,
    "wigley": Wigley,
    "sphere": Sphere,
    "hemisphere": Hemisphere,
    "offshore_vessel": OffshoreVessel,
}
MOST_FREQUENCIES = 500


def water_of(options: argparse.Namespace) -> Water:
    """The water of the options."""
    for name in ("density_kg_m3", "water_depth_m"):
        value = getattr(options, name)
        if value is not None and not (math.isfinite(value) and value > 0):
            raise HydrodynamicsError(flag(name), f"{value:g}", "a number greater than 0")
    given = options.density_kg_m3
    water = Water(Water.density_kg_m3 if given is None else given, depth_m=options.water_depth_m)
    check_water(water)
    return water


def count_of(name: str, given: int | None, limits: tuple[int, int]) -> int | None:
    """Check a count within limits."""
    if given is not None and not limits[0] <= given <= limits[1]:
        raise HydrodynamicsError(flag(name), str(given), f"a whole number from {limits[0]} to {limits[1]}")
    return given


def parse_frequencies(text: str) -> np.ndarray:
    """Frequencies from ``from:to:n`` or ``a,b,c``, at least as many as the fit of the memory needs.

    >>> parse_frequencies("0.5:2.25:8")
    array([0.5 , 0.75, 1.  , 1.25, 1.5 , 1.75, 2.  , 2.25])
    """
    allowed = (
        f"from:to:n such as 0.1:3:30, or a list a,b,c,...; {FEWEST_FREQUENCIES} to {MOST_FREQUENCIES}, "
        "increasing and greater than 0"
    )
    try:
        if ":" in text:
            start, end, count = text.split(":")
            with np.errstate(all="ignore"):
                found = np.linspace(float(start), float(end), min(int(count), MOST_FREQUENCIES + 1))
        else:
            found = np.array([float(part) for part in text.split(",")])
    except (ValueError, MemoryError):
        raise HydrodynamicsError("--frequencies-rad-s", repr(text), allowed) from None
    fits = FEWEST_FREQUENCIES <= len(found) <= MOST_FREQUENCIES
    if not fits or not np.isfinite(found).all() or found[0] <= 0 or (np.diff(found) <= 0).any():
        raise HydrodynamicsError("--frequencies-rad-s", repr(text), allowed)
    return found


def is_parametric(hull: str) -> bool:
    """Whether a hull is given as a parametric description, whose last number may look like a file's
    ending."""
    return (hull.partition(":")[0] in SHAPES or "=" in hull) and not os.path.isfile(hull)


def hull_of(options: argparse.Namespace, panels: int) -> HullMeshes:
    """The hull of the options: a mesh file or a parametric hull."""
    if os.path.isfile(options.hull):
        file = HullFile(Path(options.hull), options.draught_m, bool(options.flip_normals))
        upright = file.meshes(panels)
        asked = attitude_command.parse(options, upright.particulars)
        return upright if asked is None else inclined.of_file(file, upright, panels, asked)
    if not is_parametric(options.hull):
        kinds = ", ".join(SHAPES)
        allowed = f"a mesh file, or a parametric hull: {kinds}"
        raise HydrodynamicsError("hull", "no such file", allowed, options.hull)
    if options.draught_m is not None:
        allowed = "a mesh file; a parametric hull has its own draught"
        raise HydrodynamicsError("--draught-m", "a parametric hull", allowed)
    shape = parse_shape(options.hull)
    upright = parametric(shape, options.hull, panels)
    asked = attitude_command.parse(options, upright.particulars)
    return upright if asked is None else inclined.of_shape(shape, upright, panels, asked)


def parse_shape(text: str) -> Shape:
    """A parametric hull from its description.

    >>> parse_shape("sphere:radius_m=5")
    Sphere(radius_m=5.0)
    """
    kind, _, description = text.partition(":")
    if kind not in SHAPES:
        raise HydrodynamicsError("hull", repr(kind), f"one of {', '.join(SHAPES)}")
    return SHAPES[kind](**_values(SHAPES[kind], description, "hull", f"{kind}:"))


def parse_loading(text: str) -> Loading:
    """A loading condition from its description.

    >>> parse_loading("kg_m=2.5,roll_gyration_m=3,pitch_gyration_m=6,yaw_gyration_m=6").kg_m
    2.5
    """
    return Loading(**_values(Loading, text, "--loading", ""))


def _values(kind: type, description: str, field: str, start: str) -> dict[str, float]:
    """Numbers ``name=value,...`` for the fields of a data class; fields without a default are required."""
    names = [each.name for each in fields(kind)]
    form = start + ",".join(f"{name}=..." for name in names)
    values: dict[str, float] = {}
    for assignment in filter(None, description.split(",")):
        name, _, value = (part.strip() for part in assignment.partition("="))
        if name not in names or name in values:
            found = "given twice" if name in values else "an unknown dimension"
            raise HydrodynamicsError(f"{field}.{name}", found, form)
        try:
            values[name] = float(value)
        except ValueError:
            raise HydrodynamicsError(f"{field}.{name}", repr(value), "a number") from None
    missing = [each.name for each in fields(kind) if each.default is MISSING and each.name not in values]
    if missing:
        raise HydrodynamicsError(field, f"no {missing[0]}", form)
    return values
