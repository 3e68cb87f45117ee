"""Standard streams that are closed, full, or a pipe whose reader has gone.

Source: cron jobs and services close them; /dev/full is Linux's full disk.
"""

from __future__ import annotations

import os
import shlex
import subprocess
import sys
from pathlib import Path

import pytest

KINGPOST = f"{shlex.quote(sys.executable)} -m kingpost"
pytestmark = pytest.mark.skipif(not Path("/dev/full").exists(), reason="needs a POSIX shell and /dev/full")


def shell(line: str, folder: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        ["sh", "-c", line], cwd=folder, capture_output=True, text=True, timeout=300, check=False
    )


def test_closed_standard_streams_do_not_change_the_file_of_a_run(tmp_path: Path) -> None:
    short = "run paper --set simulation.duration_s=0.1 -q -o"
    done = shell(f"{KINGPOST} {short} a.csv && {KINGPOST} {short} b.csv <&- >&- 2>&-", tmp_path)
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "a.csv").read_bytes() == (tmp_path / "b.csv").read_bytes()


@pytest.mark.parametrize("command", ["check barge", "list --json", "--help"])
def test_a_full_standard_output_gives_one_error_line(command: str, tmp_path: Path) -> None:
    done = shell(f"{KINGPOST} {command} > /dev/full", tmp_path)
    assert done.returncode == 1
    reason = os.strerror(28)
    assert done.stderr == f"error: standard output cannot be written: {reason}\n"


def test_warnings_that_cannot_be_printed_do_not_end_a_command(tmp_path: Path) -> None:
    done = shell(f"{KINGPOST} run none.yaml 2> /dev/full", tmp_path)
    assert (done.returncode, done.stdout) == (2, "")


def test_a_reader_that_closes_its_pipe_ends_a_command_in_silence(tmp_path: Path) -> None:
    done = shell(f"{{ {KINGPOST} list; echo $? >&2; }} | true", tmp_path)
    assert done.stderr == "0\n"
