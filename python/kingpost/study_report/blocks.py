"""Blocks of a report, each with the origin of its numbers."""

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
    """Commands that a reader can repeat."""

    text: str
    kind: ClassVar[str] = "command"


@dataclass(frozen=True)
class Link:
    """An address and the text of its link."""

    text: str
    address: str
    kind: ClassVar[str] = "link"


@dataclass(frozen=True)
class Table:
    """Cells under a heading; `origin` gives the file and the command that the numbers come from."""

    title: str
    head: Sequence[str]
    rows: Sequence[Sequence[str]]
    origin: str
    numbers: Sequence[int] = ()
    kind: ClassVar[str] = "table"


@dataclass(frozen=True)
class Picture:
    """A drawing embedded in the page; `description` is its text alternative."""

    description: str
    caption: str
    origin: str
    data: str
    kind: ClassVar[str] = "picture"

    @classmethod
    def of(cls, figure: Figure, description: str, caption: str, origin: str) -> Picture:
        """Convert a figure to a drawing without a date, so that the same figure gives the same page."""
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
    """A whole report, which begins with its verdict."""

    title: str
    lead: str
    verdict: Sequence[str]
    sections: Sequence[Section]
    warnings: Sequence[str] = field(default=())


@contextmanager
def drawing() -> Iterator[None]:
    """Use settings with which a figure always gives the same SVG."""
    import matplotlib

    with matplotlib.rc_context({"svg.hashsalt": "kingpost", "svg.fonttype": "path"}):
        yield


def html(report: Report, version: str) -> str:
    """Write the report as one self-contained page of HTML.

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
