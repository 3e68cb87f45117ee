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

import exudyn as exu
import exudyn.utilities as eu
import mujoco
import numpy as np

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
NO_PUSH_N = 1e-3
SIDEWAYS_M_S = 1.0
OUT = exu.OutputVariableType


class Ropes:
    """An Exudyn model with one rope, and what it records."""

    def __init__(self, gravity: list[float]) -> None:
        self.system = exu.SystemContainer()
        self.mbs = self.system.AddSystem()
        self.ground = self.mbs.AddObject(eu.ObjectGround())
        self.gravity = gravity
        self.sensors: dict[str, int] = {}

    def fixed(self, place: list[float]) -> int:
        """A marker on the ground."""
        return self.mbs.AddMarker(eu.MarkerBodyRigid(bodyNumber=self.ground, localPosition=place))

    def body(
        self, inertia: Any, place: list[float], velocity: Any, *, euler: bool = False, falls: bool = True
    ) -> tuple[int, int]:
        """A free rigid body: its node and its marker."""
        kind = eu.NodeRigidBodyEP if euler else eu.NodeRigidBodyRotVecLG
        turned = [1, 0, 0, 0] if euler else [0, 0, 0]
        start = [*velocity, *([0] * len(turned))]
        node = self.mbs.AddNode(kind(referenceCoordinates=[*place, *turned], initialVelocities=start))
        body = self.mbs.AddObject(
            eu.ObjectRigidBody(
                nodeNumber=node,
                physicsMass=inertia.mass,
                physicsInertia=inertia.GetInertia6D(),
                physicsCenterOfMass=inertia.COM(),
            )
        )
        if falls:
            mass = self.mbs.AddMarker(eu.MarkerBodyMass(bodyNumber=body))
            self.mbs.AddLoad(eu.LoadMassProportional(markerNumber=mass, loadVector=self.gravity))
        return node, self.mbs.AddMarker(eu.MarkerNodeRigid(nodeNumber=node))

    def rope(
        self, case: dict[str, Any], length: float, markers: list[int], axes: Any, radii: Any, **more: Any
    ) -> int:
        """The rope, which records its tension and its length."""
        number = self.mbs.AddObject(
            eu.ReevingSystemSprings(
                markerNumbers=markers,
                stiffnessPerLength=case["axial_stiffness_N"],
                dampingPerLength=case["axial_stiffness_N"] * case["damping_time_s"],
                referenceLength=length,
                sheavesAxes=exu.Vector3DList(axes),
                sheavesRadii=radii,
                **({"hasCoordinateMarkers": False} | more),
            )
        )
        for name, what in (("tension_N", OUT.ForceLocal), ("length_m", OUT.Distance)):
            sensor = eu.SensorObject(objectNumber=number, storeInternal=True, outputVariableType=what)
            self.sensors[name] = self.mbs.AddSensor(sensor)
        return number

    def watch(self, name: str, node: int, what: Any) -> None:
        """Records a node's output."""
        sensor = eu.SensorNode(nodeNumber=node, storeInternal=True, outputVariableType=what)
        self.sensors[name] = self.mbs.AddSensor(sensor)

    def run(self, case: dict[str, Any], step: float, *, explicit: bool = True) -> dict[str, np.ndarray]:
        """Records by name, without their times; `explicit` is RK4, else the test suite's implicit scheme."""
        settings = exu.SimulationSettings()
        settings.timeIntegration.numberOfSteps = round(case["duration_s"] / step)
        settings.timeIntegration.endTime = case["duration_s"]
        settings.timeIntegration.newton.useModifiedNewton = True
        settings.solution.sensors.writePeriod = case["every_s"]
        settings.solution.file.write = False
        kinds = exu.DynamicSolverType
        self.mbs.SolveDynamic(settings, solverType=kinds.RK44 if explicit else kinds.GeneralizedAlpha)
        stored = {name: self.mbs.GetSensorStoredData(one) for name, one in self.sensors.items()}
        return {name: np.array(rows)[:, 1:] for name, rows in stored.items()}


