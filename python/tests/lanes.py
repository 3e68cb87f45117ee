"""The two lanes of the tests: by default one case of each kind, with KINGPOST_LANE=thorough all cases. A test
or a case with the mark `thorough` runs only in the thorough lane. `sampled` marks all cases of a list except
the representative ones.
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
    """Mark the cases of a list, in their order; cases that are not kept are for the thorough lane. `keep` is
    a list or a function. A kept case that is not in the list is an error.
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
