"""Work and error of lines with mass beside MoorDyn: a steel wire with a load, a chain on the bottom; a moored
ship.

Prints ``engine|model|parts|step_ms|us_per_simulated_s|times_real_time|error|error_by_moordyn``; lines that
start with ``#`` are for people. An error is the root mean square of the difference of the tension at the
upper end from a refined run, as a share of that run's standard deviation: from Kingpost's, and from
MoorDyn's, which is stored for ``kingpost verify --only lines``. Parts are Kingpost's elements, which have two
nodes each, or MoorDyn's segments.

Times are processor time on one core, the least of some. MoorDyn's are of runs with a call every 50 ms, so
that they are those of its own steps; its errors are of runs with a call for each step, because it
extrapolates its fairlead within a call. Its step is the longest one, of a series by a factor of 1.1, with
which a run is stable: the force is within 2 % of its standard deviation from that with a much shorter step.
"""

from __future__ import annotations

import argparse
import datetime
import importlib.metadata
import math
import sys
import tempfile
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import report
import run as benches
from kingpost.scenario import Scenario
from kingpost.simulation.simulate import Simulation
from kingpost.simulation.simulate import run as simulated
from kingpost.verify import lines as verified
from peers import fairleads

EVERY_S = 0.25
"""Interval of the stored tensions."""
CALL_S = 0.05
"""Interval of MoorDyn's calls where its time is measured."""
PARTS = 20
"""Repetitions of a measured time."""
UNSTABLE = 0.02
"""Difference of the force with a step that counts as unstable, as a share of the standard deviation."""


@dataclass(frozen=True)
class Case:
    """A line and its motion, and how each engine divides it.

    Attributes
    ----------
    line, motion
        Names in `lines.json`.
    build
        Kingpost's scenario, for a motion and a number of elements.
    elements, steps_s
        Kingpost's elements and steps.
    refined
        Elements and step of its refined run.
    segments
        MoorDyn's segments.
    timed_s
        Simulated time that is measured, after one as long.
    """

    line: str
    motion: str
    build: Callable[[str, int], Scenario]
    elements: tuple[int, ...]
    steps_s: tuple[float, ...]
    refined: tuple[int, float]
    segments: tuple[int, ...]
    timed_s: float = 40.0

    @property
    def kept(self) -> dict[str, Any]:
        """The motion, and MoorDyn's stored runs."""
        return verified.kept()[self.line][self.motion]

    def error(self, found: np.ndarray, refined: np.ndarray) -> float:
        """Root mean square of the difference of two tensions where they are compared, as a share of the
        standard deviation."""
        late = slice(round(self.kept["from_s"] / EVERY_S), None)
        one, other = found[late], refined[late]
        return float(np.sqrt(np.mean((one - other) ** 2)) / other.std())


CASES = (
    Case("wire", "half", verified.wire, (4, 6, 8), (0.05, 0.025), (40, 0.005), (20, 40)),
    Case("chain", "small", verified.chain, (10, 20, 40, 60), (0.05, 0.025), (160, 0.0125), (20, 40, 80)),
)
QUICK = (Case("wire", "half", verified.wire, (2,), (0.05,), (4, 0.05), (4,), 2.0),)


class Figure(NamedTuple):
    """A measured run: time for a simulated second, s, and errors."""

    engine: str
    model: str
    parts: int
    step_s: float
    time_s: float
    error: float
    error_by_moordyn: float

    def __str__(self) -> str:
        times = f"{1e6 * self.time_s:.0f}|{1 / self.time_s:.1f}"
        errors = f"{self.error:.1e}|{self.error_by_moordyn:.1e}"
        return f"{self.engine}|{self.model}|{self.parts}|{1e3 * self.step_s:.3g}|{times}|{errors}"


def paced(scenario: Scenario, step_s: float) -> Scenario:
    """The scenario with another step, and records as often as the stored tensions."""
    return scenario.with_overrides({"simulation.step_s": step_s, "simulation.record_every_s": EVERY_S})


def tensions(case: Case, elements: int, step_s: float) -> np.ndarray:
    """Kingpost's tensions at the times of the stored ones, N."""
    found = simulated(paced(case.build(case.motion, elements), step_s))
    return found["line_tension"].sel(line="line").values


