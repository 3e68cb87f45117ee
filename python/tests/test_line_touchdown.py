"""Lines with mass at rest that lie partly on the ground: elastic catenaries on soft and rigid ground."""

from __future__ import annotations

import itertools
from dataclasses import dataclass, replace
from functools import cache
from typing import Any

import kingpost
import numpy as np
import pytest
from kingpost.verify import lines
from kingpost.verify.models import G, value
from line_cases import DRY, of_two_ends, section
from scipy.integrate import fixed_quad
from scipy.optimize import root

EA_N, DENSITY = 3.27e9, 1025.0
RIGID_N_PER_M3 = 3e12
"""Stiffness at which the ground changes the tension by 4e-11."""


@dataclass(frozen=True)
class Lying:
    """A chain of 685 kg/m from its upper end down to an anchor on the ground, without friction."""

    length_m: float
    across_m: float
    up_m: float
    diameter_m: float

    @property
    def weight(self) -> float:
        """In the water, N/m."""
        return (685.0 - DENSITY * np.pi / 4 * self.diameter_m**2) * G

    def tension(self, parts: list[tuple[float, int]], ground: float) -> float:
        """N, by sections of these lengths and numbers of elements, on this ground, N/m^3."""
        sections = [
            section(*part, mass_kg_per_m=685.0, diameter_m=self.diameter_m, axial_stiffness_N=EA_N)
            for part in parts
        ]
        upper, anchor = [self.across_m, 0, -10], [0, 0, -10 - self.up_m]
        seabed = {"depth_m": 10 + self.up_m, "friction": 0.0, "stiffness_N_per_m3": ground}
        sea = {"depth_m": 10 + self.up_m, "density_kg_m3": DENSITY}
        line = of_two_ends(upper, anchor, sections[0], sea, sections=sections, seabed=seabed)
        return value(kingpost.Simulation(line), "line_tension", "line")


DEEP = Lying(850.0, 779.6, 186.0, 0.333)
SHALLOW = Lying(430.0, 400.0, 60.0, DRY)


@cache
def on_springs(line: Lying, stiffness: float) -> tuple[float, float, float]:
    """Tension at the upper end and horizontal force, N, and the length above the ground, m, on a ground of
    this many N per metre of line and of depth.

    With the unstretched length s, T dT/ds = V dV/ds and dV/ds = w + k min(z, 0), so that
    T + T^2 / 2EA - w z - k min(z, 0)^2 / 2 is constant. Where the line lies, V = 0 and z = -w / k. At the
    touchdown and at the anchor it rises to z = 0; there its horizontal extent is that of a straight line less
    an integral over z."""
    weight = line.weight

    def stretched(pull: float, height: Any) -> tuple[Any, Any]:
        """Tension and its vertical part at a height above the resting line, on the ground."""
        stored = pull + pull**2 / (2 * EA_N) + stiffness * height**2 / 2
        tension = EA_N * (np.sqrt(1 + 2 * stored / EA_N) - 1)
        # Without the cancellation of T - H.
        more = stiffness * height**2 / 2 / (1 + (tension + pull) / (2 * EA_N))
        return tension, np.sqrt(more * (tension + pull))

    def shorter(height: np.ndarray, pull: float) -> np.ndarray:
        tension, lift = stretched(pull, height)
        return (pull - tension) / ((1 + tension / EA_N) * lift)

    def misses(unknown: np.ndarray) -> tuple[float, float, float]:
        pull, hangs = unknown * (weight, 1.0)
        tension, lift = stretched(pull, weight / stiffness)
        upper = np.hypot(pull, lift + weight * hangs)
        turns = np.arcsinh((lift + weight * hangs) / pull) - np.arcsinh(lift / pull)
        lies = (1 + pull / EA_N) * (line.length_m - hangs)
        rises = fixed_quad(shorter, 0, weight / stiffness, args=(pull,), n=20)[0]
        across = pull / weight * turns + pull * hangs / EA_N + lies + 2 * rises
        up = (upper - tension) / weight + (upper**2 - tension**2) / (2 * EA_N * weight)
        return across - line.across_m, up - line.up_m, upper

    found = root(lambda unknown: misses(unknown)[:2], [line.across_m / 3, line.length_m / 2], tol=1e-14).x
    return misses(found)[2], found[0] * weight, found[1]


def graded(total_m: float, first_m: float, growth: float, longest_m: float) -> list[float]:
    """Lengths of elements that grow from the first one by a factor, up to the longest, and fill the total."""
    lengths = [first_m]
    while sum(lengths) < total_m:
        lengths.append(min(lengths[-1] * growth, longest_m))
    return [length * total_m / sum(lengths) for length in lengths]


