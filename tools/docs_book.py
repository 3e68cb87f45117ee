"""Figures and exercises of the book: blocks of YAML in a page, fenced with `figure` and `exercise`.

A figure is a scenario of the gallery with its parameters, controls, plot and camera: a run that is played in
the page where the site holds the built app, else a still with a link to the app. An exercise asks for a
number, a sign or a choice; `docs/exercises.js` checks the answer in the page.
"""

from __future__ import annotations

import os
import posixpath
import re
from html import escape
from pathlib import Path
from typing import Any
from urllib.parse import urlencode

import docs_math
import yaml

BLOCK = re.compile(r"^```(figure|exercise)[ ]*\n(.*?)^```[ ]*$", re.MULTILINE | re.DOTALL)
APP = os.environ.get("KINGPOST_APP", "http://127.0.0.1:8000/")
BUILT_APP = Path(__file__).resolve().parents[1] / "web" / "dist"
"""The app that `make web` builds; the site holds a copy of it."""
IN_SITE = "app/"
SIGNS = {"+": "positive", "0": "zero", "-": "negative"}
FIELDS = {
    "figure": ({"scenario", "caption"}, {"set", "controls", "plot", "camera"}),
    "exercise": (
        {"kind", "question", "answer", "by", "right", "wrong"},
        {"unit", "tolerance", "tolerance_reason", "options"},
    ),
}


def read(kind: str, text: str) -> dict[str, Any]:
    """Fields of a block.

    Raises
    ------
    ValueError
        A field is missing or unknown.
    """
    fields = yaml.safe_load(text)
    required, optional = FIELDS[kind]
    if fields.get("kind") == "number":
        required = required | {"tolerance", "tolerance_reason"}
    wrong = sorted(required - fields.keys()) + sorted(fields.keys() - required - optional)
    if wrong:
        raise ValueError(f"{kind}: found {', '.join(fields)}, missing or unknown: {', '.join(wrong)}")
    return fields


def exercises(page: str) -> list[dict[str, Any]]:
    """Exercises of a page, in their order."""
    return [read(kind, text) for kind, text in BLOCK.findall(page) if kind == "exercise"]


def figures(page: str) -> list[dict[str, Any]]:
    """Figures of a page, in their order."""
    return [read(kind, text) for kind, text in BLOCK.findall(page) if kind == "figure"]


def accepts(exercise: dict[str, Any], given: Any) -> bool:
    """Whether an answer is right: a number within the tolerance, else the answer itself."""
    return same(exercise, exercise["answer"], given)


def same(exercise: dict[str, Any], answer: Any, given: Any) -> bool:
    """Whether two answers to an exercise are one."""
    if exercise["kind"] == "number":
        return abs(float(given) - float(answer)) <= float(exercise["tolerance"])
    return str(given) == str(answer)


def rendered(markdown: str, to_root: str) -> str:
    """A page with its figures and exercises as HTML; `to_root` leads from the page to the site's first."""
    count = iter(range(1, 1000))

    def html(block: re.Match[str]) -> str:
        fields = read(block[1], block[2])
        made = figure(fields, to_root) if block[1] == "figure" else exercise(fields, next(count))
        return re.sub(r"\n+", "\n", made)

    return BLOCK.sub(html, markdown)


def inline(text: str) -> str:
    """Markdown of one paragraph as HTML, with formulas."""
    import markdown

    html = markdown.markdown(" ".join(str(text).split()), extensions=[docs_math.extension()])
    return html.removeprefix("<p>").removesuffix("</p>")


def figure(fields: dict[str, Any], to_root: str) -> str:
    """A figure with its caption and a link to the app with the same parameters."""
    live = escape(app_address(fields, to_root))
    caption = f'{inline(fields["caption"])} <a href="{live}">Run it in the app</a>'
    return f'<figure class="live">{picture(fields, to_root)}<figcaption>{caption}</figcaption></figure>'


