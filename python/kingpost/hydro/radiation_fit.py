"""The memory of the water as a state-space model: rational functions fitted to K(j omega).

K(j w) = B(w) + j w (A(w) - A_inf), in the sense of exp(+st) (`memory` derives it), is fitted by
K_ij(s) = sum over poles p of r_ij / (s - p), conjugates included. The model has the properties of
the water's memory (`passive_residues`): stable, K(0) = 0, of relative degree one, symmetric, and
positive real as a matrix at every frequency from 0 to infinity, not only at the data's.

Motions that are coupled (surge, heave and pitch of a hull with two equal sides) have their poles in common
(`vector_fitting`): only then can K be symmetric, and where it is not, K + K^H is indefinite at both
ends of the frequencies. Couplings that the data do not have stay exactly zero.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from ..errors import HydrodynamicsError
from .database import Radiation, RadiationMode
from .dataset import MOTIONS
from .memory import frequency_response, tail
from .passive_residues import Problem, best_residues, passive_residues
from .vector_fitting import common_poles, partial_fractions

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from .database import Database
    from .vector_fitting import Array, ComplexArray

LIMIT = 0.02
MOST_STATES = 24
FEWEST_FREQUENCIES = 8
PASSIVE_TRIALS = 4
# Frequencies of the tail that the fit sees, over the highest of the data.
TAIL = np.array([1.15, 1.4, 1.8, 2.5, 4.0, 7.0])
# Weights of the tail, tried in turn: where no order meets the limit with the first, the guess gives way to
# the data, and each frequency of it counts a hundredth of one of theirs, in squares.
TAIL_WEIGHTS = (1.0, 0.1)
# A motion is measured by its peak of K, or by this share of rho V l^2 sqrt(g / l) where that is more:
# the yaw of a body of revolution is noise, and is not fitted as if it were large.
LEAST_PEAK = 1e-3


def fit(
    database: Database,
    limit: float = LIMIT,
    most_states: int = MOST_STATES,
    highest_rad_s: float | None = None,
    accept: bool = False,
) -> Radiation:
    """Fit the memory with the fewest poles that meet a limit.

    Parameters
    ----------
    limit
        Of the error: the largest over frequencies and entries of
        ``min(1, w_c / w) |K_fit - K|_ij / sqrt(peak_i peak_j)``, ``peak_i`` the largest ``|K_ii|``, ``w_c``
        the frequency of the largest damping. Beyond it K is nearly j w (A - A_inf), and the weight makes of
        an error of K one of A, which panels know no better with w. Dimensionless, the same in any
        units and for forces and moments. Couplings below a tenth of it count as zero.
    most_states
        For a group of coupled motions.
    highest_rad_s
        Frequencies above it are left out: where the panels are too large for the waves.
    accept
        Whether the best passive fit is taken where none meets the limit; `misfits` says which
        motions miss it.

    Returns
    -------
    Radiation
        Its ``fit_error`` is the error of the whole.

    Raises
    ------
    HydrodynamicsError
        When no order meets the limit, or fewer than eight frequencies are left.
    """
    database = _up_to(database, np.inf if highest_rad_s is None else highest_rad_s)
    data = _Data.of(database, limit)
    modes = [RadiationMode(np.zeros(0, complex), np.zeros((0, 6), complex)) for _ in MOTIONS]
    for group in _groups(data.coupled):
        poles, matrices = _fit_group(data, group, limit, most_states, accept)
        for column, motion in enumerate(group):
            residues = np.zeros((len(poles), 6), complex)
            residues[:, group] = matrices[:, :, column] * np.sqrt(data.peaks[group] * data.peaks[motion])
            modes[motion] = RadiationMode(poles, residues)
    fitted = evaluate(Radiation(tuple(modes), 0.0), data.omega) / data.scale
    return Radiation(tuple(modes), data.largest(fitted - data.scaled))


def evaluate(radiation: Radiation, omega: Array) -> ComplexArray:
    """K(j omega) of a fitted memory, (frequency, force, motion)."""
    omega = np.atleast_1d(np.asarray(omega, float))
    found = np.zeros((len(omega), 6, 6), complex)
    for motion, mode in enumerate(radiation.modes):
        for pole, residue in zip(mode.poles_rad_s, mode.residues, strict=True):
            found[:, :, motion] += residue / (1j * omega[:, None] - pole)
            if pole.imag != 0.0:
                found[:, :, motion] += np.conj(residue) / (1j * omega[:, None] - np.conj(pole))
    return found


@dataclass(frozen=True)
class Misfit:
    """How far a motion's fit is from its data: K as `fit` measures it, A and B over the largest of each, all
    of the diagonal, and the frequency at which K misses most."""

    motion: str
    memory: float
    added_mass: float
    damping: float
    frequency_rad_s: float


def misfits(
    database: Database, radiation: Radiation, limit: float = LIMIT, highest_rad_s: float | None = None
) -> list[Misfit]:
    """Of each motion with a memory, in order.

    A of the fit is A_inf + Im K / w: the error of K that is small beside the peak of K is large in A where w
    is small, and the other way round.
    """
    database = _up_to(database, np.inf if highest_rad_s is None else highest_rad_s)
    data, found = _Data.of(database, limit), []
    error = evaluate(radiation, data.omega) - frequency_response(database)
    for motion, name in enumerate(MOTIONS):
        if not data.coupled[motion, motion]:
            continue
        one = error[:, motion, motion]
        weighted = data.importance * np.abs(one) / data.peaks[motion]
        largest = [np.abs(values[:, motion, motion]).max() for values in
                   (database.added_mass, database.radiation_damping)]  # fmt: skip
        found.append(Misfit(
            name, float(weighted.max()),
            float(np.abs(one.imag / data.omega).max() / max(largest[0], 1e-300)),
            float(np.abs(one.real).max() / max(largest[1], 1e-300)),
            float(data.omega[weighted.argmax()]),
        ))  # fmt: skip
    return found


def impulse_response(radiation: Radiation, t: Array) -> Array:
    """k(t) = sum of r exp(p t), (time, force, motion), for t >= 0: kg/s2, kg m/s2, kg m2/s2."""
    t = np.atleast_1d(np.asarray(t, float))
    found = np.zeros((len(t), 6, 6))
    for motion, mode in enumerate(radiation.modes):
        for pole, residue in zip(mode.poles_rad_s, mode.residues, strict=True):
            twice = 1.0 if pole.imag == 0.0 else 2.0
            found[:, :, motion] += twice * (residue * np.exp(pole * t)[:, None]).real
    return found


@dataclass(frozen=True)
class _Data:
    """K of the data, its two halves averaged: panels keep K_ij = K_ji only nearly (`checks`).

    Attributes
    ----------
    peaks
        (motion): see `LEAST_PEAK`.
    scaled
        K_ij / sqrt(peak_i peak_j).
    coupled
        (force, motion): where there is more than a tenth of the limit.
    importance
        (frequency): min(1, w_c / w) of `fit`.
    """

    omega: Array
    peaks: Array
    scaled: ComplexArray
    coupled: NDArray[np.bool_]
    importance: Array

    @classmethod
    def of(cls, database: Database, limit: float) -> _Data:
        omega, response = database.frequencies_rad_s, frequency_response(database)
        response = 0.5 * (response + response.transpose(0, 2, 1))
        diagonal = np.einsum("nii->ni", response)
        peaks = np.maximum(np.abs(diagonal).max(axis=0), LEAST_PEAK * _natural_damping(database))
        scaled = response / np.sqrt(np.outer(peaks, peaks))
        # Motions whose damping is noise have no say in where the largest damping is.
        damped = diagonal.real.max(axis=0) > 0.1 * peaks
        centre = omega[diagonal.real.argmax(axis=0)][damped].max(initial=omega[0])
        coupled = np.abs(scaled).max(axis=0) > 0.1 * limit
        return cls(omega, peaks, scaled, coupled, np.minimum(1.0, centre / omega))

    @property
    def scale(self) -> Array:
        """sqrt(peak_i peak_j)."""
        return np.sqrt(np.outer(self.peaks, self.peaks))

    def by_frequency(self, error: ComplexArray) -> Array:
        """The largest weighted error of any entry, (frequency)."""
        return self.importance * np.abs(error).max(axis=(1, 2))

    def largest(self, error: ComplexArray) -> float:
        """The largest weighted error of any entry at any frequency."""
        return float(self.by_frequency(error).max())


def _natural_damping(database: Database) -> Array:
    """rho V l^2 sqrt(g / V^(1/3)) of each motion, l half the beam or the length of rotations, else 1."""
    hull, water = database.hull, database.water
    lever = np.array([1.0, 1.0, 1.0, 0.5 * hull.beam_m, 0.5 * hull.length_m, 0.5 * hull.length_m])
    rate = np.sqrt(water.gravity_m_s2 / hull.volume_m3 ** (1.0 / 3.0))
    return water.density_kg_m3 * hull.volume_m3 * lever**2 * rate


def _up_to(database: Database, highest_rad_s: float) -> Database:
    kept = database.frequencies_rad_s <= highest_rad_s
    if kept.sum() < FEWEST_FREQUENCIES:
        found = f"{kept.sum()} frequencies up to {highest_rad_s:g} rad/s"
        raise HydrodynamicsError("frequencies_rad_s", found, f"at least {FEWEST_FREQUENCIES} for a fit")
    return replace(
        database,
        frequencies_rad_s=database.frequencies_rad_s[kept],
        added_mass=database.added_mass[kept],
        radiation_damping=database.radiation_damping[kept],
    )


def _groups(coupled: Array) -> list[list[int]]:
    """Motions that are coupled, directly or through others; motions without a memory are in none."""
    left, groups = [motion for motion in range(6) if coupled[motion, motion]], []
    while left:
        group = [left.pop(0)]
        for motion in group:
            joined = [other for other in left if coupled[motion, other] or coupled[other, motion]]
            group += joined
            left = [other for other in left if other not in joined]
        groups.append(sorted(group))
    return groups


def _fit_group(
    data: _Data, group: list[int], limit: float, most_states: int, accept: bool
) -> tuple[ComplexArray, ComplexArray]:
    """Poles and residues (pole, force, motion) of a group, scaled; the fewest that meet the limit."""
    target = data.scaled[:, group][:, :, group]
    tried: list[tuple[float, int, ComplexArray]] = []
    for tail_weight in TAIL_WEIGHTS:
        problem = _problem(data, group, limit, tail_weight)
        for states in range(2, min(most_states, len(data.omega)) + 1):
            poles = common_poles(problem.responses, problem.omega, problem.weights, states)
            residues = best_residues(poles, problem)
            # What misses the limit without passivity misses it with it.
            if data.largest(_values(poles, residues, data.omega) - target) <= limit:
                passive = passive_residues(poles, problem)
                if passive is None:
                    continue
                residues = passive
                if data.largest(_values(poles, passive, data.omega) - target) <= limit:
                    return poles, passive
            error = _values(poles, residues, data.omega) - target
            tried.append((data.largest(error), int(data.by_frequency(error).argmax()), poles))
        if not len(problem.tail_omega):
            break
    tried.sort(key=lambda one: one[0])
    found = _best_passive(data, problem, target, tried) if accept else None
    if found is not None:
        return found
    least, worst = tried[0][:2] if tried else (np.inf, 0)
    omega, names = data.omega, ", ".join(MOTIONS[motion] for motion in group)
    raise HydrodynamicsError(
        f"radiation of {names}",
        f"an error of {least:.3g} at {omega[worst]:.4g} rad/s with up to {states} poles",
        f"at most {limit:.3g} of the peak; compute more frequencies or a wider range ({len(omega)} from "
        f"{omega[0]:.3g} to {omega[-1]:.3g} rad/s here), remove irregular frequencies with a lid, leave "
        "out those above which the panels are too large (highest_rad_s), or take the best fit as it "
        "is (accept_fit)",
    )


def _best_passive(
    data: _Data, problem: Problem, target: ComplexArray, tried: list[tuple[float, int, ComplexArray]]
) -> tuple[ComplexArray, ComplexArray] | None:
    """The passive fit of least error with the poles that came nearest without passivity."""
    best, least = None, np.inf
    for _, _, poles in tried[:PASSIVE_TRIALS]:
        passive = passive_residues(poles, problem)
        if passive is None:
            continue
        error = data.largest(_values(poles, passive, data.omega) - target)
        if error < least:
            best, least = (poles, passive), error
    return best


def _values(poles: ComplexArray, residues: ComplexArray, omega: Array) -> ComplexArray:
    unknowns = np.concatenate([
        np.stack([residue.real] if pole.imag == 0.0 else [residue.real, residue.imag])
        for pole, residue in zip(poles, residues, strict=True)
    ])  # fmt: skip
    return np.tensordot(partial_fractions(poles, 1j * omega), unknowns, axes=1)


def _problem(data: _Data, group: list[int], limit: float, tail_weight: float) -> Problem:
    """Each interval of frequencies counts by its width, and none by less than a third of the mean.

    Where damping has not fallen to the limit at the last frequency, its asymptote is asked for beyond.
    """
    omega, n = data.omega, len(group)
    entries = [(i, j) for i in range(n) for j in range(i, n) if data.coupled[group[i], group[j]]]
    responses = np.stack([data.scaled[:, group[i], group[j]] for i, j in entries], axis=1)
    width = np.gradient(omega)
    weights = data.importance * np.sqrt(np.maximum(width / width.mean(), 1.0 / 3.0))
    decayed = np.abs(responses[-1].real).max() <= limit
    beyond = omega[-1] * (TAIL[:0] if decayed else TAIL)
    damping = np.array([tail(omega, one, beyond) for one in responses.real.T]).T
    faint = np.full(len(beyond), tail_weight)
    return Problem(n, tuple(entries), omega, responses, weights, beyond, damping, faint)
