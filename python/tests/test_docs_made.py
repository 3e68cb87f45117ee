"""The pages of the site that are made at every build: the gallery and the fields of a scenario."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import docs_commands
import docs_gallery
import docs_schema
import pytest
from kingpost.reports import fields

ROOT = Path(__file__).resolve().parents[2]
SCHEMA = ROOT / "schema" / "scenario.schema.json"
STUDY = ROOT / "schema" / "study.schema.json"


@pytest.fixture(scope="module")
def schema() -> dict[str, Any]:
    return json.loads(SCHEMA.read_text(encoding="utf-8"))


def objects(schema: dict[str, Any]) -> list[dict[str, Any]]:
    return [one for one in (schema, *schema["$defs"].values()) if "properties" in one]


def test_every_field_of_the_schema_is_on_its_page(schema) -> None:
    page = docs_schema.page(SCHEMA)
    names = {name for one in objects(schema) for name in one["properties"]}
    assert len(names) > 300
    assert names <= set(re.findall(r"`([A-Za-z0-9_]+)`", page))


def test_every_link_of_the_page_of_fields_leads_to_a_heading(schema) -> None:
    page = docs_schema.page(SCHEMA)
    headings = {heading.lower() for heading in re.findall(r"^## (\w+)$", page, re.MULTILINE)}
    assert {name.lower() for name in schema["$defs"]} <= headings
    assert set(re.findall(r"\(#(\w+)\)", page)) <= headings


def test_the_asterisk_of_a_symbol_is_kept_on_the_page() -> None:
    """Source: two stars of a paragraph, as in M* q'' = F*, mean italics in Markdown and are gone."""
    code = re.compile(r"^```.*?^```|^    .*?$|`[^`\n]*`", re.DOTALL | re.MULTILINE)
    for path in (*ROOT.glob("*.md"), *ROOT.glob("docs/**/*.md")):
        text = code.sub("", path.read_text(encoding="utf-8"))
        assert re.findall(r"(?<!\w)[MNF]\*(?!\*).*", text) == [], path


def test_every_field_of_a_study_is_on_its_page_with_links_to_headings() -> None:
    schema = json.loads(STUDY.read_text(encoding="utf-8"))
    page = docs_schema.page(STUDY)
    assert page.startswith("# Fields of a study\n")
    names = {name for one in objects(schema) for name in one["properties"]}
    assert (
        {"axes", "scatter", "operation_s", "from_s"} <= names <= set(re.findall(r"`([A-Za-z0-9_]+)`", page))
    )
    assert "| `axes` |  | [Axis](#axis) by name |" in page
    headings = {heading.lower() for heading in re.findall(r"^## (\w+)$", page, re.MULTILINE)}
    assert set(re.findall(r"\(#(\w+)\)", page)) <= headings


def test_the_unit_of_a_name_is_the_unit_that_its_description_ends_in(schema) -> None:
    """Descriptions end as "Mass, kg."; a name in another unit says so in the column of units."""
    powers = str.maketrans({"²": "^2", "³": "^3", "⁴": "^4"})
    seen = 0
    for one in objects(schema):
        for name, field in one["properties"].items():
            unit = docs_schema.unit(name).translate(powers)
            ending = re.search(r", ([A-Za-z/^0-9 ()]+)\.$", field.get("description", ""))
            known = {other.translate(powers) for other in fields.UNITS.values()}
            if ending and ending[1] in known and "x-alias-of" not in field:
                seen += 1
                assert unit == ending[1], f"{name}: {field['description']}"
    assert seen > 80


def test_a_range_and_a_default_are_written_as_a_reader_expects() -> None:
    field = {"type": "number", "minimum": 0, "maximum": 1, "default": 0.5, "description": "A share."}
    assert docs_schema.row(["share"], field, False) == "| `share` |  | number ≥ 0, ≤ 1 | `0.5` | A share. |"
    field = {"type": "number", "exclusiveMinimum": 0, "description": "Mass, kg."}
    expected = "| `mass_kg`<br>`mass_t` | kg<br>t | number > 0 | required | Mass, kg. |"
    assert docs_schema.row(["mass_kg", "mass_t"], field, True) == expected
    field = {"type": "array", "items": {"type": "number", "minimum": 0}, "minItems": 3, "maxItems": 3}
    assert docs_schema.value(field) == "list of 3 numbers ≥ 0"


def test_every_scenario_of_the_gallery_is_on_its_page_with_a_picture() -> None:
    page = docs_gallery.page(ROOT)
    groups = json.loads((ROOT / "scenarios" / "gallery.json").read_text(encoding="utf-8"))["groups"]
    for name in (name for group in groups for name in group["scenarios"]):
        assert f"cards/{name}.webp" in page
        assert (ROOT / "web" / "public" / "cards" / f"{name}.webp").is_file()


def test_the_page_of_commands_has_every_command() -> None:
    page = docs_commands.page()
    for command in (
        "run",
        "check",
        "modes",
        "rao",
        "statistics",
        "plot",
        "list",
        "hydro",
        "roll-damping",
        "serve",
    ):
        assert f"## kingpost {command}\n" in page
        assert f"usage: kingpost {command} " in page
