"""Measured roll of KVLCC2 and of Ikeda's cylinders, and hulls for the tests of roll damping."""

from __future__ import annotations

import csv
import math
from pathlib import Path

import numpy as np
from kingpost.hydro.database import Water
from kingpost.hydro.meshes import HullMeshes
from kingpost.hydro.panels import of_patches
from kingpost.hydro.surface import particulars
from kingpost.roll_damping import DecayRecord, Sections
from kingpost.roll_damping.lewis import lewis_forms

FOLDER = Path(__file__).with_name("roll_damping")
SCALE = 68.0
# Full scale, from model_test_parameters.csv of doi:10.17632/2stvkyngj9.1; the water is fresh.
KG_M, GM_M, GYRATION_M, VOLUME_M3, DENSITY_KG_M3, VISCOSITY_M2_S = 18.6, 5.73, 23.2, 312653.0, 1000.0, 1.14e-6
GRAVITY_M_S2 = 9.81
# "Prediction of roll motion using fully nonlinear potential flow and Ikeda's method" (Alexandersson,
# Kjellberg et al., 2021), coefficients from the model tests: omega0, B1, B2, B3 of the model at 1:68 by run.
PUBLISHED = {
    21337: (2.461405663797153, 2.960431148229692, -6.520487128705247, 43.7753590783464),
    21338: (2.461149414341689, 2.879736279200558, -5.874151219904037, 41.50366418695269),
}
# At 15.5 knots, run 21340 of the same table.
PUBLISHED_AT_SPEED = (2.4675051791344322, 7.523313711481077, 7.0280627607638, 0.3897887036233833)
SPEED_M_S = 15.5 * 1852 / 3600 / SCALE**0.5


def kvlcc2_sections() -> Sections:
    """Sections of the model at 1:68."""
    return Sections.read(FOLDER / "kvlcc2_sections.csv").scaled(1 / SCALE)


def kvlcc2_decay(run: int) -> DecayRecord:
    return DecayRecord.read(FOLDER / f"kvlcc2_decay_{run}.csv")


def ikeda_cylinders() -> list[dict[str, float | str]]:
    """Measured eddies of two-dimensional cylinders, a row for each curve."""
    lines = (FOLDER / "ikeda_cylinders.csv").read_text(encoding="utf-8").splitlines()
    rows = csv.DictReader(line for line in lines if not line.startswith("#"))
    return [{k: v if k == "section" else float(v) for k, v in row.items()} for row in rows]


def lewis_hull(sections: Sections, stations: int, girth: int) -> HullMeshes:
    """Wetted panels of a hull whose sections are Lewis forms of given sections, water plane at z = 0."""
    ends = sections.x_m[[0, -1]]
    x = np.linspace(*ends, stations)
    at = sections.at(x)
    forms = lewis_forms(at.beam_m, at.draught_m, at.area_coefficient)
    psi = np.linspace(0, math.pi / 2, girth)[:, None]
    y, z = forms.points(psi)
    z[-1] = 0.0
    shell = np.stack([np.broadcast_to(x, y.shape), y, z], axis=-1).transpose(1, 0, 2)
    caps = [np.stack([shell[end] * [1, part, 1] for part in (1.0, 0.5, 0.0)]) for end in (0, -1)]
    inside = np.array([x.mean(), 0.0, -0.3 * float(at.draught_m.max())])
    panels = of_patches([shell, *caps], inside)
    surface = panels.surface
    both = surface.joined(surface.mirrored(1))
    return HullMeshes("sections as Lewis forms", (1,), panels, particulars(both), None, "wetted panels only")


def fresh_water() -> Water:
    return Water(DENSITY_KG_M3, GRAVITY_M_S2)


def box_sections(length_m=100.0, beam_m=20.0, draught_m=8.0, area_coefficient=0.98, stations=11) -> Sections:
    ones = np.ones(stations)
    return Sections.of_table(
        {
            "x_m": np.linspace(-length_m / 2, length_m / 2, stations),
            "beam_m": beam_m * ones,
            "draught_m": draught_m * ones,
            "area_coefficient": area_coefficient * ones,
        }
    )
