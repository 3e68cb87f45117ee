"""Arguments of the command line: `--set` in every form, and numbers and names of the other options."""

from __future__ import annotations

import contextlib
import random
from functools import cache
from pathlib import Path

import kingpost
from kingpost.cli import main

from ..contract import Case, WrongError, check_exit
from ..mutations import NUMBER_TEXTS, damaged, weird_number
from .scenario_text import documents

SCENARIOS = ("paper", "chain", "tennis_racket")
VALUES = [
    "on", "off", "true", "null", "[]", "{}", "[0,0,1]", "[0, 0, 1", "{a: 1}", "{a: .5}",
    "{prescribed: {rate_rad_s: 0.1}}",
    "{prescribed: {rate_rad_s: .5}}", '{"prescribed": {"rate_rad_s": 0.1}}', "{waves: {}}",
    "{a: {b: {c: [1,2,{d: e}]}}}",
    "{", "}", "{{}}", "{:}", "{a}", '{"a"}', "{a: 'b'}", "{a: b: c}", "{,}", "[,]", "'", '"', "ship",
    "lever", "=", "a=b",
    "{a: " * 500 + "1" + "}" * 500, "[" * 5000, "&a [*a]", "!!python/object:os.system x", "1 000", "x" * 4000,
]  # fmt: skip
ROLL = (
    "roll-damping",
    "sections",
    "box:length_m=20,beam_m=10,draught_m=2,depth_m=5",
    "--kg-m",
    "2.5",
    "--period-s",
    "6",
)
LINES = [
    ROLL,
    (*ROLL, "--bilge-keels", "breadth_m=0.4,length_m=10", "--speed-m-s", "3", "--amplitudes-deg", "5", "10"),
    (*ROLL, "--stations", "12", "--density-kg-m3", "1025", "--viscosity-m2-s", "1e-6"),
    ("modes", "chain", "--sweep", "damping=0:100:2"),
    ("rao", "barge", "--directions-deg", "180", "--frequencies-rad-s", "0.5:1:2"),
    ("run", "chain", "--set", "simulation.duration_s=0.01", "--record", "link_1.*"),
    ("hydro", "box:length_m=20,beam_m=10,draught_m=2,depth_m=5", "--panels", "0", "-o", "x.hydro.json"),
    ("hydro", "sphere:radius_m=5", "--frequencies-rad-s", "0.5:2:1", "-o", "x.hydro.json"),
    ("hydro", "wigley:length_m=9,beam_m=1,draught_m=1", "--loading", "kg_m=2.5,roll_gyration_m=3", "-o",
    "x.hydro.json"),
    ("hydro", "sphere:radius_m=5", "--heel-deg", "5", "--directions", "3", "-o", "x.hydro.json"),
    ("serve", "--port", "99999", "--host", "127.0.0.1"),
    ("list", "--json"), ("statistics", "x.nc", "--after-s", "3"), ("plot", "x.nc", "-o", "x.png"),
]  # fmt: skip
"""Command lines that end soon, even if the changed argument is valid."""
# Arguments that would start a long computation or a server if valid.
OWN_WORDS = {
    "--anew",
    "--seeds",
    "paper",
    "verify",
    "serve",
    "-h",
    "--help",
    "--version",
    "--print-completion",
}


@cache
def paths(scenario: str) -> list[str]:
    """Dotted paths of all fields of a scenario, and its parameters."""
    found = []

    def walk(value: object, path: str) -> None:
        if path:
            found.append(path)
        entries = (
            value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
        )
        for name, entry in entries:
            walk(entry, f"{path}.{name}" if path else str(name))

    walk(documents()[scenario], "")
    return [*found, *kingpost.load(scenario).parameters]


def assignment(draw: random.Random, scenario: str) -> str:
    """Draw an assignment ``name=value``, possibly malformed."""
    name = draw.choice(paths(scenario))
    value = weird_number(draw) if draw.random() < 0.6 else draw.choice(VALUES)
    text = f"{name}={value}"
    return damaged(draw, text) if draw.random() < 0.4 else text


def drawn(draw: random.Random) -> Case:
    """Draw assignments to a scenario, or a command line with one changed argument."""
    way = draw.random()
    if way < 0.9:
        scenario = draw.choice(SCENARIOS)
        given = [assignment(draw, scenario) for _ in range(draw.choices([1, 2, 3], [5, 2, 1])[0])]
        how = "check" if way < 0.05 else "set"
        return Case("command_line", {}, (how, scenario, *map(_plain, given)))
    words = list(draw.choice(LINES))
    for _ in range(draw.choice([1, 1, 2])):
        k = draw.randrange(len(words))
        way = draw.randrange(5)
        if way == 0:
            words[k] = draw.choice(NUMBER_TEXTS)
        elif way == 1:
            words.pop(k)
        elif way == 2:
            words.insert(k, draw.choice(words or ["x"]))
        else:
            words[k] = damaged(draw, words[k])
        words = words or ["list"]
    return Case("command_line", {}, ("line", *map(_plain, words)))


def _plain(word: str) -> str:
    """Make an argument that a shell can pass and a corpus file can store."""
    return word.replace("\x00", "").encode("utf-8", "replace").decode()


def use(case: Case, folder: Path) -> str:
    """Read the scenario with the assignments, or run the command line."""
    how, *words = case.arguments
    if how == "set":
        return _set(words[0], words[1:])
    if how == "check":
        words = ["check", words[0], *(word for given in words[1:] for word in (f"--set={given}",))]
    elif OWN_WORDS & set(words) and words[:3] != ["serve", "--port", "99999"]:
        return "left out"
    code: object
    with contextlib.chdir(folder):
        try:
            code = main(words)
        except SystemExit as end:
            code = end.code
    check_exit(code)
    return f"exit {code}"


def _set(scenario: str, given: list[str]) -> str:
    import argparse

    from kingpost.commands.common import scenario_of

    found = scenario_of(argparse.Namespace(scenario=scenario, set=given))
    if not isinstance(found.resolved, dict):
        raise WrongError("a scenario without fields")
    simulation = kingpost.Simulation(found)
    try:
        simulation.step()
    except kingpost.RunError as error:
        return f"ended early: {error}"
    return "ran"
