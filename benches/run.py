"""Kingpost beside Pinocchio and MuJoCo: forward dynamics and one RK4 step of the paper's model.

Prints ``engine|model|operation|median_ns|instructions``, a line for each; lines that start with ``#`` are
for people. See README.md beside this file.
"""

from __future__ import annotations

import argparse
import datetime
import importlib.metadata
import platform
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator, Sequence
from pathlib import Path

import engines as programs
import measure
import models
from measure import Figure

README = Path(__file__).resolve().parent / "README.md"
TABLE_START, TABLE_END = "<!-- table: start -->", "<!-- table: end -->"


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
        for pair, operation, difference in measure.agreement(found):
            lines.add(f"# agreement: {pair}, {operation}: {difference:.1e} of the largest entry")
        figures = measure.figures(found, measure.QUICK if options.quick else measure.FULL)
    for figure in figures:
        lines.add(_line(figure))
    for line in ratios(figures):
        lines.add(f"# {line}")
    lines.write()
    if options.readme:
        write_readme(figures)
    return 0


def _parser() -> argparse.ArgumentParser:
    """The command line."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("-o", "--output", type=Path, help="also write the lines to this file")
    parser.add_argument("--quick", action="store_true", help="a few seconds: does it run, not how fast")
    parser.add_argument("--readme", action="store_true", help="write the table into README.md")
    names = ",".join(programs.BUILDERS)
    parser.add_argument("--engines", default=names, help="comma-separated (default: %(default)s)")
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
    """The engines that can be measured here; a line says why another is left out."""
    case = models.make_case()
    found = []
    for name in options.engines.split(","):
        if name not in programs.BUILDERS:
            raise SystemExit(f"unknown engine {name!r}, known: {', '.join(programs.BUILDERS)}")
        try:
            engine = programs.BUILDERS[name](case, folder, options.quick)
        except programs.NotHereError as reason:
            lines.add(f"# skipped: {name}: {reason}")
            continue
        lines.add(f"# engine: {name}: {engine.version}")
        found.append(engine)
    return found


def _line(figure: Figure) -> str:
    """One figure as a script reads it."""
    count = "-" if figure.instructions is None else f"{figure.instructions:.0f}"
    return f"{figure.engine}|{models.MODEL}|{figure.operation}|{figure.median_ns:.1f}|{count}"


def describe() -> Iterator[str]:
    """Comment lines: date, machine, compilers and flags."""
    yield f"# date: {datetime.datetime.now(datetime.UTC).date().isoformat()}"
    yield f"# machine: {machine()}"
    for tool in ("rustc", "g++", "valgrind"):
        yield f"# {tool}: {_version(tool)}"
    yield f"# peers: g++ {' '.join(programs.FLAGS)}, no -march, as Kingpost is built without"
    yield "# engine|model|operation|median_ns|instructions"


def machine() -> str:
    """The machine's kind: processor, cores, system."""
    name = platform.processor() or platform.machine()
    information = Path("/proc/cpuinfo")
    if information.exists():
        lines = [line for line in information.read_text().splitlines() if line.startswith("model name")]
        name = lines[0].partition(":")[2].strip() if lines else name
    return f"{name}, {platform.machine()}, {platform.system()}"


def _version(tool: str) -> str:
    """First line of ``tool --version``, or a word where it is absent."""
    if shutil.which(tool) is None:
        return "absent"
    done = subprocess.run([tool, "--version"], capture_output=True, text=True, check=False)
    return done.stdout.splitlines()[0] if done.stdout else "unknown"


def ratios(figures: Sequence[Figure]) -> Iterator[str]:
    """Each of Kingpost's figures over each peer's for the same work."""
    for ours in figures:
        if not ours.engine.startswith("kingpost"):
            continue
        for peer in figures:
            same = ours.operation.removesuffix("_ledger") == peer.operation
            if not same or peer.engine.startswith("kingpost"):
                continue
            text = f"time {ours.median_ns / peer.median_ns:.2f}"
            if ours.instructions and peer.instructions:
                text += f", instructions {ours.instructions / peer.instructions:.2f}"
            yield f"ratio: {ours.engine} {ours.operation} / {peer.engine} {peer.operation}: {text}"


def table(figures: Sequence[Figure]) -> str:
    """The figures and ratios as Markdown."""
    head = f"{datetime.datetime.now(datetime.UTC).date().isoformat()}, {machine()}; "
    versions = [f"{name} {_package_version(name)}" for name in ("kingpost", "mujoco", "pin")]
    rows = [head + ", ".join(versions) + ", " + _version("g++") + ", " + _version("rustc") + ".", ""]
    rows += [
        "| engine | operation | median, ns | fastest tenth, ns | instructions |",
        "| --- | --- | --- | --- | --- |",
    ]
    for figure in figures:
        count = "-" if figure.instructions is None else f"{figure.instructions:,.0f}"
        cells = [figure.engine, figure.operation, f"{figure.median_ns:,.0f}", f"{figure.low_ns:,.0f}", count]
        rows.append(f"| {' | '.join(cells)} |")
    rows += ["", *(f"- {line.removeprefix('ratio: ')}" for line in ratios(figures))]
    return "\n".join(rows)


def _package_version(name: str) -> str:
    """Version of an installed package, or a word where it is absent."""
    try:
        return importlib.metadata.version(name)
    except importlib.metadata.PackageNotFoundError:
        return "absent"


def write_readme(figures: Sequence[Figure]) -> None:
    """Replaces the table in README.md."""
    before, _, rest = README.read_text().partition(TABLE_START)
    _, _, after = rest.partition(TABLE_END)
    README.write_text(f"{before}{TABLE_START}\n\n{table(figures)}\n\n{TABLE_END}{after}")


if __name__ == "__main__":
    sys.exit(main())
