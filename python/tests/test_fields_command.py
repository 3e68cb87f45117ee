"""The command `kingpost fields`: the fields of every kind, as the engine's own types have them."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from kingpost.cli import main
from kingpost.reports import fields

SCHEMA = Path(__file__).resolve().parents[2] / "schema" / "scenario.schema.json"


def test_the_fields_of_a_rope_have_unit_default_and_meaning_with_nested_types(capsys) -> None:
    assert main(["fields", "rope"]) == 0
    text = capsys.readouterr().out
    assert text.startswith("rope (Force)\n")
    assert "  axial_stiffness_N [N], axial_stiffness_kN [kN]: number > 0\n" in text
    assert "  damping_time_s [s]: number ≥ 0, default 0\n" in text
    assert "  path: list of RopeStation, required\n" in text
    nested = text.split("\nCarriedByRope\n")[1]
    assert "  share: number > 0, default 1\n      Pull of the rope at rest" in nested


def test_without_a_name_every_kind_of_the_schema_is_listed(capsys) -> None:
    """Source: the alternatives of the JSON Schema."""
    assert main(["fields"]) == 0
    listed = {line.split()[0] for line in capsys.readouterr().out.splitlines() if line.startswith("  ")}
    schema = json.loads(SCHEMA.read_text(encoding="utf-8"))
    alternatives = (one for choice in schema["$defs"].values() for one in choice.get("oneOf", []))
    expected = {
        name for one in alternatives for name, inner in one.get("properties", {}).items() if "$ref" in inner
    }
    assert listed == expected
    assert len(expected) > 60


@pytest.mark.parametrize(("name", "nearest"), [("roop", "rope"), ("hydrodinamics", "hydrodynamics")])
def test_an_unknown_name_is_refused_with_the_nearest(name, nearest, capsys) -> None:
    assert main(["fields", name]) == 2
    assert (
        f"{name}: no kind, section or type of a scenario; did you mean {nearest}?" in capsys.readouterr().err
    )


def test_every_kind_section_and_type_can_be_printed() -> None:
    names = {kind.name for kind in fields.kinds()} | set(fields.schema()["$defs"]) | {"simulation", "sea"}
    for name in names:
        assert fields.reference(name).lower().startswith(name.lower())


def test_a_name_of_several_choices_prints_each(capsys) -> None:
    assert main(["fields", "cylinder", "--json"]) == 0
    types = [one["type"] for one in json.loads(capsys.readouterr().out)]
    assert types == list(dict.fromkeys(types))
    assert len(types) >= 2
