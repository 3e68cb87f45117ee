"""Lifts with something wrong: `test_fuzz_lifts` draws them, `lift_outcomes` says what they come to."""

from __future__ import annotations

from pathlib import Path

from lift_outcomes import outcome

from ..contract import Case


def use(case: Case, folder: Path) -> str:
    """What the text of a scenario comes to, as if it stood in the file that the second word names."""
    how, file = case.arguments
    return outcome(case.files["case.yaml"].decode(), file, thorough=how == "thorough")
