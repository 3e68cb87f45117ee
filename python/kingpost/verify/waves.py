"""Checks of regular waves, seas and their statistics."""

from __future__ import annotations

import math
from functools import cache

import numpy as np

from ..hydro.airy import group_ratio, wave_number
from ..hydro.database import Water
from ..simulation.simulate import Simulation, run
from .models import GRAVITY, G, scenario, settings
from .rows import Compared, check, worst

AREA = "waves"
SPHERE = "hydro/sphere.hydro.json"


def _root(omega: float, depth: float) -> float:
    """k of omega^2 = g k tanh kh by bisection, 1/m."""
    low, high = omega**2 / G, omega**2 / G + omega / math.sqrt(G * depth)
    for _ in range(200):
        middle = (low + high) / 2
        low, high = (middle, high) if G * middle * math.tanh(middle * depth) < omega**2 else (low, middle)
    return low


@check(
    "dispersion",
    "wave numbers from shallow to deep water",
    area=AREA,
    unit="1/m",
    source="w^2 = g k tanh kh by halving; Airy 1845",
    tolerance=1e-12,
    why="Newton's method ends at rounding",
)
def dispersion() -> Compared:
    omegas = np.linspace(0.1, 3.0, 60)
    return worst([wave_number(w, Water(depth_m=10.0)) for w in omegas], [_root(w, 10.0) for w in omegas])


@check(
    "group-velocity",
    "ratio of group to phase velocity, depth a tenth of the deep-water wavelength",
    area=AREA,
    source="0.8103: Shore Protection Manual, 1984, vol. 2, table C-1",
    tolerance=6.2e-5,
    why="half a unit of the last printed digit",
)
def group_velocity() -> Compared:
    omega = math.sqrt(2 * math.pi * 0.1 * G / 10.0)
    return Compared(group_ratio(omega, Water(depth_m=10.0)), 0.8103)


RAOS = (
    "direction_to_deg,period_s,surge_forward_m_per_m,surge_lag_deg,sway_port_m_per_m,sway_lag_deg,"
    "heave_up_m_per_m,heave_lag_deg,roll_port_up_deg_per_m,roll_lag_deg,pitch_bow_down_deg_per_m,"
    "pitch_lag_deg,yaw_bow_port_deg_per_m,yaw_lag_deg\n"
)


def _cork(depth: float, period: float, place: float):
    """A body that follows the water surface at a point, in a regular wave of 1 m amplitude towards +x."""
    rows = "".join(f"{d},{p},0,0,0,0,1,0,0,0,0,0,0,0\n" for d in (0, 90, 180) for p in (3, period, 30))
    joint = {"moved_by_waves": {"raos": "cork.csv", "symmetric": True, "position_m": [place, 0, 0]}}
    waves = {"wave": {"regular": {"height_m": 2.0, "period_s": period, "direction_deg": 0}}}
    bodies = {"cork": {"mass_kg": 1.0, "shape": {"sphere": {"radius_m": 1.0}}, "joint": joint}}
    one = scenario(
        bodies,
        GRAVITY,
        sea={"depth_m": depth, "waves": waves},
        simulation=settings(0.02, 20.0),
        files={"cork.csv": RAOS + rows},
    )
    return Simulation(one).run()


@check(
    "wave-in-depth",
    "surface 150 m from the origin in a wave over 12 m of water, 20 s",
    area=AREA,
    unit="m",
    source="a cos(k x - w t), k of w^2 = g k tanh kh by halving; Airy 1845",
    tolerance=1e-9,
    why="RK4 of a prescribed motion: (w h)^4 / 120 over 16 radians, 1e-8 at worst, a tenth of it measured",
)
def wave_in_depth() -> Compared:
    found = _cork(12.0, 8.0, 150.0)
    omega = 2 * math.pi / 8.0
    phase = _root(omega, 12.0) * 150.0 - omega * found.time.values
    return worst(found.position.sel(body="cork", axis="z").values, np.cos(phase))


@check(
    "vertical-speed",
    "vertical speed of the surface in a wave over 12 m of water",
    area=AREA,
    unit="m/s",
    source="a w sin(k x - w t): kinematic condition; Newman, Marine Hydrodynamics, sec. 6.2",
    tolerance=1e-9,
    why="rounding of a phase of some 10 radians",
)
def vertical_speed() -> Compared:
    found = _cork(12.0, 8.0, 150.0)
    omega = 2 * math.pi / 8.0
    phase = _root(omega, 12.0) * 150.0 - omega * found.time.values
    return worst(found.velocity.sel(body="cork", axis="z").values, omega * np.sin(phase))


