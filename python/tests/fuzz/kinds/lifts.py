"""Wrong scenarios of lifts: `test_fuzz_lifts` draws them, `lift_outcomes` judges them."""

from __future__ import annotations

from pathlib import Path

from lift_outcomes import outcome

from ..contract import Case


def use(case: Case, folder: Path) -> str:
    """Judge the text of a scenario as if it were in the file named by the second argument."""
    how, file = case.arguments
    return outcome(case.files["case.yaml"].decode(), file, thorough=how == "thorough")
