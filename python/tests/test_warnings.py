"""What the engine warns of in a run, in the data set, in a batch and in what `kingpost run` prints."""

from __future__ import annotations

import json

import kingpost
import pytest
from kingpost.cli import main

PENDULUM = """\
version: 1
title: a load on a rod
simulation: {{step_s: 0.002, duration_s: 3, record_every_s: 0.01}}
bodies:
  post: {{mass_t: 1, shape: {{point: {{}}}}, joint: {{fixed: {{position_m: [0, 0, 10]}}}}}}
  load:
    parent: post
    mass_kg: 100
    shape: {{sphere: {{radius_m: 0.1}}}}
    joint:
      universal:
        name: pendant
        first_axis: [1, 0, 0]
        second_axis: [0, 1, 0]
        child_position_m: [0, 0, 2]
        first: {{initial_angle_deg: {angle}}}
forces: {{gravity: {{gravity: {{}}}}}}
"""

ROD = """\
version: 1
title: a load on a massless rod
simulation: {{step_s: 0.002, duration_s: 1, record_every_s: 0.01}}
bodies:
  load:
    mass_kg: 100
    centre_of_mass_m: [0, 0, -0.5]
    inertia: {{radii_of_gyration: {{radii_m: [0.2, 0.2, 0.2]}}}}
    joint: {{floating: {{initial: {{position_m: [0, 0, {height}]}}}}}}
loops:
  rope:
    first: {{body: world, position_m: [0, 0, 10]}}
    second: {{body: load}}
    constraints: [{{distance: {{length_m: 3}}}}]
forces: {{gravity: {{gravity: {{}}}}}}
"""


def texts(results) -> list[str]:
    return [f"{warning['name']}: {warning['text']}" for warning in json.loads(results.attrs["warnings"])]


@pytest.mark.parametrize("angle", [60, 122])
def test_a_pendant_that_goes_over_the_top_is_told_of(tmp_path, capsys, angle) -> None:
    """A pendulum let go from rest at an angle carries m g cos(angle) first: it pushes beyond 90 degrees."""
    path = tmp_path / "pendulum.yaml"
    path.write_text(PENDULUM.format(angle=angle))
    found = texts(kingpost.run(path))
    assert any("pendant: the pendant of load pushes with" in text for text in found) == (angle > 90)
    assert any(f"pendant: load swings to {angle:.1f} deg" in text for text in found) == (angle > 90)
    assert main(["run", str(path)]) == 0
    shown = capsys.readouterr().out
    assert [line for line in shown.splitlines() if line.startswith("warning: pendant")] == [
        f"warning: {text}" for text in found
    ]


@pytest.mark.parametrize("height", [6.5, 12.5])
def test_a_massless_rod_that_holds_its_load_up_is_told_of(tmp_path, height) -> None:
    """The eye of a load of 100 kg, 0.5 m over its centre, is 3 m above the rod's other end: the rod pushes
    with the weight; or it is 3 m below: the rod pulls."""
    path = tmp_path / "rod.yaml"
    path.write_text(ROD.format(height=height))
    found = texts(kingpost.run(path))
    assert [text[: len("rope: the rod pushes with 980.6")] for text in found] == (
        ["rope: the rod pushes with 980.6"] if height > 10 else []
    )


def test_a_simulation_that_is_stepped_and_a_batch_have_the_warnings_of_the_run(tmp_path) -> None:
    """Source: the same rows, recorded in one go, by hand, and beside another run."""
    path = tmp_path / "pendulum.yaml"
    path.write_text(PENDULUM.format(angle=122))
    recorded = json.loads(kingpost.run(path).attrs["warnings"])
    simulation = kingpost.Simulation(kingpost.load(path))
    assert simulation.warnings == []
    for _ in range(300):
        simulation.row()
        simulation.step(5)
    assert [warning.text for warning in simulation.warnings] == [warning["text"] for warning in recorded]
    simulation.reset()
    assert simulation.warnings == []
    angle = "bodies.load.joint.universal.first.initial_angle_rad"
    batch = kingpost.Batch(path, {angle: [1.0, 2.129301687433082, 1.1]}).run()
    assert json.loads(batch.attrs["warnings"]) == [[], recorded, []]
