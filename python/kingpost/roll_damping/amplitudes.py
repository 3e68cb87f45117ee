"""Amplitude and frequency of a decaying oscillation, half period by half period."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ..errors import RollDampingError
from .coefficients import CUBIC, QUADRATIC

if TYPE_CHECKING:
    from .record import DecayRecord
    from .sections import Array

FEWEST_SWINGS = 4
"""Smallest number of half periods in a record."""
FEWEST_PER_PERIOD = 8
"""Smallest number of samples in a period."""
# A swing counts if it exceeds this many standard deviations of the noise and this share of the largest swing.
ABOVE_NOISE, SMALLEST_SHARE = 5.0, 0.02


@dataclass(frozen=True)
class Swings:
    """Results for windows one period long, half a period apart: time of the middle, s, offset and amplitude,
    rad, and frequency, rad/s."""

    time_s: Array
    offset_rad: Array
    amplitude_rad: Array
    frequency_rad_s: Array

    @property
    def decay_per_s(self) -> Array:
        """-2 d ln(amplitude) / dt between each window and the next: the equivalent linear damping over the
        inertia."""
        return -2 * np.diff(np.log(self.amplitude_rad)) / np.diff(self.time_s)

    @property
    def between_rad(self) -> Array:
        """Amplitude between each window and the next, the geometric mean."""
        return np.sqrt(self.amplitude_rad[1:] * self.amplitude_rad[:-1])


def swings(record: DecayRecord) -> Swings:
    """Amplitudes of a record, each from all samples of a period by least squares.

    In a window one period long about t0 the roll is
    c + (a + a' t) cos omega t + (b + b' t) sin omega t, t from t0: the amplitude is |a + i b|, and the rate
    of its phase, (a' b - a b') / (a^2 + b^2), is added to omega. The fit averages noise over the window,
    which a reading of the extrema does not; a' and b' contain the decay within the window.

    Raises
    ------
    RollDampingError
        If the record does not oscillate, or has too few samples in a period.

    >>> from kingpost.roll_damping.record import DecayRecord
    >>> time = np.linspace(0, 100, 2001)
    >>> found = swings(DecayRecord(time, 0.2 * np.exp(-0.01 * time) * np.cos(0.6 * time) + 0.01))
    >>> bool(np.allclose(found.decay_per_s, 0.02, rtol=1e-3))
    True
    >>> bool(np.allclose(found.offset_rad, 0.01, atol=1e-3))
    True
    """
    time, roll = record.time_s, record.roll_rad
    crossings = _crossings(time, roll)
    half = float(np.median(np.diff(crossings)))
    if 2 * half < FEWEST_PER_PERIOD * float(np.median(np.diff(time))):
        allowed = f"{FEWEST_PER_PERIOD} samples in a period of {2 * half:.4g} s, or more"
        raise RollDampingError("time_s", f"steps of {np.median(np.diff(time)):.4g} s", allowed)
    # After the last crossing the swings are below the noise.
    last = min(time[-1], crossings[-1] + half / 2)
    middles = np.arange(time[0] + half, last - half + 1e-9 * half, half)
    if len(middles) < FEWEST_SWINGS - 1:
        raise _no_oscillation(len(crossings) - 1)
    found = np.array([_window(time, roll, middle, half) for middle in middles])
    return Swings(middles, *found.T)


def averaged(found: Swings, frequency_rad_s: float, terms: int) -> Array:
    """p1, p2, p3 over the inertia (as many as asked for) from the amplitudes of swings.

    The energy lost between two windows is that of the averaged equation
    da/dt = -(a / 2) (p1 + 8 / (3 pi) omega a p2 + 3/4 omega^2 a^2 p3) (Froude's energy method; Bogoliubov &
    Mitropolsky, *Asymptotic Methods*, 1961): least squares over the amplitudes lost.
    """
    a, speed = found.between_rad, found.between_rad * frequency_rad_s
    columns: Array = np.stack([a, QUADRATIC * speed * a, CUBIC * speed**2 * a][:terms], axis=1)
    return _least_squares(columns, found.decay_per_s * a)


def _window(time: Array, roll: Array, middle: float, half: float) -> tuple[float, float, float]:
    """Offset, amplitude and frequency in a window of one period."""
    kept = np.abs(time - middle) <= half
    t, omega = time[kept] - middle, np.pi / half
    cos, sin = np.cos(omega * t), np.sin(omega * t)
    columns = np.stack([np.ones_like(t), cos, sin, t * cos / half, t * sin / half], axis=1)
    c, a, b, da, db = _least_squares(columns, roll[kept])
    gain = (da * b - a * db) / (half * (a**2 + b**2))
    return c, float(np.hypot(a, b)), omega + gain


def _crossings(time: Array, roll: Array) -> Array:
    """Times of zero crossings between swings larger than the noise."""
    about = roll - np.median(roll)
    # Third differences of a smooth record are nearly zero; those of noise are sqrt(20) standard deviations.
    noise = float(np.median(np.abs(np.diff(about, 3)))) / (0.6745 * np.sqrt(20.0))
    largest = float(np.abs(about).max())
    # Coarse sampling looks like noise: half of the largest swing bounds the level, so that `swings` reports
    # it.
    least = min(max(ABOVE_NOISE * noise, SMALLEST_SHARE * largest), largest / 2)
    sides = np.sign(about) * (np.abs(about) > least)
    far = np.flatnonzero(sides)
    turned = np.flatnonzero(np.diff(sides[far]) != 0) if len(far) else np.array([], int)
    if len(turned) < FEWEST_SWINGS - 1:
        raise _no_oscillation(len(turned))
    before, after = far[turned], far[turned + 1]
    part = about[before] / (about[before] - about[after])
    return time[before] + part * (time[after] - time[before])


def _no_oscillation(found: int) -> RollDampingError:
    allowed = f"a roll that swings {FEWEST_SWINGS} times or more from side to side"
    return RollDampingError("roll_rad", f"{max(found, 0)} swings", allowed)


def _least_squares(columns: Array, right: Array) -> Array:
    """Solve a least-squares problem; refuse columns that are not finite, about which LAPACK would print a
    message."""
    if not (np.isfinite(columns).all() and np.isfinite(right).all()):
        raise np.linalg.LinAlgError("columns that are not finite")
    return np.linalg.lstsq(columns, right, rcond=None)[0]
