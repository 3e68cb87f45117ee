"""Script that kills a study repeatedly. Arguments: a folder, the study, the least number of kills, and the
least number of different counts of finished units at a kill. Each try is a separate process, forked before
anything runs, so that it starts at once. The system ends it, like SIGKILL, after a random share of the
processor time of a whole study, which does not depend on the machine's load. The next try resumes the study,
and the last one completes it. Prints the number of finished units after each kill.
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
"""Largest number of kills, if the counts were not all reached before."""


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
    """Kill a number of times, then finish. The study starts again after it has ended, or after two kills with
    every unit finished."""
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
