"""Benchmarks of Kingpost against Pinocchio, MuJoCo and Exudyn: the paper's model, chains, many runs, a lift;
a floating ship.

Prints ``engine|model|operation|median_ns|instructions``, a line for each; lines that start with ``#`` are
for people. See README.md beside this file.
"""

from __future__ import annotations

import argparse
import datetime
import importlib.metadata
import json
import platform
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Collection, Iterator, Sequence
from pathlib import Path

import engines as programs
import measure
import models
import report
from measure import Figure


def main(arguments: Sequence[str] | None = None) -> int:
    """Runs the command line and returns its exit code."""
    options = _parser().parse_args(arguments)
    lines = _Lines(options.output)
    with tempfile.TemporaryDirectory() as folder:
        for line in describe():
            lines.add(line)
        found = _engines(options, Path(folder), lines)
        if not found:
            print("no engine can be measured here", file=sys.stderr)
            return 1
        if options.counts:
            options.counts.write_text(json.dumps(measure.counts(found), indent=2) + "\n")
            return 0
        for pair, operation, difference in measure.agreement(found):
            lines.add(f"# agreement: {pair}, {operation}: {difference:.1e} of the largest entry")
        figures = measure.figures(found, measure.QUICK if options.quick else measure.FULL)
    for figure in figures:
        lines.add(_line(figure))
    for line in report.ratios(figures):
        lines.add(f"# ratio: {line}")
    for line in report.speeds(figures):
        lines.add(f"# speed: {line}")
    for line in report.growth(figures):
        lines.add(f"# growth: {line}")
    lines.write()
    if options.readme:
        report.write_readme(report.tables(figures, versions()))
    return 0


def _parser() -> argparse.ArgumentParser:
    """The command line."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("-o", "--output", type=Path, help="also write the lines to this file")
    parser.add_argument("--quick", action="store_true", help="run for a few seconds, only as a test")
    parser.add_argument("--readme", action="store_true", help="write the measured figures into README.md")
    parser.add_argument(
        "--counts", type=Path, metavar="FILE", help="only write Kingpost's instruction counts to this file"
    )
    names = ",".join(programs.BUILDERS)
    parser.add_argument("--engines", default=names, help="comma-separated (default: %(default)s)")
    parser.add_argument("--models", help=f"comma-separated (default: {','.join(models.CASES)})")
    return parser


class _Lines:
    """Lines printed as they come, and kept for the output file."""

    def __init__(self, output: Path | None) -> None:
        self.output = output
        self.kept: list[str] = []

    def add(self, line: str) -> None:
        self.kept.append(line)
        print(line, flush=True)

    def write(self) -> None:
        if self.output is not None:
            self.output.write_text("\n".join(self.kept) + "\n")


def _engines(options: argparse.Namespace, folder: Path, lines: _Lines) -> list[programs.Engine]:
    """Engines that can be measured here, on each model; prints the reason for each engine that is left
    out."""
    names = ["kingpost"] if options.counts else _known("engine", options.engines, programs.BUILDERS)
    left_out = [models.chain_name(links) for links in models.CHAIN_LINKS[1::2]] if options.quick else []
    usual = ",".join(name for name in models.CASES if name not in left_out)
    cases = _known("model", options.models or usual, models.CASES)
    found = []
    for case in (models.CASES[name]() for name in cases):
        for name in [name for name in names if programs.takes(name, case)]:
            try:
                engine = programs.BUILDERS[name](case, folder, options.quick)
            except programs.NotHereError as reason:
                lines.add(f"# skipped: {name}, {case.name}: {reason}")
                continue
            if all(name != engine.name for engine in found):
                lines.add(f"# engine: {name}: {engine.version}")
            found.append(engine)
    return found


def _known(what: str, given: str, known: Collection[str]) -> list[str]:
    """Splits names at commas; refuses unknown names."""
    names = given.split(",")
    unknown = [name for name in names if name not in known]
    if unknown:
        raise SystemExit(f"unknown {what} {unknown[0]!r}, known: {', '.join(known)}")
    return names


def _line(figure: Figure) -> str:
    """One figure as a script reads it."""
    count = "-" if figure.instructions is None else f"{figure.instructions:.0f}"
    return f"{figure.engine}|{figure.model}|{figure.operation}|{figure.median_ns:.1f}|{count}"


def describe() -> Iterator[str]:
    """Comment lines: date, machine, compilers and flags."""
    yield f"# date: {datetime.datetime.now(datetime.UTC).date().isoformat()}"
    yield f"# machine: {machine()}"
    for tool in ("rustc", "g++", "valgrind"):
        yield f"# {tool}: {_version(tool)}"
    yield f"# peers: g++ {' '.join(programs.FLAGS)}, no -march, as Kingpost is built without"
    yield "# engine|model|operation|median_ns|instructions"


def machine() -> str:
    """Description of the machine: processor, cores, system."""
    name = platform.processor() or platform.machine()
    information = Path("/proc/cpuinfo")
    if information.exists():
        lines = [line for line in information.read_text().splitlines() if line.startswith("model name")]
        name = lines[0].partition(":")[2].strip() if lines else name
    return f"{name}, {platform.machine()}, {platform.system()}"


def _version(tool: str) -> str:
    """First line of ``tool --version``, or a placeholder if the tool is absent."""
    if shutil.which(tool) is None:
        return "absent"
    done = subprocess.run([tool, "--version"], capture_output=True, text=True, check=False)
    return done.stdout.splitlines()[0] if done.stdout else "unknown"


def versions() -> str:
    """Machine, packages and compilers, for the head of the table."""
    packages = [f"{name} {_package_version(name)}" for name in ("kingpost", "mujoco", "pin", "exudyn")]
    return f"{machine()}; " + ", ".join([*packages, _version("g++"), _version("rustc")])


def _package_version(name: str) -> str:
    """Version of an installed package, or a placeholder if it is absent."""
    try:
        return importlib.metadata.version(name)
    except importlib.metadata.PackageNotFoundError:
        return "absent"


if __name__ == "__main__":
    sys.exit(main())
