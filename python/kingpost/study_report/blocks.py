"""Blocks of a report, which say where their numbers come from."""

from __future__ import annotations

import base64
import io
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from importlib.resources import files
from typing import TYPE_CHECKING, Any, ClassVar

if TYPE_CHECKING:
    from matplotlib.figure import Figure

TEMPLATE, STYLE = "report.html.j2", "report.css"


@dataclass(frozen=True)
class Paragraph:
    """A paragraph."""

    text: str
    kind: ClassVar[str] = "paragraph"


@dataclass(frozen=True)
class Heading:
    """A heading inside a section."""

    text: str
    kind: ClassVar[str] = "heading"


@dataclass(frozen=True)
class Command:
    """Commands that a person can repeat."""

    text: str
    kind: ClassVar[str] = "command"


@dataclass(frozen=True)
class Link:
    """An address with the words that lead there."""

    text: str
    address: str
    kind: ClassVar[str] = "link"


@dataclass(frozen=True)
class Table:
    """Cells under a heading; `origin` says from which file and by which command its numbers are."""

    title: str
    head: Sequence[str]
    rows: Sequence[Sequence[str]]
    origin: str
    numbers: Sequence[int] = ()
    kind: ClassVar[str] = "table"


@dataclass(frozen=True)
class Picture:
    """A drawing, inside the page; `description` is for who does not see it."""

    description: str
    caption: str
    origin: str
    data: str
    kind: ClassVar[str] = "picture"

    @classmethod
    def of(cls, figure: Figure, description: str, caption: str, origin: str) -> Picture:
        """The drawing of a figure, with no date in it: the same figure gives the same page."""
        drawn = io.BytesIO()
        with drawing():
            figure.savefig(drawn, format="svg", metadata={"Date": None})
        return cls(description, caption, origin, base64.b64encode(drawn.getvalue()).decode())


Block = Paragraph | Heading | Command | Link | Table | Picture


@dataclass(frozen=True)
class Section:
    """A numbered section of a report."""

    key: str
    title: str
    blocks: Sequence[Block]


@dataclass(frozen=True)
class Report:
    """A whole report: its verdict first."""

    title: str
    lead: str
    verdict: Sequence[str]
    sections: Sequence[Section]
    warnings: Sequence[str] = field(default=())


@contextmanager
def drawing() -> Iterator[None]:
    """Settings under which a figure gives the same SVG every time."""
    import matplotlib

    with matplotlib.rc_context({"svg.hashsalt": "kingpost", "svg.fonttype": "path"}):
        yield


def html(report: Report, version: str) -> str:
    """The report as one page of HTML that needs nothing beside it.

    >>> from kingpost.study_report.blocks import Paragraph, Report, Section
    >>> page = html(Report("A < B", "", ["No."], [Section("one", "One", [Paragraph("1 & 2")])]), "0.1.0")
    >>> "A &lt; B" in page, "1 &amp; 2" in page
    (True, True)
    """
    import jinja2

    environment = jinja2.Environment(
        loader=jinja2.PackageLoader(__package__, ""), autoescape=True, undefined=jinja2.StrictUndefined
    )
    style = files(__package__).joinpath(STYLE).read_text(encoding="utf-8")
    given: dict[str, Any] = vars(report) | {"version": version, "style": style}
    return environment.get_template(TEMPLATE).render(given) + "\n"
