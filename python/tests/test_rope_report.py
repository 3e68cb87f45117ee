"""Where a rod stands for a rope and does what no rope does: `kingpost run` and the data set say so."""

from __future__ import annotations

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


@pytest.mark.parametrize("angle", [60, 122])
def test_a_pendant_that_goes_over_the_top_is_told_of(tmp_path, capsys, angle) -> None:
    """A pendulum let go from rest at an angle carries m g cos(angle) first: it pushes beyond 90 degrees."""
    path = tmp_path / "pendulum.yaml"
    path.write_text(PENDULUM.format(angle=angle))
    warning = kingpost.run(path).attrs.get("warning", "")
    assert ("pendant of load pushes with" in warning) == (angle > 90)
    assert (f"load swings to {angle:.1f} deg" in warning) == (angle > 90)
    assert main(["run", str(path)]) == 0
    assert ("warning: pendant" in capsys.readouterr().out) == (angle > 90)


@pytest.mark.parametrize("height", [6.5, 12.5])
def test_a_massless_rod_that_holds_its_load_up_is_told_of(tmp_path, height) -> None:
    """The eye of a load of 100 kg, 0.5 m over its centre, is 3 m above the rod's other end: the rod pushes
    with the weight; or it is 3 m below: the rod pulls."""
    path = tmp_path / "rod.yaml"
    path.write_text(ROD.format(height=height))
    warning = kingpost.run(path).attrs.get("warning", "")
    assert (warning.startswith("rope: the rod pushes with 980.6")) == (height > 10), warning