def reeving(
    *, plane: bool, arc: float, step: float, test: bool = False, dampers: bool = True, off: bool = False
) -> dict[str, Any]:
    """The disc in the bight. `arc` of half a turn is in the rope's length; `test` has all of the suite's run,
    its dampers too; `off` switches a slack rope off.
    """
    case, radius = REEVING, REEVING["radius_m"]
    flat = np.diag([1, 1, 0 if plane else 1])
    first, last, middle = (flat @ np.array(one) for one in (*case["ends_m"], case["sheave_m"]))
    length = np.linalg.norm(middle - first) + np.linalg.norm(last - middle) + arc * np.pi * radius
    model = Ropes([0, -case["gravity_m_s2"], 0])
    disc = eu.InertiaCylinder(case["density_kg_m3"], case["thickness_m"], radius, 2)
    inertia = disc.Translated([0, -radius, 0])
    node, marker = model.body(inertia, middle.tolist(), [0, 0, 0], euler=test)
    more: dict[str, Any] = {"regularizationForce": NO_PUSH_N}
    if test:
        more = {}
    if test and dampers:
        stiffness = case["axial_stiffness_N"]
        more = {"dampingTorsional": 0.005 * stiffness, "dampingShear": 0.05 * stiffness}
    end = case["end_radius_m"] if test else 0.0
    markers = [model.fixed(first.tolist()), marker, model.fixed(last.tolist())]
    axes = [[0, 0, -1], [0, 0, 1], [0, 0, -1]]
    rope = model.rope(case, length, markers, axes, [end, radius, end], **more)
    model.watch("place", node, OUT.Position)
    model.watch("turned", node, OUT.RotationMatrix)
    model.mbs.Assemble()
    if off:

        def switch(mbs: Any, _time: float) -> bool:
            taut = mbs.GetObjectOutput(rope, OUT.Distance) > length
            mbs.SetObjectParameter(rope, "activeConnector", bool(taut))
            return True

        model.mbs.SetPreStepUserFunction(switch)
    found = model.run(case, step, explicit=not test)
    turned = found["turned"].reshape(-1, 3, 3)
    mass = found["place"] + turned @ np.array([0, -radius, 0])
    return {
        "unstretched_length_m": float(length),
        "step_s": step,
        "norm": float(np.linalg.norm(model.mbs.systemData.GetODE2Coordinates())) if test else None,
        "tension_N": found["tension_N"][:, 0].tolist(),
        "centre_of_mass_m": mass.tolist(),
    }


def exudyn_lift(step: float, *, sideways: float = 0.0, drum: bool = False) -> dict[str, Any]:
    """The lift in Exudyn."""
    case = LIFT
    model = Ropes([0, 0, -case["gravity_m_s2"]])
    velocity = [case["load_velocity_m_s"][0], sideways, 0]
    node, load = model.body(_ball(case["load_kg"]), case["load_m"], velocity)
    sheave, radii, axes = model.fixed([0, 0, 0]), [0, case["radius_m"], 0], [[0, 1, 0]] * 3
    model.watch("load_m", node, OUT.Position)
    length, more = case["unstretched_length_m"], {"regularizationForce": NO_PUSH_N}
    if drum:
        arm = case["drum_radius_m"]
        turn = model.mbs.AddNode(eu.Node1D(referenceCoordinates=[0]))
        moment = case["carriage_kg"] * arm**2
        model.mbs.AddObject(eu.ObjectRotationalMass1D(nodeNumber=turn, physicsInertia=moment))
        free = model.mbs.AddMarker(eu.MarkerNodeCoordinate(nodeNumber=turn, coordinate=0))
        model.mbs.AddLoad(eu.LoadCoordinate(markerNumber=free, load=-case["pull_N"] * arm))
        point = model.mbs.AddNode(eu.NodePointGround())
        still = model.mbs.AddMarker(eu.MarkerNodeCoordinate(nodeNumber=point, coordinate=0))
        markers = [model.fixed(case["carriage_m"]), sheave, load, free, still]
        more |= {"hasCoordinateMarkers": True, "coordinateFactors": [arm, 0]}
        model.watch("turned", turn, OUT.Coordinates)
    else:
        node, carriage = model.body(_ball(case["carriage_kg"]), case["carriage_m"], [0, 0, 0], falls=False)
        model.mbs.AddLoad(eu.Force(markerNumber=carriage, loadVector=[-case["pull_N"], 0, 0]))
        model.watch("turned", node, OUT.Displacement)
        markers = [carriage, sheave, load]
    model.rope(case, length, markers, axes, radii, **more)
    model.mbs.Assemble()
    found = model.run(case, step)
    name = "drum_rad" if drum else "carriage_m"
    return {
        "step_s": step,
        "tension_N": found["tension_N"][:, 0].tolist(),
        "load_m": found["load_m"].tolist(),
        name: found["turned"][:, 0].tolist(),
    }


def _ball(mass: float) -> Any:
    """A body that nothing turns."""
    return eu.RigidBodyInertia(mass, np.eye(3) * 100.0)


def mujoco_text(step: float) -> str:
    """The lift in MJCF: a tendon that pulls only, by a range of lengths without force."""
    case, arm = LIFT, LIFT["radius_m"]
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


def mujoco_lift(step: float, *, sideways: float = 0.0) -> dict[str, Any]:
    """The lift in MuJoCo."""
    case = LIFT
    model = mujoco.MjModel.from_xml_string(mujoco_text(step))
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


def figures() -> dict[str, Any]:
    """All that is written."""
    published = reeving(plane=False, arc=1.0, step=0.01, test=True)
    bare = reeving(plane=False, arc=1.0, step=0.01, test=True, dampers=False)
    reevings = {
        "as_published": {"norm": published["norm"], "norm_without_dampers": bare["norm"]},
        "plane": reeving(plane=True, arc=0.8, step=1e-3),
        "skew": reeving(plane=False, arc=0.8, step=1e-3),
        "slack": reeving(plane=True, arc=1.0, step=1e-5, off=True),
    }
    lifts = {
        "exudyn": exudyn_lift(5e-4),
        "mujoco": mujoco_lift(5e-4),
        "drum": exudyn_lift(5e-4, drum=True),
        "exudyn_sideways": exudyn_lift(5e-4, sideways=SIDEWAYS_M_S),
        "mujoco_sideways": mujoco_lift(5e-4, sideways=SIDEWAYS_M_S),
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
