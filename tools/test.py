"""Runs the tests of every part, in the lane of KINGPOST_LANE: the last line reads `N passed, N failed`.

Two parts run at a time: one that mostly waits, for pages and servers, and one that computes. The output of a
part is printed when it has ended. If the tests of a part fail, or it breaks before its first test, the exit
code is 1; the other parts still run. `make test` calls this script.
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor, as_completed
from dataclasses import dataclass

MAKE = os.environ.get("MAKE", "make")
COLOUR = re.compile(r"\x1b\[[0-9;]*m")
COUNT = re.compile(r"(\d+) (passed|failed|errors?)\b")
AT_ONCE = 2
# Remove the job server of a calling make, which the makes below cannot share.
ENVIRONMENT = {name: value for name, value in os.environ.items() if name != "MAKEFLAGS"}


@dataclass(frozen=True)
class Part:
    """One part: the make target that runs it, and the start of the lines that count its tests."""

    name: str
    target: str
    summary: str | None = None


# Common targets are built first, in one make: two makes at once would both build them.
BUILD = Part("build", "compile web")
# In the order of their start. Each uses all cores; the last are short, so that no core is idle for long.
PARTS = [
    Part("browser", "test-browser", summary=r"browser: "),
    Part("Python", "test-python", summary=r"=+ .* in [\d.]+s"),
    Part("engine", "test-rust", summary=r"test result: "),
    Part("lint", "lint"),
    Part("web", "test-web", summary=r"\s+Tests  "),
]


@dataclass
class Result:
    """Result of one part."""

    passed: int = 0
    failed: int = 0
    seconds: float = 0.0
    processor_s: float = 0.0
    output: str = ""

    def add(self, line: str) -> None:
        """Adds the counts in a runner's summary line."""
        for count, what in COUNT.findall(line):
            if what == "passed":
                self.passed += int(count)
            else:
                self.failed += int(count)


def run(part: Part) -> Result:
    """Runs a part, which counts as one failure if it breaks."""
    print(f"{part.name} begins", flush=True)
    start = time.monotonic()
    process = subprocess.Popen(
        [MAKE, *part.target.split()],
        env=ENVIRONMENT,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        errors="replace",
    )
    with process.stdout as lines:
        output = lines.read()
    _, status, used = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    processor_s = used.ru_utime + used.ru_stime
    result = Result(seconds=time.monotonic() - start, processor_s=processor_s, output=output)
    for line in output.splitlines():
        plain = COLOUR.sub("", line)
        if part.summary and re.match(part.summary, plain):
            result.add(plain)
    if process.returncode != 0 and result.failed == 0:
        result.failed = 1
    return result


def show(part: Part, result: Result) -> None:
    """Prints what a part printed."""
    print(f"\n--- {part.name} ({result.seconds:.0f} s) ---\n{result.output}", end="", flush=True)


def run_together(parts: list[Part]) -> dict[str, Result]:
    """Runs some parts at a time, and prints the output of each when it has ended."""
    results = {}
    with ThreadPoolExecutor(AT_ONCE) as pool:
        running = {pool.submit(run, part): part for part in parts}
        for future in as_completed(running):
            part, result = running[future], future.result()
            show(part, result)
            results[part.name] = result
    return {part.name: results[part.name] for part in parts}


def main() -> int:
    """Builds, and runs all parts."""
    results = run_together([BUILD]) | run_together(PARTS)
    print("\n--- all ---")
    for name, result in results.items():
        counts = f"{result.passed:5} passed {result.failed:4} failed"
        print(f"{name:8} {counts} {result.seconds:6.0f} s {result.processor_s:6.0f} s of a processor")
    passed = sum(result.passed for result in results.values())
    failed = sum(result.failed for result in results.values())
    print(f"{passed} passed, {failed} failed", flush=True)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
