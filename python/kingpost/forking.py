"""Locks of cached properties in a forked process, on Python 3.11.

There `functools.cached_property` holds a lock while it computes. If another thread holds this lock when the
program forks, the lock stays locked in the child for ever.
"""

from __future__ import annotations

import os
import sys
import threading
from functools import cached_property

LOCKED = sys.version_info < (3, 12)
"""Whether cached properties of this version of Python have a lock; from 3.12 on they have none."""


def renew_locks() -> None:
    """Give each cached property of this package a new, free lock."""
    package = __name__.partition(".")[0]
    for name, module in list(sys.modules.items()):
        if name.partition(".")[0] != package:
            continue
        classes = [one for one in vars(module).values() if isinstance(one, type)]
        for one in (value for owner in classes for value in vars(owner).values()):
            if isinstance(one, cached_property):
                one.lock = threading.RLock()  # type: ignore[attr-defined]


def watch() -> None:
    """Renew the locks in every child that is forked from now on."""
    if LOCKED and hasattr(os, "register_at_fork"):
        os.register_at_fork(after_in_child=renew_locks)
