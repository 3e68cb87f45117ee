"""Roll damping from a decay test: first estimate from amplitudes, then a fit of the simulated record."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ..errors import RollDampingError
from .amplitudes import Swings, averaged, swings
from .coefficients import Coefficients, fitted
from .oscillator import PARAMETERS, fit, simulated
from .record import DecayRecord

if TYPE_CHECKING:
    from .sections import Array

MODELS = {"linear": 1, "quadratic": 2, "cubic": 3}
"""Number of the terms p1, p2, p3 in each model."""
TERMS = ("linear", "quadratic", "cubic")
# With fewer swings the curvature of the righting arm cannot be distinguished from the period.
SWINGS_FOR_STIFFENING = 8


@dataclass(frozen=True)
class DecayFit:
    """Roll that decays by x'' + p1 x' + p2 |x'| x' + p3 x'^3 + omega0^2 x (1 + k x^2) = 0, roll = x + offset.

    Attributes
    ----------
    model
        ``linear``, ``quadratic`` or ``cubic``: the highest of the terms p1, p2, p3.
    frequency_rad_s, period_s
        omega0 and 2 pi / omega0, of small amplitudes without damping.
    damping
        p1, 1/s; p2; p3, s.
    deviations
        Standard deviations by name: ``frequency``, ``linear``, ``quadratic``, ``cubic``.
    stiffening
        k, 1/rad^2: curvature of the righting arm.
    offset_rad
        Mean angle of the roll.
    rms_rad
        RMS of the difference between record and model.
    swings
        Amplitudes, half period by half period.
    averaged
        p1, p2, p3 from these amplitudes alone.
    """

    model: str
    frequency_rad_s: float
    damping: tuple[float, float, float]
    deviations: dict[str, float]
    stiffening: float
    offset_rad: float
    rms_rad: float
    swings: Swings
    averaged: tuple[float, float, float]

    @property
    def period_s(self) -> float:
        """Natural period, s."""
        return 2 * math.pi / self.frequency_rad_s

    def equivalent(self, amplitude_rad: Array | float) -> Array | float:
        """Equivalent linear damping over the inertia, 1/s: p1 + 8 / (3 pi) omega a p2 + 3/4 omega^2 a^2
        p3."""
        return Coefficients(*self.damping).equivalent(self.frequency_rad_s, amplitude_rad)

    def damping_ratio(self, amplitude_rad: Array | float) -> Array | float:
        """The equivalent linear damping as a fraction of the critical damping, 2 omega0."""
        return self.equivalent(amplitude_rad) / (2 * self.frequency_rad_s)

    def inertia_kg_m2(
        self, mass_kg: float, metacentric_height_m: float, gravity_m_s2: float = 9.80665
    ) -> float:
        """Inertia in roll, added inertia included, m g GM / omega0^2.

        Raises
        ------
        RollDampingError
            When a number is not greater than 0.
        """
        for name, value in (("mass_kg", mass_kg), ("metacentric_height_m", metacentric_height_m)):
            if not (math.isfinite(value) and value > 0):
                raise RollDampingError(name, f"{value:g}", "a number greater than 0")
        return mass_kg * gravity_m_s2 * metacentric_height_m / self.frequency_rad_s**2

    def coefficients(self, inertia_kg_m2: float) -> Coefficients:
        """B1, B2 and B3 of the total roll damping, radiated waves included."""
        if not (math.isfinite(inertia_kg_m2) and inertia_kg_m2 > 0):
            raise RollDampingError("inertia_kg_m2", f"{inertia_kg_m2:g}", "a number greater than 0")
        return Coefficients(*(inertia_kg_m2 * p for p in self.damping))

    def for_scenario(self, inertia_kg_m2: float, radiated_damping: float = 0.0) -> Coefficients:
        """Linear and quadratic damping, neither negative, for a scenario whose database already contains the
        radiation damping.

        The best fit to the equivalent damping less the radiation damping, over the amplitudes of the record.

        Raises
        ------
        RollDampingError
            If the radiation damping exceeds the total.
        """
        amplitudes = np.linspace(self.swings.amplitude_rad.min(), self.swings.amplitude_rad.max(), 20)
        whole = self.coefficients(inertia_kg_m2).equivalent(self.frequency_rad_s, amplitudes)
        rest = np.broadcast_to(whole, amplitudes.shape) - radiated_damping
        if not (radiated_damping >= 0 and (rest > 0).all()):
            allowed = f"0 to less than the least of the whole damping, {np.min(whole):.4g}"
            raise RollDampingError("radiated_damping", f"{radiated_damping:.4g}", allowed)
        return fitted(amplitudes, rest, self.frequency_rad_s)

    def simulated(self, record: DecayRecord, angle_rad: float, rate_rad_s: float) -> Array:
        """Roll at the times of a record, from an initial angle about the offset and an initial rate."""
        rate = rate_rad_s / self.frequency_rad_s
        state = [self.frequency_rad_s, self.offset_rad, self.stiffening, angle_rad, rate, *self.damping]
        return simulated(np.array(state)[:, None], record.time_s)[:, 0]


def from_decay(record: DecayRecord, model: str = "quadratic", after_s: float | None = None,
               until_s: float | None = None) -> DecayFit:  # fmt: skip
    """Damping and natural period from a record of decaying roll.

    The amplitudes of the swings (`amplitudes.swings`) and the energy lost in each give a first estimate. From
    there the simulated roll is fitted to the whole record by least squares, with the initial angle and rate,
    the offset and, from eight swings on, the curvature of the righting arm.

    Parameters
    ----------
    record
        Time and angle.
    model
        ``linear`` (p1), ``quadratic`` (p1, p2) or ``cubic`` (p1, p2, p3).
    after_s, until_s
        The used part of the record; default: from its largest angle to its end.

    Raises
    ------
    RollDampingError
        If the record does not oscillate, or no model fits it.

    >>> time = np.linspace(0, 120, 1201)
    >>> record = DecayRecord(time, 0.2 * np.exp(-0.01 * time) * np.cos(0.6 * time))
    >>> found = from_decay(record, "linear")
    >>> round(found.damping[0], 6), round(found.period_s, 2)
    (0.02, 10.47)
    """
    if model not in MODELS:
        raise RollDampingError("model", repr(model), ", ".join(MODELS))
    try:
        # An overflow ends the fit.
        with np.errstate(all="ignore"):
            return _fitted(_part(record, after_s, until_s), model)
    except np.linalg.LinAlgError:
        raise RollDampingError("roll_rad", "a record of no decaying roll", "decaying roll") from None


def _fitted(used: DecayRecord, model: str) -> DecayFit:
    """Fit the simulated roll to a record."""
    seen = swings(used)
    used = used.between(used.time_s[0], seen.time_s[-1] + math.pi / seen.frequency_rad_s[-1])
    count, frequency = MODELS[model], float(np.median(seen.frequency_rad_s))
    first = np.zeros(3)
    first[:count] = averaged(seen, frequency, count)
    offset = float(np.median(seen.offset_rad))
    start = np.array([frequency, offset, 0.0, *_state(used, offset, frequency), *first])
    free = np.array(
        [True, True, len(seen.time_s) >= SWINGS_FOR_STIFFENING, True, True, *(np.arange(3) < count)]
    )
    best = fit(start, free, used.time_s, used.roll_rad)
    named = dict(zip(PARAMETERS, best.parameters.tolist(), strict=True))
    deviations = dict(zip(PARAMETERS, best.deviations.tolist(), strict=True))
    return DecayFit(
        model,
        named["frequency"],
        (named["linear"], named["quadratic"], named["cubic"]),
        {name: deviations[name] for name in ("frequency", *TERMS[:count])},
        named["stiffening"],
        named["offset"],
        float(np.sqrt(np.mean(best.residual**2))),
        seen,
        tuple(first.tolist()),
    )


def _part(record: DecayRecord, after_s: float | None, until_s: float | None) -> DecayRecord:
    """The record from its largest angle on, or the given part."""
    time, roll = record.time_s, record.roll_rad
    if after_s is None:
        after_s = float(time[np.abs(roll - np.median(roll)).argmax()])
    last = float(time[-1]) if until_s is None else until_s
    if not after_s < last:
        raise RollDampingError("after_s", f"{after_s:g}", f"less than the end, {last:g}")
    return record.between(after_s, last)


def _state(record: DecayRecord, offset: float, frequency: float) -> tuple[float, float]:
    """Angle about the offset and rate over frequency at the start, from the first half period."""
    t = record.time_s - record.time_s[0]
    kept = frequency * t <= math.pi
    columns = np.stack([np.cos(frequency * t[kept]), np.sin(frequency * t[kept])], axis=1)
    angle, rate = np.linalg.lstsq(columns, record.roll_rad[kept] - offset, rcond=None)[0]
    return float(angle), float(rate)
