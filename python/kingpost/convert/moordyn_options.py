"""OPTIONS of a MoorDyn input file: sea, seabed, gravity and time step."""

from __future__ import annotations

from .cells import NUMBER
from .deck import Deck
from .moordyn_sections import Row, Sections

LONGEST_STEP_S, USUAL_STEP_S = 0.05, 0.01
LONGEST_INTERVAL_S = 10.0
"""Longest `dtOut` that becomes the interval of records: longer ones turn MoorDyn's output off."""
WATER = {
    "g": "gravity_m_s2", "gravity": "gravity_m_s2",
    "rho": "density_kg_m3", "wtrdnsty": "density_kg_m3", "rhow": "density_kg_m3",
    "kbot": "stiffness_n_per_m3", "kb": "stiffness_n_per_m3",
    "cbot": "damping_n_s_per_m3", "cb": "damping_n_s_per_m3",
    "frictioncoefficient": "friction",
}  # fmt: skip
"""Fields of `Water` by option."""
DEPTH = ("wtrdpth", "wtrdepth", "depth")
AT_REST = "a run begins with its lines at rest"
LOG = "concerns files and messages of MoorDyn"
OF_WAVES = "waves, currents and their files are not read: write them under `sea`"
OF_FRICTION = "friction of the seabed grows to its limit by the engine's own law"
LEFT_OUT = {
    "writelog": LOG, "writeunits": LOG, "disableoutput": LOG, "disableouttime": LOG,
    "outswitch": LOG, "echo": LOG,
    "dtic": AT_REST, "icdt": AT_REST, "tmaxic": AT_REST, "ictmax": AT_REST, "cdscaleic": AT_REST,
    "icdfac": AT_REST, "threshic": AT_REST, "icthresh": AT_REST, "icgendynamic": AT_REST,
    "gendynamicic": AT_REST, "fileic": AT_REST, "icfile": AT_REST,
    "tscheme": "the engine's own schemes step the lines: simulation.integrator",
    "cfl": "the engine's step does not depend on the lengths of segments",
    "wavekin": OF_WAVES, "dtwave": OF_WAVES, "currents": OF_WAVES, "unifycurrentgrid": OF_WAVES,
    "waterkin": OF_WAVES,
    "fricdamp": OF_FRICTION, "cv": OF_FRICTION, "statdynfricscale": OF_FRICTION, "mc": OF_FRICTION,
    "seafloorfile": "the seabed is level, at the depth of the water",
    "inertialf": "concerns the coupling to OpenFAST", "inertialf_rampt": "concerns the coupling to OpenFAST",
}  # fmt: skip
"""Reasons by option."""
WITHOUT_EFFECT = {"wavekin": "0", "currents": "0", "statdynfricscale": "1", "mc": "1"}
"""Values of options that lose nothing."""


def read(sections: Sections, deck: Deck) -> None:
    """Read the options into the deck; what has no counterpart is noted."""
    friction: dict[str, float] = {}
    for row in sections.rows("OPTIONS"):
        if len(row) < 2:
            deck.notes.leave_out(row.line, row.text, "an option is a value and a name")
            continue
        name = row[1].text.lower()
        if name in WATER:
            is_above = WATER[name] == "density_kg_m3"
            setattr(deck.water, WATER[name], row[0].number(f"OPTIONS.{row[1].text}", 0, above=is_above))
        elif name in ("mu_ka", "mu_kt"):
            friction[name] = row[0].number(f"OPTIONS.{row[1].text}", 0)
            deck.notes.convert(row.line, row.text, "one coefficient of friction along and across: the larger")
        elif name in DEPTH:
            _depth(row, deck)
        elif name in ("dtm", "dt"):
            _step(row, deck)
        elif name == "dtout":
            _interval(row, deck)
        else:
            _leave_out(row, name, deck)
    if friction:
        deck.water.friction = max(friction.values())
    if deck.step_s is None:
        deck.step_s = USUAL_STEP_S
        deck.notes.convert(None, "no dtM", f"simulation.step_s is {USUAL_STEP_S:g} s")


def _depth(row: Row, deck: Deck) -> None:
    if NUMBER.fullmatch(row[0].text):
        deck.water.depth_m = row[0].number(f"OPTIONS.{row[1].text}", 0)
    else:
        deck.notes.leave_out(row.line, row.text, "the seabed is level, at the depth of the lowest point")


def _step(row: Row, deck: Deck) -> None:
    step = row[0].number(f"OPTIONS.{row[1].text}", 0, above=True)
    deck.step_s = min(step, LONGEST_STEP_S)
    if step > LONGEST_STEP_S:
        deck.notes.convert(row.line, row.text, f"simulation.step_s is {LONGEST_STEP_S:g} s")


def _interval(row: Row, deck: Deck) -> None:
    interval = row[0].number(f"OPTIONS.{row[1].text}", 0)
    if 0 < interval <= LONGEST_INTERVAL_S:
        deck.record_every_s = interval
    else:
        deck.notes.leave_out(row.line, row.text, "simulation.record_every_s has its usual value")


def _leave_out(row: Row, name: str, deck: Deck) -> None:
    value = row[0].text
    nothing = WITHOUT_EFFECT.get(name)
    if nothing is not None and NUMBER.fullmatch(value) and float(value) == float(nothing):
        return
    deck.notes.leave_out(row.line, row.text, LEFT_OUT.get(name, "an unknown option"))
