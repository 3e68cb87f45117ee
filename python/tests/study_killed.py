"""A study that is killed again and again: run as a script with a folder, the study and how often.

Each try is a process of its own, forked before anything runs, so that it starts at once. The system ends it
at a random moment of its processor time, wherever it is, with nothing that it could do about it, as SIGKILL
does; a busy machine gives it as much as an idle one. Then the next goes on, and at last one to the end.

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

LONGEST_S = 0.4
"""Processor time of a try."""


def main(folder: Path, study: kingpost.Study, kills: int) -> None:
    """Kill so often, then finish. A study begins anew once it has ended, or was killed at its end."""
    draw, done, units = random.Random(kills), [], study.plan.units
    while len(done) < kills:
        moment = draw.uniform(0.01, LONGEST_S)
        child = os.fork()
        if child == 0:
            signal.setitimer(signal.ITIMER_PROF, moment)
            study.run(folder, workers=1, resume=True)
            os._exit(0)
        _, status = os.waitpid(child, 0)
        ended = os.waitstatus_to_exitcode(status)
        assert ended in (-signal.SIGPROF, 0), ended
        if ended != 0:
            done.append(len(list((folder / "units").glob("[0-9]*.json"))))
        if ended == 0 or done[-2:] == [units, units]:
            shutil.rmtree(folder)
    study.run(folder, workers=1, resume=True)
    print(json.dumps(done))


if __name__ == "__main__":
    main(Path(sys.argv[1]), kingpost.Study(sys.argv[2]), int(sys.argv[3]))