def pace(scenario: Scenario, step_s: float, timed_s: float) -> float:
    """Processor time of Kingpost for a simulated second, s: the least one of parts of a time."""
    simulation = Simulation(scenario)
    simulation.step(round(timed_s / step_s))
    count = max(round(timed_s / PARTS / step_s), 1)
    used = []
    for _ in range(PARTS):
        begun = time.process_time()
        simulation.step(count)
        used.append(time.process_time() - begun)
    return min(used) / (count * step_s)


def kingpost(case: Case, refined: np.ndarray) -> Iterator[Figure]:
    """Measures Kingpost on a case."""
    theirs = np.array(case.kept["segments"][verified.FINEST[case.line]]["tension_N"])
    for elements in case.elements:
        for step_s in case.steps_s:
            found = tensions(case, elements, step_s)
            used = pace(paced(case.build(case.motion, elements), step_s), step_s, case.timed_s)
            errors = case.error(found, refined), case.error(found, theirs)
            yield Figure("kingpost", case.line, elements, step_s, used, *errors)


class MoorDyn:
    """MoorDyn on a case, by the runs of the peer tests."""

    def __init__(self, case: Case) -> None:
        from peers import lines

        self.case, self.runs = case, lines
        self.folder = tempfile.TemporaryDirectory()
        self.states: dict[int, str] = {}
        self.line, self.motion = lines.LINES[case.line], lines.MOTIONS[f"{case.line}-{case.motion}"]

    def places(self, t: np.ndarray) -> np.ndarray:
        """Positions of the fairlead, m."""
        return self.runs.place(self.motion, self.line["fairlead_m"], t)

    def state(self, segments: int) -> str:
        """File of the line at rest, which takes MoorDyn longer than the run."""
        if segments not in self.states:
            known = self.runs.AT_REST[self.case.line]
            relaxed = known[min((one for one in known if one >= segments), default=max(known))]
            folder = Path(self.folder.name) / str(segments)
            folder.mkdir()
            self.states[segments] = self.runs.rest(self.line, segments, relaxed, str(folder))
        return self.states[segments]

    def advance(self, segments: int, step_s: float, until_s: float) -> tuple[np.ndarray, np.ndarray]:
        """Run with coarse calls; returns the force at the fairlead, N, and the processor time, s, of each
        second."""
        moordyn, line, state = self.runs.moordyn, self.line, self.state(segments)
        damping = line["axial_stiffness_N"] * line["damping_time_s"]
        forces, used = [], []
        with (
            tempfile.TemporaryDirectory() as folder,
            self.runs._system(self.runs.deck(line, segments, step_s, damping), folder) as system,
        ):
            moordyn.SetVerbosity(system, moordyn.LEVEL_NONE)
            moordyn.Init_NoIC(system, line["fairlead_m"], [0.0, 0.0, 0.0])
            moordyn.LoadState(system, state)
            for second in range(math.ceil(until_s)):
                t = second + CALL_S * np.arange(round(1 / CALL_S) + 1)
                x = self.places(t)
                v = np.diff(x, axis=0) / CALL_S
                begun = time.process_time()
                for at, to, now in zip(x.tolist(), v.tolist(), t.tolist(), strict=False):
                    force = moordyn.Step(system, at, to, now, CALL_S)
                used.append(time.process_time() - begun)
                forces.append(np.linalg.norm(force))
        return np.array(forces), np.array(used)

    def longest_step(self, segments: int) -> float:
        """The longest stable step, s: first, half more than the limit of a scheme of second order for the
        shortest wave of the segments is tried."""
        stiffness, mass = self.line["axial_stiffness_N"], self.line["mass_kg_per_m"]
        omega = 2 * segments / self.line["unstretched_length_m"] * math.sqrt(stiffness / mass)
        bound = 1.5 * min(2 / omega, 2 / (self.line["damping_time_s"] * omega**2))
        limit = UNSTABLE * self.case.kept["segments"][verified.FINEST[self.case.line]]["std_N"]
        count = math.ceil(CALL_S / bound)
        finer, _ = self.advance(segments, bound / 6, self.case.timed_s)
        while True:
            try:
                coarse, _ = self.advance(segments, CALL_S / count, self.case.timed_s)
                if np.sqrt(np.mean((coarse - finer) ** 2)) < limit:
                    return CALL_S / count
            except RuntimeError:
                pass
            count = math.ceil(1.1 * count)

    def figures(self, refined: np.ndarray) -> Iterator[Figure]:
        """Measures MoorDyn."""
        case, apart = self.case, round(EVERY_S / self.runs.EVERY_S)
        theirs = np.array(case.kept["segments"][verified.FINEST[case.line]]["tension_N"])
        for segments in case.segments:
            with self.runs._quiet():
                step_s = self.longest_step(segments)
                _, used = self.advance(segments, step_s, 2 * case.timed_s)
            start = step_s, self.state(segments)
            whole = self.runs.moved(self.line, segments, start, self.places, case.kept["duration_s"])
            found = whole[::apart]
            errors = case.error(found, refined), case.error(found, theirs)
            yield Figure("moordyn", case.line, segments, step_s, used[round(case.timed_s) :].min(), *errors)


