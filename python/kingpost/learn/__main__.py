"""Writes the baselines' scores into docs/learning.md: ``python -m kingpost.learn [FILE]``."""

import sys
from pathlib import Path

from .scores import table

START, END = "<!-- scores: start -->", "<!-- scores: end -->"

if __name__ == "__main__":
    page = Path(sys.argv[1] if len(sys.argv) > 1 else "docs/learning.md")
    text = page.read_text(encoding="utf-8") if page.is_file() else f"{START}{END}"
    before, after = text.split(START)[0], text.split(END)[-1]
    page.write_text(f"{before}{START}\n\n{table()}\n{END}{after}", encoding="utf-8")
