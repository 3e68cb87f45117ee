"""Script that kills a run while it overwrites a good file. Arguments: the least number of tries, the least
number of killed ones, and a command line. Each try is a separate process, forked after all imports, so that
it consists only of the run and its writing. The system ends it, like SIGKILL, after a share of the run's
processor time, which does not depend on the machine's load. Prints after each try whether it was killed, and
a digest of the file's values.
"""

from __future__ import annotations

import contextlib
import hashlib
import json
import os
import signal
import sys
from pathlib import Path

import pandas
import xarray
from kingpost import cli

LONGEST_SHARE = 0.9
"""Longest try as a share of the processor time of a whole run; a few tries need less and end by
themselves."""
MOST = 80
"""Largest number of tries, if too few were killed before."""


def digest(path: Path) -> str:
    """Digest of the values in a file."""
    if path.suffix == ".nc":
        with xarray.open_dataset(path, engine="h5netcdf") as found:
            table = found["kinetic_energy"].to_dataframe()
    else:
        table = pandas.read_csv(path) if path.suffix == ".csv" else pandas.read_parquet(path)
    return hashlib.sha256(pandas.util.hash_pandas_object(table).to_numpy().tobytes()).hexdigest()


def run(words: list[str], moment_s: float | None) -> tuple[bool, float]:
    """Runs in a separate process. Returns whether it was killed, and its processor time, s."""
    child = os.fork()
    if child == 0:
        if moment_s is not None:
            signal.setitimer(signal.ITIMER_PROF, moment_s)
        os._exit(cli.main(words))
    _, status, used = os.wait4(child, 0)
    ended = os.waitstatus_to_exitcode(status)
    assert ended in (-signal.SIGPROF, 0), ended
    return ended != 0, used.ru_utime + used.ru_stime


def main(tries: int, kills: int, words: list[str]) -> list[tuple[bool, str]]:
    """Run to the end in this process, which imports everything before the forks, then kill repeatedly."""
    target, found = Path(words[-1]), []
    assert cli.main(words) == 0
    digest(target)
    _, took_s = run(words, None)
    for k in range(MOST):
        killed, _ = run(words, LONGEST_SHARE * took_s * (k % tries + 1) / tries)
        found.append((killed, digest(target)))
        if k + 1 >= tries and sum(killed for killed, _ in found) >= kills:
            break
    return found


if __name__ == "__main__":
    with Path(os.devnull).open("w") as nowhere, contextlib.redirect_stdout(nowhere):
        told = main(int(sys.argv[1]), int(sys.argv[2]), sys.argv[3:])
    print(json.dumps(told))
