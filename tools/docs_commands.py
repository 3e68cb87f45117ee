"""Generates the site's page on the command line: the help of each command."""

from __future__ import annotations

import os
import re
import subprocess
import sys


def page() -> str:
    """The commands with their options, as Markdown."""
    whole = said()
    commands = re.findall(r"^    ([a-z][a-z-]+)(?: |$)", whole, re.MULTILINE)
    lines = ["# Command line", "", *block(whole)]
    for command in commands:
        lines += [f"## kingpost {command}", "", *block(said(command))]
    return "\n".join(lines)


def said(*command: str) -> str:
    """The help text of a command."""
    words = [sys.executable, "-m", "kingpost", *command, "--help"]
    plain = os.environ | {"COLUMNS": "96", "NO_COLOR": "1"}
    return subprocess.run(words, check=True, capture_output=True, text=True, env=plain).stdout


def block(text: str) -> list[str]:
    return ["```text", text.rstrip(), "```", ""]
