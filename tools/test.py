"""Runs every part's tests and sums them: the last line reads `N passed, N failed`.

A part whose tests fail, or which breaks before it has any, makes the exit code 1; the others still
run. `make test` calls this.
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
import time
from dataclasses import dataclass

MAKE = os.environ.get("MAKE", "make")
COLOUR = re.compile(r"\x1b\[[0-9;]*m")
COUNT = re.compile(r"(\d+) (passed|failed|errors?)\b")


@dataclass(frozen=True)
class Part:
    """One part: the make target that runs it, and the start of the lines that count its tests."""

    name: str
    target: str
    summary: str | None = None


PARTS = [
    Part("engine", "test-rust", summary=r"test result: "),
    Part("WASM", "wasm"),
    Part("web", "test-web", summary=r"\s+Tests  "),
    Part("browser", "test-browser", summary=r"browser: "),
    Part("Python", "test-python", summary=r"=+ .* in [\d.]+s"),
    Part("lint", "lint"),
]


@dataclass
class Result:
    """Result of one part."""

    passed: int = 0
    failed: int = 0
    seconds: float = 0.0

    def add(self, line: str) -> None:
        """Adds the counts that a runner's summary line gives."""
        for count, what in COUNT.findall(line):
            if what == "passed":
                self.passed += int(count)
            else:
                self.failed += int(count)


def run(part: Part) -> Result:
    """Runs a part and shows its output as it comes. A part that breaks counts as one failure."""
    result = Result()
    print(f"\n--- {part.name} ---", flush=True)
    start = time.monotonic()
    command = [MAKE, part.target]
    with subprocess.Popen(
        command,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        errors="replace",
    ) as process:
        for line in process.stdout or ():
            print(line, end="", flush=True)
            plain = COLOUR.sub("", line)
            if part.summary and re.match(part.summary, plain):
                result.add(plain)
    result.seconds = time.monotonic() - start
    if process.returncode != 0 and result.failed == 0:
        result.failed = 1
    return result


def main() -> int:
    """Runs all parts."""
    results = {part.name: run(part) for part in PARTS}
    print("\n--- all ---")
    for name, result in results.items():
        print(f"{name:8} {result.passed:5} passed {result.failed:4} failed {result.seconds:6.0f} s")
    passed = sum(result.passed for result in results.values())
    failed = sum(result.failed for result in results.values())
    print(f"{passed} passed, {failed} failed", flush=True)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
