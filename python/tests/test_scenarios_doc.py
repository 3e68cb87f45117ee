"""docs/scenarios.md: every piece of its scenario reads, every command runs, its table is the engine's."""

from __future__ import annotations

import copy
import re
import shlex
from pathlib import Path
from typing import Any

import kingpost
import pytest
import yaml
from gallery_pass import Gallery
from kingpost import cli

PAGE = (Path(__file__).resolve().parents[2] / "docs" / "scenarios.md").read_text(encoding="utf-8")
BLOCKS = re.findall(r"```([\w ]*)\n(.*?)```", PAGE, re.DOTALL)
FILE = "barge_crane.yaml"
RECORD = "time_s,elevation_m\n" + "\n".join(f"{i},{(-1) ** i * 0.2}" for i in range(64)) + "\n"


def merged(whole: Any, piece: Any) -> Any:
    """A piece added to what is there: fields under the same keys, items with fields behind the others."""
    if isinstance(whole, dict) and isinstance(piece, dict):
        return whole | {key: merged(whole.get(key), value) for key, value in piece.items()}
    if isinstance(whole, list) and all(isinstance(item, dict) for item in piece):
        return [*whole, *(item for item in piece if item not in whole)]
    return piece


def write(scenario: Any, path: str = FILE) -> None:
    Path(path).write_text(yaml.safe_dump(scenario, sort_keys=False), encoding="utf-8")


def commands(block: str) -> list[list[str]]:
    return [shlex.split(line)[1:] for line in block.splitlines()]


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """With the database that the page computes, and a record of waves."""
    pytest.importorskip("capytaine")
    made = tmp_path_factory.mktemp("scenario")
    (words,) = commands(BLOCKS[0][1])
    assert words[0] == "hydro"
    output = words.index("-o") + 1
    assert cli.main([*words[:output], str(made / words[output]), *words[output + 1 :]]) == 0
    (made / "gauge.csv").write_text(RECORD)
    return made


def test_the_page_is_a_scenario_that_grows_and_runs(folder, monkeypatch, capsys) -> None:
    monkeypatch.chdir(folder)
    whole: Any = {}
    ran = []
    for language, block in BLOCKS[1:]:
        if language == "yaml":
            piece = yaml.safe_load(block)
            for one in each_sea(piece):
                write(merged(whole, one))
                kingpost.Simulation(kingpost.load(FILE)).step(3)
            whole = whole if "regular_wave" in block else merged(whole, piece)
            write(whole)
        elif language == "yaml mode":
            for mode in block.splitlines():
                write(slewing(whole, mode), "moved.yaml")
                kingpost.Simulation(kingpost.load("moved.yaml")).step(3)
        elif language == "python":
            exec(compile(block, "scenarios.md", "exec"), {})
        else:
            for words in commands(block):
                ran.append(words[0])
                words = [*words, "--check", "--port", "0"] if words[0] == "serve" else words
                assert cli.main(words) == 0, words
    assert ran == ["check", "run", "statistics", "plot", "rao", "serve"]
    shown = capsys.readouterr().out
    assert "pendant.joint_reaction.force_z" in shown
    # Light crane on a wide barge: upright but for a few degrees.
    assert max(abs(kingpost.run(FILE, {"simulation.duration_s": 30})["roll"].sel(body="hull").values)) < 0.1


def slewing(scenario: Any, mode: str) -> Any:
    """The scenario with a line of the page as the mode of its slewing joint, or of a slide in its place."""
    moved = copy.deepcopy(scenario)
    (joint,) = [body["joint"] for body in moved["bodies"].values()
                if body.get("joint", {}).get("revolute", {}).get("name") == "slew"]  # fmt: skip
    joint["revolute"] |= yaml.safe_load(mode)
    if "_m" in mode:
        joint["prismatic"] = joint.pop("revolute")
        del joint["prismatic"]["initial_angle_deg"]
    return moved


def each_sea(piece: Any) -> list[Any]:
    """Of a piece with several wave systems one for each of them."""
    waves = piece.get("sea", {}).get("waves", {})
    return [{"sea": {"waves": {name: waves[name]}}} for name in waves] if len(waves) > 1 else [piece]


def table(shown: Gallery) -> list[str]:
    """The table of results that the page should have."""
    # Of the gallery, one with turning and sliding joints, loops and cylinders names units and labels.
    found: dict[str, dict] = {}
    for name in ("knuckle_boom_crane", *kingpost.gallery.names()):
        for channel in shown[name]["channels"]:
            known = found.setdefault(channel["variable"], {**channel, "units": []})
            known["units"] += [unit for unit in channel["units"] if unit not in known["units"]]
    channels = sorted(
        found.values(), key=lambda channel: not channel["dims"] and channel["variable"] != "time"
    )
    labels = {"body": "hull", "axis": "z", "quaternion": "w", "coordinate": "pendant.first",
              "joint": "pendant",
              "component": "force_z", "point": "boom.tip", "hull": "water", "line": "line_astern",
              "line_point": "line_astern.point_8",
              "flow": "wind_on_hull", "planar": "yaw", "seen_from": "hull"}  # fmt: skip
    rows = [
        "| variable | a column | unit | frame | dimensions | what it is |",
        "| --- | --- | --- | --- | --- | --- |",
    ]
    for channel in channels:
        kinds = {dim: dim.partition("_with_")[0].upper() for dim in channel["dims"]}
        # No line of the page is paid out.
        named = {} if channel["variable"] == "line_pay_out_rate" else labels
        at = {dim: named.get(dim, f"NAME_OF_{kind}") for dim, kind in kinds.items()}
        cells = (f"`{channel['variable']}`", f"`{channel['column'].format_map(at)}`",
                 " or ".join(dict.fromkeys(channel["units"])),
                 "" if channel["frame"] == "none" else channel["frame"].replace("_", " "),
                 ", ".join(channel["dims"]), channel["description"])  # fmt: skip
        rows.append("| " + " | ".join(cells) + " |")
    return rows


def test_the_table_of_results_is_the_engines(shown) -> None:
    found = [line for line in PAGE.split("## Results")[1].splitlines() if line.startswith("|")]
    now = table(shown)
    assert found == now, "\n".join(["it is now:", *now])


def test_the_page_names_the_dimension_of_a_variable_that_only_some_ropes_have() -> None:
    """Source: a lift with four slings, of which none leads over a crane."""
    found = kingpost.run("four_leg_lift", {"simulation.duration_s": 0.01})
    (dimension,) = set(found["rope_offlead"].dims) - {"time"}
    assert found[dimension].values.tolist() == ["hoist_rope"]
    assert len(found["rope"]) == 5
    assert f"`{dimension}`" in PAGE


def test_the_columns_that_the_page_names_are_columns(folder, monkeypatch) -> None:
    monkeypatch.chdir(folder)
    names = set(re.findall(r"`([a-z_]+(?:\.[a-z_]+)+)`", PAGE.split("## Results")[1]))
    columns = set(kingpost.results.frame(kingpost.run(FILE, {"simulation.duration_s": 0.2})).columns)
    columns_named = {name for name in names if not name.endswith(".csv")}
    assert len(columns_named) > 20
    assert columns_named <= columns
