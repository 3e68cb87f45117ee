"""Ropes compared with Exudyn and MuJoCo: their stored runs, and the reason why that of a drum differs."""

from __future__ import annotations

import json
import re
from pathlib import Path

import numpy as np
from kingpost.verify import ropes, running

PAGE = Path(__file__).resolve().parents[2] / "docs" / "validation.md"
KEPT = ropes.kept()


def test_the_kept_run_of_the_reeving_has_the_number_that_its_suite_publishes() -> None:
    """Source: Exudyn's `runTestSuiteRefSol.py`. The suite holds the fixed ends by joints, solved to 1e-10."""
    found = KEPT["reeving"]["as_published"]["norm"]
    published = KEPT["reeving"]["published_norm"]
    assert abs(found - published) < 1e-9
    assert abs(KEPT["reeving"]["as_published"]["norm_without_dampers"] / published - 1.0125) < 5e-4


def drum_turns(*, strain_energy: bool) -> float:
    """Turn of the lift's drum after its 5 s, by these equations and RK4 of 1 ms: the load (x, z) hangs from a
    circle, the drum pays out rope; the torque of the strain energy that winds on acts or does not."""
    case = KEPT["lift"]
    radius, arm, mass = case["radius_m"], case["drum_radius_m"], case["load_kg"]
    moment = case["carriage_kg"] * arm**2
    lead = -case["carriage_m"][0]

    def rates(y: np.ndarray) -> np.ndarray:
        (x, z, turn), (u, w, rate) = y[:3], y[3:]
        distance = np.hypot(x, z)
        leg = np.sqrt(distance**2 - radius**2)
        # From the top of the circle to where the leg touches it, by angles from straight up towards x.
        wrapped = np.arctan2(x, z) % (2 * np.pi) - np.arccos(radius / distance)
        along = np.array([np.cos(wrapped), -np.sin(wrapped)])
        length = case["unstretched_length_m"] + arm * turn
        stretch = lead + radius * wrapped + leg - length
        stiffness = case["axial_stiffness_N"] / length
        elastic = stiffness * stretch
        tension = elastic + stiffness * case["damping_time_s"] * (along @ [u, w] - arm * rate)
        energy = arm * elastic**2 / (2 * case["axial_stiffness_N"]) if strain_energy else 0.0
        torque = arm * (tension - case["pull_N"]) + energy
        fall = np.array([0, -case["gravity_m_s2"]]) - tension / mass * along
        return np.array([u, w, rate, *fall, torque / moment])

    y = np.array([case["load_m"][0], case["load_m"][2], 0, case["load_velocity_m_s"][0], 0, 0])
    h = 1e-3
    for _ in range(round(case["duration_s"] / h)):
        a = rates(y)
        b = rates(y + h / 2 * a)
        c = rates(y + h / 2 * b)
        y = y + h / 6 * (a + 2 * b + 2 * c + rates(y + h * c))
    return float(y[2])


def test_a_drum_turns_by_the_strain_energy_of_the_wound_rope_and_exudyns_drum_without_it() -> None:
    """The same law by equations of its own; ten figures of Exudyn's are kept."""
    ours = ropes.track(ropes.lift(drum=True), KEPT["lift"], "load")["winch"][-1]
    assert abs(ours / drum_turns(strain_energy=True) - 1) < 1e-9
    theirs = KEPT["lift"]["drum"]["drum_rad"][-1]
    assert abs(theirs / drum_turns(strain_energy=False) - 1) < 1e-9
    assert abs(theirs - ours) > 0.04


def test_the_page_agrees_with_the_present_results_of_ropes() -> None:
    """Source: the rows, and of MuJoCo's smooth cylinder the kept run."""
    page = PAGE.read_text(encoding="utf-8").split("### Ropes over sheaves")[1].split("\n### ")[0]
    rows = {one.id: one for one in running.checks("peers")}
    printed = dict(re.findall(r"^\| .* \| `([a-z-]+)` \| ([\d.e-]+) \|$", page, re.MULTILINE))
    assert set(printed) == {name for name in rows if "lift" in name or "reeving" in name}
    for name, text in printed.items():
        error = rows[name].measure().error
        # Differences at rounding of the ten figures are printed by their bound.
        assert error < 1e-8 if text == "1e-8" else abs(error / float(text) - 1) < 0.06, (name, error)
    ours = ropes.track(ropes.lift(ropes.SIDEWAYS), KEPT["lift"], "load")["place"]
    apart = np.abs(ours - np.array(KEPT["lift"]["mujoco_sideways"]["load_m"])).max()
    assert f"{apart:.2f} m" in page


def test_the_stored_runs_name_their_origin() -> None:
    script = Path(__file__).parent / "peers" / "rope_lifts.py"
    assert json.dumps(KEPT["command"])[1:-1] in script.read_text(encoding="utf-8")
