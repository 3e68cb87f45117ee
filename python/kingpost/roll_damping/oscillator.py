"""A damped oscillator, stepped for many parameters at once, and fitted to a record by least squares."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ..errors import RollDampingError

if TYPE_CHECKING:
    from collections.abc import Callable

    from .sections import Array

PARAMETERS = ("frequency", "offset", "stiffening", "angle", "rate", "linear", "quadratic", "cubic")
STEPS_PER_PERIOD = 48
MOST_ITERATIONS = 60


def simulated(parameters: Array, time_s: Array) -> Array:
    """Roll at times of x'' + p1 x' + p2 |x'| x' + p3 x'^3 + omega0^2 x (1 + k x^2) = 0, roll = x + offset.

    The classical Runge-Kutta scheme in steps of a 48th of a period, h = 0.13 rad, between them cubic Hermite
    interpolation: the relative error of the period is h^4 / 120, 2e-6, and that of the amplitude per period 2
    pi h^5 / 144, 2e-6.

    Parameters
    ----------
    parameters
        By rows, in the order of `PARAMETERS`: omega0, offset, k, x(0), x'(0) / omega0, p1, p2, p3; a column
        for each oscillator.
    time_s
        Times; x(0) is at the first.

    Returns
    -------
    numpy.ndarray
        Shape (times, oscillators).

    >>> free = np.array([[2.0], [0.0], [0.0], [0.1], [0.0], [0.0], [0.0], [0.0]])
    >>> bool(np.allclose(simulated(free, np.array([0.0, 1.0]))[:, 0], [0.1, 0.1 * np.cos(2.0)], atol=1e-8))
    True
    """
    omega, offset, stiffening, angle, rate, p1, p2, p3 = parameters
    step = 2 * math.pi / float(omega.max()) / STEPS_PER_PERIOD
    count = max(1, math.ceil((time_s[-1] - time_s[0]) / step))
    step = (time_s[-1] - time_s[0]) / count
    square = omega**2

    bend = square * stiffening
    drag = bool(p2.any() or p3.any())

    def acceleration(x: Array, v: Array) -> Array:
        against = p1
        if drag:
            speed = np.abs(v)
            against = p1 + speed * (p2 + p3 * speed)
        return -(against * v + x * (square + bend * x * x))

    x, v = angle.copy(), rate * omega
    path = np.empty((count + 1, 2, len(omega)))
    path[0] = x, v
    with np.errstate(over="ignore", invalid="ignore"):
        for k in range(count):
            a1 = acceleration(x, v)
            v2 = v + step / 2 * a1
            a2 = acceleration(x + step / 2 * v, v2)
            v3 = v + step / 2 * a2
            a3 = acceleration(x + step / 2 * v2, v3)
            v4 = v + step * a3
            a4 = acceleration(x + step * v3, v4)
            x = x + step / 6 * (v + 2 * v2 + 2 * v3 + v4)
            v = v + step / 6 * (a1 + 2 * a2 + 2 * a3 + a4)
            path[k + 1] = x, v
        return offset + _between(path, (time_s - time_s[0]) / step, step)


def _between(path: Array, place: Array, step: float) -> Array:
    """Cubic Hermite interpolation in a path of angles and rates, at places counted in steps."""
    first = np.minimum(place.astype(int), len(path) - 2)
    t = (place - first)[:, None]
    (x0, v0), (x1, v1) = np.moveaxis(path[first], 1, 0), np.moveaxis(path[first + 1], 1, 0)
    return (
        (1 + 2 * t) * (1 - t) ** 2 * x0
        + t * (1 - t) ** 2 * step * v0
        + t**2 * (3 - 2 * t) * x1
        + t**2 * (t - 1) * step * v1
    )


@dataclass(frozen=True)
class Fit:
    """Parameters in the order of `PARAMETERS`, their standard deviations (0 for held ones), and the residual
    of the record."""

    parameters: Array
    deviations: Array
    residual: Array


def fit(start: Array, free: Array, time_s: Array, roll_rad: Array) -> Fit:
    """The oscillator that fits a record best, by least squares (Levenberg, Quart. Appl. Math. 2,
    1944; Marquardt, J. SIAM 11(2), 1963).

    The standard deviations are those of linear theory, s^2 (J^T J)^-1, times the root of (1 + r) / (1 - r)
    with r the correlation of neighbouring residuals, because the residual is not white noise.

    Parameters
    ----------
    start
        Starting values.
    free
        Parameters that are fitted; the others keep their values.
    time_s, roll_rad
        The record.

    Raises
    ------
    RollDampingError
        If no step reduces the residual and it is not at its minimum.
    """
    index = np.flatnonzero(free)

    def residuals(points: Array) -> Array:
        full = np.repeat(start[:, None], points.shape[1], axis=1)
        full[index] = points
        return simulated(full, time_s) - roll_rad[:, None]

    point, jacobian, residual = _least(residuals, start[index])
    found, deviations = start.copy(), np.zeros_like(start)
    found[index], deviations[index] = point, _deviations(jacobian, residual)
    return Fit(found, deviations, residual)


def _least(residuals: Callable[[Array], Array], point: Array) -> tuple[Array, Array, Array]:
    """Parameters, derivatives and residual at the minimum; one simulation both tests a step and gives the
    derivatives."""
    damping = 1e-3
    jacobian, residual = _jacobian(residuals, point)
    for _ in range(MOST_ITERATIONS):
        size = np.linalg.norm(jacobian, axis=0)
        scaled = jacobian / size
        if not (np.isfinite(scaled).all() and np.isfinite(residual).all()):
            break
        # The reduction of the residual that a whole step promises. If it is nearly zero, the rounding error
        # is measured by the change of the parameters.
        whole = np.linalg.lstsq(scaled, residual, rcond=None)[0]
        rounding = 1e-9 * float(np.linalg.norm(size * point))
        if np.linalg.norm(scaled @ whole) <= 1e-5 * np.linalg.norm(residual) + rounding:
            return point, jacobian, residual
        square = scaled.T @ scaled + damping * np.eye(len(point))
        there = point - np.linalg.solve(square, scaled.T @ residual) / size
        new_jacobian, new_residual = _jacobian(residuals, there)
        better = float(new_residual @ new_residual) < float(residual @ residual)
        if better and np.isfinite(new_jacobian).all():
            point, jacobian, residual, damping = there, new_jacobian, new_residual, max(damping / 10, 1e-12)
        else:
            damping *= 10
    raise RollDampingError("roll_rad", "a record that no damped oscillator fits", "decaying roll")


def _jacobian(residuals: Callable[[Array], Array], point: Array) -> tuple[Array, Array]:
    """Derivatives by central differences, and the residual."""
    n = len(point)
    steps = 1e-5 * np.maximum(np.abs(point), 1e-2)
    moved = np.concatenate([np.diag(steps), -np.diag(steps), np.zeros((n, 1))], axis=1)
    values = residuals(point[:, None] + moved)
    return (values[:, :n] - values[:, n : 2 * n]) / (2 * steps), values[:, -1]


def _deviations(jacobian: Array, residual: Array) -> Array:
    size = np.linalg.norm(jacobian, axis=0)
    covariance = np.linalg.pinv((jacobian / size).T @ (jacobian / size))
    samples = max(1, len(residual) - len(size))
    variance = float(residual @ residual) / samples
    alike = float(residual[1:] @ residual[:-1]) / max(float(residual @ residual), np.finfo(float).tiny)
    alike = min(max(alike, 0.0), 1 - 1 / len(residual))
    return np.sqrt(np.diag(covariance) * variance * (1 + alike) / (1 - alike)) / size
