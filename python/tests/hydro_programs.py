"""Writers of files as WAMIT, ShipX, AQWA and Nemoh write them, with their digits, from one database.

Each writes about a point vertically above or below the origin, because the phases are those of the wave
there.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
from hydro_writers import GRAVITY_CENTRE, About, Wamit
from kingpost.hydro.database import Database

ABOVE = np.array([0.0, 0.0, -1.2])


def wamit_six_digits(stem: Path, base: Database, *, version: int = 7) -> Path:
    """STEM.1, .3, .3fk, .3sc and .hst with six or seven digits, periods of -1 and 0 first in
    version 6 and last among version 7's, and a header line in version 7."""
    about, rho, g = About(base, ABOVE), base.water.density_kg_m3, base.water.gravity_m_s2
    number = (lambda x: f"{x:14.6E}") if version == 7 else six_digits
    head = [" WAMIT Numeric Output -- Filename  hull     06-Dec-2016  11:59:40"] if version == 7 else []
    limits = [(column, i, j, about.matrix(base.added_mass_infinite)[i, j] / rho) for column in (-1.0, 0.0)
              for i in range(6) for j in range(6)]  # fmt: skip
    limits = [f"{number(c)} {i + 1:5d} {j + 1:5d} {number(a)}" for c, i, j, a in limits]
    rows = []
    periods = 2 * np.pi / base.frequencies_rad_s
    for k, period in enumerate(periods):
        a = about.matrix(base.added_mass)[k] / rho
        b = about.matrix(base.radiation_damping)[k] / rho / base.frequencies_rad_s[k]
        rows += [f"{number(period)} {i + 1:5d} {j + 1:5d} {number(a[i, j])} {number(b[i, j])}"
                 for i in range(6) for j in range(6)]  # fmt: skip
    _lines(stem, ".1", head + (limits + rows if version == 6 else rows + limits))
    parts = {".3": base.excitation, ".3fk": base.froude_krylov, ".3sc": base.diffraction}
    for ending, forces in parts.items():
        values = about.force(forces).conj() / (rho * g)
        _lines(stem, ending, head + [
            f"{number(periods[k])} {number(np.degrees(base.wave_directions_rad[b]))} {i + 1:5d} "
            f"{number(abs(x))} "
            f"{number(np.degrees(np.angle(x)))} {number(x.real)} {number(x.imag)}"
            for k, b, i in np.ndindex(values.shape) for x in [values[k, b, i]]
        ])  # fmt: skip
    restoring = about.restoring(GRAVITY_CENTRE) / (rho * g)
    _lines(
        stem, ".hst", head + [f"{i + 1:6d} {j + 1:5d} {number(restoring[i, j])}" for i, j in np.ndindex(6, 6)]
    )
    return stem.with_suffix(".1")


def six_digits(x: float) -> str:
    """Fortran's 0.123456E+01."""
    if x == 0.0:
        return "  0.000000E+00"
    exponent = int(np.floor(np.log10(abs(x)))) + 1
    return f"{x / 10.0**exponent:10.6f}E{exponent:+03d}"


