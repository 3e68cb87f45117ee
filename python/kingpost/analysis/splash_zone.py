"""Loads on objects that are lowered through the splash zone by the simplified method of DNV-RP-N103.

DNV-RP-N103, *Modelling and analysis of marine operations*, sec. 4.3, for an object that is small compared
with the waves, under the crane's tip with the motion eta, v_ct, a_ct in heave. With the amplitude zeta, the
period T_z and the depth d of the part under water,

    v_w  = zeta (2 pi / T_z) exp(-4 pi^2 d / (T_z^2 g)),     a_w = v_w 2 pi / T_z
    v_r  = v_c + sqrt(v_ct^2 + v_w^2)
    F_slam = 1/2 rho C_S A_S v_r^2                           F_D = 1/2 rho C_D A_p v_r^2
    F_M    = sqrt([(M + A) a_ct]^2 + [(rho V + A) a_w]^2)    F_rho = rho g A_w sqrt(zeta^2 + eta^2)
    F_hyd  = sqrt((F_D + F_slam)^2 + (F_M - F_rho)^2)        F_hyd <= 0.9 (M g - rho V g)

the last one to avoid slack slings (sec. 4.4.3). zeta is 0.9 Hs in a random sea (sec. 4.3.4). The text
of the recommended practice was not available: compare the formulas with it before you rely on them.
"""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import results
from ..errors import KingpostError
from ..given import not_negative
from ..scenario import Overrides, Scenario
from ..simulation.simulate import Simulation
from .wave_response import as_simulation

if TYPE_CHECKING:
    import xarray

LOWERING_SPEED_M_S = 0.5
"""v_c: typical lowering speed (DNV-RP-N103, sec. 4.3.5)."""
CHARACTERISTIC = 0.9
"""zeta over Hs in a random sea (DNV-RP-N103, sec. 4.3.4)."""
SLACK_MARGIN = 0.9
"""Largest F_hyd over the static force (DNV-RP-N103, sec. 4.4.3)."""
LEAST_SLAMMING = {False: 5.0, True: 3.0}
"""Smallest C_S unless tests or theory give another value; the key is True for circular cylinders
(DNV-RP-N103, sec. 4.3.5)."""
IMMERSIONS = ("touches", "half immersed", "immersed")
FREQUENCIES = 2000
"""Number of frequencies of the spectrum's integrals: amplitude and period of a JONSWAP sea are within 1e-7 of
those with a hundred times as many frequencies."""


def splash_zone(
    scenario_or_simulation: Scenario | Simulation | str | Path,
    overrides: Overrides | None = None,
    *,
    lowering_speed_m_s: float = LOWERING_SPEED_M_S,
    tip_heave_m: float = 0.0,
    tip_speed_m_s: float = 0.0,
    tip_acceleration_m_s2: float = 0.0,
    **parameters: Any,
) -> xarray.Dataset:
    """Characteristic loads on each `submerged` object, upright, at three immersions, by DNV-RP-N103.

    Parameters
    ----------
    scenario_or_simulation
        Scenario or simulation with `submerged` forces; the wave height and period are those of its sea.
    overrides, parameters
        Values that override those of a scenario.
    lowering_speed_m_s
        v_c, m/s.
    tip_heave_m, tip_speed_m_s, tip_acceleration_m_s2
        eta, v_ct, a_ct: characteristic amplitudes of the crane tip's vertical motion.

    Returns
    -------
    xarray.Dataset
        By ``object`` and ``immersion`` (touches, half immersed, immersed): ``depth`` of the bottom (m),
        ``added_mass`` (kg), ``slamming_coefficient`` (over the projected area), and the forces (N)
        ``static_force``, ``slamming_force``, ``drag_force``, ``mass_force``, ``buoyancy_force``,
        ``hydrodynamic_force``; ``slack_utilisation`` is F_hyd over 0.9 times the static force, NaN for a body
        with several objects. The attributes give ``wave_amplitude_m``, ``zero_up_crossing_period_s``.

    Raises
    ------
    KingpostError
        When there is no `submerged` force, or a number is negative or not finite.

    >>> found = splash_zone("subsea_lowering")
    >>> found.immersion.values.tolist()
    ['touches', 'half immersed', 'immersed']
    """
    import xarray

    speeds = [
        not_negative("lowering_speed_m_s", lowering_speed_m_s),
        not_negative("tip_heave_m", tip_heave_m),
        not_negative("tip_speed_m_s", tip_speed_m_s),
        not_negative("tip_acceleration_m_s2", tip_acceleration_m_s2),
    ]
    simulation = as_simulation(scenario_or_simulation, overrides, parameters)
    described = simulation.scenario.model
    objects = described["objects_in_water"]
    if not objects:
        raise KingpostError("forces: found no object that is lowered into the water, allowed: at least one")
    amplitude, period = characteristic_wave(simulation)
    rows = [
        [_loads(one, at, speeds, (amplitude, period), described["gravity_m_s2"]) for at in one["immersions"]]
        for one in objects
    ]
    units = dict.fromkeys(rows[0][0], "N") | OTHER_UNITS
    variables = {
        name: (
            ("object", "immersion"),
            np.array([[at[name] for at in row] for row in rows]),
            {"units": units[name]},
        )
        for name in rows[0][0]
    }
    coordinates = {
        "object": np.array([one["name"] for one in objects], str),
        "immersion": np.array(IMMERSIONS, str),
    }
    attributes = results.attributes(simulation.scenario, "characteristic loads by DNV-RP-N103")
    attributes |= {"wave_amplitude_m": amplitude, "zero_up_crossing_period_s": period}
    attributes |= dict(
        zip(
            ("lowering_speed_m_s", "tip_heave_m", "tip_speed_m_s", "tip_acceleration_m_s2"),
            speeds,
            strict=True,
        )
    )
    return xarray.Dataset(variables, coordinates, attributes)


