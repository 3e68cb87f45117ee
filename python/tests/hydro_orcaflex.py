"""A writer of OrcaFlex's text data file from one database, in any of its conventions.

The vessel's axes have their origin at `AXES` from the database's; OrcaFlex writes numbers as 30.8e3.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from decimal import Decimal
from pathlib import Path

import numpy as np
from hydro_writers import GRAVITY_CENTRE, About, database
from kingpost.hydro.database import Database, Water

AXES = np.array([-3.0, 0.0, 1.5])
"""The origin of the vessel's axes, from the database's origin: 3 m aft of it, 1.5 m above the water."""
MATRICES = np.array([1.0, 0.5, -2.0])
FORCES = np.array([0.0, 0.0, -0.7])
SIGNS = {"SurgePositive": ("forward", "aft"), "SwayPositive": ("port", "starboard"),
         "HeavePositive": ("up", "down"), "RollPositiveStarboard": ("down", "up"),
         "PitchPositiveBow": ("down", "up"), "YawPositiveBow": ("port", "starboard")}  # fmt: skip
PERIOD_PART = {"crest": 0.0, "zero down-crossing": 0.25, "trough": 0.5, "zero up-crossing": 0.75}
"""Share of a period by which each phase reference passes a point after the crest."""


@dataclass(frozen=True)
class Form:
    """The conventions of a vessel type."""

    waves: str = "period (s)"
    phases: str = "lags"
    units: str = "degrees"
    after: str = "crest"
    turned: tuple[str, ...] = ()
    """Motions of `SIGNS` with the opposite positive direction."""
    symmetry: str = "None"
    degrees: tuple[float, ...] = (0.0, 90.0, 180.0, 270.0)
    phase_origin: tuple[float, float, float] | None = None
    """From the database's origin; `None` writes ~, which stands for the load RAOs' origin."""
    mass: float = 1.0
    """Mass over the displaced mass."""
    weight: bool = True
    others: dict[str, str] = field(default_factory=dict)
    """Replacement lines of the vessel type or its draught, by their key."""


def base() -> Database:
    """The writers' database in OrcaFlex's gravity; port is as starboard, ahead is not as astern."""
    return replace(database(), water=Water(1000.0, 9.80665, None))


def alike_fore_and_aft() -> Database:
    """The same with forces that mirror in x = 0 too, and its waterplane's centre there."""
    found = base()
    hull = replace(found.hull, waterplane=replace(found.hull.waterplane, first_moments_m3=np.zeros(2)))
    excitation = found.excitation.copy()
    excitation[:, :, 4] += 9810.0 * 24.0
    excitation[:, :, 5] = 0.0
    return replace(found, hull=hull, froude_krylov=0.7 * excitation, diffraction=0.3 * excitation)


def number(x: float) -> str:
    """As OrcaFlex: exponents in steps of three, without their plus.

    >>> number(30835.9), number(0.5), number(float("inf"))
    ('30.8359e3', '0.5', 'Infinity')
    """
    if not np.isfinite(x):
        return "Infinity"
    exponent = 3 * int(np.floor(np.log10(abs(x)) / 3.0)) if x else 0
    return (
        repr(float(x))
        if exponent in (0, -3)
        else f"{float(Decimal(repr(float(x))).scaleb(-exponent))!r}e{exponent}"
    )


def written(path: Path, of: Database, *forms: Form, depth: float = 100.0) -> Path:
    """A file of one vessel type for each form, named Type 1 and so on."""
    head = f"""%YAML 1.1
# Type: Model
# Program: OrcaFlex 11.4a
---
General:
  # Units
  UnitsSystem: SI
  StageDuration:
    - 8
    - 16
Environment:
  VerticalDensityVariation: Constant
  Density: {number(of.water.density_kg_m3 / 1e3)}
  WaterDepth: {number(depth)}
VesselTypes:
"""
    types = [_vessel_type(f"Type {n}", of, form) for n, form in enumerate(forms, 1)]
    path.write_text(head + "".join(types), encoding="utf-8-sig")
    return path


def _vessel_type(name: str, of: Database, form: Form) -> str:
    fields = {"Name": name, "Length": "~", "RAOResponseUnits": "degrees", "RAOWaveUnit": "amplitude",
              "WavesReferredToBy": form.waves, "RAOPhaseConvention": form.phases,
              "RAOPhaseUnitsConvention": form.units, "RAOPhaseRelativeToConvention": form.after,
              **{key: ways[key in form.turned] for key, ways in SIGNS.items()},
              "Symmetry": form.symmetry}  # fmt: skip
    fields.update({key: value for key, value in form.others.items() if key in fields})
    lines = [f"    {key}: {value}" for key, value in fields.items()]
    lines[0] = "  - " + lines[0].strip()
    return "\n".join([*lines, "    Draughts:", *_draught(of, form)]) + "\n"


