"""Checks of swimming bodies: links in an ideal fluid, a fin, a vehicle with two arms.

Links that turn against each other in an ideal fluid at rest keep their total impulse zero. With the
velocities of all links linear in the motion xi of the first and in the rates of the hinges, this gives

    I(q) xi + A(q) q' = 0,    g' = g xi

for its place g (Kanso, Marsden, Rowley & Melli-Huber, "Locomotion of articulated bodies in a perfect fluid",
J. Nonlinear Sci. 15, 2005, p. 255; here without hydrodynamic interaction of the links). SciPy integrates it,
in the plane and without any of the engine's mechanics.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache
from typing import TYPE_CHECKING, Any

import numpy as np
from scipy.integrate import solve_ivp

from ..simulation.simulate import Simulation
from .models import GRAVITY, scenario, settings
from .rows import Compared, check, worst

if TYPE_CHECKING:
    import numpy.typing as npt
    import xarray

    Array = npt.NDArray[np.float64]

AREA = "hydrodynamics"
DENSITY_KG_M3 = 1000.0
DEPTH_M = 5.0
OF_RK4 = "RK4 at 400 steps a period of the stroke: (w h)^4 / 120 of the motion, 5e-10, over ten periods"


@dataclass(frozen=True)
class Oscillation:
    """Angle of a hinge: ``s(t / ramp) A sin(2 pi t / T + phase)`` with the smooth step s of fifth degree."""

    amplitude_rad: float
    period_s: float
    phase_rad: float
    ramp_s: float

    def angle_and_rate(self, time_s: float) -> tuple[float, float]:
        omega = 2 * np.pi / self.period_s
        x = min(time_s / self.ramp_s, 1.0)
        share, growth = x**3 * (10 - 15 * x + 6 * x**2), 30 * x**2 * (1 - x) ** 2 / self.ramp_s
        phase = omega * time_s + self.phase_rad
        angle = self.amplitude_rad * np.sin(phase)
        return share * angle, share * self.amplitude_rad * omega * np.cos(phase) + growth * angle

    def mode(self) -> dict[str, Any]:
        """The mode of a joint in a scenario."""
        return {"oscillation": vars(self)}


@dataclass(frozen=True)
class Link:
    """A neutrally buoyant link of a tree in the plane.

    Attributes
    ----------
    size_m
        Length and width; its height is 0.2 m.
    added_kg, added_kg_m2
        Added mass along its length and across, and about its centre.
    parent, hinge_m, own_hinge_m
        Number of the link before it, and the hinge from the centre of either, along and across.
    motion
        Oscillation of the hinge.
    """

    size_m: tuple[float, float]
    added_kg: tuple[float, float]
    added_kg_m2: float
    parent: int = -1
    hinge_m: tuple[float, float] = (0.0, 0.0)
    own_hinge_m: tuple[float, float] = (0.0, 0.0)
    motion: Oscillation | None = None

    @property
    def mass_kg(self) -> float:
        return DENSITY_KG_M3 * self.size_m[0] * self.size_m[1] * HEIGHT_M

    @property
    def inertia_kg_m2(self) -> float:
        """Moment of inertia with the added moment."""
        return self.mass_kg * (self.size_m[0] ** 2 + self.size_m[1] ** 2) / 12 + self.added_kg_m2


HEIGHT_M = 0.2


def ellipse(a: float, b: float, **more: Any) -> Link:
    """A link with the added mass of an ellipse of the half axes a and b, and with its volume.

    Newman, *Marine Hydrodynamics*, 1977, sec. 4.15.
    """
    along, across = (DENSITY_KG_M3 * np.pi * half**2 * HEIGHT_M for half in (b, a))
    about = DENSITY_KG_M3 * np.pi * (a**2 - b**2) ** 2 / 8 * HEIGHT_M
    return Link((2 * a, np.pi * b / 2), (along, across), about, **more)


def chain(motions: Sequence[Oscillation]) -> list[Link]:
    """Chain of equal ellipses."""
    a, b, gap = 0.2, 0.04, 0.02
    hinges = {"hinge_m": (-a - gap, 0.0), "own_hinge_m": (a + gap, 0.0)}
    behind = [ellipse(a, b, parent=k, motion=motion, **hinges) for k, motion in enumerate(motions)]
    return [ellipse(a, b), *behind]


def vehicle() -> list[Link]:
    """A vehicle of 2 x 1.4 m with two arms in front, which slew together and then grow apart in phase."""
    arms = [
        ellipse(
            0.7,
            0.07,
            parent=0,
            hinge_m=(1.0, side),
            own_hinge_m=(-0.75, 0.0),
            motion=Oscillation(0.8, period_s, 0.0, 8.0),
        )
        for side, period_s in ((0.45, 4.0), (-0.45, 5.0))
    ]
    return [Link((2.0, 1.4), (280.0, 500.0), 170.0), *arms]


def _turned(angle: float) -> Array:
    cos, sin = np.cos(angle), np.sin(angle)
    return np.array([[cos, -sin], [sin, cos]])


def _across(vector: Array) -> Array:
    """z x vector."""
    return np.array([-vector[1], vector[0]])


def _momentum(links: Sequence[Link], angles: Array, motion: Array, rates: Array) -> Array:
    """Linear and angular impulse in the axes of the first link, about its centre; `motion` is its velocity
    and rate in these axes."""
    places = [(np.zeros(2), 0.0, motion[:2], motion[2])]
    total = np.zeros(3)
    for k, link in enumerate(links):
        if link.parent >= 0:
            at, angle, velocity, rate = places[link.parent]
            arm = _turned(angle) @ link.hinge_m
            own_angle, own_rate = angle + angles[k], rate + rates[k]
            own_arm = -_turned(own_angle) @ link.own_hinge_m
            moved = velocity + rate * _across(arm) + own_rate * _across(own_arm)
            places.append((at + arm + own_arm, own_angle, moved, own_rate))
        at, angle, velocity, rate = places[k]
        turned = _turned(angle)
        masses = link.mass_kg + np.array(link.added_kg)
        linear = turned @ (masses * (turned.T @ velocity))
        total[:2] += linear
        total[2] += link.inertia_kg_m2 * rate + at[0] * linear[1] - at[1] * linear[0]
    return total


def by_impulse(links: Sequence[Link], time_s: float) -> Array:
    """x, y and heading of the first link after a time, from rest."""
    motions: list[Callable[[float], tuple[float, float]]] = [
        link.motion.angle_and_rate if link.motion else (lambda _: (0.0, 0.0)) for link in links
    ]

    def rate(time_s: float, place: Array) -> Array:
        angles, rates = np.array([motion(time_s) for motion in motions]).T
        rest = _momentum(links, angles, np.zeros(3), rates)
        locked = np.column_stack([_momentum(links, angles, unit, 0 * rates) for unit in np.eye(3)])
        motion = np.linalg.solve(locked, -rest)
        return np.array([*(_turned(place[2]) @ motion[:2]), motion[2]])

    ramps = {link.motion.ramp_s for link in links if link.motion}
    place, begin = np.zeros(3), 0.0
    for end in sorted({*(ramp for ramp in ramps if ramp < time_s), time_s}):
        place = solve_ivp(rate, (begin, end), place, "DOP853", rtol=1e-11, atol=1e-12).y[:, -1]
        begin = end
    return place


def swimming(links: Sequence[Link], step_s: float, duration_s: float) -> xarray.Dataset:
    """A run of the same links, free in space below the surface."""
    bodies: dict[str, Any] = {}
    forces: dict[str, Any] = dict(GRAVITY)
    for k, link in enumerate(links):
        length, width = link.size_m
        shape = {"box": {"length_m": length, "width_m": width, "height_m": HEIGHT_M}}
        joint: dict[str, Any] = {"floating": {"initial": {"position_m": [0, 0, -DEPTH_M]}}}
        parent = {}
        if link.motion:
            hinge = {"axis": [0, 0, 1], "mode": link.motion.mode()}
            places = {"position_m": [*link.hinge_m, 0], "child_position_m": [*link.own_hinge_m, 0]}
            joint, parent = {"revolute": hinge | places}, {"parent": f"link{link.parent}"}
        bodies[f"link{k}"] = {"mass_kg": link.mass_kg, "shape": shape, "joint": joint, **parent}
        added = {
            "coefficients": [float(added / link.mass_kg) for added in link.added_kg] + [0],
            "moments_kg_m2": [0, 0, link.added_kg_m2],
        }
        forces[f"water{k}"] = {"submerged": {"body": f"link{k}", "shape": shape, "added_mass": added}}
    sea = {"density_kg_m3": DENSITY_KG_M3}
    return Simulation(scenario(bodies, forces, sea=sea, simulation=settings(step_s, duration_s))).run()


def _place(run: xarray.Dataset) -> Array:
    """x, y and heading of the first link at the end."""
    of = run.kingpost
    return np.array([of[f"link0.{column}"].values[-1] for column in ("position.x", "position.y", "yaw")])


STROKE = (Oscillation(1.0, 1.0, 0.0, 2.0), Oscillation(1.0, 1.0, 1.6, 2.0))


@check(
    "swimmer-ideal-fluid",
    "place and heading of three links after ten strokes in an ideal fluid",
    area=AREA,
    unit="m, rad",
    source="Kanso et al. (2005): zero impulse, integrated by SciPy's DOP853 at 1e-11",
    tolerance=1e-6,
    why=OF_RK4,
)
def swimmer_ideal_fluid() -> Compared:
    links = chain(STROKE)
    return worst(_place(swimming(links, 0.0025, 10.0)), by_impulse(links, 10.0))


@check(
    "vehicle-two-arms",
    "place and heading of a vehicle under water whose two arms slew in an ideal fluid",
    area=AREA,
    unit="m, rad",
    source="zero impulse of body and added mass, integrated by SciPy's DOP853 at 1e-11",
    tolerance=1e-6,
    why=OF_RK4,
)
def vehicle_two_arms() -> Compared:
    links = vehicle()
    return worst(_place(swimming(links, 0.01, 20.0)), by_impulse(links, 20.0))


SPEED_M_S, PERIOD_S, SPAN_M, BEHIND_M = 1.5, 0.8, 0.3, 0.12
HEAVE_M, PITCH_RAD, PHASE_RAD = 1e-3, 3.5e-3, -1.9
STEPS = 400
LIGHTHILL = "Lighthill, J. Fluid Mech. 9 (1960), p. 305: slender fish, at the trailing edge"
OF_AMPLITUDE = "the theory is for small amplitudes: their square, 1e-5"


def towed() -> xarray.Dataset:
    """A fin that heaves and pitches while it is towed: two periods to grow, one to measure."""

    def part(joint: dict[str, Any], **more: Any) -> dict[str, Any]:
        return {"mass_kg": 1, "shape": {"sphere": {"radius_m": 0.01}}, "joint": joint, **more}

    def slide(axis: list[int], mode: dict[str, Any], **more: Any) -> dict[str, Any]:
        return {"prismatic": {"axis": axis, "mode": mode, **more}}

    times = {"period_s": PERIOD_S, "ramp_s": 2 * PERIOD_S}
    heave = {"oscillation": {"amplitude_m": HEAVE_M, **times}}
    pitch = {"oscillation": {"amplitude_rad": PITCH_RAD, "phase_rad": PHASE_RAD, **times}}
    bodies = {
        "carriage": part(
            slide([1, 0, 0], {"prescribed": {"speed_m_s": SPEED_M_S}}, position_m=[0, 0, -DEPTH_M])
        ),
        "arm": part(slide([0, 1, 0], heave), parent="carriage"),
        "fin": part({"revolute": {"axis": [0, 0, 1], "mode": pitch}}, parent="arm"),
    }
    edge = {"trailing_edge": {"body": "fin", "position_m": [-BEHIND_M, 0, 0], "span_m": SPAN_M}}
    sea = {"density_kg_m3": DENSITY_KG_M3}
    simulation = settings(PERIOD_S / STEPS, 3 * PERIOD_S)
    return Simulation(scenario(bodies, {**GRAVITY, "edge": edge}, sea=sea, simulation=simulation)).run()


def of_slender_fish() -> tuple[float, float]:
    """Mean thrust and mean power by Lighthill: with the height h of the edge,
    ``m/2 (<h_t^2> - U^2 <h_x^2>)`` and ``m U <h_t (h_t + U h_x)>``."""
    omega, mass = 2 * np.pi / PERIOD_S, np.pi / 4 * DENSITY_KG_M3 * SPAN_M**2
    pitch = PITCH_RAD * np.exp(1j * PHASE_RAD)
    rate, slope = 1j * omega * (HEAVE_M - BEHIND_M * pitch), -pitch
    thrust = mass / 4 * (abs(rate) ** 2 - SPEED_M_S**2 * abs(slope) ** 2)
    power = mass * SPEED_M_S / 2 * (rate * np.conj(rate + SPEED_M_S * slope)).real
    return float(thrust), float(power)


@cache
def measured() -> tuple[float, float]:
    """Mean thrust and mean power of the fin over the last period of the run."""
    run = towed()
    force, wake = (
        run.kingpost[column].values[-STEPS:] for column in ("edge.trailing_edge_force.x", "edge.wake_power")
    )
    thrust = float(np.mean(force))
    return thrust, thrust * SPEED_M_S + float(np.mean(wake))


@check(
    "fin-thrust",
    "mean thrust of a fin that heaves and pitches while it is towed",
    area=AREA,
    unit="N",
    source=LIGHTHILL,
    tolerance=1e-4,
    why=OF_AMPLITUDE,
)
def fin_thrust() -> Compared:
    return Compared(measured()[0], of_slender_fish()[0])


@check(
    "fin-efficiency",
    "share of its power that this fin turns into thrust (Froude efficiency)",
    area=AREA,
    unit="1",
    source=LIGHTHILL,
    tolerance=1e-4,
    why=OF_AMPLITUDE,
)
def fin_efficiency() -> Compared:
    (thrust, power), (own_thrust, own_power) = of_slender_fish(), measured()
    return Compared(own_thrust * SPEED_M_S / own_power, thrust * SPEED_M_S / power)
