"""Checks of a gyroscopic wave energy converter in one mode: a float that pitches in a flume, with flywheels
in gimbals.

With the impedance of the float's pitch rate, Z = B + i (w (I + A) - C / w), the angular momentum H of the
wheels, and the inertia J, damping c and stiffness k of the gimbals,

    Z_g = i w H^2 / (k - J w^2 + i w c),    P = |X|^2 Re(Z_g) / (2 |Z + Z_g|^2)

per amplitude squared (Kanki, Arii, Furusawa & Otoyo, "Development of advanced wave power generation system by
applying gyroscopic moment", EWTEC 2009). In a flume of the width W a float that is symmetric fore and aft has
X^2 = 2 B W rho g c_g (Haskind's relation in two dimensions; Newman, *Marine Hydrodynamics*, 1977, ch. 6).
Then P is at most half of the power W rho g c_g / 2 that comes in: where Z_g is the complex conjugate of Z
(Evans, J. Fluid Mech. 77, 1976, p. 1).
"""

from __future__ import annotations

import json
from dataclasses import dataclass, replace
from functools import cache
from typing import TYPE_CHECKING, Any

import numpy as np

from ..hydro.database import Database, Hull, Provenance, Radiation, RadiationMode, Water, Waterplane
from ..hydro.database_file import to_tree
from ..simulation.simulate import Simulation
from .models import GRAVITY, scenario
from .rows import Compared, check, worst

if TYPE_CHECKING:
    import xarray

AREA = "response"
HALF = "Evans, J. Fluid Mech. 77, 1976, p. 1: a symmetric body that moves in one mode takes at most one half"
OF_A_RUN = (
    "RK4 at 100 steps a period: (w h)^4 / 30 of each motion, 5e-7; the precession, of 1e-4 rad, squared"
)
PRECESSION = "H^2 i w / (k - J w^2 + i w c) of the gimbals in series with the float's impedance"

WIDTH_M, LENGTH_M, DRAUGHT_M = 10.0, 20.0, 2.0
DENSITY_KG_M3, GRAVITY_M_S2 = 1025.0, 9.80665
MASS_KG = DENSITY_KG_M3 * WIDTH_M * LENGTH_M * DRAUGHT_M
PITCH_INERTIA_KG_M2 = 36.0 * MASS_KG
ADDED_INERTIA_KG_M2 = 1.2e7
"""Added moment of inertia at infinite frequency."""
MEMORY = (1.2e7, 1.5, 0.5)
"""s1, n and z of K(s) = s1 s / (s^2 + 2 z n s + n^2), which is positive real and zero at s = 0."""
MOMENTUM_N_M_S = 2.0e6
GIMBAL_INERTIA_KG_M2 = 3.0e4
"""Moment of inertia of gimbal and wheel, about the axis of precession."""
FREQUENCIES = np.round(np.arange(0.1, 4.01, 0.1), 1)
PITCH = 4
OMEGAS = (0.9, 1.2, 1.4)
DETUNED = ((1 / 3, 1.0), (3.0, 1.0), (1.0, 0.8), (1.0, 1.2))
AMPLITUDE_M, PERIODS, STEPS_OF_A_PERIOD = 1e-4, 120, 100


def memory(omega: Any) -> Any:
    """K(i omega): its real part is B, its imaginary part omega (A - A at infinite frequency)."""
    strength, natural, ratio = MEMORY
    s = 1j * np.asarray(omega)
    return strength * s / (s**2 + 2 * ratio * natural * s + natural**2)


def incoming_power(omega: float) -> float:
    """Return the power of a wave of 1 m amplitude over the flume's width, W; group velocity g / (2 w)."""
    return 0.5 * WIDTH_M * DENSITY_KG_M3 * GRAVITY_M_S2 * GRAVITY_M_S2 / (2 * omega)


def excitation(omega: float) -> float:
    """Amplitude of the pitch moment per metre of wave amplitude, by Haskind's relation."""
    return float(np.sqrt(4 * memory(omega).real * incoming_power(omega)))


