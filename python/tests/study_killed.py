"""A study that is killed again and again: run as a script with a folder, the study, how often at least, and
at how many different numbers of units done.

Each try is a process of its own, forked before anything runs, so that it starts at once. The system ends it
after a random share of the processor time of a whole study, wherever it is, with nothing that it could do
about it, as SIGKILL does; a busy machine gives it as much as an idle one. Then the next goes on, and at last
one to the end.

Prints how many units were done after each kill.
"""

from __future__ import annotations

import json
import os
import random
import shutil
import signal
import sys
from pathlib import Path

import kingpost
import zarr  # noqa: F401, loaded before the forks

SHARES = (0.005, 0.3)
"""Shortest and longest try, as a share of the processor time of a whole study."""
MOST = 100
"""Kills, if those moments were not all met before."""


def attempt(folder: Path, study: kingpost.Study, moment_s: float | None) -> tuple[bool, float]:
    """Runs or resumes in a separate process. Returns whether it was killed, and its processor time, s."""
    child = os.fork()
    if child == 0:
        if moment_s is not None:
            signal.setitimer(signal.ITIMER_PROF, moment_s)
        study.run(folder, workers=1, resume=True)
        os._exit(0)
    _, status, used = os.wait4(child, 0)
    ended = os.waitstatus_to_exitcode(status)
    assert ended in (-signal.SIGPROF, 0), ended
    return ended != 0, used.ru_utime + used.ru_stime


def main(folder: Path, study: kingpost.Study, kills: int, moments: int) -> None:
    """Kill so often, then finish. A study begins anew once it has ended, or twice had every unit done."""
    draw, done, units = random.Random(kills), [], study.plan.units
    _, whole_s = attempt(folder, study, None)
    shutil.rmtree(folder)
    while len(done) < kills or (len(set(done)) < moments and len(done) < MOST):
        killed, _ = attempt(folder, study, draw.uniform(*SHARES) * whole_s)
        if killed:
            done.append(len(list((folder / "units").glob("[0-9]*.json"))))
        if not killed or done[-2:] == [units, units]:
            shutil.rmtree(folder)
    study.run(folder, workers=1, resume=True)
    print(json.dumps(done))


if __name__ == "__main__":
    main(Path(sys.argv[1]), kingpost.Study(sys.argv[2]), int(sys.argv[3]), int(sys.argv[4]))
