"""Generates the site's page of the gallery: cards with titles and descriptions from the scenario files."""

from __future__ import annotations

import json
import re
from pathlib import Path

import yaml


def page(root: Path) -> str:
    """The gallery in its groups, as Markdown."""
    lines = [
        "# Gallery",
        "",
        "Every scenario that comes with Kingpost. Run one by its name: `kingpost run paper`. Open one in the "
        "app: `kingpost serve paper`. The pictures are the app's own, taken of the running scenario.",
        "",
    ]
    gallery = json.loads((root / "scenarios" / "gallery.json").read_text(encoding="utf-8"))
    for group in gallery["groups"]:
        lines += [f"## {group['title']}", ""]
        for name in group["scenarios"]:
            lines += card(root, name)
    return "\n".join([*lines, *plots(root)])


def card(root: Path, name: str) -> list[str]:
    """One scenario: picture, title, description and parameters."""
    scenario = yaml.safe_load((root / "scenarios" / f"{name}.yaml").read_text(encoding="utf-8"))
    description = " ".join(scenario["description"].split())
    knobs = ", ".join(f"`{parameter['name']}`" for parameter in scenario.get("parameters", []))
    return [
        f"### {scenario['title']} {{#{name}}}",
        "",
        f"![{scenario['title']}](cards/{name}.webp){{ .card }}",
        "",
        f"{description} [`{name}.yaml`](../scenarios/{name}.yaml)",
        "",
        *([f"Parameters: {knobs}.", ""] if knobs else []),
    ]


def plots(root: Path) -> list[str]:
    """Plots of the validation page, with a link to their explanation."""
    page = (root / "docs" / "validation.md").read_text(encoding="utf-8")
    lines = ["## Compared with measurements", "", "Explanations: [Validation](validation.md).", ""]
    for caption, picture in re.findall(r"!\[([^\]]+)\]\((validation/[^)]+)\)", page):
        lines += [f"![{caption}]({picture})", "", f"*{caption}.*", ""]
    return lines