@cache
def _sea(kind: str, hours: float, **spectrum: float) -> np.ndarray:
    """Elevation at a held hull, every quarter of a second, without a ramp."""
    held = {"hold_translation": True, "hold_rotation": True}
    body = {"mass_t": 261.8, "shape": {"sphere": {"radius_m": 5.0}}, "joint": {"floating": held}}
    realisation = {
        key: spectrum.pop(key) for key in ("components", "lowest_rad_s", "highest_rad_s") if key in spectrum
    }
    wave = {kind: {**spectrum, "direction_deg": 0, "realisation": {"components": 200, **realisation}}}
    water = {"body": "hull", "database": SPHERE, "radiation": False, "added_mass": False}
    one = scenario(
        {"hull": body},
        {**GRAVITY, "water": {"hydrodynamics": water}},
        sea={"density_kg_m3": 1000.0, "waves": {"sea": wave}},
        simulation=settings(0.25, 3600 * hours, integrator="forward_euler", seed=1),
    )
    return run(one).wave_elevation.values[:, 0]


SCATTER = "standard error sqrt(2 pi / T Int S^2 dw) / 2 m0 = 1.7 % of three hours (docs/theory.md)"


@check(
    "significant-height",
    "significant height of three hours of JONSWAP, Tp 8 s",
    area=AREA,
    unit="m",
    source="4 sqrt(m0); DNV-RP-C205, sec. 3.5",
    tolerance=0.017,
    why=SCATTER,
)
def significant_height() -> Compared:
    record = _sea("jonswap", 3.0, significant_height_m=3.0, peak_period_s=8.0, gamma=3.3)
    return Compared(4 * float(record.std()), 3.0)


def _crossing_period(record: np.ndarray) -> float:
    """Mean time between upward crossings of zero, s, of a record of quarter seconds."""
    ups = np.flatnonzero((record[:-1] < 0) & (record[1:] >= 0))
    at = ups - record[ups] / (record[ups + 1] - record[ups])
    return float(0.25 * (at[-1] - at[0]) / (len(at) - 1))


@check(
    "tz-jonswap",
    "mean period over peak period of six hours of JONSWAP, gamma 3.3",
    area=AREA,
    source="0.778; DNV-RP-C205, sec. 3.5.5",
    tolerance=0.02,
    why="the count of 1,800 crossings scatters by 0.7 % (Rice), twice that; the cut at 10 peaks adds 0.5 %",
)
def tz_jonswap() -> Compared:
    spectrum = {"significant_height_m": 3.0, "peak_period_s": 15.0, "gamma": 3.3}
    record = _sea("jonswap", 6.0, **spectrum, components=400, highest_rad_s=4.33)
    return Compared(_crossing_period(record) / 15.0, 0.778)


@check(
    "tz-pierson-moskowitz",
    "mean period over peak period of three hours of Pierson-Moskowitz, cut at 5 peaks",
    area=AREA,
    source="(5 pi / 4)^(-1/4) and the cut's erfc: Gamma functions of x^-5 exp(-5/4 x^-4)",
    tolerance=0.016,
    why="the count of 1,850 crossings scatters by 0.8 % (Rice); twice that",
)
def tz_pierson_moskowitz() -> Compared:
    record = _sea("pierson_moskowitz", 3.0, significant_height_m=3.0, peak_period_s=8.0)
    u = 1.25 / 5.0**4
    second = math.sqrt(1.25 * math.pi) * math.erfc(math.sqrt(u))
    return Compared(_crossing_period(record) / 8.0, math.sqrt(math.exp(-u) / second))


@check(
    "band-energy",
    "share of Pierson-Moskowitz's energy between 0.8 and 1.3 of the peak, over twelve hours",
    area=AREA,
    source="exp(-5/4 x^-4) at the ends: Pierson & Moskowitz 1964, integrated",
    tolerance=0.019,
    why="standard error sqrt(2 pi / T Int S^2 dw) / m0 = 1.9 % of the variance of a band of 0.39 rad/s",
)
def band_energy() -> Compared:
    peak = 2 * math.pi / 8.0
    band = {"lowest_rad_s": 0.8 * peak, "highest_rad_s": 1.3 * peak, "components": 100}
    record = _sea("pierson_moskowitz", 12.0, significant_height_m=3.0, peak_period_s=8.0, **band)
    share = math.exp(-1.25 / 1.3**4) - math.exp(-1.25 / 0.8**4)
    return Compared(float(record.var()) / (3.0**2 / 16), share)
