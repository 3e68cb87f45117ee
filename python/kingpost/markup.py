"""Tables and figures for notebooks, as HTML."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from html import escape

_draw: Callable[[object], str] | None = None


def draw_figures_by(draw: Callable[[object], str]) -> None:
    """Register the function that makes a figure of a scenario, a simulation or a run: registered, because
    the function needs modules that use this one."""
    global _draw
    _draw = draw


def figure(of: object) -> str:
    """Figure of a scenario, a simulation or a run; empty without a registered function."""
    return "" if _draw is None else _draw(of)


def table(heading: str, rows: Iterable[Sequence[object]], columns: Sequence[str] = ()) -> str:
    """A heading over rows of cells; numbers have six digits.

    >>> table("Ship", [("mass", 2.0)], ("", "kg"))
    '<p><b>Ship</b></p><table><tr><th></th><th>kg</th></tr><tr><td>mass</td><td>2</td></tr></table>'
    """
    head = "".join(f"<th>{escape(name)}</th>" for name in columns)
    body = "".join(f"<tr>{''.join(f'<td>{_cell(cell)}</td>' for cell in row)}</tr>" for row in rows)
    return f"<p><b>{escape(heading)}</b></p><table>{f'<tr>{head}</tr>' if head else ''}{body}</table>"


def _cell(value: object) -> str:
    return escape(f"{value:.6g}" if isinstance(value, float) else str(value))