def wamit_listing(stem: Path, base: Database) -> Path:
    """STEM.out: its header, and the tables of each period, phases in whole degrees."""
    about, rho, g = About(base, ABOVE), base.water.density_kg_m3, base.water.gravity_m_s2
    hull, restoring = base.hull, About(base, ABOVE).restoring(GRAVITY_CENTRE) / (rho * g)
    buoyancy, centre = hull.centre_of_buoyancy_m - ABOVE, GRAVITY_CENTRE - ABOVE
    lines = [
        "                        WAMIT  Version 7.2(x64)        ",
        f" Gravity:     {g:.5f}                Length scale:        1.00000",
        f" Water depth:        infinite       Water density:     {rho:.5f}",
        " BODY PARAMETERS:",
        " Total panels:    1008  Waterline panels:     48      Symmetries: none    ",
        f" XBODY ={ABOVE[0]:10.4f} YBODY ={ABOVE[1]:10.4f} ZBODY ={ABOVE[2]:10.4f} PHIBODY =   0.0",
        " Volumes (VOLX,VOLY,VOLZ):      " + "  ".join(f"{hull.volume_m3:12.3f}" for _ in range(3)),
        " Center of Buoyancy (Xb,Yb,Zb):" + "".join(f"{x:13.6f}" for x in buoyancy),
        " Hydrostatic and gravitational restoring coefficients: ",
        f" C(3,3),C(3,4),C(3,5): {restoring[2, 2]:.5E} {restoring[2, 3]:.5E} {restoring[2, 4]:.5E}",
        f" C(4,4),C(4,5),C(4,6):        {restoring[3, 3]:.5E} {restoring[3, 4]:.5E} 0.0000",
        f"        C(5,5),C(5,6):        {restoring[4, 4]:.5E} 0.0000",
        " Center of Gravity  (Xg,Yg,Zg):" + "".join(f"{x:13.6f}" for x in centre),
        "                            Output from  WAMIT",
    ]
    infinite = about.matrix(base.added_mass_infinite) / rho
    lines += [" Wave period = zero                                 Wavenumber = infinite ",
              "    ADDED-MASS COEFFICIENTS", "     I     J         A(I,J)", ""]  # fmt: skip
    lines += [f"{i + 1:6d}{j + 1:6d}{infinite[i, j]:15.6E}" for i, j in np.ndindex(6, 6)]
    values = about.force(base.excitation).conj() / (rho * g)
    for k, omega in enumerate(base.frequencies_rad_s):
        a, b = (about.matrix(m)[k] / rho for m in (base.added_mass, base.radiation_damping))
        lines += [f" Wave period (sec) = {2 * np.pi / omega:13.6E}        Wavenumber (kL) =  1.270829E-01",
                  "    ADDED-MASS AND DAMPING COEFFICIENTS", "     I     J         A(I,J)         "
                  "B(I,J)", ""]  # fmt: skip
        lines += [f"{i + 1:6d}{j + 1:6d}{a[i, j]:15.6E}{b[i, j] / omega:15.6E}" for i, j in np.ndindex(6, 6)]
        lines += ["", "    DIFFRACTION EXCITING FORCES AND MOMENTS", ""]
        for at, direction in enumerate(np.degrees(base.wave_directions_rad)):
            lines += [f"  Wave Heading (deg) : {direction:6.0f}", "", "     I     Mod[Xh(I)]     Pha[Xh(I)]"]
            lines += [
                f"{i + 1:6d}{abs(x):15.6E}{np.degrees(np.angle(x)):15.0f}"
                for i, x in enumerate(values[k, at])
            ]
        lines += ["", "    RESPONSE AMPLITUDE OPERATORS", "     1   9.9E+01             12"]
    _lines(stem, ".out", lines)
    return stem.with_suffix(".out")


def shipx(stem: Path, base: Database) -> Path:
    """STEM.re7, .re8 and .hyd: x aft and y to starboard, headings from the bow, exp(+i w t)."""
    turn = np.array([-1.0, -1.0, 1.0, -1.0, -1.0, 1.0])
    about, hull, water = About(base, ABOVE), base.hull, base.water
    draught, omega = hull.draught_m, base.frequencies_rad_s
    mass = water.density_kg_m3 * hull.volume_m3 * np.eye(6)
    texts = ["HYDRODYNAMIC COEFFICIENTS (Version 2) - VERES Version  4.02.3", *[" text"] * 5]
    head = [f" {water.density_kg_m3:.8E} {water.gravity_m_s2:.8E}",
            f" {hull.length_m:.8E} {hull.beam_m:.8E} {draught:.8E}",
            f" {-GRAVITY_CENTRE[0] + 2.0:.8E} {GRAVITY_CENTRE[2] + draught:.8E}"]  # fmt: skip
    counts = f"     1    {len(base.wave_directions_rad)}    {len(omega)}     6"
    speed = f" 0.0 0.0 0.0 2.0 {ABOVE[2] + draught:.6f}"
    headings = np.mod(np.degrees(base.wave_directions_rad) + 180.0, 360.0)
    order = np.argsort(headings)
    seven, eight = (
        [*texts, *head, "    -1     2", counts, *_matrix(mass), speed],
        [*texts, *head, counts, speed],
    )
    zero = np.zeros((6, 6))
    forces = about.force(base.excitation).conj() * turn
    for b in order:
        seven.append(f" {headings[b]:.2f}")
        eight.append(f" {headings[b]:.2f}")
        for k, w in enumerate(omega):
            seven.append(f" {w:.7f}")
            for matrices in (base.added_mass[k], base.radiation_damping[k]):
                seven += [*_matrix(about.matrix(matrices) * np.outer(turn, turn)), *_matrix(zero)]
            seven += [
                *_matrix(about.restoring(GRAVITY_CENTRE) * np.outer(turn, turn)),
                *_matrix(zero),
                " 1.0 2.0 3.0",
            ]
            eight += [
                f" {w:.7f}",
                *(f" {i + 1} {x.real:.8E} {x.imag:.8E}" for i, x in enumerate(forces[k, b])),
            ]
    _lines(stem, ".re7", seven)
    _lines(stem, ".re8", eight)
    keel = hull.centre_of_buoyancy_m[2] + draught
    _lines(stem, ".hyd", [f"Vertical center of bouyancy,     KB               {keel:.4f}*"])
    return stem.with_suffix(".re7")


