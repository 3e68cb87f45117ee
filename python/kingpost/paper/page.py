"""Page with the paper's results and the differences between its text and the physics."""

from __future__ import annotations

import base64
from collections.abc import Iterable, Sequence
from importlib.resources import files
from pathlib import Path

from latex2mathml.converter import convert

from ..engine import engine
from . import comparison, summary
from .errata import Erratum, errata, power
from .figures import Figure
from .integrators import DURATION_S, REFERENCE_STEP_S, Compared
from .measured import Measured
from .table import Row

TITLE = "Crane-induced ship motion by the moving frame method"
SECTIONS = {
    "figures": "Figures 9 to 11",
    "table": "Table 2",
    "integrators": "Comparison of the integrators",
    "differences": "Where the paper's text and the physics disagree",
    "choices": "What we chose where the paper is silent",
    "files": "The numbers",
}
CHOICES = (
    "Integrator: Runge-Kutta of order 4 in the form of Munthe-Kaas, 1 ms steps, 3 s, recorded every "
    "10 ms. The paper integrates by forward Euler and gives no step.",
    "Torque: constant from the start to the end while a motor is on. The paper gives no history; it "
    "speaks of abrupt changes of the torque and of phases of constant torque, without their times, so "
    "its curves and ours cannot be compared point by point.",
    "Start: at rest, tower and arm angle zero: the arm is level and points forward.",
    "Joints without friction; motors without limits of power or speed.",
    "The load, where it is on, is a point mass of 1,000 kg fixed at the arm's tip. Here it is off.",
    "Axes: x forward, y to port, z up. The paper's 1, 2, 3 are our y, z, x: its w1 is the pitch rate "
    "about y, w2 the yaw rate about z, w3 the roll rate about x, all in the ship's axes.",
    "As in the paper: no gravity, no water, and the ship's centre of mass is held.",
)


def html(
    folder: Path, drawn: list[Figure], rows: list[Row], compared: list[Compared], remarks: Measured
) -> str:
    """The page as one file that contains pictures, style and equations."""
    bodies = {
        "figures": _figures(folder, drawn, rows),
        "table": _table_2(rows),
        "integrators": _integrators(folder, compared, remarks),
        "differences": _errata(errata(remarks)),
        "choices": _list(CHOICES),
        "files": _files(drawn),
    }
    links = "".join(f'<li><a href="#{key}">{title}</a></li>' for key, title in SECTIONS.items())
    sections = "".join(
        f'<section id="{key}"><h2>{title}</h2>{bodies[key]}</section>' for key, title in SECTIONS.items()
    )
    style = files(__package__).joinpath("page.css").read_text(encoding="utf-8")
    return (
        f'<!doctype html><html lang="en-GB"><head><meta charset="utf-8"><title>{TITLE}</title>'
        '<meta name="viewport" content="width=device-width, initial-scale=1">'
        f"<style>{style}</style></head><body><header><h1>{TITLE}</h1>{_lead()}"
        f"<nav><ul>{links}</ul></nav></header><main>{sections}</main>"
        f"<footer><p>Written by <code>kingpost paper</code>, version {engine.__version__}. "
        "The pictures, and the numbers of the runs, were computed for it.</p></footer></body></html>\n"
    )


def _lead() -> str:
    return (
        '<p class="lead">The case of Jardim, Rein, Haveland, Rykkje and Impelluso (2019), '
        '<a href="https://doi.org/10.1115/1.4042536">doi 10.1115/1.4042536</a>: a box-shaped ship with a '
        "tower that turns and an arm that is lifted and lowered, each by a motor that pushes back on what "
        "it stands on. Here the crane stands at the ship's centre and carries no load, as in the paper's "
        "Figs. 9 to 11.</p>"
    )


def _picture(folder: Path, name: str, description: str, caption: str) -> str:
    data = base64.b64encode((folder / f"{name}.svg").read_bytes()).decode()
    return (
        f'<figure><img alt="{description}" src="data:image/svg+xml;base64,{data}">'
        f"<figcaption>{caption}</figcaption></figure>"
    )


def _figures(folder: Path, drawn: list[Figure], rows: list[Row]) -> str:
    pictures = ""
    pitch, yaw, roll = (f"{row.value:,g}" for row in rows if row.symbol.startswith(r"\zeta"))
    for figure in drawn:
        case = figure.case
        caption = (
            f"Fig. {case.number}, {case.title} on. Pitch, yaw and roll rate of the ship, without and with "
            f"damping ({pitch}, {yaw} and {roll} N m s on pitch, yaw and roll)."
        )
        description = f"Pitch, yaw and roll rate against time, {case.title}"
        pictures += _picture(folder, figure.name, description, caption)
    head, *body = summary.largest_rates(drawn)
    end = f"{drawn[0].time_s[-1]:g}"
    return f"{pictures}<p>Largest magnitudes within {end} s:</p>{_table(head, body)}"


