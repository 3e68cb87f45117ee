"""Times, instruction counts and agreement of the benchmark programs."""

from __future__ import annotations

import os
import re
import shutil
import statistics
import subprocess
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

import numpy as np
from engines import Engine
from models import tree

# repetitions in a batch, on the paper's model: well under a millisecond, so that on a shared machine most
# batches run undisturbed
REPETITIONS = {
    "forward": 500,
    "euler_step": 400,
    "rk4_step": 100,
    "rk4_step_ledger": 100,
    "lanes_euler": 400,
    "lanes_rk4": 100,
}
# steps of all runs, for many at once
BATCH_STEPS = 1000
PAPER_VELOCITIES = 8
# Kingpost's and MuJoCo's Euler schemes are not the same one
COMPARED = ("forward", "rk4_step", "rk4_step_ledger")
CHECK_STEPS = 1000
COUNTED = (100, 1100)
# entries of the ship in q and v concatenated
ORIENTATION = slice(3, 7)


@dataclass(frozen=True)
class Effort:
    """How often to measure: rounds through all engines, and batches of each operation in a round.

    Many runs at once are measured in every third round, with ``long_batches``.
    """

    rounds: int
    batches: int
    long_batches: int


FULL = Effort(rounds=15, batches=100, long_batches=3)
QUICK = Effort(rounds=2, batches=3, long_batches=1)


@dataclass(frozen=True)
class Figure:
    """One operation of one engine: nanoseconds (median and tenth percentile) and instructions, if counted."""

    engine: str
    model: str
    operation: str
    median_ns: float
    low_ns: float
    instructions: float | None


def repetitions(engine: Engine, operation: str) -> int:
    """Repetitions in a batch, fewer for a larger model."""
    if operation.startswith("batch_"):
        return BATCH_STEPS
    return _fewer(engine, REPETITIONS[operation])


def _fewer(engine: Engine, count: int) -> int:
    """Scales a count for the paper's model to a larger one."""
    return max(1, count * PAPER_VELOCITIES // (engine.case.v.size * engine.case.weight))


def times(engines: Sequence[Engine], effort: Effort) -> dict[tuple[str, str, str], list[float]]:
    """Nanoseconds per operation in every batch; each round measures all engines once."""
    found: dict[tuple[str, str, str], list[float]] = {}
    for turn in range(effort.rounds):
        for engine in engines:
            for operation in engine.operations:
                many = operation.startswith("batch_")
                if many and turn % 3:
                    continue
                batches = effort.long_batches if many else effort.batches
                count = repetitions(engine, operation) // (10 if many and effort is QUICK else 1)
                arguments = [operation, "time", str(batches), str(count)]
                numbers = [float(line) for line in _lines(engine, arguments)]
                found.setdefault((engine.name, engine.case.name, operation), []).extend(numbers)
    return found


def instructions(engine: Engine, operation: str, effort: Effort) -> float | None:
    """Instructions of one operation: callgrind's difference between two repetition counts.

    A quick run counts only accelerations: callgrind takes a second to start for each operation.
    """
    if not engine.countable or operation.startswith("batch_") or shutil.which("valgrind") is None:
        return None
    if effort is QUICK and operation != "forward":
        return None
    few, many = (_fewer(engine, count) for count in COUNTED)
    first, second = (_collected(engine, operation, count) for count in (few, many))
    return None if first is None or second is None else (second - first) / (many - few)


def _collected(engine: Engine, operation: str, count: int) -> int | None:
    """Instructions of a whole process under callgrind; None if callgrind cannot run it."""
    tool = ["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null"]
    command = [*tool, *engine.command, operation, "count", str(count)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    match = re.search(r"Collected : (\d+)", done.stderr)
    return int(match[1]) if match and done.returncode == 0 else None


def counts(engines: Sequence[Engine]) -> dict[str, dict[str, int]]:
    """Instructions of every countable operation, by model and operation: independent of the machine's
    load."""
    rows = [(engine, operation) for engine in engines for operation in engine.operations]
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        counted = list(pool.map(lambda row: instructions(*row, FULL), rows))
    found: dict[str, dict[str, int]] = {}
    for (engine, operation), count in zip(rows, counted, strict=True):
        if count is not None:
            found.setdefault(engine.case.name, {})[operation] = round(count)
    return found


def figures(engines: Sequence[Engine], effort: Effort) -> list[Figure]:
    """All printed figures of all engines; instructions are counted on all cores, because counting does not
    need an idle machine."""
    measured = times(engines, effort)
    rows = [(engine, operation) for engine in engines for operation in engine.operations]
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        counts = list(pool.map(lambda row: instructions(*row, effort), rows))
    result = []
    for (engine, operation), counted in zip(rows, counts, strict=True):
        numbers = measured[engine.name, engine.case.name, operation]
        low, middle = float(np.quantile(numbers, 0.1)), statistics.median(numbers)
        result.append(Figure(engine.name, engine.case.name, operation, middle, low, counted))
    return result


def check_values(engine: Engine, operation: str) -> tree.Array:
    """The acceleration at the state, or q and v after 1,000 steps (fewer of a heavy case), in Kingpost's
    coordinates."""
    count = 1 if operation == "forward" else max(CHECK_STEPS // engine.case.weight, 1)
    values = np.array([float(line) for line in _lines(engine, [operation, "check", str(count)])])
    if operation == "forward":
        return engine.acceleration(values)
    state = engine.state(values)
    # a quaternion and its negative are one orientation
    state[ORIENTATION] *= np.copysign(1.0, state[ORIENTATION.start])
    return state


def agreement(engines: Sequence[Engine]) -> list[tuple[str, str, float]]:
    """Largest difference of every engine from the first, relative to the first's largest entry.

    Accelerations agree to rounding, steps to the difference in the engines' RK4 for rotations, WASM to the
    bit.
    """
    rows = []
    for case in dict.fromkeys(engine.case.name for engine in engines):
        for operation in COMPARED:
            able = _able([engine for engine in engines if engine.case.name == case], operation)
            results = [check_values(engine, own) for engine, own in able]
            for (engine, _), values in zip(able[1:], results[1:], strict=True):
                difference = np.abs(values - results[0]).max() / np.abs(results[0]).max()
                rows.append((f"{engine.name} - {able[0][0].name}, {case}", operation, float(difference)))
    return rows


def _able(engines: Sequence[Engine], operation: str) -> list[tuple[Engine, str]]:
    """Engines with an operation, and its name in each: for a lift Kingpost has only the step with its
    ledger."""
    if not any(operation in engine.operations for engine in engines):
        return []
    names = (operation, f"{operation}_ledger")
    own = [(engine, next((n for n in names if n in engine.operations), None)) for engine in engines]
    return [(engine, name) for engine, name in own if name is not None]


def _lines(engine: Engine, arguments: Sequence[str]) -> list[str]:
    """Lines printed by a program."""
    command = [*engine.command, *arguments]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode:
        raise RuntimeError(f"{engine.name} {' '.join(arguments)}: {done.stderr.strip()[-300:]}")
    return done.stdout.split()