def ratios(figures: Sequence[Figure]) -> Iterator[str]:
    """Ratio of the times of each of MoorDyn's runs and of Kingpost's fastest one with no larger error."""
    for peer in (one for one in figures if one.engine == "moordyn"):
        same = [one for one in figures if (one.engine, one.model) == ("kingpost", peer.model)]
        good = [one for one in same if one.error <= peer.error]
        name = f"moordyn {peer.model} {peer.parts}"
        if not good:
            yield f"{name}: none of kingpost's has as small an error"
            continue
        fastest = min(good, key=lambda one: one.time_s)
        yield (
            f"kingpost {fastest.model} {fastest.parts} at {1e3 * fastest.step_s:g} ms / {name}: "
            f"time {fastest.time_s / peer.time_s:.3f}, error {fastest.error / peer.error:.2f}"
        )


def ship(quick: bool) -> dict[str, float]:
    """Processor time for a simulated second, s, of the moored ship on four lines of 20 elements, and on the
    gallery's massless ones."""
    scenarios = {"lines": fairleads.moored(2.5), "catenaries": fairleads.massless()}
    return {name: pace(one, CALL_S, 1.0 if quick else 20.0) for name, one in scenarios.items()}


def head() -> str:
    """Date, machine and versions."""
    found = []
    for name in ("kingpost", "moordyn"):
        try:
            found.append(f"{name} {importlib.metadata.version(name)}")
        except importlib.metadata.PackageNotFoundError:
            found.append(f"{name} absent")
    today = datetime.datetime.now(datetime.UTC).date().isoformat()
    return f"{today}, {benches.machine()}; {', '.join(found)}."


def table(figures: Sequence[Figure], ships: dict[str, float]) -> str:
    """The figures and ratios as Markdown."""
    title = (
        "| line | engine | parts | step, ms | us for a second | times real time | error | from MoorDyn's |"
    )
    rows = [
        f"| {one.model} | {one.engine} | " + " | ".join(str(one).split("|")[2:]) + " |" for one in figures
    ]
    afloat = [
        f"moored ship, {name}: {1e6 * used:,.0f} us for a second, {1 / used:.0f} times real time"
        for name, used in ships.items()
    ]
    notes = [f"- {one}" for one in (*ratios(figures), *afloat)]
    return "\n".join([head(), "", title, "| --- " * 8 + "|", *rows, "", *notes])


def main(arguments: Sequence[str] | None = None) -> int:
    """Runs the command line and returns its exit code."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("--quick", action="store_true", help="run for a few seconds, only as a test")
    parser.add_argument("--readme", action="store_true", help="write the measured figures into README.md")
    parser.add_argument("--models", default="wire,chain,ship", help="comma-separated (default: %(default)s)")
    options = parser.parse_args(arguments)
    chosen = options.models.split(",")
    print(f"# {head()}")
    figures: list[Figure] = []

    def add(found: Iterator[Figure]) -> None:
        for one in found:
            figures.append(one)
            print(one, flush=True)

    for case in (one for one in (QUICK if options.quick else CASES) if one.line in chosen):
        refined = tensions(case, *case.refined)
        theirs = np.array(case.kept["segments"][verified.FINEST[case.line]]["tension_N"])
        print(f"# refined runs of the {case.line} differ by {case.error(theirs, refined):.1e}", flush=True)
        add(kingpost(case, refined))
        try:
            peer = MoorDyn(case)
        except ImportError:
            print("# skipped: moordyn is not installed")
            continue
        add(peer.figures(refined))
    for line in ratios(figures):
        print(f"# ratio: {line}")
    ships = ship(options.quick) if "ship" in chosen else {}
    for name, used in ships.items():
        print(f"kingpost|moored_ship_{name}|20|{1e3 * CALL_S:g}|{1e6 * used:.0f}|{1 / used:.1f}|-|-")
    if options.readme:
        report.write_readme({"lines": table(figures, ships)})
    return 0


if __name__ == "__main__":
    sys.exit(main())
