"""The memory of the water as a state-space model: rational functions fitted to K(j omega).

K(j w) = B(w) + j w (A(w) - A_inf), in the sense of exp(+st) (`memory` derives it), is fitted by
K_ij(s) = sum over poles p of r_ij / (s - p), conjugates included. The model has the properties of
the water's memory (`passive_residues`): stable, K(0) = 0, of relative degree one, symmetric, and
positive real as a matrix at every frequency from 0 to infinity, not only at the data's.

Coupled motions (surge, heave and pitch of a symmetric hull) have common poles (`vector_fitting`): only then
can K be symmetric. If K is not symmetric, K + K^H is indefinite at both ends of the frequency range.
Couplings that the data do not have stay exactly zero.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ..errors import HydrodynamicsError
from .database import Radiation, RadiationMode
from .fit_data import OTHER_DAMPING, FitData, up_to
from .free_response import FreeResponse
from .memory import frequency_response, tail
from .passive_residues import Problem, best_residues, passive_residues
from .vector_fitting import common_poles, order, partial_fractions

if TYPE_CHECKING:
    from collections.abc import Callable

    from .fit_data import Hulls
    from .several import SeveralHulls
    from .vector_fitting import Array, ComplexArray

LIMIT = 0.02
MOST_STATES, MOST_STATES_OF_SEVERAL = 24, 32
PASSIVE_TRIALS = 4
# Frequencies of the tail in the fit, over the highest frequency of the data.
TAIL = np.array([1.15, 1.4, 1.8, 2.5, 4.0, 7.0])
# Weights of the tail relative to the last frequency of the data, tried in turn: if no order meets the limits
# with the first, the guessed tail counts less than the data, a hundredth in squares.
TAIL_WEIGHTS = (1.0, 0.1)
# Several hulls have many couplings, whose tails follow no rule.
TAIL_WEIGHTS_OF_SEVERAL = (0.1,)
# Fits whose errors differ by less than this factor count as equal: the one with fewer poles is taken.
ALIKE = 1.5


def fit(
    database: Hulls,
    limit: float = LIMIT,
    most_states: int | None = None,
    highest_rad_s: float | None = None,
    accept: bool = False,
    response_share: float = 1.0,
    progress: Callable[[float], None] | None = None,
) -> Radiation:
    """Fit the memory with the fewest poles that meet a limit.

    Parameters
    ----------
    limit
        Of the error: the largest over frequencies and entries of
        ``min(1, w_c / w) |K_fit - K|_ij / sqrt(peak_i peak_j)``, ``peak_i`` the largest
        ``min(1, w_i / w) |K_ii|``, ``w_i`` the frequency of the largest damping of motion i, ``w_c`` the
        highest ``w_i`` of the motions that are damped. Beyond it K is nearly j w (A - A_inf), and the weight
        turns an error of K into one of A, whose accuracy by panels does not improve with w. Dimensionless,
        the same in any units and for forces and moments. Couplings below a tenth of it count as zero.
    most_states
        The most states for a group of coupled motions; `None`: 24, or 32 of several hulls.
    highest_rad_s
        Leave out frequencies above it: the panels are too large for their waves.
    accept
        Whether to take the best passive fit if none meets the limit; `misfits` gives the motions that miss
        it.
    response_share
        Aim for the error of responses as a share of the limit (`fit_data`), if there are enough poles: less
        than 1 for hulls that resonate with less damping than `fit_data` assumes.
    progress
        Called with the share of the work that is done, from 0 to 1, after each number of poles.

    Returns
    -------
    Radiation
        The fitted memory; its ``fit_error`` is the error of the whole fit.

    Raises
    ------
    HydrodynamicsError
        If no order meets the limit, or fewer than eight frequencies are left.
    """
    database = up_to(database, np.inf if highest_rad_s is None else highest_rad_s)
    data, size = FitData.of(database, limit), len(database.motions)
    modes = [RadiationMode(np.zeros(0, complex), np.zeros((0, size), complex)) for _ in range(size)]
    groups = _groups(data.coupled)
    for done, group in enumerate(groups):

        def report(share: float, done: int = done) -> None:
            if progress:
                progress((done + share) / len(groups))

        limits = (limit, response_share * limit)
        search = _Search.of(data, most_states)
        poles, matrices = _fit_group(data, group, limits, search, accept, report)
        report(1.0)
        for column, motion in enumerate(group):
            residues = np.zeros((len(poles), size), complex)
            residues[:, group] = matrices[:, :, column] * np.sqrt(data.peaks[group] * data.peaks[motion])
            modes[motion] = RadiationMode(poles, residues)
    fitted = evaluate(Radiation(tuple(modes), 0.0), data.omega) / data.scale
    return Radiation(tuple(modes), data.largest(fitted - data.scaled))


def evaluate(radiation: Radiation, omega: Array) -> ComplexArray:
    """K(j omega) of a fitted memory, (frequency, force, motion)."""
    omega = np.atleast_1d(np.asarray(omega, float))
    size = len(radiation.modes)
    found = np.zeros((len(omega), size, size), complex)
    for motion, mode in enumerate(radiation.modes):
        for pole, residue in zip(mode.poles_rad_s, mode.residues, strict=True):
            found[:, :, motion] += residue / (1j * omega[:, None] - pole)
            if pole.imag != 0.0:
                found[:, :, motion] += np.conj(residue) / (1j * omega[:, None] - np.conj(pole))
    return found


@dataclass(frozen=True)
class Misfit:
    """Errors of a motion's fit: K as in `fit`, with couplings; A and B of the diagonal over the largest of
    each; the frequency with the largest error of K; and the other motion if that error is in a coupling.
    """

    motion: str
    memory: float
    added_mass: float
    damping: float
    frequency_rad_s: float
    coupled_with: str = ""


def misfits(
    database: Hulls, radiation: Radiation, limit: float = LIMIT, highest_rad_s: float | None = None
) -> list[Misfit]:
    """The errors of each motion with a memory, in order.

    A of the fit is A_inf + Im K / w: at low w, an error of K that is small relative to its peak is large in
    A, and at high w the reverse holds.
    """
    database = up_to(database, np.inf if highest_rad_s is None else highest_rad_s)
    data, found = FitData.of(database, limit), []
    error = evaluate(radiation, data.omega) - frequency_response(database)
    for motion, name in enumerate(database.motions):
        if not data.coupled[motion, motion]:
            continue
        one = error[:, motion, motion]
        weighted = data.importance[:, None] * np.abs(error[:, motion]) / data.scale[motion]
        at, other = np.unravel_index(weighted.argmax(), weighted.shape)
        largest = [np.abs(values[:, motion, motion]).max() for values in
                   (database.added_mass, database.radiation_damping)]  # fmt: skip
        found.append(Misfit(
            name, float(weighted.max()),
            float(np.abs(one.imag / data.omega).max() / max(largest[0], 1e-300)),
            float(np.abs(one.real).max() / max(largest[1], 1e-300)),
            float(data.omega[at]), database.motions[other] if other != motion else "",
        ))  # fmt: skip
    return found


def response_error(database: SeveralHulls, radiation: Radiation, highest_rad_s: float | None = None) -> float:
    """Largest error of a motion of freely floating hulls in waves, over its peak (`free_response`)."""
    database = up_to(database, np.inf if highest_rad_s is None else highest_rad_s)
    error = evaluate(radiation, database.frequencies_rad_s) - frequency_response(database)
    return FreeResponse.of(database, OTHER_DAMPING).error(error)


def impulse_response(radiation: Radiation, t: Array) -> Array:
    """k(t) = sum of r exp(p t), (time, force, motion), for t >= 0: kg/s2, kg m/s2, kg m2/s2."""
    t = np.atleast_1d(np.asarray(t, float))
    size = len(radiation.modes)
    found = np.zeros((len(t), size, size))
    for motion, mode in enumerate(radiation.modes):
        for pole, residue in zip(mode.poles_rad_s, mode.residues, strict=True):
            twice = 1.0 if pole.imag == 0.0 else 2.0
            found[:, :, motion] += twice * (residue * np.exp(pole * t)[:, None]).real
    return found


def _groups(coupled: Array) -> list[list[int]]:
    """Groups of motions that are coupled, directly or through others; motions without a memory are in no
    group."""
    left, groups = [motion for motion in range(len(coupled)) if coupled[motion, motion]], []
    while left:
        group = [left.pop(0)]
        for motion in group:
            joined = [other for other in left if coupled[motion, other] or coupled[other, motion]]
            group += joined
            left = [other for other in left if other not in joined]
        groups.append(sorted(group))
    return groups


@dataclass(frozen=True)
class _Trial:
    """Poles and residues (pole, force, motion), scaled, with both errors and where the first is largest."""

    poles: ComplexArray
    residues: ComplexArray
    error: float
    response_error: float
    worst: int

    @classmethod
    def of(cls, data: FitData, group: list[int], poles: ComplexArray, residues: ComplexArray) -> _Trial:
        error = _values(poles, residues, data.omega) - data.scaled[:, group][:, :, group]
        by_frequency = data.by_frequency(error)
        return cls(poles, residues, float(by_frequency.max()), data.response_error(error, group),
                   int(by_frequency.argmax()))  # fmt: skip

    @property
    def both(self) -> float:
        return max(self.error, self.response_error)


@dataclass(frozen=True)
class _Search:
    """Numbers of states and weights of the tail that are tried, and whether passivity is verified: for
    several hulls each trial takes seconds, and only every second number is tried."""

    orders: range
    tail_weights: tuple[float, ...]
    verified: bool

    @classmethod
    def of(cls, data: FitData, most_states: int | None) -> _Search:
        several = len(data.motions) > 6
        most = min(most_states or (MOST_STATES_OF_SEVERAL if several else MOST_STATES), len(data.omega))
        if several:
            return cls(range(min(4, most), most + 1, 2), TAIL_WEIGHTS_OF_SEVERAL, True)
        return cls(range(2, most + 1), TAIL_WEIGHTS, False)


def _fit_group(
    data: FitData,
    group: list[int],
    limits: tuple[float, float],
    search: _Search,
    accept: bool,
    report: Callable[[float], None],
) -> tuple[ComplexArray, ComplexArray]:
    """Scaled poles and residues (pole, force, motion) of a group: the fewest poles that meet both limits;
    otherwise, among the fits that meet the limit of K, the one with the smallest error of responses."""
    limit, response_limit = limits
    tried: list[tuple[_Trial, Problem]] = []
    passed: list[_Trial] = []
    for tail_weight in search.tail_weights:
        problem = _problem(data, group, limit, tail_weight, search.verified)
        for states in search.orders:
            report(len(tried) / (len(search.tail_weights) * len(search.orders)))
            poles = common_poles(problem.responses, problem.omega, problem.weights, states)
            trial = _Trial.of(data, group, poles, best_residues(poles, problem))
            tried.append((trial, problem))
            # A fit that misses the limit without passivity also misses it with passivity.
            passive = passive_residues(poles, problem) if trial.error <= limit else None
            if passive is None:
                continue
            found = _Trial.of(data, group, poles, passive)
            if found.error <= limit and found.response_error <= response_limit:
                return found.poles, found.residues
            if found.error <= limit:
                passed.append(found)
        if not len(problem.tail_omega):
            break
    if passed:
        best = _fewest_of_the_best(passed, lambda one: one.response_error)
        return best.poles, best.residues
    if accept:
        tried.sort(key=lambda one: one[0].both)
        passed = _passive(data, group, tried[:PASSIVE_TRIALS])
    if passed:
        best = _fewest_of_the_best(passed, lambda one: one.both)
        return best.poles, best.residues
    best = min((trial for trial, _ in tried), key=lambda one: one.error)
    omega, names = data.omega, ", ".join(data.motions[motion] for motion in group)
    why = "" if best.error > limit else ", of a memory that generates energy; no passive one meets the limit"
    raise HydrodynamicsError(
        f"radiation of {names}",
        f"an error of {best.error:.3g} at {omega[best.worst]:.4g} rad/s with up to {states} poles{why}",
        f"at most {limit:.3g} of the peak; compute more frequencies or a wider range ({len(omega)} from "
        f"{omega[0]:.3g} to {omega[-1]:.3g} rad/s here), remove irregular frequencies with a lid, leave "
        "out those above which the panels are too large (highest_rad_s), or take the best fit as it "
        "is (accept_fit)",
    )


def _passive(data: FitData, group: list[int], tried: list[tuple[_Trial, Problem]]) -> list[_Trial]:
    found = ((one.poles, passive_residues(one.poles, problem)) for one, problem in tried)
    return [_Trial.of(data, group, poles, residues) for poles, residues in found if residues is not None]


def _fewest_of_the_best(trials: list[_Trial], error: Callable[[_Trial], float]) -> _Trial:
    least = min(error(one) for one in trials)
    return min((one for one in trials if error(one) <= ALIKE * least), key=lambda one: order(one.poles))


def _values(poles: ComplexArray, residues: ComplexArray, omega: Array) -> ComplexArray:
    unknowns = np.concatenate([
        np.stack([residue.real] if pole.imag == 0.0 else [residue.real, residue.imag])
        for pole, residue in zip(poles, residues, strict=True)
    ])  # fmt: skip
    return np.tensordot(partial_fractions(poles, 1j * omega), unknowns, axes=1)


def _problem(
    data: FitData, group: list[int], limit: float, tail_weight: float, verified: bool = False
) -> Problem:
    """Each frequency interval is weighted by its width, at least a third of the mean; each frequency also by
    the effect of an error there on responses.

    If damping has not fallen to the limit at the last frequency, its asymptote is fitted beyond it, with at
    most the weight of the last frequency.
    """
    omega, n = data.omega, len(group)
    entries = [(i, j) for i in range(n) for j in range(i, n) if data.coupled[group[i], group[j]]]
    responses = np.stack([data.scaled[:, group[i], group[j]] for i, j in entries], axis=1)
    width = np.gradient(omega)
    counts = data.counts(group)
    weights = counts * np.sqrt(np.maximum(width / width.mean(), 1.0 / 3.0))
    decayed = np.abs(responses[-1].real).max() <= limit
    beyond = omega[-1] * (TAIL[:0] if decayed else TAIL)
    damping = np.array([tail(omega, one, beyond) for one in responses.real.T]).T
    faint = tail_weight * counts[-1] * omega[-1] / beyond
    return Problem(n, tuple(entries), omega, responses, weights, beyond, damping, faint, verified)
