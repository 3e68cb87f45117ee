"""Memory of the water from the data of a database: K(j omega), its tail, its impulse response.

Ogilvie's relations (T. F. Ogilvie, "Recent progress toward the understanding and prediction of ship
motions", 5th Symposium on Naval Hydrodynamics, 1964) for Cummins' equation (W. E. Cummins, "The impulse
response function and ship motions", Schiffstechnik 9, 1962). A velocity nu(t) of the hull gives the force

    F(t) = -A_inf nu'(t) - integral_0^inf k(tau) nu(t - tau) dtau.

Put nu = Re{v exp(+j w t)}: F = -Re{[j w A_inf + K(j w)] v exp(+j w t)} with
K(j w) = integral k exp(-j w tau) dtau. A(w) and B(w) are defined by F = -A nu' - B nu, they are real, and so
the same for exp(-i w t) and exp(+j w t): only the excitation depends on that sign. Comparison gives, in the
sense of exp(+st), s = j w,

    K(j w) = B(w) + j w (A(w) - A_inf),
    k(t) = (2/pi) integral_0^inf B(w) cos(w t) dw,
    A(w) = A_inf - (1/w) integral_0^inf k(t) sin(w t) dt.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from .database import Database
    from .several import SeveralHulls
    from .vector_fitting import Array, ComplexArray

# Least and largest power of omega with which damping falls beyond the data: 3 is the slowest known, for a
# vertical side that moves along its normal (a piston wavemaker, B ~ rho omega / k^2, k = omega^2 / g).
SLOWEST_TAIL, FASTEST_TAIL = 3.0, 7.0
# The integral of the tail ends at this multiple of the highest frequency: there it is 40^-3 of its height.
TAIL_END = 40.0


def frequency_response(database: Database | SeveralHulls) -> ComplexArray:
    """K(j omega), (frequency, force, motion), in the sense of exp(+j omega t)."""
    omega = database.frequencies_rad_s[:, None, None]
    return database.radiation_damping + 1j * omega * (database.added_mass - database.added_mass_infinite)


def tail(omega: Array, damping: Array, beyond: Array) -> Array:
    """Damping (frequency, ...) beyond the data: B(w_n) (w_n / w)^m.

    m is the logarithmic slope over the last fifth of the range, for the sum of the squares of all given
    entries, limited to 3 to 7.
    """
    size = np.sqrt((damping.reshape(len(omega), -1) ** 2).sum(axis=1))
    last = (omega >= 0.8 * omega[-1]) & (size > 0.0)
    slope = SLOWEST_TAIL
    if last.sum() >= 2:
        slope = -np.polyfit(np.log(omega[last]), np.log(size[last]), 1)[0]
    power = np.clip(slope, SLOWEST_TAIL, FASTEST_TAIL)
    shape = (len(beyond),) + (1,) * (damping.ndim - 1)
    return damping[-1] * ((omega[-1] / beyond) ** power).reshape(shape)


def smooth(omega: Array, values: Array, at: Array) -> Array:
    """Values (frequency, ...) by piecewise cubics with the slopes of parabolas through three points."""
    flat = values.reshape(len(omega), -1)
    step, rise = np.diff(omega)[:, None], np.diff(flat, axis=0)
    chord = rise / step
    slope = np.empty_like(flat)
    slope[1:-1] = (chord[:-1] * step[1:] + chord[1:] * step[:-1]) / (step[:-1] + step[1:])
    slope[0], slope[-1] = 2.0 * chord[0] - slope[1], 2.0 * chord[-1] - slope[-2]
    k = np.clip(np.searchsorted(omega, at, side="right") - 1, 0, len(omega) - 2)
    h, u = step[k], ((at - omega[k]) / np.diff(omega)[k])[:, None]
    cubic = (flat[k] * (1.0 + 2.0 * u) * (1.0 - u) ** 2 + slope[k] * h * u * (1.0 - u) ** 2
             + flat[k + 1] * u**2 * (3.0 - 2.0 * u) + slope[k + 1] * h * u**2 * (u - 1.0))  # fmt: skip
    return cubic.reshape(len(at), *values.shape[1:])


def damping_on_a_fine_grid(omega: Array, damping: Array, points: int = 4000) -> tuple[Array, Array]:
    """Frequencies from 0 to `TAIL_END` times the last, and the damping: 0 at frequency 0, then data, then
    tail."""
    with_zero = np.append(0.0, omega)
    values = np.concatenate([np.zeros((1, *damping.shape[1:])), damping])
    inside = np.unique(np.concatenate([np.linspace(0.0, omega[-1], points), with_zero]))
    beyond = omega[-1] * np.geomspace(1.0, TAIL_END, points // 2)[1:]
    fine = np.concatenate([smooth(with_zero, values, inside), tail(omega, damping, beyond)])
    return np.concatenate([inside, beyond]), fine


def retardation(database: Database | SeveralHulls, t: Array) -> Array:
    """k(t) = (2/pi) integral_0^inf B(w) cos(w t) dw, (time, force, motion), directly from the damping.

    Between the frequencies damping is a piecewise cubic, at 0 it is 0, beyond the last it is `tail`; on
    a fine grid of these the integral is exact for straight lines (Filon's way), so that large t need no
    finer grid. Direct convolution and the tests use it; nothing is fitted.
    """
    omega, damping = damping_on_a_fine_grid(database.frequencies_rad_s, database.radiation_damping)
    return cosine_transform(omega, damping, np.atleast_1d(np.asarray(t, float)))


def cosine_transform(omega: Array, values: Array, t: Array) -> Array:
    """(2/pi) integral of piecewise linear values(omega) cos(omega t), (time, ...).

    By parts: [B sin(wt)/t] + sum of slopes times differences of cos(wt)/t^2.
    """
    flat = values.reshape(len(omega), -1)
    slope = np.diff(flat, axis=0) / np.diff(omega)[:, None]
    found = np.empty((len(t), flat.shape[1]))
    for row, moment in enumerate(t):
        if abs(moment) * omega[-1] < 1e-6:
            found[row] = (0.5 * (flat[1:] + flat[:-1]) * np.diff(omega)[:, None]).sum(axis=0)
        else:
            # cos b - cos a as a product: small differences keep their digits.
            middle, half = 0.5 * (omega[1:] + omega[:-1]) * moment, 0.5 * np.diff(omega) * moment
            difference = -2.0 * np.sin(middle) * np.sin(half)
            ends = flat[-1] * np.sin(omega[-1] * moment) - flat[0] * np.sin(omega[0] * moment)
            found[row] = ends / moment + difference @ slope / moment**2
    return (2.0 / np.pi) * found.reshape(len(t), *values.shape[1:])


def added_mass_infinite(omega: Array, added_mass: Array, damping: Array) -> Array:
    """A_inf = A(w) - (2/pi) P integral_0^inf B(x) / (x^2 - w^2) dx, the median over the middle frequencies.

    This is the third of Ogilvie's relations with the second inserted. The singularity is removed with
    P integral_0^inf dx / (x^2 - w^2) = 0: the integrand is (B(x) - B(w)) / (x^2 - w^2).
    """
    fine, values = damping_on_a_fine_grid(omega, damping)
    found = []
    for k in range(len(omega) // 4, len(omega) - len(omega) // 4):
        # Beyond the grid B is zero; the integral of the remaining -B(w) / (x^2 - w^2) is known.
        w, away = omega[k], np.abs(fine - omega[k]) > 1e-9 * omega[k]
        x = fine[away]
        integrand = (values[away] - damping[k]) / (x**2 - w**2)[:, None, None]
        integral = (0.5 * (integrand[1:] + integrand[:-1]) * np.diff(x)[:, None, None]).sum(axis=0)
        rest = damping[k] / (2 * w) * np.log((x[-1] + w) / (x[-1] - w))
        found.append(added_mass[k] - (2.0 / np.pi) * (integral - rest))
    return np.median(found, axis=0)
