"""Process that judges cases: a case that crashes, hangs or takes too much memory ends only this process."""

from __future__ import annotations

import contextlib
import importlib
import multiprocessing
import os
import signal
import tempfile
import time
from dataclasses import dataclass
from multiprocessing.connection import Connection
from multiprocessing.process import BaseProcess
from pathlib import Path

from .contract import LONGEST_CASE_S, MEMORY_BYTES, Case, judge

LONGEST_WAIT_S = 300.0
"""Longest wall-clock time without an answer, s; it is extended while the process computes. The machine may be
busy, and may lack a timer of processor time."""


@dataclass(frozen=True)
class Verdict:
    """Result of a case, its processor time, and the peak memory of the process."""

    says: str
    processor_s: float = 0.0
    peak_bytes: int = 0

    @property
    def is_wrong(self) -> bool:
        """Whether the case violates the contract."""
        return self.says.startswith("WRONG")


class Apart:
    """Judge of cases in a separate process, which is replaced if it dies."""

    def __init__(self) -> None:
        self.process: BaseProcess | None = None

    def ask(self, case: Case) -> Verdict:
        """Judge a case in the separate process."""
        if self.process is None:
            self.begin()
        try:
            self.ends.send(case)
            return self.ends.recv() if self._answers() else self.lost("it hangs")
        except (EOFError, OSError):
            return self.lost("the process died")

    def _answers(self) -> bool:
        """Whether an answer arrives. A case that takes too much processor time is ended by the timer of its
        process."""
        assert self.process is not None
        before, now = -1.0, _processor_s(self.process.pid)
        while before < now:
            if self.ends.poll(LONGEST_WAIT_S):
                return True
            before, now = now, _processor_s(self.process.pid)
        return False

    def begin(self) -> None:
        context = multiprocessing.get_context("spawn")
        self.ends, theirs = context.Pipe()
        self.process = context.Process(target=answer, args=(theirs,), daemon=True)
        self.process.start()
        theirs.close()
        assert self.ends.recv() == "ready"

    def lost(self, what: str) -> Verdict:
        assert self.process is not None
        self.process.kill()
        self.process.join()
        code = self.process.exitcode
        self.process = None
        hung = code == -int(getattr(signal, "SIGPROF", 0))
        found = f"more than {LONGEST_CASE_S:g} s" if hung else f"{what}, exit code {code}"
        return Verdict(f"WRONG: {found}", LONGEST_CASE_S if hung else 0.0)

    def end(self) -> None:
        """End the process."""
        if self.process is not None:
            with contextlib.suppress(OSError):
                self.ends.send(None)
            self.process.join()
            self.process = None


def answer(ends: Connection) -> None:
    """Judge incoming cases until the input ends."""
    os.environ.setdefault("OMP_NUM_THREADS", "1")
    import xarray  # noqa: F401  # It takes seconds, and no case is to be blamed for them.

    _limit_memory()
    ends.send("ready")
    with tempfile.TemporaryDirectory() as name:
        while (case := ends.recv()) is not None:
            ends.send(_timed(case, Path(name)))


def _timed(case: Case, folder: Path) -> Verdict:
    # The import of its module and one-time preparations do not count as time of the case.
    use = importlib.import_module(f"fuzz.kinds.{case.kind}").use
    _forget_peak()
    began = time.process_time()
    # Processor time, independent of the machine's load; the signal also interrupts compiled code.
    _alarm(LONGEST_CASE_S)
    says = judge(use, case, folder)
    _alarm(0)
    return Verdict(says, time.process_time() - began, _peak_bytes())


def _processor_s(pid: int | None) -> float:
    """Processor time of a process and its children, s (proc(5), Linux); always 0 elsewhere."""
    with contextlib.suppress(OSError):
        # The name in brackets may have blanks.
        fields = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
        return sum(map(int, fields[11:15])) / os.sysconf("SC_CLK_TCK")
    return 0.0


def _alarm(seconds: float) -> None:
    if hasattr(signal, "setitimer"):
        signal.setitimer(signal.ITIMER_PROF, seconds)


def _limit_memory() -> None:
    """Limit the memory that the process writes; libraries are not counted."""
    with contextlib.suppress(ImportError, AttributeError, ValueError):
        import resource

        resource.setrlimit(resource.RLIMIT_DATA, (MEMORY_BYTES, MEMORY_BYTES))


def _forget_peak() -> None:
    """Reset the peak memory, so that it is that of the next case (proc(5), Linux)."""
    with contextlib.suppress(OSError):
        Path("/proc/self/clear_refs").write_text("5")


def _peak_bytes() -> int:
    with contextlib.suppress(OSError):
        status = Path("/proc/self/status").read_text()
        return 1024 * int(status.partition("VmHWM:")[2].split()[0])
    with contextlib.suppress(ImportError):
        import resource

        return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024
    return 0
