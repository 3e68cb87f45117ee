"""Checks against other engines: random trees of hinges and slides for installed engines, and published
runs."""

from __future__ import annotations

import importlib
import importlib.util
from dataclasses import dataclass
from functools import cache
from types import ModuleType
from typing import Any

import numpy as np

from ..simulation.simulate import Simulation
from .measured import OES, decay
from .models import GRAVITY, G, scenario
from .rows import Compared, NotInstalledError, check, worst

AREA = "peers"
BODIES = (3, 6, 12)
STATES = 20
SOLVED = "both solve M q'' = f to rounding, times the condition of M: 1e-16 * 1e5"


@dataclass(frozen=True)
class Link:
    """A body of a random tree: its position, its joint and its mass."""

    parent: int
    slides: bool
    axis: np.ndarray
    place: np.ndarray
    arm: np.ndarray
    mass: float
    moments: np.ndarray


@cache
def tree(bodies: int) -> tuple[Link, ...]:
    """A tree drawn from a seed: three hinges to one slide; the moments of inertia are physical."""
    random = np.random.default_rng(bodies)
    links = []
    for i in range(bodies):
        axis = random.standard_normal(3)
        sides = random.uniform(0.3, 1.5, 3) ** 2
        mass = float(random.uniform(1.0, 20.0))
        moments = mass / 12 * (sides.sum() - sides)
        links.append(
            Link(
                int(random.integers(-1, i)) if i else -1,
                bool(random.random() < 0.25),
                axis / np.linalg.norm(axis),
                random.uniform(-1, 1, 3),
                random.uniform(-1, 1, 3),
                mass,
                moments,
            )
        )
    return tuple(links)


def _ours(links: tuple[Link, ...]) -> Simulation:
    bodies: dict[str, Any] = {}
    for i, link in enumerate(links):
        where = {
            "axis": link.axis.tolist(),
            "position_m": link.place.tolist(),
            "child_position_m": (-link.arm).tolist(),
        }
        bodies[f"body_{i}"] = {
            "parent": "world" if link.parent < 0 else f"body_{link.parent}",
            "mass_kg": link.mass,
            "inertia": {"tensor": {"moments_kg_m2": link.moments.tolist()}},
            "joint": {"prismatic" if link.slides else "revolute": where},
        }
    return Simulation(scenario(bodies, GRAVITY))


def _module(name: str) -> ModuleType:
    if importlib.util.find_spec(name) is None:
        raise NotInstalledError(name)
    return importlib.import_module(name)


class Mujoco:
    """A tree in MuJoCo, its bodies' frames at their joints."""

    def __init__(self, links: tuple[Link, ...]) -> None:
        self.engine = _module("mujoco")
        world = "".join(self._body(links, i) for i, link in enumerate(links) if link.parent < 0)
        self.model = self.engine.MjModel.from_xml_string(
            f'<mujoco><compiler angle="radian"/><option gravity="0 0 {-G!r}" timestep="1e-6"/>'
            f"<worldbody>{world}</worldbody></mujoco>"
        )
        self.data = self.engine.MjData(self.model)
        kind = self.engine.mjtObj.mjOBJ_JOINT
        names = [self.engine.mj_name2id(self.model, kind, f"j{i}") for i in range(len(links))]
        self.at = np.array([self.model.jnt_dofadr[one] for one in names])

    def _body(self, links: tuple[Link, ...], i: int) -> str:
        link = links[i]
        parent = links[link.parent].arm if link.parent >= 0 else np.zeros(3)
        inside = "".join(self._body(links, k) for k, other in enumerate(links) if other.parent == i)

        def row(values: np.ndarray) -> str:
            return " ".join(repr(float(one)) for one in values)

        kind = "slide" if link.slides else "hinge"
        return (
            f'<body pos="{row(parent + link.place)}">'
            f'<joint name="j{i}" type="{kind}" axis="{row(link.axis)}"/>'
            f'<inertial pos="{row(link.arm)}" mass="{link.mass!r}" diaginertia="{row(link.moments)}"/>'
            f"{inside}</body>"
        )

    def acceleration(self, q: np.ndarray, v: np.ndarray, force: np.ndarray) -> np.ndarray:
        """Accelerations of the joints, in the tree's order."""
        self.data.qpos[self.at], self.data.qvel[self.at], self.data.qfrc_applied[self.at] = q, v, force
        self.engine.mj_forward(self.model, self.data)
        return self.data.qacc[self.at].copy()