def test_a_soft_ground_is_a_rigid_one_that_is_lower_by_half_of_the_penetration():
    """Source: both closed forms. T + T^2 / 2EA - w z is that of a rigid ground at z = -w / 2k; the lying line
    is shorter by the integral of V^2 / 2H^2, of the order of k^(-3/2)."""
    rigid = float(np.hypot(*lines.catenary(lines.kept()["chain"], True)))
    assert on_springs(DEEP, RIGID_N_PER_M3 * DEEP.diameter_m)[0] == pytest.approx(rigid, rel=1e-10)
    changes = []
    for ground in (3e6, 3e7, 3e8):
        stiffness = ground * DEEP.diameter_m
        lower = replace(DEEP, up_m=DEEP.up_m + DEEP.weight / (2 * stiffness))
        on_bottom = on_springs(lower, RIGID_N_PER_M3 * DEEP.diameter_m)[0]
        changes.append(abs(on_bottom / on_springs(DEEP, stiffness)[0] - 1))
    # 10^1.5 each; 4e-11 of the ground that stands for the rigid one.
    assert changes[0] == pytest.approx(1.86e-7, rel=0.01)
    assert all(soft / stiff > 28 for soft, stiff in itertools.pairwise(np.array(changes) + 4e-11))


def test_a_section_that_ends_at_the_touchdown_gives_1e_9_of_the_catenary_by_two_meshes():
    """Source: Irvine, Cable Structures, 1981, ch. 1; Richardson's extrapolation of fourth order. On each side
    of the touchdown the line is smooth."""
    pull, lift = lines.catenary(lines.kept()["chain"], True)
    hangs = lift / DEEP.weight
    exact = float(np.hypot(pull, lift))
    tensions = [
        DEEP.tension([(hangs, elements), (DEEP.length_m - hangs, 2)], RIGID_N_PER_M3)
        for elements in (10, 20, 40)
    ]
    errors = [tension / exact - 1 for tension in tensions]
    assert all(fine == pytest.approx(coarse / 16, rel=0.05) for coarse, fine in itertools.pairwise(errors))
    # The next term, and 4e-11 of the ground: 1.3e-10.
    assert all(abs((16 * b - a) / 15) < 1e-9 for a, b in itertools.pairwise(errors))


def test_elements_shorter_than_the_bend_on_a_soft_ground_give_1e_9_of_its_catenary():
    """Source: the closed form. Near touchdown and anchor the line bends within sqrt(H / k), 1.2 m."""
    stiffness = 3e6 * DEEP.diameter_m
    exact, pull, hangs = on_springs(DEEP, stiffness)
    bend = float(np.sqrt(pull / stiffness))
    errors = []
    for finer in (2, 4, 8):
        growth, shortest = 1 + 0.8 / finer, bend / finer
        hanging = graded(hangs, shortest, growth, 40 / finer)
        lying = graded((DEEP.length_m - hangs) / 2, shortest, growth, 60 / finer)
        parts = [(length, 1) for length in (*hanging[::-1], *lying, *lying[::-1])]
        errors.append(abs(DEEP.tension(parts, 3e6) / exact - 1))
    # 62, 118 and 229 elements: 1.1e-8, 2e-9, 2e-10. Their growth and length change together, so that the
    # order is between third and fourth; terms of both signs are in the first error.
    assert all(fine < coarse / 5 for coarse, fine in itertools.pairwise(errors)), errors
    assert errors[-1] < 1e-9


def test_a_line_on_an_elastic_ground_converges_with_second_order_over_all_places_of_its_touchdown():
    """Source: the closed form.

    The support has a kink where the line leaves the ground, somewhere in an element; so single meshes do not
    extrapolate. The worst of ten meshes does, and their mean has hardly an error."""
    stiffness = 2e4
    exact = on_springs(SHALLOW, stiffness)[0]
    worst, mean = [], []
    for first in (40, 80, 160):
        errors = [
            SHALLOW.tension([(SHALLOW.length_m, elements)], stiffness / SHALLOW.diameter_m) / exact - 1
            for elements in range(first, first + 20, 2)
        ]
        worst.append(float(np.abs(errors).max()))
        mean.append(abs(float(np.mean(errors))))
    # (h / 86 m)^2 / 6 with the length of the hanging part, by Simpson's rule: 2.6e-3 with 40 elements. Twice
    # as many have a quarter.
    assert worst[0] < 3e-3
    assert all(fine < coarse / 3.5 for coarse, fine in itertools.pairwise(worst)), worst
    # Ten places of the touchdown: a hundredth of the worst.
    assert all(average < most / 50 for average, most in zip(mean, worst, strict=True)), (mean, worst)
