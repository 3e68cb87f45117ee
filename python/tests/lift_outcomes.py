"""Judgement of a scenario: an error message, a run with finite numbers, or a violation."""

from __future__ import annotations

import json
import re
import sys
import time
from pathlib import Path

import kingpost
import numpy as np
from fuzz.contract import LONGEST_TEXT, NOT_FOR_READERS, WrongError
from kingpost.results import entries
from kingpost.results.kept import has_entries

STEPS = 12
"""Number of single steps before and after a snapshot."""
LONGEST_STEPS_S = 2.0
"""Processor time for these steps, s, above which they are not repeated."""
LONGEST_RUN_S = 0.5
"""Processor time after which a run is stopped as by Ctrl-C, s."""
# file:line:column: field: found ..., allowed: ...
SAYS = re.compile(r"found .+, allowed: .+", re.DOTALL)


class StoppedError(Exception):
    """A run that exceeds the time limit."""


def outcome(text: str, file: str, *, thorough: bool = False, longest_run_s: float = LONGEST_RUN_S) -> str:
    """``refused``, ``ran``, ``ended early`` or ``stopped``, with the words of the error.

    Raises
    ------
    WrongError
        When an error has no place or no help, or when a run has numbers that are none.
    """
    try:
        scenario = kingpost.Scenario(text, file)
    except kingpost.ScenarioError as error:
        check_refusal(error)
        return f"refused: {error}"
    simulation = kingpost.Simulation(scenario)
    check_description(simulation)
    start = simulation.row()
    check_numbers(simulation, "at the start")
    early = check_steps(simulation)
    simulation.reset()
    if not same(start, simulation.row()):
        raise WrongError("reset leads elsewhere than to the start")
    if thorough:
        early = check_the_rest(simulation, text) or early
    return check_run(simulation, longest_run_s) or (f"ended early: {early}" if early else "ran")


def check_refusal(error: kingpost.ScenarioError) -> None:
    says = str(error)
    if not SAYS.search(says):
        raise WrongError(f"an error that does not say what was found and what is allowed: {says}")
    if error.line is None and not error.field:
        raise WrongError(f"an error without a place: {says}")
    check_words(says.replace(str(error.found), ""))
    if not str(error.found).strip() or not str(error.allowed).strip():
        raise WrongError(f"an error with an empty part: {says!r}")


def check_words(says: str) -> None:
    if NOT_FOR_READERS.search(says) or "\n" in says:
        raise WrongError(f"an error that is not for readers: {says!r}")
    if len(says) > LONGEST_TEXT:
        raise WrongError(f"an error of {len(says)} characters: {says[:300]}")


def check_description(simulation: kingpost.Simulation) -> None:
    json.dumps(simulation.scenario.model)
    names = [channel["variable"] for channel in simulation.channels]
    if len(names) != len(set(names)):
        raise WrongError(f"variables of one name: {names}")
    columns = [column for channel in simulation.channels for column in channel.get("columns", [])]
    if len(columns) != len(set(columns)):
        raise WrongError("columns of one name")
    for value in simulation.inputs.values():
        if not np.isfinite(value.value):
            raise WrongError(f"an input that is no number: {value}")


def check_numbers(simulation: kingpost.Simulation, when: str) -> None:
    row = simulation.row()
    if not np.isfinite(row).all():
        bad = [
            channel["variable"]
            for channel in simulation.channels
            if not np.isfinite(row[channel["offset"] : channel["offset"] + channel["len"]]).all()
        ]
        raise WrongError(f"no numbers {when} in {', '.join(bad)}")
    if not np.isfinite(simulation.poses()).all():
        raise WrongError(f"no numbers {when} in the poses")
    for line in simulation.lines():
        if not np.isfinite(line.points_m).all():
            raise WrongError(f"no numbers {when} in the drawing of {line.name}")


def check_motion(simulation: kingpost.Simulation) -> None:
    """Steps that do not fail leave positions and rates that are numbers; rows are looked at in a run."""
    state = simulation.state
    if not (
        np.isfinite(state.q).all() and np.isfinite(state.v).all() and np.isfinite(simulation.poses()).all()
    ):
        raise WrongError(f"no numbers in the motion at {simulation.time_s} s")


def check_steps(simulation: kingpost.Simulation) -> str:
    """Steps one by one, a snapshot between; why they end early, if they do."""
    began = time.process_time()
    try:
        for _ in range(STEPS):
            simulation.step()
            if time.process_time() - began > LONGEST_STEPS_S:
                check_motion(simulation)
                return ""
        check_motion(simulation)
        snapshot = simulation.snapshot()
        simulation.step(STEPS)
    except kingpost.RunError as error:
        check_end(error)
        check_motion(simulation)
        return str(error)
    check_motion(simulation)
    there = simulation.row()
    simulation.restore(snapshot)
    simulation.step(STEPS)
    if not same(there, simulation.row()):
        raise WrongError("a run resumed from a snapshot has other numbers")
    return ""


def check_end(error: kingpost.RunError) -> None:
    check_words(str(error))
    if error.time_s is None or not np.isfinite(error.time_s) or len(str(error)) < 20:
        raise WrongError(f"a run that ends without time or reason: {error}")


def check_the_rest(simulation: kingpost.Simulation, text: str) -> str:
    """Check hydrostatics, equilibrium and linearisation, as requested by the app."""
    says = ""
    for ask in (simulation.hydrostatics, simulation.settle, simulation.linearize, simulation.mass_matrix):
        try:
            ask()
        except kingpost.KingpostError as error:
            says = str(error)
            check_words(says)
            if len(says) < 20:
                raise WrongError(f"an error that says nothing: {says!r}") from None
    simulation.reset()
    return says


def check_run(simulation: kingpost.Simulation, longest_run_s: float) -> str:
    began = time.process_time()

    def progress(_: float) -> None:
        if time.process_time() - began > longest_run_s:
            raise StoppedError

    why = ""
    try:
        results = simulation.run(progress)
    except kingpost.RunError as error:
        check_end(error)
        results, why = error.results, f"ended early: {error}"
    except StoppedError as error:
        results, why = error.results, "stopped"  # type: ignore[attr-defined]
    for name, variable in results.variables.items():
        if "time" in variable.dims and variable.dtype.kind == "f" and not np.isfinite(variable.values).all():
            raise WrongError(f"no numbers in the results: {name} ({results.attrs['status']})")
    for kind, found in json.loads(entries.as_json(results)).items():
        for entry in found:
            if re.search(r"\bnan\b|\binf\b|NaN", json.dumps(entry)):
                raise WrongError(f"no number in {kind}: {entry}")
    if not has_entries(results):
        raise WrongError("events, warnings or limits of another form than a file may have")
    return why


def same(a: np.ndarray, b: np.ndarray) -> bool:
    return a.tobytes() == b.tobytes()


if __name__ == "__main__":
    # The scenario in a file, as `python lift_outcomes.py case.yaml`.
    path = Path(sys.argv[1])
    print(outcome(path.read_text(encoding="utf-8"), str(path), thorough=True))
