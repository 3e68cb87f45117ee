"""Equilibria at every scale: stiff slings, deep water, long wires, and drives that carry a load there."""

from __future__ import annotations

from pathlib import Path

import kingpost
import numpy as np
import pytest
from lanes import sampled

G = 9.80665
SLING = """version: 1
title: A load on a sling
simulation: {{step_s: 1.0e-4, duration_s: 1.0e-3, begin_at_equilibrium: true}}
bodies:
  load:
    mass_t: {mass_t}
    shape: {{sphere: {{radius_m: 1}}}}
    joint: {{floating: {{initial: {{position_m: [0, 0, {below}]}}}}}}
forces:
  gravity: {{gravity: {{}}}}
  sling:
    rope:
      path:
        - {{point: {{body: world, position_m: [0, 0, {above}]}}}}
        - {{point: {{body: load, position_m: [0, 0, 1]}}}}
      unstretched_length_m: 19
      axial_stiffness_kN: {stiffness_kN}
      damping_time_s: 0.01
"""
LEVERS = {
    "simulation.begin_at_equilibrium": True,
    "drives.main_luffing.cylinder.target": "lever",
    "drives.knuckle_luffing.cylinder.target": "lever",
}


@pytest.mark.parametrize(
    ("depth_m", "stiffness_kn", "mass_t"),
    sampled(
        [
            (depth, stiffness, mass)
            for depth in (0, 300, 3000)
            for stiffness in (1e4, 1e6, 1e8, 1e10)
            for mass in (1, 1000)
        ],
        keep=[(0, 1e10, 1000), (3000, 1e6, 1), (3000, 1e10, 1)],
    ),
)
def test_a_load_on_a_stiff_sling_rests(
    depth_m: float, stiffness_kn: float, mass_t: float, tmp_path: Path
) -> None:
    """Source: the pull is m g. Rounding of places times stiffness over mass exceeds 1e-10 m/s2 there."""
    if mass_t * G > 0.04 * stiffness_kn:
        pytest.skip("stretched by more than 4 %")
    path = tmp_path / "sling.yaml"
    text = SLING.format(mass_t=mass_t, stiffness_kN=stiffness_kn, above=-depth_m, below=-depth_m - 20)
    path.write_text(text, encoding="utf-8")
    tension = kingpost.run(path).rope_tension.values[0, 0]
    # Known to the rounding of its ends times its stiffness.
    rounding_n = 4 * np.finfo(float).eps * (depth_m + 20) * 1e3 * stiffness_kn / 19
    assert tension == pytest.approx(1e3 * mass_t * G, rel=1e-9, abs=rounding_n)


def test_cylinders_by_lever_carry_the_crane_where_a_run_begins_at_an_equilibrium() -> None:
    """Source: at rest nothing accelerates; a lever holds the length that it has set."""
    crane = kingpost.load("knuckle_boom_crane")
    set_to = {name: value for name, value in LEVERS.items() if name.startswith("simulation")}
    drives = crane.resolved["drives"]
    cylinders = [name for name, drive in drives.items() if "cylinder" in drive]
    set_to |= {f"drives.{name}.cylinder.target": "lever" for name in cylinders}
    set_to["simulation.duration_s"] = 0.1
    found = kingpost.run(crane.with_overrides(set_to))
    lengths = found.cylinder_length.values
    assert np.abs(found.acceleration.values[0]).max() < 1e-8
    assert np.abs(lengths - lengths[0]).max() < 1e-8
    assert np.abs(found.cylinder_force.values[0]).min() > 1e5
    linear = kingpost.Simulation(crane.with_overrides(set_to)).linearize()
    assert np.isfinite(linear.A.values).all()


def test_a_load_under_water_counts_at_its_submerged_weight_in_the_righting_arms() -> None:
    """Source: the heel at which the ship rests is where GZ passes through zero, by the mesh and by linear
    buoyancy within 0.1 degrees; 20 t in the air are 13.85 t here."""
    (hull,) = kingpost.load("heave_compensation").hydrostatics["hulls"]
    (load,) = hull["hanging"]
    assert load["mass_kg"] == pytest.approx(13_850, rel=1e-3)
    assert hull["mass_kg"] == pytest.approx(hull["displacement_kg"], rel=2e-5)
    curve = hull["righting_arm"]
    assert curve["equilibrium_rad"] == pytest.approx(hull["heel_rad"], abs=np.deg2rad(0.1))
    assert np.rad2deg(curve["vanishing_rad"]) == pytest.approx(39.5, abs=0.1)
