"""`kingpost hydro FILE.h5 -o X.hydro.json`: convert another program's file to a database."""

from __future__ import annotations

import argparse
from dataclasses import fields

from ..errors import HydrodynamicsError, flag
from . import importers
from .database import Database

SHARED = ("density_kg_m3", "water_depth_m", "draught_m")
# Share of the fit's limit for responses: some files are of platforms, which resonate with little damping.
RESPONSE_SHARE = 0.25
TRUE = {"yes": True, "no": False}


def add_options(command: argparse.ArgumentParser) -> None:
    """Add the options for values that a file may lack, except those in `SHARED`, which `kingpost hydro`
    already has."""
    group = command.add_argument_group(
        "another program's file", "values that the file does not contain must be given; nothing is assumed"
    )
    for field in fields(importers.Options):
        if field.name not in SHARED:
            group.add_argument(flag(field.name), metavar="V", help=importers.ALLOWED[field.name])


def run(options: argparse.Namespace) -> Database:
    """Read the file and check it."""
    given = {
        field.name: parsed(field.name, getattr(options, field.name))
        for field in fields(importers.Options)
        if getattr(options, field.name) is not None
    }
    database = importers.load(options.hull, importers.Options(**given), options.title, options.highest_rad_s)
    for note in database.provenance.notes:
        print(f"{'note':<20}{note}")
    return database


def refuse(options: argparse.Namespace) -> None:
    """Refuse options of other programs' files for a hull."""
    allowed = f"another program's file: {importers.KINDS}"
    for field in fields(importers.Options):
        if field.name not in SHARED and getattr(options, field.name) is not None:
            raise HydrodynamicsError(flag(field.name), "a hull", allowed)


def parsed(name: str, text: object) -> object:
    """Parse the value of an option.

    >>> parsed("reference_m", "0,0,-2"), parsed("restoring_includes_weight", "no")
    ((0.0, 0.0, -2.0), False)
    """
    if not isinstance(text, str) or name in importers.CHOICES or name in importers.TEXTS:
        return text
    if name == "restoring_includes_weight":
        return TRUE.get(text, text)
    try:
        numbers = tuple(float(part) for part in text.split(","))
    except ValueError:
        raise HydrodynamicsError(flag(name), repr(text), importers.ALLOWED[name]) from None
    return numbers if name in importers.VECTORS else numbers[0] if len(numbers) == 1 else text