def picture(fields: dict[str, Any], to_root: str) -> str:
    """A still of the scenario that leads to the app; with the built app, an element that plays the run. From
    a folder, without a server, the page shows the still."""
    live = escape(app_address(fields, to_root))
    still = posixpath.join(to_root, "cards", f"{fields['scenario']}.webp")
    shown = f'<a href="{live}"><img src="{still}" loading="lazy" alt="{title(fields)}"></a>'
    if not has_app():
        return shown
    attributes = {
        "src": posixpath.join(to_root, IN_SITE),
        "scenario": fields["scenario"],
        "set": "; ".join(f"{name}={value}" for name, value in values(fields).items()),
        "controls": ", ".join(fields.get("controls", [])),
        "plot": ", ".join(fields.get("plot", [])),
        "camera": fields.get("camera", ""),
        "poster": still,
    }
    given = " ".join(f'{name}="{escape(value)}"' for name, value in attributes.items() if value)
    return f"<kingpost-figure {given}>{shown}</kingpost-figure>"


def values(fields: dict[str, Any]) -> dict[str, str]:
    """Parameters of a figure as in an address of the app."""
    return {name: address_of(value) for name, value in fields.get("set", {}).items()}


def app_address(fields: dict[str, Any], to_root: str) -> str:
    """Address of the app with the scenario and the parameters of a figure."""
    app = posixpath.join(to_root, IN_SITE) if has_app() else APP
    return f"{app}?{urlencode({'scenario': fields['scenario'], **values(fields)})}"


def has_app() -> bool:
    """Whether the app is built, with the element that plays it in a page."""
    return (BUILT_APP / "kingpost-figure.js").is_file()


def title(fields: dict[str, Any]) -> str:
    """Description of a figure for readers who do not see it."""
    return f"Picture of the scenario {fields['scenario'].replace('_', ' ')}"


def address_of(value: Any) -> str:
    """A parameter's value in an address of the app."""
    return str(value).lower() if isinstance(value, bool) else str(value)


def exercise(fields: dict[str, Any], number: int) -> str:
    """A form that checks itself."""
    name = f"exercise-{number}"
    unit = f" {escape(fields['unit'])}" if fields.get("unit") else ""
    tolerance = ""
    if fields["kind"] == "number":
        reason = inline(fields["tolerance_reason"])
        tolerance = f"<small>Accepted within {fields['tolerance']:g}{unit}: {reason}</small>"
    wrong = "".join(
        f'<p hidden data-when="{escape(str(one["answer"]))}">{inline(one["because"])}</p>'
        for one in fields["wrong"]
    )
    data = f'data-kind="{fields["kind"]}" data-answer="{escape(str(fields["answer"]))}"'
    if "tolerance" in fields:
        data += f' data-tolerance="{fields["tolerance"]}"'
    return f"""<form class="exercise" id="{name}" {data}>
<fieldset><legend>Exercise {number}</legend><p>{inline(fields["question"])}</p>
{answers(fields, name, unit)} {tolerance}
<p><button type="submit" class="md-button">Check</button></p>
<div role="status"><p hidden data-right>Right. {inline(fields["right"])}</p>{wrong}\
<p hidden data-other>Not yet. Try again, or look at the answer.</p></div>
<details><summary>Answer</summary><p>{shown(fields)}{unit}. {inline(fields["right"])}</p></details>
</fieldset></form>"""


def shown(fields: dict[str, Any]) -> str:
    """The answer as a reader sees it."""
    return SIGNS[fields["answer"]] if fields["kind"] == "sign" else inline(fields["answer"])


def answers(fields: dict[str, Any], name: str, unit: str) -> str:
    """Inputs of the form: one for a number, or one for each of several answers."""
    if fields["kind"] == "number":
        field = '<input name="answer" inputmode="decimal" autocomplete="off" size="12" required>'
        return f"<label>Your answer: {field}{unit}</label>"
    options = SIGNS if fields["kind"] == "sign" else {option: option for option in fields["options"]}
    return "".join(
        f'<label><input type="radio" name="answer" value="{escape(value)}" required> {inline(text)}</label>'
        for value, text in options.items()
    )
