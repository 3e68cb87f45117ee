"""Ropes over sheaves by Exudyn and by MuJoCo's spatial tendon alone, for `kingpost verify --only peers`.

    pip install exudyn mujoco numpy
    python python/tests/peers/rope_lifts.py -o python/kingpost/verify/rope_lifts.json

gives the figures again, in a minute. Nothing of Kingpost is used.

Reeving: the set-up of `reevingSystemSpringsTest.py` in Exudyn's suite of tests, written here from its text. A
disc of 2 m radius hangs in the bight of a rope between two points at one height, its centre of mass 2 m below
the sheave that it is; y is up. `as_published` is the suite's own run, whose number is the norm of the disc's
coordinates after 2 s. The others leave out what is no rope over a sheave: damping across and about the legs,
and ends with a radius, where length that winds on is not counted. In `plane` and `skew` the rope begins taut,
with the length that the test's own comment names; `plane` has all in one plane, `skew` the sheaves as in the
test. `slack` has the test's length, and no stiffness and damping where the rope is slack, as Exudyn's
documentation advises; the tension that it records is 0 there.

Lift: a load on a rope over a fixed sheave to a carriage on a level slide, on which a constant force hauls.
In `drum` the carriage is a drum: Exudyn pays out length by a coordinate. z is up from the sheave's centre.
"""

from __future__ import annotations

import argparse
import json
import re
import warnings
from importlib.metadata import version
from pathlib import Path
from typing import Any

import exudyn_ropes
import mujoco_lift

COMMAND = "python python/tests/peers/rope_lifts.py -o python/kingpost/verify/rope_lifts.json"
REEVING = {
    "gravity_m_s2": 9.81,
    "ends_m": [[0, 0, 0], [12, 0, 2]],
    "sheave_m": [7, -20, 1],
    "radius_m": 2.0,
    "end_radius_m": 0.5,
    "thickness_m": 0.1,
    "density_kg_m3": 1000,
    "axial_stiffness_N": 1e5,
    "damping_time_s": 0.5,
    "duration_s": 2.0,
    "every_s": 0.1,
    "published_norm": 2.2155575717433007,
}
LIFT = {
    "gravity_m_s2": 9.80665,
    "radius_m": 0.5,
    "load_kg": 2000.0,
    "load_m": [0.5, 0, -15.0],
    "load_velocity_m_s": [2.0, 0, 0],
    "carriage_kg": 8000.0,
    "carriage_m": [-10.0, 0, 0.5],
    "pull_N": 21000.0,
    "axial_stiffness_N": 1e7,
    "damping_time_s": 0.015,
    "unstretched_length_m": 25.735,
    "drum_radius_m": 0.5,
    "duration_s": 5.0,
    "every_s": 0.25,
}
SIDEWAYS_M_S = 1.0


def figures() -> dict[str, Any]:
    """All that is written."""
    published = exudyn_ropes.reeving(REEVING, plane=False, arc=1.0, step=0.01, test=True)
    bare = exudyn_ropes.reeving(REEVING, plane=False, arc=1.0, step=0.01, test=True, dampers=False)
    reevings = {
        "as_published": {"norm": published["norm"], "norm_without_dampers": bare["norm"]},
        "plane": exudyn_ropes.reeving(REEVING, plane=True, arc=0.8, step=1e-3),
        "skew": exudyn_ropes.reeving(REEVING, plane=False, arc=0.8, step=1e-3),
        "slack": exudyn_ropes.reeving(REEVING, plane=True, arc=1.0, step=1e-5, off=True),
    }
    lifts = {
        "exudyn": exudyn_ropes.run_lift(LIFT, 5e-4),
        "mujoco": mujoco_lift.run_lift(LIFT, 5e-4),
        "drum": exudyn_ropes.run_lift(LIFT, 5e-4, drum=True),
        "exudyn_sideways": exudyn_ropes.run_lift(LIFT, 5e-4, sideways=SIDEWAYS_M_S),
        "mujoco_sideways": mujoco_lift.run_lift(LIFT, 5e-4, sideways=SIDEWAYS_M_S),
    }
    return {
        "command": COMMAND,
        "exudyn": version("exudyn"),
        "mujoco": version("mujoco"),
        "reeving": REEVING | reevings,
        "lift": LIFT | lifts,
    }


def _rounded(value: Any) -> Any:
    """Numbers to ten figures, but those that the case is made of and the published one's."""
    if isinstance(value, float):
        return float(f"{value:.10g}")
    return [_rounded(one) for one in value] if isinstance(value, list) else value


def main() -> None:
    """Runs the command line."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("-o", "--output", type=Path, required=True, help="the file to write")
    warnings.simplefilter("ignore", DeprecationWarning)
    output = parser.parse_args().output
    found = figures()
    for group in ("reeving", "lift"):
        for name, one in found[group].items():
            if isinstance(one, dict) and name != "as_published":
                found[group][name] = {key: _rounded(value) for key, value in one.items() if value is not None}
    # Innermost lists on a line each.
    lines = re.sub(r"\[[^][]*\]", lambda one: " ".join(one[0].split()), json.dumps(found, indent=1))
    output.write_text(lines + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
