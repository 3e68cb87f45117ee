"""Exudyn's rope over sheaves, in the cases of `rope_lifts.py`."""

from __future__ import annotations

from typing import Any

import exudyn as exu
import exudyn.utilities as eu
import numpy as np

NO_PUSH_N = 1e-3
OUT = exu.OutputVariableType


class Ropes:
    """An Exudyn model with one rope and its records."""

    def __init__(self, gravity: list[float]) -> None:
        self.system = exu.SystemContainer()
        self.mbs = self.system.AddSystem()
        self.ground = self.mbs.AddObject(eu.ObjectGround())
        self.gravity = gravity
        self.sensors: dict[str, int] = {}
        self.nodes: list[int] = []

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
        """The rope; its number."""
        return self.mbs.AddObject(
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

    def watch_rope(self, rope: int) -> None:
        """Records the rope's tension."""
        sensor = eu.SensorObject(objectNumber=rope, storeInternal=True, outputVariableType=OUT.ForceLocal)
        self.sensors["tension_N"] = self.mbs.AddSensor(sensor)

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
    case: dict[str, Any],
    *,
    plane: bool,
    arc: float,
    step: float,
    test: bool = False,
    dampers: bool = True,
    off: bool = False,
) -> dict[str, Any]:
    """The disc in the bight. `arc` of half a turn is in the rope's length; `test` has all of the suite's run,
    its dampers too; `off` switches a slack rope off.
    """
    radius = case["radius_m"]
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
    model.watch_rope(rope)
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


def lift(case: dict[str, Any], *, sideways: float = 0.0, drum: bool = False, records: bool = True) -> Ropes:
    """The lift; its nodes are the load's and the winch's."""
    model = Ropes([0, 0, -case["gravity_m_s2"]])
    velocity = [case["load_velocity_m_s"][0], sideways, 0]
    hangs, load = model.body(_ball(case["load_kg"]), case["load_m"], velocity)
    sheave, radii, axes = model.fixed([0, 0, 0]), [0, case["radius_m"], 0], [[0, 1, 0]] * 3
    more: dict[str, Any] = {"regularizationForce": NO_PUSH_N}
    if drum:
        winch, ends = _drum(model, case)
        markers = [model.fixed(case["carriage_m"]), sheave, load, *ends]
        more |= {"hasCoordinateMarkers": True, "coordinateFactors": [case["drum_radius_m"], 0]}
    else:
        still = [0, 0, 0]
        winch, carriage = model.body(_ball(case["carriage_kg"]), case["carriage_m"], still, falls=False)
        model.mbs.AddLoad(eu.Force(markerNumber=carriage, loadVector=[-case["pull_N"], 0, 0]))
        markers = [carriage, sheave, load]
    rope = model.rope(case, case["unstretched_length_m"], markers, axes, radii, **more)
    model.nodes = [hangs, winch]
    if records:
        model.watch_rope(rope)
        model.watch("load_m", hangs, OUT.Position)
        model.watch("winch", winch, OUT.Coordinates if drum else OUT.Displacement)
    model.mbs.Assemble()
    return model


def _drum(model: Ropes, case: dict[str, Any]) -> tuple[int, list[int]]:
    """The drum's node; markers of its turn, on which the pull acts, and of the rope's fast end."""
    arm, mbs = case["drum_radius_m"], model.mbs
    turn = mbs.AddNode(eu.Node1D(referenceCoordinates=[0]))
    moment = case["carriage_kg"] * arm**2
    mbs.AddObject(eu.ObjectRotationalMass1D(nodeNumber=turn, physicsInertia=moment))
    free = mbs.AddMarker(eu.MarkerNodeCoordinate(nodeNumber=turn, coordinate=0))
    mbs.AddLoad(eu.LoadCoordinate(markerNumber=free, load=-case["pull_N"] * arm))
    point = mbs.AddNode(eu.NodePointGround())
    return turn, [free, mbs.AddMarker(eu.MarkerNodeCoordinate(nodeNumber=point, coordinate=0))]


def run_lift(
    case: dict[str, Any], step: float, *, sideways: float = 0.0, drum: bool = False
) -> dict[str, Any]:
    """The lift's records."""
    found = lift(case, sideways=sideways, drum=drum).run(case, step)
    return {
        "step_s": step,
        "tension_N": found["tension_N"][:, 0].tolist(),
        "load_m": found["load_m"].tolist(),
        "drum_rad" if drum else "carriage_m": found["winch"][:, 0].tolist(),
    }


def _ball(mass: float) -> Any:
    """A body on which no moment acts."""
    return eu.RigidBodyInertia(mass, np.eye(3) * 100.0)
