"""Scenarios of the gallery and of tests, and random parts, damaged as texts and as trees."""

from __future__ import annotations

import contextlib
import copy
import random
from functools import cache
from pathlib import Path
from typing import Any

import kingpost
from kingpost.cli import main
from lift_mutations import written
from lift_outcomes import outcome

from ..contract import Case, check_exit
from ..from_schema import section_changed
from ..mutations import damaged, damaged_tree, encoded

# Beside the gallery, so that its databases are found.
FILE = str(kingpost.gallery.folder() / "case.yaml")
SMALL = ("paper", "chain", "tennis_racket", "flexible_boom", "knuckle_boom_crane", "paper_on_a_rope")
"""Scenarios that are built and stepped in milliseconds."""
LEAVES = Path(__file__).resolve().parents[4] / "crates" / "kingpost" / "tests"
RUN_S = 0.03
"""Processor time after which a run is stopped as by Ctrl-C, s."""


@cache
def texts() -> dict[str, str]:
    """Texts by name; most draws are from the small scenarios."""
    gallery = {entry.name: kingpost.gallery.read_text(entry.path) for entry in kingpost.gallery.entries()}
    tests = [*LEAVES.glob("leaves/*.yaml"), *LEAVES.glob("common/*.yaml")]
    yard = Path(__file__).resolve().parents[2] / "lift_yard.yaml"
    return gallery | {path.stem: path.read_text(encoding="utf-8") for path in (*sorted(tests), yard)}


@cache
def documents() -> dict[str, dict[str, Any]]:
    """Trees of the scenarios, with parts mounted, parameters applied and short runs."""
    found = {}
    for name, text in texts().items():
        with contextlib.suppress(kingpost.ScenarioError):
            found[name] = kingpost.Scenario(text, FILE, (("simulation.duration_s", 0.5),)).resolved
    return found


def drawn(draw: random.Random) -> Case:
    """Draw a wrong text or a wrong tree."""
    way = draw.random()
    if way < 0.45:
        text = damaged(draw, texts()[_name(draw, texts())])
    else:
        document = documents()[_name(draw, documents())]
        if way < 0.75:
            document = section_changed(draw, document)
        if way >= 0.7:
            document = damaged_tree(draw, copy.deepcopy(document))
        text = written(document)
    how = draw.choices(["outcome", "thorough", "check", "run", "modes"], [80, 2, 2, 1, 1])[0]
    return Case("scenario_text", {"case.yaml": encoded(draw, text)}, (how,))


def _name(draw: random.Random, of: dict[str, Any]) -> str:
    return draw.choice(SMALL) if draw.random() < 0.8 else draw.choice(sorted(of))


def use(case: Case, folder: Path) -> str:
    """Read the text; if it is a scenario, step and run it, sometimes by the command line."""
    how, path = case.arguments[0], folder / "case.yaml"
    if how in ("check", "run", "modes"):
        return _by_command(how, path)
    text = kingpost.gallery.read_text(path)
    return outcome(text, FILE, thorough=how == "thorough", longest_run_s=RUN_S)


def _by_command(how: str, path: Path) -> str:
    short = ["--set", "simulation.duration_s=0.02", "--set", "simulation.step_s=0.01"]
    code = main([how, str(path), *(short if how == "run" else [])])
    check_exit(code)
    return f"exit {code}"
