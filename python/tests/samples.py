"""Scenarios that several tests use, and a reader of tables."""

from functools import partial

import pandas

read_csv = partial(pandas.read_csv, float_precision="round_trip")
"""Read a CSV with exact numbers: before version 3 pandas by default may change the last digit for speed."""

CALIBRATION = {"crane_x_m": 0, "crane_y_m": 0, "simulation.duration_s": 0.5}
"""Crane at the centre, tower motor alone, no damping, no load, half a second."""

SMALL = """\
version: 1
title: A box with a boom
parameters:
  - name: mass
    label: Mass of the boom
    writes: [bodies.boom.mass_kg]
    range: [1, 1000]
simulation: {integrator: rk4, step_s: 0.01, duration_s: 0.1, record_every_s: 0.02}
bodies:
  box:
    mass_kg: 1000
    shape: {box: {length_m: 4, width_m: 3, height_m: 2}}
    joint: {floating: {hold_translation: false}}
  boom:
    parent: box
    mass_kg: 100
    inertia: {tensor: {moments_kg_m2: [10, 40, 40]}}
    joint: {revolute: {name: hinge, axis: [0, 1, 0], position_m: [0, 0, 1], child_position_m: [-1, 0, 0]}}
    points: {tip: {position_m: [1, 0, 0]}}
drives:
  motor: {motor: {joint: hinge, torque_N_m: 50}}
"""

# Three independent multibody codes agree on these digits for the calibration run. The value and
# what its printed digits leave open: 1e-5 with five decimals, half a unit of the last with four.
TRUTH = {
    "pitch rate": (0.19709, 1e-5),
    "yaw rate": (-0.12348, 1e-5),
    "roll rate": (-0.07719, 1e-5),
    "slew rate": (6.6699, 6e-5),
    "luff rate": (0.0338, 6e-5),
    "slew": (1.7159, 6e-5),
    "luff": (0.0632, 6e-5),
}
ROD = """\
  {name}:
    {parent}mass_kg: {mass}
    inertia: {{tensor: {{moments_kg_m2: [{moment}, {moment}, 0]}}}}
    joint:
      revolute:
        name: {joint}
        axis: [0, 1, 0]
        position_m: {at}
        child_position_m: [0, 0, {half}]
        damping_N_m_s: {damping}
        initial_angle_rad: 0.2
"""
DAMPING = """\
parameters:
  - {name: damping, label: Damping, default: 0, writes: [bodies.rod.joint.revolute.damping_N_m_s]}
"""


def rod(name="rod", joint="swing", length=2.0, mass=3.0, damping=0.0, parent="", at="[0, 0, 0]"):
    """A uniform rod that hangs on a hinge at its upper end."""
    parent = f"parent: {parent}\n    " if parent else ""
    return ROD.format(name=name, parent=parent, mass=mass, moment=mass * length**2 / 12, joint=joint,
                      at=at, half=length / 2, damping=damping)  # fmt: skip
