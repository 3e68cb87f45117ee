"""MuJoCo's spatial tendon over a cylinder, in the lift of `rope_lifts.py`."""

from __future__ import annotations

from typing import Any

import mujoco
import numpy as np


def mjcf(case: dict[str, Any], step: float) -> str:
    """The lift in MJCF: a tendon that pulls only, by a range of lengths without force."""
    arm = case["radius_m"]
    length = case["unstretched_length_m"]
    stiffness = case["axial_stiffness_N"] / length

    def row(values: list[float]) -> str:
        return " ".join(repr(float(one)) for one in values)

    slides = "".join(f'<joint type="slide" axis="{axis}"/>' for axis in ("1 0 0", "0 1 0", "0 0 1"))
    return f"""<mujoco>
<option integrator="RK4" timestep="{step!r}" gravity="0 0 {-case["gravity_m_s2"]!r}"/>
<worldbody>
<site name="side" pos="{row([arm, 0, arm])}"/>
<geom name="sheave" type="cylinder" size="{arm!r} 0.1" zaxis="0 1 0" contype="0" conaffinity="0"/>
<body pos="{row(case["carriage_m"])}"><joint type="slide" axis="1 0 0"/>
<inertial pos="0 0 0" mass="{case["carriage_kg"]!r}" diaginertia="100 100 100"/><site name="carriage"/></body>
<body pos="{row(case["load_m"])}">{slides}
<inertial pos="0 0 0" mass="{case["load_kg"]!r}" diaginertia="100 100 100"/><site name="load"/></body>
</worldbody>
<tendon><spatial stiffness="{stiffness!r}" damping="{stiffness * case["damping_time_s"]!r}"
springlength="0 {length!r}">
<site site="carriage"/><geom geom="sheave" sidesite="side"/><site site="load"/></spatial></tendon></mujoco>"""


def run_lift(case: dict[str, Any], step: float, *, sideways: float = 0.0) -> dict[str, Any]:
    """The lift in MuJoCo."""
    model = mujoco.MjModel.from_xml_string(mjcf(case, step))
    data = mujoco.MjData(model)
    data.qvel[:] = [0, case["load_velocity_m_s"][0], sideways, 0]
    data.qfrc_applied[0] = -case["pull_N"]
    length = case["unstretched_length_m"]
    found: dict[str, Any] = {"step_s": step, "tension_N": [], "load_m": [], "carriage_m": []}
    for sample in range(round(case["duration_s"] / case["every_s"]) + 1):
        while data.time < sample * case["every_s"] - step / 2:
            mujoco.mj_step(model, data)
        mujoco.mj_forward(model, data)
        stretch = data.ten_length[0] - length + case["damping_time_s"] * data.ten_velocity[0]
        found["tension_N"].append(case["axial_stiffness_N"] / length * stretch)
        found["load_m"].append((np.array(case["load_m"]) + data.qpos[1:]).tolist())
        found["carriage_m"].append(float(data.qpos[0]))
    return found