def aqwa(stem: Path, base: Database, structures: int = 1) -> Path:
    """STEM.AH1 of structures, all alike, the centre of gravity of the first at `ABOVE`; A at 100 rad/s is
    that of infinite frequency. The coupling between structures is a hundredth of the coefficients of one
    structure."""
    about, hull, water = About(base, ABOVE), base.hull, base.water
    omega, degrees = base.frequencies_rad_s, np.degrees(base.wave_directions_rad)
    every = range(1, structures + 1)
    pairs = [(i, j) for i in every for j in every]
    lines = ["* FILE VERSION NO 5"]
    for i in every:
        lines += [f"  {i}  {len(degrees)}  {len(omega)} " + " ".join(f"{d:.5f}" for d in degrees),
                  " ".join(f"{w:.7f}" for w in omega)]  # fmt: skip
    of_each = {"GENERAL": f"1000.000 {water.density_kg_m3:.3f} {water.gravity_m_s2:.3f} 0 0",
               "COG": " ".join(f"{x:.3f}" for x in ABOVE), "DRAFT": f"{hull.draught_m:.3f}",
               "COB": " ".join(f"{x:.3f}" for x in hull.centre_of_buoyancy_m),
               "DISPLACEMENT": f"{hull.volume_m3:.4E}"}  # fmt: skip
    for name, numbers in of_each.items():
        lines += [name, *(f"  {i} {numbers}" for i in every)]
    lines.append("HYDSTIFFNESS")
    for i in every:
        lines += [f"  {i}", *_matrix(about.restoring(ABOVE))]

    def of_pair(i: int, j: int, matrix: np.ndarray) -> list[str]:
        return _matrix(matrix if i == j else 0.01 * matrix)

    for name, matrices in (("ADDEDMASS", base.added_mass), ("DAMPING", base.radiation_damping)):
        lines.append(name)
        for i, j in pairs:
            for k, each in enumerate(about.matrix(matrices)):
                lines += [f"  {i}  {j}  {k + 1}", *of_pair(i, j, each)]
    lines.append("ADDEDMASS_HF")
    for i, j in pairs:
        lines += [f"  {i}  {j}", *of_pair(i, j, about.matrix(base.added_mass_infinite))]
    lines.append("FORCERAO")
    for i in every:
        for b in range(len(degrees)):
            for k, forces in enumerate(about.force(base.excitation)[:, b]):
                lines += [f"  {i}  {b + 1}  {k + 1} " + " ".join(f"{abs(x):.6E}" for x in forces),
                          " ".join(f"{np.degrees(np.angle(x)):.4f}" for x in forces)]  # fmt: skip
    _lines(stem, ".AH1", lines)
    return stem.with_suffix(".AH1")


