"""Hydrodynamic databases (.hydro.json), read by Python and by the engine."""

from __future__ import annotations

import copy
import json
import random
from functools import cache
from pathlib import Path
from typing import Any

import kingpost
from kingpost.hydro import database_file

from ..contract import Case, WrongError
from ..mutations import damaged, damaged_tree, encoded

NAME = "hull.hydro.json"
FREQUENCIES, DIRECTIONS = 5, 4
"""Numbers of frequencies and directions kept from the gallery's databases, so that reading takes
milliseconds."""
LARGE = ("added_mass", "radiation_damping", "froude_krylov", "diffraction")
SCENARIO = """version: 1
title: Afloat
simulation: {step_s: 0.05, duration_s: 0.2}
sea: {density_kg_m3: 1000, waves: {swell: {regular: {height_m: 0.5, period_s: 5}}}}
bodies:
  hemisphere:
    mass_t: 261.746
    inertia: {radii_of_gyration: {radii_m: [2.5, 2.5, 2.8]}}
    centre_of_mass_m: [0, 0, -1.875]
    joint: {floating: {initial: {position_m: [0, 0, -1.875]}}}
forces:
  gravity: {gravity: {}}
  water: {hydrodynamics: {body: hemisphere, database: hull.hydro.json}}
"""


@cache
def trees() -> list[dict[str, Any]]:
    """The sphere, and the barge with its mean drift: few frequencies and directions, with mesh and memory."""
    folder = kingpost.gallery.folder() / "hydro"
    return [_smaller(json.loads((folder / f"{name}.hydro.json").read_text())) for name in ("sphere", "barge")]


def _smaller(tree: dict[str, Any]) -> dict[str, Any]:
    kept = range(0, len(tree["frequencies_rad_s"]), len(tree["frequencies_rad_s"]) // FREQUENCIES)
    ways = range(0, len(tree["wave_directions_rad"]), len(tree["wave_directions_rad"]) // DIRECTIONS)
    for name in ("frequencies_rad_s", "added_mass", "radiation_damping"):
        tree[name] = [tree[name][k] for k in kept]
    tree["wave_directions_rad"] = [tree["wave_directions_rad"][b] for b in ways]
    for name in ("froude_krylov", "diffraction"):
        for part in ("real", "imaginary"):
            tree[name][part] = [[tree[name][part][k][b] for b in ways] for k in kept]
    tree["hull"]["mesh"] = {
        "vertices_m": [[x, y, z] for x in (-5, 5) for y in (-5, 5) for z in (-5, 5)],
        "triangles": [[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1], [2, 3, 7], [2, 7, 6],
                      [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]],
    }  # fmt: skip
    if tree["mean_drift"] is not None:
        tree["mean_drift"] = [[tree["mean_drift"][k][b] for b in ways] for k in kept]
    return tree


@cache
def rest(k: int, names: tuple[str, ...] | None = LARGE) -> str:
    """The large tables of a tree as the end of a text; without names all of it."""
    if names is None:
        return json.dumps(trees()[k], separators=(",", ":"))
    return json.dumps({name: trees()[k][name] for name in names})[1:]


def drawn(draw: random.Random) -> Case:
    """Draw a database with changed values or damaged text; half of them are read by the engine."""
    k = draw.randrange(len(trees()))
    if draw.random() < 0.75:
        # Most values belong to a few large tables, which stay text: otherwise other values would hardly be
        # drawn.
        small = draw.random() < 0.7
        names = [name for name in trees()[k] if not small or name not in LARGE]
        part = damaged_tree(draw, {name: copy.deepcopy(trees()[k][name]) for name in names})
        content = (json.dumps(part)[:-1] + (", " * bool(part) + rest(k) if small else "}")).encode()
    else:
        content = encoded(draw, damaged(draw, rest(k, names=None)))
    files = {NAME: content}
    if draw.random() < 0.5:
        return Case("databases", files, ("python",))
    return Case("databases", files | {"case.yaml": SCENARIO.encode()}, ("engine",))


def use(case: Case, folder: Path) -> str:
    """Read the database; if a hull floats with it, make steps."""
    if case.arguments[0] == "python":
        database = database_file.read(folder / NAME)
        database_file.write(database, folder / f"again.{NAME}")
        return "taken"
    scenario = kingpost.load(folder / "case.yaml")
    simulation = kingpost.Simulation(scenario)
    try:
        simulation.step(2)
    except kingpost.RunError as error:
        return f"ended early: {error}"
    if not all(map(_is_finite, simulation.state.q)):
        raise WrongError("a position that is NaN")
    return "ran"


def _is_finite(value: float) -> bool:
    return abs(value) < float("inf")
