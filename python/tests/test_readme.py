"""Every command and every example of the README runs."""

from __future__ import annotations

import re
import shlex
from pathlib import Path

import kingpost
import matplotlib
import pytest
from kingpost import cli
from kingpost.film.order import Order

README = (Path(__file__).resolve().parents[2] / "README.md").read_text(encoding="utf-8")
COMMANDS = [line.split("#")[0].strip() for line in README.splitlines() if line.startswith("kingpost ")]
# They take long, and test_paper.py, test_verify.py and, for half a second, test_film.py run them.
PAPER, VERIFY = "kingpost paper -o results", "kingpost verify"
FILM = "kingpost film slew_and_land -o lift.webm --speed 4 --plots"
EXAMPLES = re.findall(r"```python\n(.*?)```", README, re.DOTALL)


def test_the_readme_has_the_commands_paper_and_verify_and_a_film() -> None:
    assert {PAPER, VERIFY, FILM} <= set(COMMANDS)
    options = cli.parser().parse_args(shlex.split(FILM)[1:])
    order = Order(options.size, options.fps, options.from_s, options.to_s, options.speed, options.plots)
    assert order.for_page(kingpost.load(options.scenario), Path(options.output).suffix)


@pytest.mark.parametrize("command", [command for command in COMMANDS if command not in (PAPER, VERIFY, FILM)])
def test_every_command_of_the_readme_runs(
    command: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    words = shlex.split(command)[1:]
    # The server would serve for ever, and on every network.
    words = ["serve", "paper", "--check", "--port", "0"] if words[0] == "serve" else words
    try:
        status = cli.main(words)
    except SystemExit as left:
        status = left.code
    assert status in (0, None)


def test_the_examples_of_the_readme_run_one_after_another(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    matplotlib.use("Agg")
    assert len(COMMANDS) >= 5
    assert len(EXAMPLES) >= 3
    names: dict[str, object] = {}
    for example in EXAMPLES:
        exec(compile(example, "README.md", "exec"), names)