OTHER_UNITS = {"depth": "m", "added_mass": "kg", "slamming_coefficient": "1", "slack_utilisation": "1"}


def _loads(
    object_: dict[str, Any],
    at: dict[str, float],
    speeds: list[float],
    wave: tuple[float, float],
    g: float,
) -> dict[str, float]:
    """Loads on one object at one immersion, by the equations in the module's docstring."""
    (lowering, heave, tip_speed, tip_acceleration), (amplitude, period) = speeds, wave
    density = object_["density_kg_m3"]
    frequency = 2 * math.pi / period if period > 0 else 0.0
    decay = math.exp(-(frequency**2) * at["centre_depth_m"] / g)
    water_speed = amplitude * frequency * decay
    speed = lowering + math.hypot(tip_speed, water_speed)
    mass, displaced, added = object_["mass_kg"], density * at["displaced_volume_m3"], at["added_mass_kg"]
    static = (mass - displaced) * g
    slamming = 0.5 * density * at["slamming_area_m2"] * speed**2
    drag = 0.5 * density * at["drag_area_m2"] * speed**2
    inertia = math.hypot((mass + added) * tip_acceleration, (displaced + added) * water_speed * frequency)
    buoyancy = density * g * at["waterplane_area_m2"] * math.hypot(amplitude, heave)
    if at is object_["immersions"][-1]:
        buoyancy = 0.0
    hydrodynamic = math.hypot(drag + slamming, inertia - buoyancy)
    alone = object_["objects_on_body"] == 1 and static > 0
    return {
        "depth": at["depth_m"],
        "added_mass": added,
        "slamming_coefficient": at["slamming_area_m2"] / object_["projected_area_m2"],
        "static_force": static,
        "slamming_force": slamming,
        "drag_force": drag,
        "mass_force": inertia,
        "buoyancy_force": buoyancy,
        "hydrodynamic_force": hydrodynamic,
        "slack_utilisation": hydrodynamic / (SLACK_MARGIN * static) if alone else math.nan,
    }


def characteristic_wave(simulation: Simulation) -> tuple[float, float]:
    """Amplitude (m) and zero up-crossing period (s) of the scenario's sea for the simplified method. The
    amplitude is 0.9 Hs in a random sea, and the sum of the amplitudes if every system is a regular wave. In
    still water both are 0.
    """
    (systems,) = simulation.sea_spectra([], 1)
    bands = [one["band_rad_s"] for one in systems if one["band_rad_s"]]
    lines = [line for one in systems for line in one["lines"]]
    m0, m2 = sum(line[2] for line in lines), sum(line[0] ** 2 * line[2] for line in lines)
    if bands:
        lowest, highest = min(band[0] for band in bands), max(band[1] for band in bands)
        grid = np.linspace(lowest, highest, FREQUENCIES)
        (systems,) = simulation.sea_spectra(grid, 1)
        density = sum(np.asarray(one["density_m2_s"]) for one in systems if one["band_rad_s"])
        m0 += float(np.trapezoid(density, grid))
        m2 += float(np.trapezoid(grid**2 * density, grid))
    if m2 == 0:
        return 0.0, 0.0
    amplitude = CHARACTERISTIC * 4 * math.sqrt(m0) if bands else sum(math.sqrt(2 * line[2]) for line in lines)
    return amplitude, 2 * math.pi * math.sqrt(m0 / m2)