def impedance(omega: float) -> complex:
    """Return the mechanical impedance in pitch, moment over pitch rate, N m s."""
    buoyancy = WIDTH_M * LENGTH_M**3 / 12 + WIDTH_M * LENGTH_M * DRAUGHT_M * (-0.5 * DRAUGHT_M)
    stiffness = DENSITY_KG_M3 * GRAVITY_M_S2 * buoyancy
    inertia = PITCH_INERTIA_KG_M2 + ADDED_INERTIA_KG_M2
    return memory(omega) + 1j * (omega * inertia - stiffness / omega)


@dataclass(frozen=True)
class Gimbal:
    """The power take-off on the axis of precession."""

    damping_n_m_s: float
    stiffness_n_m_per_rad: float

    def impedance(self, omega: float) -> complex:
        """Mechanical impedance that the gimbal adds in pitch."""
        dynamic = (
            self.stiffness_n_m_per_rad - GIMBAL_INERTIA_KG_M2 * omega**2 + 1j * omega * self.damping_n_m_s
        )
        return 1j * omega * MOMENTUM_N_M_S**2 / dynamic

    def capture(self, omega: float) -> float:
        """Share of the incoming power, by the closed form."""
        added = self.impedance(omega)
        power = excitation(omega) ** 2 * added.real / (2 * abs(impedance(omega) + added) ** 2)
        return float(power / incoming_power(omega))

    def times(self, damping: float, stiffness: float) -> Gimbal:
        return replace(
            self,
            damping_n_m_s=damping * self.damping_n_m_s,
            stiffness_n_m_per_rad=stiffness * self.stiffness_n_m_per_rad,
        )


def best(omega: float) -> Gimbal:
    """Make the gimbal whose impedance is the complex conjugate of the float's."""
    dynamic = 1j * omega * MOMENTUM_N_M_S**2 / np.conj(impedance(omega))
    return Gimbal(float(dynamic.imag / omega), float(dynamic.real + GIMBAL_INERTIA_KG_M2 * omega**2))


def database() -> str:
    """The hydrodynamic database of the float: pitch alone has coefficients."""
    k = memory(FREQUENCIES)
    pitch = (slice(None), PITCH, PITCH)
    added, damping = np.zeros((2, len(FREQUENCIES), 6, 6))
    infinite, none = np.zeros((6, 6)), np.zeros((len(FREQUENCIES), 4, 6), complex)
    infinite[PITCH, PITCH] = ADDED_INERTIA_KG_M2
    added[pitch], damping[pitch] = ADDED_INERTIA_KG_M2 + k.imag / FREQUENCIES, k.real
    waves = none.copy()
    waves[:, 0, PITCH] = 1j * np.array([excitation(omega) for omega in FREQUENCIES])
    waves[:, 2, PITCH] = -waves[:, 0, PITCH]
    return json.dumps(to_tree(Database(
        title="A float in a flume",
        provenance=Provenance("tests", "closed form", "a float in a flume"),
        water=Water(DENSITY_KG_M3, GRAVITY_M_S2, None),
        hull=_hull(),
        frequencies_rad_s=FREQUENCIES,
        wave_directions_rad=0.5 * np.pi * np.arange(4),
        added_mass=added,
        radiation_damping=damping,
        added_mass_infinite=infinite,
        froude_krylov=waves,
        diffraction=none,
        radiation=_radiation(),
    )))  # fmt: skip


def _hull() -> Hull:
    area = WIDTH_M * LENGTH_M
    second_moments = np.array([area * LENGTH_M**2, 0.0, area * WIDTH_M**2]) / 12
    return Hull(
        draught_m=DRAUGHT_M,
        length_m=LENGTH_M,
        beam_m=WIDTH_M,
        volume_m3=area * DRAUGHT_M,
        centre_of_buoyancy_m=np.array([0.0, 0.0, -0.5 * DRAUGHT_M]),
        waterplane=Waterplane(area, np.zeros(2), second_moments),
    )


def _radiation() -> Radiation:
    """K(s) by its pole p and residue s1 p / (2 i Im p)."""
    strength, natural, ratio = MEMORY
    pole = natural * complex(-ratio, np.sqrt(1 - ratio**2))
    residues = np.zeros((6, 1, 6), complex)
    residues[PITCH, 0, PITCH] = strength * pole / (2j * pole.imag)
    return Radiation(tuple(RadiationMode(np.array([pole]), own) for own in residues), 0.0)


