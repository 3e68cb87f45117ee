"""Warnings of the engine in a run, in the data set, in a batch and in the output of `kingpost run`."""

from __future__ import annotations

import json
import warnings as python_warnings

import kingpost
import pandas
import pyarrow.parquet
import pytest
from kingpost import results
from kingpost.cli import main
from kingpost.results import entries

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


def texts(found) -> list[str]:
    return [f"{warning['name']}: {warning['text']}" for warning in entries.warnings_of(found)]


@pytest.mark.parametrize("angle", [60, 122])
def test_a_pendant_that_goes_over_the_top_gives_a_warning(tmp_path, capsys, angle) -> None:
    """A pendulum let go from rest at an angle carries m g cos(angle) first: it pushes beyond 90 degrees."""
    path = tmp_path / "pendulum.yaml"
    path.write_text(PENDULUM.format(angle=angle))
    found = texts(kingpost.run(path))
    assert any("pendant: the pendant of load pushes with" in text for text in found) == (angle > 90)
    assert any(f"pendant: load swings to {angle:.1f} deg" in text for text in found) == (angle > 90)
    assert main(["run", str(path)]) == 0
    assert capsys.readouterr().err.splitlines() == [f"warning: {text}" for text in found]


@pytest.mark.parametrize("height", [6.5, 12.5])
def test_a_massless_rod_that_holds_its_load_up_gives_a_warning(tmp_path, height) -> None:
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
    recorded = entries.warnings_of(kingpost.run(path))
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
    assert entries.warnings_of_runs(batch) == [[], recorded, []]
    assert batch.warning_run.values.tolist() == [1] * len(recorded)
    assert entries.warnings_of(batch.isel(run=1)) == recorded


STEP = "simulation.step_s"
LIFT = {"waves": True, "significant_height_m": 4, "wave_direction_deg": 90, "peak_period_s": 6,
        "simulation.duration_s": 32, "simulation.seed": 2}  # fmt: skip
"""A barge that leans until her deck goes under water."""


def told_by(work) -> list[str]:
    """Python warnings as shown in a notebook."""
    with python_warnings.catch_warnings(record=True) as caught:
        python_warnings.simplefilter("always")
        work()
    ours = [one for one in caught if issubclass(one.category, kingpost.KingpostWarning)]
    # The line that a reader is pointed at is his own.
    assert {one.filename for one in ours} <= {__file__}
    return [str(one.message) for one in ours]


def test_a_notebook_a_command_line_and_files_have_the_same_warnings_of_a_run(tmp_path, capsys) -> None:
    """Source: the definition; one run of a barge that leans far, and the same run as one of two seeds."""
    found: list = []
    told = told_by(lambda: found.append(kingpost.run("barge", LIFT)))
    assert sum("the edge of its deck went" in text for text in told) == 1
    assert told == texts(found[0])
    assert told_by(lambda: kingpost.Simulation(kingpost.load("barge", LIFT)).run()) == told
    assert told_by(lambda: kingpost.Batch("barge", {"simulation.seed": [2]}, LIFT).run()) == told
    settings = [f"--set={name}={str(value).lower()}" for name, value in LIFT.items()]
    for name in ("run.nc", "run.csv", "run.parquet"):
        assert main(["run", "barge", *settings, "-o", str(tmp_path / name)]) == 0
        shown = capsys.readouterr()
        assert shown.err.splitlines() == [f"warning: {text}" for text in told]
        assert "warning" not in shown.out
    assert main(["run", "barge", *settings, "--seeds", "2", "-o", str(tmp_path / "run_*.nc")]) == 0
    lines = capsys.readouterr().err.splitlines()
    assert sum("the edge of its deck went" in line for line in lines) == 1
    assert all(line.startswith("warning, in ") for line in lines)
    for name in ("run.nc", "run_2.nc"):
        assert texts(results.read(tmp_path / name)) == told
    metadata = pyarrow.parquet.read_schema(tmp_path / "run.parquet").metadata
    assert json.loads(metadata[b"entries"]) == json.loads(entries.as_json(found[0]))
    assert json.loads(metadata[b"entries"])["warnings"] == entries.warnings_of(found[0])
    beside = pandas.read_csv(tmp_path / "run.warnings.csv")
    assert [f"{row.warning_name}: {row.warning_text}" for row in beside.itertuples()] == told


def test_a_step_that_is_too_long_also_gives_a_warning_in_python(capsys) -> None:
    """Source: the command line, which says the same of the same run."""
    short = {STEP: 0.02, "simulation.duration_s": 0.04, "simulation.record_every_s": 0.02}
    told = told_by(lambda: kingpost.run("vessel_knuckle_boom", short))
    assert told[0].startswith("the step of 0.02 s is too long for rk4")
    settings = [f"--set={name}={value}" for name, value in short.items()]
    assert main(["run", "vessel_knuckle_boom", *settings]) == 0
    assert capsys.readouterr().err.splitlines() == [f"warning: {text}" for text in told]


def test_each_warning_of_many_runs_is_emitted_once(tmp_path) -> None:
    """Source: a pendulum that goes over the top in two of three runs."""
    path = tmp_path / "pendulum.yaml"
    path.write_text(PENDULUM.format(angle=60))
    batch = kingpost.Batch(path, {"bodies.load.joint.universal.first.initial_angle_rad": [1.0, 2.1, 2.2]})
    told = told_by(batch.run)
    assert sum("swings to" in text for text in told) == 1
    assert all(text.startswith("in 2 of 3 runs, from ") and "(run 2)" in text for text in told)


def test_a_filter_of_python_stops_the_warnings_and_no_others(tmp_path) -> None:
    path = tmp_path / "pendulum.yaml"
    path.write_text(PENDULUM.format(angle=122))
    with python_warnings.catch_warnings(record=True) as caught:
        python_warnings.simplefilter("always")
        python_warnings.simplefilter("ignore", kingpost.KingpostWarning)
        kingpost.run(path)
        python_warnings.warn("another's", UserWarning, stacklevel=1)
    assert [str(one.message) for one in caught] == ["another's"]
