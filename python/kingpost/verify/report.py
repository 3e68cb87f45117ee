"""Reports of the rows as text, Markdown, JSON and one page of HTML."""

from __future__ import annotations

import html
import json
from collections.abc import Sequence
from itertools import groupby

from .. import __version__
from ..reports.tables import table, unit_cell
from .rows import ABSENT, AREAS, FAILED, PASSED, Row


def counts(rows: Sequence[Row]) -> dict[str, int]:
    """The number of rows with each verdict.

    >>> counts([])
    {'pass': 0, 'FAIL': 0, 'not installed': 0}
    """
    return {verdict: sum(row.verdict == verdict for row in rows) for verdict in (PASSED, FAILED, ABSENT)}


def summary(rows: Sequence[Row]) -> str:
    """One line: the number of rows, of failures, and the time."""
    found = counts(rows)
    seconds = sum(row.seconds for row in rows)
    counted = found[PASSED] + found[FAILED]
    absent = f", {found[ABSENT]} not counted: other programs that are not installed" if found[ABSENT] else ""
    return f"{counted} rows, {found[PASSED]} pass, {found[FAILED]} fail{absent}; {seconds:.0f} s"


def number(value: float | None, digits: int = 6) -> str:
    """A number in a cell, or a dash if there is none.

    >>> number(0.428412345), number(None), number(1.2e-13, 2)
    ('0.428412', '-', '1.2e-13')
    """
    return "-" if value is None else f"{value:.{digits}g}"


def _cells(row: Row) -> tuple[str, ...]:
    unit = f" {unit_cell(row.unit)}".rstrip()
    theirs = number(row.theirs) + unit if row.theirs is not None else "-"
    limits = number(row.error, 2), number(row.tolerance, 2)
    return (row.id, row.what, number(row.ours), theirs, *limits, row.verdict)


HEAD = ("row", "what", "ours", "theirs", "error", "allowed", "verdict")


def text(rows: Sequence[Row]) -> str:
    """The table for a terminal, by area, then failures and the summary.

    Errors are relative to the other value, or to the scale that the row's source names.
    """
    lines = []
    shown = iter(table([HEAD, *(_cells(row) for row in rows)], "<<>>>><"))
    lines.append(next(shown))
    for area, group in groupby(rows, key=lambda row: row.area):
        lines += ["", AREAS[area]]
        lines += [next(shown) for _ in group]
    wrong = [f"{row.verdict} {row.id}: {_trouble(row)}" for row in rows if row.verdict != PASSED]
    return "\n".join([*lines, "", *wrong, summary(rows)])


def _trouble(row: Row) -> str:
    if row.message:
        return row.message
    return f"off by {number(row.error, 3)}, allowed {number(row.tolerance, 3)} ({row.why}); {row.source}"


def as_json(rows: Sequence[Row]) -> str:
    """The rows with all their fields, and the counts."""
    found = {"kingpost": __version__, "counts": counts(rows), "rows": [row.as_dict() for row in rows]}
    return json.dumps(found, indent=1, ensure_ascii=False) + "\n"


def markdown(rows: Sequence[Row]) -> str:
    """A page with a table for each area; each row with its source and the reason of its tolerance."""
    lines = [
        "# Verification, measured",
        "",
        f"Kingpost {__version__}: {summary(rows)}.",
        "",
        "Errors are relative to theirs, or to the scale that the row names. `kingpost verify` repeats them.",
    ]
    for area, group in groupby(rows, key=lambda row: row.area):
        lines += ["", f"## {AREAS[area]}", "", "| " + " | ".join([*HEAD, "source", "allowed because"]) + " |"]
        lines.append("| --- | --- | ---: | ---: | ---: | ---: | --- | --- | --- |")
        for row in group:
            cells = (*_cells(row), row.source, row.message or row.why)
            lines.append("| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |")
    return "\n".join(lines) + "\n"


STYLE = """
body { font: 15px/1.45 system-ui, sans-serif; margin: 2rem auto; max-width: 82rem; padding: 0 1rem;
  color: #1d2733 }
h2 { margin-top: 2rem } table { border-collapse: collapse; width: 100% }
th, td { text-align: left; padding: .3rem .6rem; border-bottom: 1px solid #d8dee6; vertical-align: top }
td.n { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap }
td small, .absent { color: #5b6b7d } .pass { color: #1b7f3b } .fail { color: #b3261e; font-weight: 700 }
"""
CLASSES = {PASSED: "pass", FAILED: "fail", ABSENT: "absent"}


def page(rows: Sequence[Row]) -> str:
    """One self-contained page of HTML."""
    parts = [
        "<!doctype html>",
        '<html lang="en"><head><meta charset="utf-8">',
        '<meta name="viewport" content="width=device-width, initial-scale=1">',
        f"<title>Kingpost {__version__}: verification</title><style>{STYLE}</style></head><body>",
        f"<h1>Verification, measured</h1><p>Kingpost {__version__}: {html.escape(summary(rows))}.</p>",
        "<p>Errors are relative to theirs, or to the scale that the row names.</p>",
    ]
    for area, group in groupby(rows, key=lambda row: row.area):
        parts.append(f"<h2>{html.escape(AREAS[area])}</h2><table><thead><tr>")
        parts += [f"<th>{name}</th>" for name in HEAD]
        parts.append("</tr></thead><tbody>")
        parts += [_line(row) for row in group]
        parts.append("</tbody></table>")
    return "\n".join([*parts, "</body></html>"]) + "\n"


def _line(row: Row) -> str:
    name, what, *numbers, verdict = (html.escape(cell) for cell in _cells(row))
    notes = "<br>".join(html.escape(note) for note in (row.source, row.message or row.why))
    cells = "".join(f'<td class="n">{cell}</td>' for cell in numbers)
    return (
        f'<tr id="{name}"><td>{name}</td><td>{what}<br><small>{notes}</small></td>{cells}'
        f'<td class="{CLASSES[row.verdict]}">{verdict}</td></tr>'
    )