class Pinocchio:
    """A tree in Pinocchio, its joints' frames at the joints."""

    def __init__(self, links: tuple[Link, ...]) -> None:
        self.engine = pin = _module("pinocchio")
        self.model = pin.Model()
        self.model.gravity.linear = np.array([0.0, 0.0, -G])
        ids: list[int] = []
        for i, link in enumerate(links):
            kind = pin.JointModelPrismaticUnaligned if link.slides else pin.JointModelRevoluteUnaligned
            parent = links[link.parent].arm if link.parent >= 0 else np.zeros(3)
            at = 0 if link.parent < 0 else ids[link.parent]
            place = pin.SE3(np.eye(3), parent + link.place)
            ids.append(self.model.addJoint(at, kind(*link.axis), place, f"j{i}"))
            self.model.appendBodyToJoint(
                ids[-1], pin.Inertia(link.mass, link.arm, np.diag(link.moments)), pin.SE3.Identity()
            )
        self.data = self.model.createData()
        self.at = np.array([self.model.joints[one].idx_v for one in ids])

    def acceleration(self, q: np.ndarray, v: np.ndarray, force: np.ndarray) -> np.ndarray:
        """Accelerations of the joints, in the tree's order."""
        sorted_q, sorted_v, sorted_force = np.zeros((3, len(q)))
        sorted_q[self.at], sorted_v[self.at], sorted_force[self.at] = q, v, force
        found = self.engine.aba(self.model, self.data, sorted_q, sorted_v, sorted_force)
        return np.asarray(found)[self.at]


def _compare(engine: type[Mujoco] | type[Pinocchio], bodies: int) -> Compared:
    links = tree(bodies)
    peer, simulation = engine(links), _ours(links)
    random = np.random.default_rng(7)
    largest = None
    for _ in range(STATES):
        q, v = random.uniform(-np.pi, np.pi, bodies), random.uniform(-2, 2, bodies)
        force = random.uniform(-100, 100, bodies)
        simulation.set_state(q, v)
        one = worst(simulation.acceleration(force), peer.acceleration(q, v, force))
        largest = one if largest is None or one.error > largest.error else largest
    return largest


def _add(engine: type[Mujoco] | type[Pinocchio], name: str, source: str, bodies: int) -> None:
    check(
        f"{name}-{bodies}",
        f"accelerations of a random tree of {bodies} bodies in {STATES} states, worst",
        area=AREA,
        unit="m/s^2, rad/s^2",
        source=source,
        tolerance=1e-9,
        why=SOLVED,
    )(lambda: _compare(engine, bodies))


for _bodies in BODIES:
    _add(Mujoco, "mujoco", "MuJoCo, mj_forward (Todorov et al., IROS 2012)", _bodies)
    _add(Pinocchio, "pinocchio", "Pinocchio, aba (Carpentier et al., SII 2019)", _bodies)


OES_SOURCE = "mean of ProteusDS, InWave, WavEC, InWave-HOTINT: Wendt et al., J. Mar. Sci. Eng. 7, 2019, 379"


@check(
    "oes-minimum",
    "first minimum of a sphere of 5 m dropped from 1 m, by four linear codes",
    area=AREA,
    unit="m",
    source=OES_SOURCE,
    tolerance=0.008,
    why="twice the standard deviation of the four, 0.0035 m",
)
def oes_minimum() -> Compared:
    return Compared(decay()[1][0], float(np.mean(OES)))


@check(
    "oes-cfd",
    "first minimum of a sphere of 5 m dropped from 1 m, by a Navier-Stokes code",
    area=AREA,
    unit="m",
    tolerance=0.01,
    source="NREL's STAR-CCM+: Wendt et al., J. Mar. Sci. Eng. 7, 2019, 379",
    why="the mesh of that code, and nonlinear effects in a drop of a fifth of the radius",
)
def oes_cfd() -> Compared:
    return Compared(decay()[1][0], -0.8686)
