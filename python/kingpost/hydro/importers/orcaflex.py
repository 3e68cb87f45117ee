"""Vessel types of OrcaFlex's text data file .yml, which can also hold OrcaWave's results.

A vessel type states the conventions of its numbers: period or frequency, phases that lag or lead, in degrees
or radians, behind crest, trough or a zero crossing, the positive direction of each motion, and symmetry; the
positive directions also apply to stiffness, added mass and damping (Orcina's help, "Vessel types:
Conventions"). Wave directions are those that waves travel towards, counted from the bow to port. Each draught
has

- `LoadRAOs`: forces of kN/m and moments of kN m/m about `RAOOrigin`, their phases those of the wave at
  `PhaseOrigin`, or at `RAOOrigin` where that is `~`;
- `FrequencyDependentAddedMassAndDamping` and `HydrostaticStiffness` about `ReferenceOrigin`, whose height
  above the water is the first of `ReferenceOriginDatumPosition`: te, kN, m;
- `Mass` and `CentreOfMass`: if this mass equals the displaced mass, its weight is in the stiffness.

An infinite period means frequency 0, and period 0 means infinite frequency. Points are in the vessel's axes.
The
origin here is on the water plane above or below the load RAOs' origin; planes of symmetry go through that.
The sea of the model may differ from that of the coefficients: its depth is not used.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .directions import ENDS
from .foreign import Foreign, Options, reading_error
from .orcaflex_conventions import ENDS_ALONE, GRAVITY_M_S2, Conventions, Place
from .orcaflex_file import Entry, load

if TYPE_CHECKING:
    from numpy.typing import NDArray

# kg of a te, N of a kN.
THOUSAND = 1e3
SAME_FREQUENCY = 1e-4
SAME_MASS = 0.01
MATRIX = ("X", "Y", "Z", "Rx", "Ry", "Rz")
COLUMNS = ["RAOPeriodOrFrequency"] + [
    f"RAO{motion}{part}" for motion in ("Surge", "Sway", "Heave", "Roll", "Pitch", "Yaw")
    for part in ("Amp", "Phase")
]  # fmt: skip


def read(path: str, options: Options) -> Foreign:
    """Read one draught of one vessel type, by name if there are several.

    Raises
    ------
    HydrodynamicsError
        If the file is not a text data file in SI units; if a convention is unknown; if the vessel type, its
        draught or a table is missing or ambiguous.
    """
    model, program = load(path)
    model.entry("General").choice("UnitsSystem", {"SI": None})
    vessel = model.named("VesselTypes", options.vessel_type, "vessel_type")
    draught = vessel.named("Draughts", options.draught_name, "draught_name")
    conventions = Conventions.of(vessel)
    draught.choice("AMDMethod", {"Frequency dependent": None})
    place = Place.of(draught)
    notes = [f"vessel type {vessel.text('Name')!r}, draught {draught.text('Name')!r}", *place.notes()]
    omega, added_mass, damping, infinite = _radiation(draught, conventions)
    directions, omega, kept, excitation = _excitation(draught, conventions, omega, notes)
    excitation = place.phased(omega, directions, excitation, options, path)
    symmetry = conventions.symmetry
    if symmetry == ENDS_ALONE:
        directions, excitation, symmetry = *_mirrored_ends(directions, excitation), "none"
    density = _density(model)
    volume = draught.number("DisplacedVolume")
    centre = _centre_of_the_weight(draught, density or options.density_kg_m3, volume, notes)
    includes = True if centre is not None and options.restoring_includes_weight is None else None
    notes.extend(_left_out(model, draught))
    return Foreign(
        file=path,
        solver=program,
        frequencies_rad_s=omega,
        directions_rad=directions,
        added_mass=added_mass[kept],
        radiation_damping=damping[kept],
        added_mass_infinite=infinite,
        excitation=place.carried(excitation),
        froude_krylov=None,
        restoring=_restoring(draught, conventions),
        density_kg_m3=density,
        gravity_m_s2=GRAVITY_M_S2,
        reference_m=place.reference,
        restoring_includes_weight=includes,
        centre_of_gravity_m=None if centre is None else place.here(centre),
        centre_of_buoyancy_m=place.here(draught.needed("CentreOfBuoyancy")),
        volume_m3=volume,
        length_m=_length(vessel, options, notes),
        hull_symmetry=symmetry,
        notes=tuple(notes),
        others_about=bool(model.entries("MultibodyGroups")),
    )


def refuse_binary(path: str, options: Options) -> Foreign:
    """Refuse OrcaWave's binary results, which cannot be read without OrcaFlex.

    Raises
    ------
    HydrodynamicsError
        Always; the message explains how to make a readable file.
    """
    allowed = "a text data file: open the results in OrcaFlex and save the model as .yml"
    raise reading_error("OrcaWave's results file, which is binary", allowed, path)


def _radiation(draught: Entry, conventions: Conventions) -> tuple:
    """Increasing frequencies above 0, added mass and damping there, added mass at infinity or `None`."""
    blocks = draught.entries("FrequencyDependentAddedMassAndDamping")
    if not blocks:
        allowed = "a table for each period or frequency; those of a multibody group are not read"
        raise draught.error("FrequencyDependentAddedMassAndDamping", "nothing", allowed)
    signs = THOUSAND * np.outer(conventions.signs, conventions.signs)
    periods = [block.number("AMDPeriodOrFrequency", infinite=True) for block in blocks]
    if None in periods:
        raise draught.error("AMDPeriodOrFrequency", "nothing", "a period or a frequency of each table")
    omega = conventions.frequencies(draught, np.array(periods))
    added_mass = np.stack([signs * _matrix(block, "AddedMassMatrix") for block in blocks])
    damping = np.stack([signs * _matrix(block, "Damping") for block in blocks])
    at_infinity = np.flatnonzero(np.isinf(omega))
    infinite = added_mass[at_infinity[0]] if len(at_infinity) else None
    order = np.argsort(omega)
    order = order[(omega[order] > 0.0) & np.isfinite(omega[order])]
    if not len(order) or (np.diff(omega[order]) <= 0.0).any():
        found = "no period" if not len(order) else "a period twice"
        allowed = "periods greater than 0, each once"
        raise draught.error("FrequencyDependentAddedMassAndDamping", found, allowed)
    return omega[order], added_mass[order], damping[order], infinite


def _matrix(block: Entry, name: str) -> NDArray[np.float64]:
    found = block.table([name + motion for motion in MATRIX])
    if found.shape != (6, 6) or not np.isfinite(found).all():
        raise block.error(name, f"{len(found)} rows", "6 rows of 6 finite numbers")
    return found


def _excitation(
    draught: Entry, conventions: Conventions, omega: NDArray[np.float64], notes: list[str]
) -> tuple:
    """Directions, frequencies at which all directions have forces, a mask of these, and forces for exp(-i w
    t)."""
    tables = draught.entry("LoadRAOs").entries("RAOs")
    if not tables:
        raise draught.error("LoadRAOs.RAOs", "nothing", "a table for each direction")
    directions, rows = [], []
    kept = np.ones(len(omega), bool)
    for table in tables:
        degrees = table.number("RAODirection")
        if degrees is None:
            raise table.error("RAODirection", "nothing", "a direction, deg")
        directions.append(np.radians(degrees))
        values = table.table(COLUMNS)
        if not np.isfinite(values[:, 1:]).all():
            raise table.error("RAOs", "a row that is not finite", "finite amplitudes and phases")
        found = conventions.frequencies(table, values[:, 0])
        found = np.where(np.isfinite(found), found, 0.0)
        nearest = np.abs(found - omega[:, None]).argmin(axis=1)
        kept &= np.abs(found[nearest] - omega) <= SAME_FREQUENCY * omega
        amplitudes = THOUSAND * conventions.signs * values[nearest, 1::2]
        lag = conventions.phase_factor * values[nearest, 2::2] + conventions.behind_rad
        rows.append(amplitudes * np.exp(1j * lag))
    if not kept.any():
        allowed = "the periods or frequencies of added mass and damping"
        raise draught.error("LoadRAOs.RAOs", "other periods or frequencies", allowed)
    if not kept.all():
        notes.append(
            f"{(~kept).sum()} frequencies left out at which there are no load RAOs in all directions"
        )
    return np.array(directions), omega[kept], kept, np.stack(rows, axis=1)[kept]


def _mirrored_ends(
    directions: NDArray[np.float64], excitation: NDArray[np.complex128]
) -> tuple[NDArray[np.float64], NDArray[np.complex128]]:
    """The forces with mirror images in the plane x = 0 of their own origin: waves towards b become waves
    towards pi - b."""
    return np.append(directions, np.pi - directions), np.concatenate([excitation, excitation * ENDS], axis=1)


def _restoring(draught: Entry, conventions: Conventions) -> NDArray[np.float64]:
    name, own = "HydrostaticStiffness", [2, 3, 4]
    rows = draught.table([name + motion for motion in ("z", "Rx", "Ry")])
    if rows.shape != (3, 3) or not np.isfinite(rows).all():
        raise draught.error(name, f"{len(rows)} rows", "3 rows of 3 finite numbers")
    found, signs = np.zeros((6, 6)), conventions.signs[own]
    found[np.ix_(own, own)] = THOUSAND * rows * np.outer(signs, signs)
    return found


def _density(model: Entry) -> float | None:
    """Density of the sea in the OrcaFlex model."""
    sea = model.entry("Environment")
    found = sea.number("Density") if sea.text("VerticalDensityVariation") in (None, "Constant") else None
    return None if found is None else THOUSAND * found


def _centre_of_the_weight(
    draught: Entry, density: float | None, volume: float | None, notes: list[str]
) -> NDArray[np.float64] | None:
    """Return the centre of mass if the mass equals the displaced mass; otherwise the stiffness has another
    weight."""
    mass, centre = draught.number("Mass"), draught.vector("CentreOfMass")
    if centre is None:
        centre = draught.vector("CentreOfGravity")
    if mass is None or centre is None or density is None or volume is None:
        return None
    displaced = density * volume
    if abs(THOUSAND * mass - displaced) <= SAME_MASS * displaced:
        return centre
    notes.append(
        f"the vessel type's mass, {mass:.4g} te, is not the displaced one, {displaced / THOUSAND:.4g} te: "
        "its centre is not that of the weight in the stiffness"
    )
    return None


def _length(vessel: Entry, options: Options, notes: list[str]) -> float | None:
    found = vessel.number("Length")
    if found is not None and options.length_m is None:
        notes.append(f"the length is the vessel type's, {found:.4g} m between perpendiculars")
    return found


def _left_out(model: Entry, draught: Entry) -> list[str]:
    """Notes on data of a draught that are not used."""
    notes = []
    if draught.entry("WaveDrift").entries("RAOs"):
        notes.append("wave drift of the file is left out")
    other = [draught.vector(f"Other{kind}Damping", 6) for kind in ("Linear", "Quadratic")]
    if any(each is not None and each.any() for each in other):
        notes.append("other damping of the file, which is not radiation damping, is left out")
    if model.entries("MultibodyGroups"):
        notes.append("the couplings of multibody groups are left out: other bodies are held still")
    return notes
