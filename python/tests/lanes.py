"""The two lanes of the tests: by default one case of each kind, with KINGPOST_LANE=thorough all of them.

A test or a case with the mark `thorough` runs in the thorough lane alone. `sampled` marks the cases of a list
so, all but those that stand for the others.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable
from typing import Any

import pytest

LANES = ("default", "thorough")
LANE = os.environ.get("KINGPOST_LANE") or "default"
if LANE not in LANES:
    raise pytest.UsageError(f"KINGPOST_LANE: found {LANE}, allowed: {', '.join(LANES)}")
THOROUGH = LANE == "thorough"


def sampled(cases: Iterable[Any], keep: Iterable[Any] | Callable[[Any], bool]) -> list[Any]:
    """The cases of a list, in their order; those that are not kept are for the thorough lane.

    What is kept is listed, or told by a function. A kept case that is not in the list is a mistake.
    """
    cases = list(cases)
    if callable(keep):
        kept = [case for case in cases if keep(case)]
    else:
        kept = list(keep)
        missing = [case for case in kept if case not in cases]
        assert not missing, f"kept, but no case: {missing}"
    assert kept, "nothing is kept for the default lane"
    return [case if case in kept else _thorough(case) for case in cases]


def _thorough(case: Any) -> Any:
    values = case if isinstance(case, tuple) else (case,)
    return pytest.param(*values, marks=pytest.mark.thorough)