def aqwa_listing(stem: Path, base: Database) -> Path:
    """STEM.LIS of one structure as 2020 R1 writes it, its centre of gravity at `ABOVE`: coefficients of five
    digits, forces of three, tables of two directions a page with blanks for the same one."""
    about, hull, water = About(base, ABOVE), base.hull, base.water
    omega, degrees = base.frequencies_rad_s, np.degrees(base.wave_directions_rad)
    page = "   * * * * H Y D R O D Y N A M I C   P A R A M E T E R S   F O R   S T R U C T U R E   1 * * * *"
    lines = [" * File generated by Aqwa in Workbench 2020 R1 *", "1",
             f"  WATER  DEPTH  . . . . . . . . . . . . . . . . = {1000.0:11.4f}",
             f"  DENSITY  OF  WATER  . . . . . . . . . . . . . = {water.density_kg_m3:11.3f}",
             f"  ACCELERATION  DUE  TO GRAVITY . . . . . . . . = {water.gravity_m_s2:11.3f}",
             f"    DEPTH OF LOWEST POINT ON VESSEL . . . . . . . {hull.draught_m:7.4f}",
             "STRUCTURE C.O.G.   " + "  ".join(f"G{n}= {x:9.4f}" for n, x in zip("XYZ", ABOVE, strict=True)),
             f"  MESH BASED DISPLACEMENT  . . . . . . . .   = {hull.volume_m3:13.5E}",
             *(f"  B{n} = {x:13.4f}" for n, x in zip("XYZ", hull.centre_of_buoyancy_m, strict=True)),
             "   3. TOTAL HYDROSTATIC STIFFNESS",
             "       Z            RX            RY            RZ"]  # fmt: skip
    restoring = about.restoring(ABOVE)
    for name, row in zip(("HEAVE( Z)", "ROLL (RX)", "PITCH(RY)"), restoring[2:5], strict=True):
        lines.append(f"   {name} =  " + "".join(f"{x:14.5E}" for x in row[2:6]))
    for k, w in enumerate(omega):
        lines += ["1", page, f"   WAVE PERIOD = {2 * np.pi / w:7.3f}   WAVE FREQUENCY = {w:7.4f}"]
        for name, of in (("ADDED  MASS", base.added_mass), ("DAMPING", base.radiation_damping)):
            lines += _listed(name, about.matrix(of)[k])
    for title, forces in (("DIFFRACTION", base.diffraction), ("FROUDE KRYLOV", base.froude_krylov),
                          ("FROUDE KRYLOV + DIFFRACTION", base.excitation)):  # fmt: skip
        for b, direction in enumerate(degrees):
            lines += ["1", page, f"    {title} FORCES-VARIATION WITH WAVE PERIOD/FREQUENCY",
                      "  PERIOD   FREQ   DIRECTION    X    Y    Z    RX    RY    RZ"]  # fmt: skip
            for k, row in enumerate(about.force(forces)[:, b]):
                named = f"{direction:10.2f}" if k == 0 else 10 * " "
                numbers = "".join(f"{abs(x):10.2E}{np.degrees(np.angle(x)):8.2f}" for x in row)
                lines.append(f"{2 * np.pi / omega[k]:8.2f}{omega[k]:8.3f}{named}{numbers}")
    limits = "* * * * H Y D R O D Y N A M I C   P A R A M E T E R S   A T   L O W   &   H I G H   * * * *"
    lines += ["1", limits, "   F O R   S T R U C T U R E   1"]
    for w, matrix in ((0.0018, base.added_mass[0]), (100.0, base.added_mass_infinite)):
        lines.append(f"  WAVE FREQUENCY = {w:9.4f}(RAD/S)     ENCOUNTER FREQUENCY = {w:9.4f}(RAD/S)")
        lines += _listed("ADDED MASS", about.matrix(matrix))
    _lines(stem, ".LIS", lines)
    return stem.with_suffix(".LIS")


def _listed(name: str, matrix: np.ndarray) -> list[str]:
    rows = zip(("X", "Y", "Z", "RX", "RY", "RZ"), matrix, strict=True)
    listed = [f"{row:>13}  " + "".join(f"{x:14.4E}" for x in values) for row, values in rows]
    return [f"    {name}", "    X     Y     Z     RX     RY     RZ", *listed]


def wamit_motions(stem: Path, base: Database, mass: np.ndarray, damping: np.ndarray) -> None:
    """STEM.frc with matrices about `ABOVE`, and STEM.4: the motions of the hull so loaded."""
    about, omega = About(base, ABOVE), base.frequencies_rad_s[:, None, None]
    impedance = (-(omega**2) * (mass + about.matrix(base.added_mass))
                 - 1j * omega * (about.matrix(base.radiation_damping) + damping)
                 + about.restoring(GRAVITY_CENTRE))  # fmt: skip
    motions = np.linalg.solve(impedance[:, None], about.force(base.excitation)[..., None])[..., 0].conj()
    periods, degrees = 2 * np.pi / base.frequencies_rad_s, np.degrees(base.wave_directions_rad)
    _lines(stem, ".4", [
        f"{periods[k]:14.6E} {degrees[b]:14.6E} {i + 1:5d} {abs(x):14.6E} {np.degrees(np.angle(x)):14.6E} "
        f"{x.real:14.6E} {x.imag:14.6E}"
        for k, b, i in np.ndindex(motions.shape) for x in [motions[k, b, i]]
    ])  # fmt: skip
    _lines(stem, ".frc", ["title", "1 0 1 1 0 0 0 0 0 IOPTN", f"{base.water.density_kg_m3} RHO",
                          " ".join(str(x) for x in GRAVITY_CENTRE - ABOVE), "1", *_matrix(mass),
                          "1", *_matrix(damping), "0", "0"])  # fmt: skip


