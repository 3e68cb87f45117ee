"""A crate that slides and spins to rest on three feet, by MuJoCo.

    python python/tests/peers/sliding_crate.py > python/tests/peers/sliding_crate.json

writes `sliding_crate.json` again in seconds. Path and rotation are coupled by the friction of the feet, whose
loads change as the crate slows. Contacts are stiff, friction cones elliptic, and steps short, so that the
result approaches Coulomb's law on a rigid body; the loads of three feet follow from statics.
"""

from __future__ import annotations

import json
import math

import mujoco
import numpy as np

STEP_S = 2e-5
MODEL = """
<mujoco>
  <option timestep="{step}" gravity="0 0 -9.80665" cone="elliptic" impratio="{impratio}"
    integrator="implicitfast" iterations="200" tolerance="1e-14"/>
  <worldbody>
    <geom type="plane" size="50 50 1" friction="0.3 0 0" condim="3" solref="{solref} 1"
      solimp="0.99 0.99 0.001"/>
    <body name="crate" pos="0 0 0.5">
      <freejoint/>
      <inertial pos="0 0 0" mass="2000" diaginertia="541.6666666666666 833.3333333333334 1041.6666666666667"/>
      {feet}
    </body>
  </worldbody>
</mujoco>
"""
FOOT = """<geom type="sphere" size="0.001" pos="{x} {y} -0.499" friction="0.3 0 0" condim="3"
  solref="{solref} 1" solimp="0.99 0.99 0.001"/>"""
FEET = [(1.0, 0.75), (1.0, -0.75), (-1.0, 0.0)]
VELOCITY_M_S = [3.0, 0.0, 0.0]
YAW_RATE_RAD_S = 2.5
REST_S = 1.0


def run(solref_s: float, impratio: float) -> list[list[float]]:
    """Time, x, y and yaw every 0.1 s, after the crate has come to rest on its contacts."""
    feet = "".join(FOOT.format(x=x, y=y, solref=solref_s) for x, y in FEET)
    text = MODEL.format(step=STEP_S, solref=solref_s, impratio=impratio, feet=feet)
    model = mujoco.MjModel.from_xml_string(text)
    data = mujoco.MjData(model)
    for _ in range(round(REST_S / STEP_S)):
        mujoco.mj_step(model, data)
    data.qpos[:2] = 0.0
    data.qvel[:] = [*VELOCITY_M_S, 0.0, 0.0, YAW_RATE_RAD_S]
    rows, every = [], round(0.1 / STEP_S)
    for k in range(20 * every + 1):
        if k % every == 0:
            w, x, y, z = data.qpos[3:7]
            yaw = math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z))
            rows.append([round(k * STEP_S, 6), float(data.qpos[0]), float(data.qpos[1]), yaw])
        mujoco.mj_step(model, data)
    return rows


def main() -> None:
    """Prints the finest run, and the difference of a coarser one."""
    fine, coarse = run(0.002, 1000.0), run(0.004, 100.0)
    spread = np.abs(np.array(fine) - np.array(coarse)).max(axis=0)[1:]
    found = {
        "program": f"MuJoCo {mujoco.__version__}",
        "columns": ["time_s", "x_m", "y_m", "yaw_rad"],
        "rows": [[float(f"{x:.6g}") for x in row] for row in fine],
        "coarser_run_differs_by": [float(f"{x:.2g}") for x in spread],
    }
    print(json.dumps(found))


if __name__ == "__main__":
    main()