def _draught(of: Database, form: Form) -> list[str]:
    hull, rho = of.hull, of.water.density_kg_m3
    point = (MATRICES - AXES)[None]
    fields = {
        "Name": "Draught1",
        "Mass": number(form.mass * rho * hull.volume_m3 / 1e3),
        "CentreOfMass": _list(GRAVITY_CENTRE - AXES),
        "AMDMethod": "Frequency dependent",
        "ReferenceOrigin": _list(point[0]),
        "ReferenceOriginDatumPosition": _list([MATRICES[2], 0.0, 0.0]),
        "HydrostaticStiffnessMethod": "Displacement",
        "DisplacedVolume": number(hull.volume_m3),
        "CentreOfBuoyancy": _list(hull.centre_of_buoyancy_m - AXES),
    }
    fields.update(
        {key: value for key, value in form.others.items() if key in fields or key.startswith("Oth")}
    )
    lines = [f"        {key}: {value}" for key, value in fields.items()]
    lines[0] = "      - " + lines[0].strip()
    return [*lines, *_matrices(of, form), *_forces(of, form)]


def _signs(form: Form) -> np.ndarray:
    return np.array([-1.0 if key in form.turned else 1.0 for key in SIGNS])


def _referred(form: Form, omega: np.ndarray) -> np.ndarray:
    with np.errstate(divide="ignore"):
        return {"period (s)": 2.0 * np.pi / omega, "frequency (rad/s)": omega,
                "frequency (Hz)": omega / (2.0 * np.pi)}[form.waves]  # fmt: skip


def _matrices(of: Database, form: Form) -> list[str]:
    about, signs = About(of, MATRICES), np.outer(_signs(form), _signs(form)) / 1e3
    names = ("X", "Y", "Z", "Rx", "Ry", "Rz")
    restoring = (about.restoring(GRAVITY_CENTRE if form.weight else None) * signs)[2:5, 2:5]
    lines = ["        HydrostaticStiffnessz, HydrostaticStiffnessRx, HydrostaticStiffnessRy:",
             *_rows(10, restoring), "        FrequencyDependentAddedMassAndDamping:"]  # fmt: skip
    omega = np.append(np.inf, of.frequencies_rad_s)
    added_mass = np.concatenate([of.added_mass_infinite[None], of.added_mass])
    damping = np.concatenate([np.zeros((1, 6, 6)), of.radiation_damping])
    # OrcaFlex lists periods from the shortest: of frequencies the first is infinite too.
    for k, referred in enumerate(_referred(form, omega)):
        lines.append(f"          - AMDPeriodOrFrequency: {number(referred)}")
        for name, matrices in (("AddedMassMatrix", added_mass), ("Damping", damping)):
            lines.append("            " + ", ".join(name + each for each in names) + ":")
            lines += _rows(14, about.matrix(matrices)[k] * signs)
    return lines


def _forces(of: Database, form: Form) -> list[str]:
    names = ("Surge", "Sway", "Heave", "Roll", "Pitch", "Yaw")
    key = ", ".join(["RAOPeriodOrFrequency", *(f"RAO{name}{part}" for name in names
                                               for part in ("Amp", "Phase"))])  # fmt: skip
    point = form.phase_origin
    phase_origin = "[~, ~, ~]" if point is None else _list(np.array(point) - AXES)
    lines = ["        LoadRAOs:", f"          RAOOrigin: {_list(FORCES - AXES)}",
             f"          PhaseOrigin: {phase_origin}", "          RAOs:"]  # fmt: skip
    forces = About(of, FORCES).force(of.excitation) / 1e3
    every = np.degrees(of.wave_directions_rad)
    for degrees in form.degrees:
        at = forces[:, int(np.argmin(np.abs(every - degrees % 360.0)))]
        if point is not None:
            # The crest reaches a point that is r ahead later, by k r of phase: so much less does a force lag.
            ahead = point[0] * np.cos(np.radians(degrees)) + point[1] * np.sin(np.radians(degrees))
            at = at * np.exp(-1j * of.frequencies_rad_s**2 / of.water.gravity_m_s2 * ahead)[:, None]
        rows = np.zeros((len(of.frequencies_rad_s), 13))
        rows[:, 0] = _referred(form, of.frequencies_rad_s)
        rows[:, 1::2] = np.abs(at)
        # |X| cos(w t - arg X): arg X is the lag behind the crest.
        lag = np.angle(at * _signs(form)) - 2.0 * np.pi * PERIOD_PART[form.after]
        lag = np.mod(lag if form.phases == "lags" else -lag, 2.0 * np.pi)
        rows[:, 2::2] = np.degrees(lag) if form.units == "degrees" else lag
        lines += [f"            - RAODirection: {number(degrees)}", f"              {key}:"]
        lines += _rows(16, rows)
    return lines


def _list(values) -> str:
    return "[" + ", ".join(number(float(x)) for x in values) + "]"


def _rows(indent: int, rows: np.ndarray) -> list[str]:
    return [f"{' ' * indent}- {_list(row)}" for row in rows]