def nemoh(folder: Path, base: Database) -> Path:
    """Nemoh.cal, Mesh and Results; rotations, moments and KH about `ABOVE`, where gravity acts."""
    about, hull, water = About(base, ABOVE), base.hull, base.water
    omega, degrees = base.frequencies_rad_s, np.degrees(base.wave_directions_rad)
    point = " ".join(f"{x:.6f}" for x in ABOVE)
    axes = [f"{kind} {' '.join('1.' if k == j else '0.' for j in range(3))} {point} ! dof"
            for kind in (1, 2) for k in range(3)]  # fmt: skip
    cal = ["--- Environment ---", f"{water.density_kg_m3}\t! RHO", f"{water.gravity_m_s2}\t! G",
    "0.\t! DEPTH",
           "0. 0. ! XEFF YEFF", "--- Bodies ---", "1 ! Number of bodies", "--- Body 1 ---", "hull.dat ! mesh",
           "4 1 ! points", "6 ! dofs", *axes, "6 ! forces", *axes, "0 ! lines", "--- Load cases ---",
           f"{len(omega)} {omega[0]} {omega[-1]} ! Number of wave frequencies, Min, and Max (rad/s)",
           f"{len(degrees)} {degrees[0]} {degrees[-1]} ! Number of wave directions, Min and Max "
           f"(degrees)"]  # fmt: skip
    for name in ("Mesh", "Results"):
        (folder / name).mkdir(parents=True)
    _lines(folder / "Nemoh", ".cal", cal)
    _lines(folder / "Mesh/KH", ".dat", _matrix(about.restoring(ABOVE)))
    centres = zip("XYZ", hull.centre_of_buoyancy_m, ABOVE, strict=True)
    lines = [f" {axis}F = {b:.6f} - {axis}G = {g:.6f}" for axis, b, g in centres]
    _lines(folder / "Mesh/Hydrostatics", ".dat", [*lines, f" Displacement = {hull.volume_m3:.7E}"])
    rows = ['VARIABLES="w (rad/s)"']
    a, b = about.matrix(base.added_mass), about.matrix(base.radiation_damping)
    for j in range(6):
        rows.append(f'Zone t="Motion of body    1 in DoF   {j + 1}",I=   {len(omega)},F=POINT')
        rows += [
            f" {w:.7E} " + " ".join(f"{a[k, i, j]:.7E} {b[k, i, j]:.7E}" for i in range(6))
            for k, w in enumerate(omega)
        ]
    _lines(folder / "Results/RadiationCoefficients", ".tec", rows)
    for name, forces in (("ExcitationForce", base.excitation), ("FKForce", base.froude_krylov)):
        rows = ['VARIABLES="w (rad/s)"']
        for d, degree in enumerate(degrees):
            rows.append(f'Zone t="Diffraction force - beta = {degree:7.3f} deg",I=   {len(omega)},F=POINT')
            rows += [f" {w:.7E} " + " ".join(f"{abs(x):.7E} {np.angle(x):.7E}" for x in
            about.force(forces)[k, d])
                     for k, w in enumerate(omega)]  # fmt: skip
        _lines(folder / f"Results/{name}", ".tec", rows)
    return folder / "Nemoh.cal"


def _matrix(values: np.ndarray) -> list[str]:
    return ["  " + "  ".join(f"{x:.8E}" for x in row) for row in values]


def _lines(stem: Path, ending: str, lines: list[str]) -> None:
    stem.with_suffix(ending).write_text("\n".join(lines) + "\n", encoding="latin-1")


__all__ = [
    "ABOVE",
    "Wamit",
    "aqwa",
    "aqwa_listing",
    "nemoh",
    "shipx",
    "wamit_listing",
    "wamit_motions",
    "wamit_six_digits",
]
