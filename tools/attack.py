"""Fuzzing with wrong inputs of every kind, for a given time: `python tools/attack.py --minutes 60`.

The generators and the contract are those of `python/tests/fuzz`. The first case of each kind of violation is
saved with a description. The tests replay cases in `python/tests/fuzz/corpus/KIND`. Exit code 1 if there was
any violation.
"""

from __future__ import annotations

import argparse
import importlib
import os
import random
import re
import sys
import time
from dataclasses import dataclass, field
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path[:0] = [str(ROOT / "python" / "tests"), str(ROOT / "python")]
os.environ.setdefault("OMP_NUM_THREADS", "1")

from fuzz.apart import Apart, Verdict  # noqa: E402
from fuzz.contract import Case  # noqa: E402
from fuzz.corpus import save  # noqa: E402

TURN_S = 15.0
"""Wall-clock time for one kind before the next one, s."""
SHARES = {
    "scenario_text": 3.0,
    "command_line": 1.0,
    "databases": 1.0,
    "rao_tables": 1.0,
    "records": 1.0,
    "meshes": 1.0,
    "netcdf": 1.0,
    "foreign": 1.0,
    "requests": 2.0,
}
"""Number of turns of each kind, by the expected number of failures."""
VARIES = re.compile(r"/tmp/\S+|\d+|'[^']*'|\"[^\"]*\"")


@dataclass
class Tally:
    """Outcome of the cases of a kind."""

    inputs: int = 0
    refused: int = 0
    wrong: int = 0
    seconds: float = 0.0
    slowest_s: float = 0.0
    peak_bytes: int = 0
    distinct: set[int] = field(default_factory=set)
    failures: dict[str, tuple[int, Path]] = field(default_factory=dict)

    def add(self, case: Case, verdict: Verdict, folder: Path) -> None:
        """Count a case, and save it if it is the first with its failure."""
        self.inputs += 1
        self.distinct.add(hash((case.arguments, tuple(case.files.items()))))
        self.refused += verdict.says.startswith(("refused", "exit 2", "answered 4"))
        self.slowest_s = max(self.slowest_s, verdict.processor_s)
        self.peak_bytes = max(self.peak_bytes, verdict.peak_bytes)
        if not verdict.is_wrong:
            return
        self.wrong += 1
        alike = VARIES.sub("#", verdict.says)[:90]
        times, path = self.failures.get(alike) or (0, save(case, folder, verdict.says))
        self.failures[alike] = (times + 1, path)

    def row(self, kind: str) -> str:
        """Row of the table."""
        taken = self.inputs - self.refused - self.wrong
        return (
            f"{kind:15}{self.inputs:9}{len(self.distinct):10}{self.refused:9}{taken:9}{self.wrong:7}"
            f"{self.slowest_s:10.2f}{self.peak_bytes / 1e6:9.0f}{self.seconds:8.0f}"
        )


HEADS = f"{'kind':15}{'inputs':>9}{'distinct':>10}{'refused':>9}{'taken':>9}{'wrong':>7}" + (
    f"{'slowest s':>10}{'peak MB':>9}{'took s':>8}"
)


def attack(kinds: list[str], minutes: float, seed: int, folder: Path) -> dict[str, Tally]:
    """Run cases of all kinds in turn until the time is over."""
    tallies = {kind: Tally() for kind in kinds}
    ends, apart = time.monotonic() + 60 * minutes, Apart()
    while time.monotonic() < ends:
        for kind in kinds:
            until = min(time.monotonic() + TURN_S * SHARES[kind], ends)
            _turn(kind, tallies[kind], apart, until, seed, folder)
            print(tallies[kind].row(kind), flush=True)
    apart.end()
    return tallies


def _turn(kind: str, tally: Tally, apart: Apart, until: float, seed: int, folder: Path) -> None:
    drawn = importlib.import_module(f"fuzz.kinds.{kind}").drawn
    began = time.monotonic()
    while time.monotonic() < until:
        case = drawn(random.Random(f"{seed}.{kind}.{tally.inputs}"))
        tally.add(case, apart.ask(case), folder)
    tally.seconds += time.monotonic() - began


def main() -> int:
    """Run the cases and print the results."""
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    options.add_argument("--minutes", type=float, default=60.0)
    options.add_argument("--kinds", nargs="+", choices=SHARES, default=list(SHARES))
    options.add_argument("--seed", type=int, default=1, help="another seed draws other cases")
    options.add_argument(
        "--keep", type=Path, default=ROOT / "target" / "attack", help="folder of the failures"
    )
    given = options.parse_args()
    print(HEADS)
    tallies = attack(given.kinds, given.minutes, given.seed, given.keep)
    print(f"\n{HEADS}")
    for kind, tally in tallies.items():
        print(tally.row(kind))
    print(f"\n{sum(tally.inputs for tally in tallies.values())} inputs")
    for tally in tallies.values():
        for alike, (times, path) in sorted(tally.failures.items(), key=lambda found: -found[1][0]):
            print(f"{times:6}  {path}  {alike}")
    return 1 if any(tally.wrong for tally in tallies.values()) else 0


if __name__ == "__main__":
    sys.exit(main())
