"""Plan of a study: its scenario, cases, columns, units of work and fingerprint."""

from __future__ import annotations

import difflib
from collections.abc import Sequence
from dataclasses import dataclass
from fnmatch import fnmatchcase
from functools import cached_property
from itertools import islice
from math import inf

from ...engine import source_digest
from ...scenario import ParameterValue, Scenario
from ...simulation.batch import SEED
from ...simulation.records import Limit, LimitBounds
from ...simulation.simulate import Simulation
from ..reduce import Kept
from ..sea_states import scatter
from ..sea_states.quantities import quantities
from ..steps import Bounds
from . import fingerprint
from .cases import Cases, cases
from .content import Peaks, Rainflow
from .file import StudyFile
from .job import LANES, MOST_BYTES, Job, columns, run_bytes
from .parts import Parts, parts
from .trials import check_axes, check_corners

MOST_RUNS = 1_000_000
"""Largest number of runs of a study."""
MOST_UNITS, MOST_RUNS_OF_UNIT = 64, 32


@dataclass(frozen=True)
class Plan:
    """A study that is checked and ready to run.

    Attributes
    ----------
    file
        Content of the study file.
    scenario
        Scenario that all runs are based on.
    cases
        The points of the axes.
    columns
        Columns that have statistics, with their units.
    limits
        Limits that are evaluated: name, column, unit, at_least, at_most.
    kept
        Quantities that are kept of each run.
    run_bytes
        Memory of the rows of a run, bytes.
    parts
        Parts of a run that happen once, and stationary ones.
    """

    file: StudyFile
    scenario: Scenario
    cases: Cases
    columns: dict[str, str]
    limits: list[Limit]
    kept: Kept
    run_bytes: float
    parts: Parts

    @cached_property
    def seeds(self) -> list[int]:
        """The seeds of every case."""
        seeds = self.file.content["seeds"]
        return list(range(seeds["first"], seeds["first"] + seeds["count"]))

    @property
    def runs(self) -> int:
        """Number of runs."""
        return self.cases.count * len(self.seeds)

    @cached_property
    def runs_of_unit(self) -> int:
        """Number of runs of a unit, which are computed, written and resumed together: a multiple of the
        number of SIMD lanes, small enough for many workers. It depends only on the number of runs."""
        wanted = -(-self.runs // MOST_UNITS)
        return min(MOST_RUNS_OF_UNIT, max(1, -(-wanted // LANES)) * LANES)

    @property
    def units(self) -> int:
        """Number of units."""
        return -(-self.runs // self.runs_of_unit)

    def runs_in(self, unit: int) -> range:
        """The runs of a unit."""
        first = unit * self.runs_of_unit
        return range(first, min(first + self.runs_of_unit, self.runs))

    def job(self, unit: int) -> Job:
        """Return the job of a worker for a unit."""
        base = list(self.scenario.overrides)
        variants = [[*base, *self.overrides(run)] for run in self.runs_in(unit)]
        scenario = self.scenario
        return Job(unit, scenario.text, scenario.file, scenario.files, variants, self.kept, self.run_bytes)

    def overrides(self, run: int) -> list[tuple[str, ParameterValue]]:
        """Return the overrides of the scenario in a run."""
        case, seed = divmod(run, len(self.seeds))
        return [*self.cases.overrides(case), (SEED, self.seeds[seed])]

    @cached_property
    def depends_on(self) -> dict[str, str]:
        """Digests of everything that determines the numbers, by part."""
        kept = self.kept
        recorded = [kept.columns, kept.peaks, kept.keep, kept.cycles, kept.slopes, kept.after_s]
        parts = {
            "scenario": self.scenario.resolved,
            "files": self.scenario.digests,
            "axes": [[name, self.cases.values[name]] for name in self.cases.names],
            "seeds": self.seeds,
            "what is recorded": recorded,
            "units": self.runs_of_unit,
        }
        digests = {name: fingerprint.of_value(value) for name, value in parts.items()}
        return {**digests, "engine": source_digest(), "reduction": fingerprint.reduction()}

    @cached_property
    def fingerprint(self) -> str:
        """SHA-256 of everything that determines the numbers."""
        return fingerprint.of_value(self.depends_on)

    @cached_property
    def sea(self) -> dict[str, str]:
        """Axis of each quantity of the sea: as stated by the study, otherwise by the fields that the axes
        set."""
        writes = {one["name"]: one["writes"] for one in self.scenario.resolved.get("parameters", [])}
        found = quantities({name: writes.get(name, [name]) for name in self.cases.names})
        return found | self.file.content["sea"]


def plan(file: StudyFile) -> Plan:
    """Check a study and plan its runs. The scenario is built with every value of each axis and at the corners
    of all axes. A case in between that gives no valid scenario gets the status ``not_built``; the others run.

    Raises
    ------
    ScenarioError
        With the place of the wrong value in the study.
    """
    scenario = file.scenario()
    simulation = Simulation(scenario)
    known = columns(simulation.channels)
    limits = simulation.limits
    of_parts = parts(file, scenario.resolved)
    kept = _kept(file, known, simulation, of_parts)
    size = run_bytes(scenario.resolved["simulation"], simulation.channels)
    _check_length(file, scenario, size)
    check_axes(file, scenario)
    units = {name: known[name] for name in kept.columns}
    found = Plan(file, scenario, _cases(file), units, limits, kept, size, of_parts)
    if not 1 <= found.runs <= MOST_RUNS:
        raise file.error("axes", f"{found.runs} runs", f"from 1 to {MOST_RUNS} runs")
    check_corners(file, scenario, found.cases)
    if name := file.content.get("scatter"):
        # Check before hours of runs, not after them.
        scatter.read(file.beside(name))
    return found


def _cases(file: StudyFile) -> Cases:
    content = file.content

    def cells() -> list[tuple[float, float]]:
        return scatter.read(file.beside(content["scatter"])).cells()

    return cases(content["axes"], content.get("samples"), cells)


def _kept(file: StudyFile, known: dict[str, str], simulation: Simulation, of_parts: Parts) -> Kept:
    content, limits = file.content, simulation.limits
    rainflow = content.get("rainflow", Rainflow(columns=[], slopes=[]))
    peaks = content.get("peaks", Peaks(columns=[], keep=0))
    recorded = _matching(file, "record", content["record"], known)
    with_peaks = _matching(file, "peaks.columns", peaks["columns"], known)
    with_cycles = _matching(file, "rainflow.columns", rainflow["columns"], known)
    wanted = {limit.column for limit in limits}.union(recorded, with_peaks, with_cycles)
    names = tuple(name for name in known if name in wanted)
    if not names:
        raise file.error("record", "no column and no limit", "columns, as hull.roll, or limits")
    return Kept(
        names,
        tuple(limit.name for limit in limits),
        content["after_s"],
        tuple(names.index(name) for name in names if name in with_peaks),
        peaks["keep"],
        tuple(names.index(name) for name in names if name in with_cycles),
        tuple(float(slope) for slope in rainflow["slopes"]),
        of_parts.steps,
        tuple(_bounds(file, simulation, names, one) for one in simulation.limit_bounds),
    )


def _bounds(file: StudyFile, simulation: Simulation, names: Sequence[str], limit: LimitBounds) -> Bounds:
    known = next(one for one in simulation.scenario.model["limits"] if one["name"] == limit.name)
    until_s = inf if known["until_s"] is None else float(known["until_s"])
    steps = tuple(int(step) for step in known["steps"])
    from_s = max(float(known["from_s"]), file.content["after_s"])
    least = -inf if limit.at_least is None else limit.at_least
    most = inf if limit.at_most is None else limit.at_most
    unit_si = float(known["unit_si"])
    return Bounds(names.index(limit.column), least, most, unit_si, from_s, until_s, steps, limit.percentile)


def _matching(file: StudyFile, field: str, patterns: Sequence[str], known: dict[str, str]) -> set[str]:
    found: set[str] = set()
    for k, pattern in enumerate(patterns):
        names = [name for name in known if fnmatchcase(name, pattern)]
        if not names:
            near = difflib.get_close_matches(pattern, known, n=3) or list(islice(known, 3))
            raise file.error(f"{field}.{k}", f"{pattern!r}", f"a column of the run, as {', '.join(near)}")
        found.update(names)
    return found


def _check_length(file: StudyFile, scenario: Scenario, size: float) -> None:
    settings, after_s = scenario.resolved["simulation"], file.content["after_s"]
    step_s = max(settings["record_every_s"], settings["step_s"])
    if after_s > settings["duration_s"] - step_s:
        allowed = f"before the last records of a run, which lasts {settings['duration_s']:g} s"
        raise file.error("after_s", f"{after_s:g}", allowed)
    if size > MOST_BYTES:
        allowed = f"at most {MOST_BYTES / 1e9:g} GB: record less often (set: simulation.record_every_s)"
        raise file.error("set", f"{size / 1e9:.1f} GB of rows in a run", allowed)