def _pair(side: str, turns: int, gimbal: Gimbal) -> dict[str, Any]:
    """A gimbal of half of the inertia, with a wheel of 20 t m2 that spins up or down."""
    about_axis, across = 2.0e4, 1.2e4
    frame = 0.5 * GIMBAL_INERTIA_KG_M2 - across
    precession = {
        "name": f"precession_{side}",
        "axis": [1, 0, 0],
        "damping_N_m_s": 0.5 * gimbal.damping_n_m_s,
        "spring": {"stiffness_N_m_per_rad": 0.5 * gimbal.stiffness_n_m_per_rad},
    }
    rate = turns * 0.5 * MOMENTUM_N_M_S / about_axis
    spin = {"name": f"spin_{side}", "axis": [0, 0, 1], "mode": {"prescribed": {"rate_rad_s": rate}}}
    light = {"mass_kg": 1e-3}
    return {
        f"gimbal_{side}": light
        | {
            "parent": "float",
            "inertia": {"tensor": {"moments_kg_m2": [frame, frame, frame]}},
            "joint": {"revolute": precession},
        },
        f"wheel_{side}": light
        | {
            "parent": f"gimbal_{side}",
            "inertia": {"tensor": {"moments_kg_m2": [across, across, about_axis]}},
            "joint": {"revolute": spin},
        },
    }


def in_a_wave(omega: float, gimbal: Gimbal) -> xarray.Dataset:
    """A run in a regular wave. Two wheels of H / 2 spin against each other, so that nothing rolls."""
    period = 2 * np.pi / omega
    step = period / STEPS_OF_A_PERIOD
    own = PITCH_INERTIA_KG_M2 - GIMBAL_INERTIA_KG_M2
    float_body = {
        "mass_kg": MASS_KG,
        "inertia": {"tensor": {"moments_kg_m2": [1e7, own, 2e7]}},
        "joint": {"floating": {"hold_translation": True}},
    }
    wave = {"height_m": 2 * AMPLITUDE_M, "period_s": period}
    flume = scenario(
        {"float": float_body} | _pair("port", 1, gimbal) | _pair("starboard", -1, gimbal),
        {
            **GRAVITY,
            "water": {"hydrodynamics": {"body": "float", "database": "flume.hydro.json"}},
        },
        {"flume.hydro.json": database()},
        sea={"density_kg_m3": DENSITY_KG_M3, "waves": {"swell": {"regular": wave}}},
        simulation={"step_s": step, "duration_s": PERIODS * period, "record_every_s": step},
    )
    return Simulation(flume).run()


def generated_w(run: xarray.Dataset, damping_n_m_s: float, samples: int) -> float:
    """Mean power of the two generators, of this damping each, over the last samples of a run."""
    rates = run.joint_velocity.isel(time=slice(-samples, None))
    of_both = [rates.sel(coordinate=f"precession_{side}").values for side in ("port", "starboard")]
    return damping_n_m_s * sum(float(np.mean(rate**2)) for rate in of_both)


@cache
def captured(omega: float, damping: float = 1.0, stiffness: float = 1.0) -> tuple[float, float]:
    """Share of the incoming power, by the last period of a run and by the closed form; factors detune the
    best gimbal."""
    gimbal = best(omega).times(damping, stiffness)
    power_w = generated_w(in_a_wave(omega, gimbal), 0.5 * gimbal.damping_n_m_s, STEPS_OF_A_PERIOD)
    return power_w / (incoming_power(omega) * AMPLITUDE_M**2), gimbal.capture(omega)


@check(
    "gyro-converter-best",
    "share of a wave's power that a gyroscopic converter takes in a flume at its best tuning, three periods",
    area=AREA,
    unit="1",
    source=HALF,
    tolerance=1e-5,
    why=OF_A_RUN,
)
def gyro_converter_best() -> Compared:
    return worst([captured(omega)[0] for omega in OMEGAS], [0.5] * len(OMEGAS))


@check(
    "gyro-converter-detuned",
    "share that it takes with three times and a third of the damping, and 0.8 and 1.2 of the stiffness",
    area=AREA,
    unit="1",
    source=PRECESSION,
    tolerance=1e-5,
    why=OF_A_RUN,
)
def gyro_converter_detuned() -> Compared:
    every = np.array([captured(omega, *factors) for omega in OMEGAS for factors in DETUNED])
    return worst(every[:, 0], every[:, 1])
