"""Drive functions: those of inverse dynamics are found; the gallery's hold the load; mistakes."""

from __future__ import annotations

import json

import kingpost
import numpy as np
import pytest
from kingpost import KingpostError

GALLERY = "load_held_by_drive_functions"
AFTER_S = 60.0
"""The swell has grown."""
MASS_KG, STIFFNESS, DAMPING, FORCE_N = 2.0, 20.0, 3.0, 10.0


def cage(commands: int = 16, period_s: float = 4.0, **changes: object) -> kingpost.Scenario:
    """A mass on a spring and a damper, pushed by a lever of 10 N, with a periodic function."""
    joint = {
        "name": "slide",
        "axis": [1, 0, 0],
        "spring": {"stiffness_N_per_m": STIFFNESS, "rest_m": 0},
        "damping_N_s_m": DAMPING,
    }
    curve = {
        "to": "push",
        "period_s": period_s,
        "time_s": [period_s * k / commands for k in range(commands)],
        "command": [0.0] * commands,
    }
    given = {
        "version": 1,
        "title": "A cage",
        "simulation": {"step_s": 0.01, "duration_s": 24},
        "bodies": {"cage": {"mass_kg": MASS_KG, "shape": {"point": {}}, "joint": {"prismatic": joint}}},
        "drives": {"push": {"linear_motor": {"joint": "slide", "force_N": FORCE_N, "history": "lever"}}},
        "controllers": {"curve": {"drive_function": curve | changes}},
    }
    return kingpost.Scenario(json.dumps(given), "cage.json")


def test_the_found_commands_equal_those_of_inverse_dynamics():
    # x = a sin(w t) needs the force m x'' + c x' + k x. The transient is 1e-5 after 16 s.
    # The spline through 16 commands errs by at most 5/384 (w h)^4 of the force, 3e-4 (Hall & Meyer,
    # J. Approx. Theory 16, 1976), and its values may differ from the force by as much.
    w, amplitude = 2 * np.pi / 4.0, 0.1
    scenario = cage()
    times = np.arange(0, 24.005, 0.01)
    wanted = {"slide.joint_position": amplitude * np.sin(w * times)}
    found = kingpost.drive_functions(scenario, "curve", wanted=wanted, from_s=16)
    knots = np.arange(16) * 0.25
    force = amplitude * ((STIFFNESS - MASS_KG * w**2) * np.sin(w * knots) + DAMPING * w * np.cos(w * knots))
    error = np.abs(FORCE_N * np.array(found.commands["curve"]) - force).max() / np.abs(force).max()
    assert error < 5 / 384 * (w * 0.25) ** 4 * 2
    assert found.deviation["slide.joint_position"] < 1e-3 * amplitude
    assert found.deviation_before["slide.joint_position"] == pytest.approx(amplitude / np.sqrt(2), rel=0.01)
    # It is linear: one step finds it, the next shows it.
    assert found.iterations <= 4
    assert found.scenario["controllers.curve.drive_function.command.3"] == found.commands["curve"][3]


@pytest.mark.parametrize(
    ("held_by", "ropes", "axes"), [("winch", False, "z"), ("boom", False, "xyz"), ("ropes", True, "xyz")]
)
def test_the_drive_functions_of_the_gallery_keep_the_load_in_place(held_by: str, ropes: bool, axes: str):
    def deviations(held: str) -> dict[str, float]:
        found = kingpost.run(GALLERY, {"simulation.duration_s": 90}, held_by=held, auxiliary_ropes=ropes)
        columns = {axis: found.kingpost[f"lift.position.{axis}"].values for axis in axes}
        counted = found.time.values >= AFTER_S
        return {axis: float(np.sqrt(np.mean((x - x[0])[counted] ** 2))) for axis, x in columns.items()}

    free, held = deviations("nothing"), deviations(held_by)
    assert all(held[axis] < 0.01 * free[axis] for axis in axes), (free, held)


@pytest.mark.thorough
def test_a_search_from_zero_finds_the_winch_of_the_gallery():
    path = "controllers.winch_hoists.drive_function.command"
    found = kingpost.drive_functions(
        GALLERY,
        "winch_hoists",
        {"simulation.duration_s": 74, path: [0] * 8},
        held_by="winch",
        wanted={"lift.position.z": None},
        from_s=AFTER_S,
    )
    assert found.deviation["lift.position.z"] < 0.01 * found.deviation_before["lift.position.z"]
    # The gallery's were sought over four periods, these over two: the swing of the load, which has a period
    # of its own, moves them by less than 1 % of the largest.
    kept = kingpost.load(GALLERY)[path]
    assert np.abs(np.subtract(found.commands["winch_hoists"], kept)).max() < 0.01 * max(kept)


def test_errors_name_the_wrong_value_and_the_allowed_ones():
    position = {"slide.joint_position": 0.1}
    short = {"simulation.duration_s": 0.1}
    for name, given, expected in [
        ("push", {}, "controllers: found push, allowed: curve"),
        ("curve", {"wanted": {}}, "wanted: found no column"),
        ("curve", {"wanted": {"slide.joint_positon": 0}}, "slide.joint_positon"),
        (
            "curve",
            {"wanted": {"slide.joint_position": [0, 1]}},
            r"wanted.slide.joint_position: found the shape \(2,\)",
        ),
        ("curve", {"weights": {"slide": 1}}, "weights: found slide, allowed: slide.joint_position"),
        ("curve", {"weights": {"slide.joint_position": 0}}, "weights.slide.joint_position: found 0"),
        ("curve", {"from_s": 1.0}, "from_s: found 1.0, allowed: at most 0.1"),
    ]:
        with pytest.raises(KingpostError, match=expected):
            kingpost.drive_functions(cage(), name, short, **({"wanted": position} | given))
    with pytest.raises(KingpostError, match="controllers: found curve, allowed: none"):
        kingpost.drive_functions(cage(enabled=False), "curve", short, wanted=position)
    with pytest.raises(
        KingpostError, match="controllers: found winch_hoists, allowed: a function that moves lift"
    ):
        kingpost.drive_functions(
            GALLERY, "winch_hoists", short, held_by="boom", wanted={"lift.position.z": None}
        )
