"""Printed lines of `kingpost hydro`, and the fit of the memory that ends a run."""

from __future__ import annotations

import argparse
import os
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from .. import progress
from ..errors import HydrodynamicsError, flag
from . import demand
from .database_file import One, rounded, write
from .fit_data import FEWEST_FREQUENCIES, OTHER_DAMPING
from .radiation_fit import LIMIT, Misfit, fit, misfits, response_error
from .several import SeveralHulls

if TYPE_CHECKING:
    from .database import Database, Provenance, Radiation

MOST_FIT_ERROR = 0.25
"""Largest error of a written fit of the memory, as a share of its peak: the heave amplitude at resonance has
at least the same error."""
NEXT_CUT = 0.85
"""Ratio of successive upper frequencies that are tried for the advice; each needs one fit."""


def print_demand(run: demand.Size) -> list[str]:
    """Print the size of the computation before it starts; warn if the machine has too little memory."""
    threads = os.environ.get("OMP_NUM_THREADS") or os.cpu_count()
    lid = f", {run.lid_panels} of them a lid," if run.lid_panels else ""
    print(f"{'to be solved':<20}{run.panels} panels{lid} for 1 frequency at a time, {threads} threads")
    needed, matrix = demand.process_bytes(run), run.matrix_bytes
    print(f"{'memory':<20}{needed / 1e9:.3g} GB at most, whole process; {matrix / 1e6:.3g} MB a matrix")
    there = demand.machine_bytes()
    if there is not None and needed > there:
        return [f"this machine has {there / 1e9:.3g} GB of memory: use fewer panels"]
    return []


def warn(warnings: list[str]) -> None:
    """Print warnings."""
    for warning in warnings:
        print(f"warning: {warning}")


def warned_of(database: One, warnings: list[str]) -> One:
    """Return the database with additional warnings, which are repeated at every use of it."""
    about: Provenance = database.provenance
    return replace(database, provenance=replace(about, warnings=(*about.warnings, *warnings)))


def fitted(database: One, options: argparse.Namespace, target: Path, response_share: float = 1.0) -> One:
    """Fit the memory, print its errors and write the database."""
    database = rounded(database)
    with progress.bar(1.0, "memory") as update:
        radiation = fit(
            database,
            highest_rad_s=options.highest_rad_s,
            accept=options.accept_fit,
            response_share=response_share,
            progress=update,
        )
    misfit: list[Misfit] = misfits(database, radiation, highest_rad_s=options.highest_rad_s)
    if radiation.fit_error > MOST_FIT_ERROR:
        raise HydrodynamicsError(
            "radiation",
            f"a memory fitted to {radiation.fit_error:.0%} of its peak",
            f"at most {MOST_FIT_ERROR:.0%}: with more it is no memory of this hull; {_cut(database, misfit)}",
        )
    print(f"{'memory of the water':<20}{_states(radiation)} states, fitted to {radiation.fit_error:.2%}")
    width = max([20, *(len(one.motion) + 4 for one in misfit)])
    for one in misfit:
        parts = f"{one.memory:.2%} of K, {one.added_mass:.2%} of A, {one.damping:.2%} of B"
        print(f"{'  ' + one.motion:<{width}}{parts}")
    missed = [_missed(one) for one in misfit if one.memory > LIMIT]
    if isinstance(database, SeveralHulls):
        missed += _motions_missed(response_error(database, radiation, options.highest_rad_s))
    warn(missed)
    database = replace(warned_of(database, missed), radiation=radiation)
    print(f"{'written':<20}{write(database, target)}")
    return database


def _motions_missed(error: float) -> list[str]:
    """Print the error of the motions of freely floating hulls; return a warning if it is large."""
    other = f"with other damping of {OTHER_DAMPING:.0%} of the critical"
    print(f"{'  free motions':<20}{error:.2%} of their peaks, {other}")
    if error <= LIMIT:
        return []
    return [f"the memory changes motions of the hulls, floating freely, by {error:.1%} of their peaks"]


def _cut(database: Database | SeveralHulls, found: list[Misfit]) -> str:
    """Advice on the highest frequency up to which the memory can be fitted, if there is one."""
    omega = database.frequencies_rad_s
    cut = max(found, key=lambda one: one.memory).frequency_rad_s
    best: tuple[float, float] | None = None
    while (kept := omega[omega < cut]).size >= FEWEST_FREQUENCIES:
        cut = float(kept[-1])
        error = fit(database, highest_rad_s=cut, accept=True).fit_error
        if best is None or error < best[0]:
            best = error, cut
        if error <= LIMIT:
            break
        cut *= NEXT_CUT
    if best is None or best[0] > MOST_FIT_ERROR:
        return "compute the hull again, with a lid and more panels"
    error, cut = best
    return (
        f"above {cut:.4g} rad/s waves may be too short for the panels, or irregular frequencies lie there: "
        f"with {flag('highest_rad_s')} {cut:.4g} it is {error:.2%}"
    )


def _missed(one: Misfit) -> str:
    coupling = f", coupled with {one.coupled_with}," if one.coupled_with else ""
    return (
        f"the memory of {one.motion}{coupling} is fitted to {one.memory:.2%} only, at "
        f"{one.frequency_rad_s:.4g} rad/s "
        f"({one.added_mass:.1%} of its added mass, {one.damping:.1%} of its damping)"
    )


def _states(radiation: Radiation) -> int:
    """Real states of the fit: one for a real pole, two for a complex one."""
    return sum(int(np.where(mode.poles_rad_s.imag > 0, 2, 1).sum()) for mode in radiation.modes)