def _table_2(rows: list[Row]) -> str:
    head = ("Quantity", "Symbol", "Value", "Unit", "Field of the scenario")
    body = [
        (
            row.quantity,
            convert(row.symbol),
            f"{row.value:,g}".replace("-", "\u2212"),
            row.unit,
            f"<code>{row.field}</code>",
        )
        for row in rows
    ]
    note = (
        "<p>As the scenario <code>paper</code> holds it. The table's crane position is the stern corner; "
        "the figures above move it to the centre.</p>"
    )
    return note + _table(head, body, numbers=(2,))


def _integrators(folder: Path, compared: list[Compared], remarks: Measured) -> str:
    caption = (
        f"Errors after {DURATION_S:g} s with both motors on, no damping, no load, against what they cost. "
        "The kinetic energy should equal the work of the motors, and the angular momentum about the held "
        "centre should stay zero; the true orientation and slew angle are those of RK4 at "
        f"{1000 * REFERENCE_STEP_S:g} ms. Each mark is a step, or for Dormand-Prince a tolerance. Below "
        "right: the arm's joint holds a spring of 10<sup>9</sup> N m/rad, swinging at about 56 Hz. "
        "The two explicit forms of Euler differ only in the rotation: nothing else here depends on it."
    )
    picture = _picture(folder, comparison.NAME, "Errors of eight integrators against their cost", caption)
    head, *body = comparison.table(compared)
    columns = (
        "<p>Order: the expected one, then the slopes of the three errors against the step, up to 10 ms. "
        "Largest step: the energy error stays within a tenth of the work and the tower within "
        "0.1 rad of its true angle, on the paper's case and with the spring. Implicit schemes "
        "count the evaluations that their derivatives take. Times were measured on this machine.</p>"
    )
    advice = f'<p class="advice">{comparison.recommendation(compared)}</p>'
    note = (
        "<p>Why momentum beside energy: a term that does no work can be wrong and leave the energy "
        "balanced. With D left out of eq. 60b, both motors on for 1 s, RK4 at 1 ms closes the energy to "
        f"{power(remarks.without_d_energy)} of the work, and the angular momentum is off by "
        f"{remarks.without_d_momentum:,.0f} N m s.</p>"
    )
    return advice + picture + _table(head, body) + columns + note


def _errata(remarks: list[Erratum]) -> str:
    note = (
        "<p>Found by comparing the printed equations with finite differences of the kinematics and with "
        "other multibody engines. S(a) is the skew matrix of a, the paper's double arrow. Everything on "
        "this page is computed with the corrected forms. Right as printed: eqs. 8, 30, 34, 36, 37, 40, "
        "42, 49, 58, 60 to 63, rows 1 to 4 and 6 of 46a, and B54.</p>"
    )
    items = "".join(f'<li class="remark"><h3>{remark.title}</h3>{_remark(remark)}</li>' for remark in remarks)
    return f'{note}<ol class="errata">{items}</ol>'


def _remark(remark: Erratum) -> str:
    text = remark.text if remark.text.startswith("<") else f"<p>{remark.text}</p>"
    kinds = (("Printed", "as-printed", remark.printed), ("Corrected", "corrected", remark.corrected))
    lines = ""
    for label, style, equations in kinds:
        if equations:
            shown = "".join(convert(equation, display="block") for equation in equations)
            lines += f'<dt class="{style}">{label}</dt><dd>{shown}</dd>'
    return text + (f'<dl class="equations">{lines}</dl>' if lines else "")


def _files(drawn: list[Figure]) -> str:
    names = [*(figure.name for figure in drawn), comparison.NAME]
    items = [
        f"{name}: "
        + ", ".join(f'<a href="{name}.{kind}">{kind.upper()}</a>' for kind in ("csv", "png", "svg"))
        for name in names
    ]
    items.append('table_2: <a href="table_2.csv">CSV</a>, <a href="table_2.md">Markdown</a>')
    again = "<p>Any of the runs can be made again, for example Fig. 9: <code>kingpost run paper "
    again += "--set crane_x_m=0 --set crane_y_m=0 -o figure_9.nc</code></p>"
    return _list(items) + again


def _number(value: float) -> str:
    return f"{value:,g}".replace("-", "\u2212")


def _list(items: Iterable[str]) -> str:
    return "<ul>" + "".join(f"<li>{item}</li>" for item in items) + "</ul>"


def _table(head: Sequence[str], body: Iterable[Sequence[str]], numbers: Sequence[int] | None = None) -> str:
    """An HTML table; the columns named in `numbers` (default: all but the first) stand to the right."""
    right = range(1, len(head)) if numbers is None else numbers

    def row(cells: Sequence[str], tag: str) -> str:
        sides = (' class="number"' if column in right else "" for column in range(len(cells)))
        return "".join(f"<{tag}{side}>{cell}</{tag}>" for side, cell in zip(sides, cells, strict=True))

    lines = "".join(f"<tr>{row(cells, 'td')}</tr>" for cells in body)
    heading = f"<thead><tr>{row(head, 'th')}</tr></thead>"
    return f'<div class="scroll"><table>{heading}<tbody>{lines}</tbody></table></div>'
