"""The logger `kingpost`; other loggers are unchanged."""

from __future__ import annotations

import ast
import logging
from pathlib import Path

import kingpost
import pytest
from kingpost import results

PACKAGE = Path(kingpost.__file__).parent
SHORT = {"simulation.duration_s": 0.1}


def test_a_run_and_a_file_are_logged_below_kingpost(caplog, tmp_path) -> None:
    """Source: the tree of loggers; a program that listens to `kingpost` hears all of it."""
    with caplog.at_level(logging.INFO, logger="kingpost"):
        results.write(kingpost.run("paper", SHORT), tmp_path / "run.csv")
    assert [record.getMessage() for record in caplog.records] == [
        "Crane ship of Jardim et al. (2019): finished at 0.1 s, 11 rows",
        f"written: {tmp_path / 'run.csv'}",
    ]
    assert all(record.name.startswith("kingpost.") for record in caplog.records)


def test_a_program_without_a_log_handler_prints_no_log(capfd) -> None:
    """Source: the contract of a library's logger: a handler of its own that does nothing."""
    assert any(isinstance(handler, logging.NullHandler) for handler in logging.getLogger("kingpost").handlers)
    logging.getLogger("kingpost").error("not to be seen")
    assert capfd.readouterr().err == ""


def test_no_other_logger_is_changed_by_the_library() -> None:
    pytest.importorskip("capytaine")
    from kingpost.hydro.solve import capytaine

    log = logging.getLogger("capytaine")
    before = log.level
    capytaine()
    assert log.level == before


def test_only_commands_set_levels_and_filters() -> None:
    """Source: the files: what a program hears is the program's to say, and the command line is one."""
    found = set()
    for path in PACKAGE.rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Attribute) and node.attr in (
                "setLevel",
                "disable",
                "simplefilter",
                "seterr",
            ):
                found.add(path.relative_to(PACKAGE).as_posix())
    assert found == {"cli.py", "commands/common.py"}
