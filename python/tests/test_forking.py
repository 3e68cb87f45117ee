"""A process that is forked while a thread runs does not hang."""

from __future__ import annotations

import os
import signal
import threading

import kingpost
import pytest
from kingpost import forking
from kingpost.scenario import Scenario

WAIT_S = 60
"""For a child that hangs: a model is described in some hundredths of a second."""


@pytest.mark.skipif(not (forking.LOCKED and hasattr(os, "fork")), reason="no lock, or no fork")
def test_a_forked_child_can_compute_a_property_that_a_thread_was_computing() -> None:
    scenario = kingpost.load("chain")
    held, done = threading.Event(), threading.Event()

    def hold() -> None:
        with vars(Scenario)["model"].lock:
            held.set()
            done.wait()

    thread = threading.Thread(target=hold)
    thread.start()
    held.wait()
    child = os.fork()
    if child == 0:
        signal.alarm(WAIT_S)
        os._exit(0 if scenario.model["bodies"] else 1)
    _, status = os.waitpid(child, 0)
    done.set()
    thread.join()
    assert status == 0, "the child ended by a signal, or without a model"
