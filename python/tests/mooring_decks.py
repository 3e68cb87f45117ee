"""Mooring systems as files of MoorDyn and MoorPy, for tests of `kingpost convert`."""

from __future__ import annotations

from pathlib import Path

import kingpost
from kingpost.convert import convert

DECK = """\
------------------- MoorDyn Input File -------------------
A chain and a wire from an anchor
---------------------- LINE TYPES ----------------------
TypeName  Diam   Mass/m  EA      BA/-zeta  EI   Cd   Ca   CdAx  CaAx
(name)    (m)    (kg/m)  (N)     (N-s/-)   (-)  (-)  (-)  (-)   (-)
chain     0.333  685.0   3.27e9  65.4e6    0    1.2  1.0  0.05  0.5
wire      0.1    40.0    5.0e8   -0.8      12   1.1  0.9  0.01  0.2   # a comment
spare     0.1    40.0    5.0e8   -0.8      0    1.1  0.9  0.01  0.2
---------------------- POINTS --------------------------
ID  Attachment  X      Y  Z       Mass  Volume  CdA  Ca
(#) (word/ID)   (m)    (m) (m)    (kg)  (m^3)   (m^2) (-)
1   Fixed       779.6  0  -200.0  0     0       0    0
2   Free        390    0  -107.0  0     0       0    0
3   Coupled     0      0  -14.0   0     0       0    0
---------------------- LINES ---------------------------
ID  LineType  AttachA  AttachB  UnstrLen  NumSegs  Outputs
(#) (name)    (#)      (#)      (m)       (-)      (-)
1   chain     1        2        405       20       p
2   wire      2        3        405       11       -
---------------------- FAILURE -------------------------
ID  Point  Lines  FailTime  FailTen
()  ()     (,)    (s)       (N)
1   3      2      0         1e6
---------------------- OPTIONS -------------------------
0.005   dtM
9.81    g
1020    rho
200     WtrDpth
2e6     kBot
1e5     cBot
0.4     FrictionCoefficient
0       WaveKin
RK4     tScheme
100     TmaxIC
0.5     dtOut
---------------------- OUTPUTS -------------------------
FairTen1
AnchTen1
---------------------- need this line ------------------
"""
POINTS, LINES = (
    "3   Coupled     0      0  -14.0   0     0       0    0\n",
    "2   wire      2        3        405       11       -\n",
)

MOORPY = """\
water_depth: 200
rho: 1020
points:
  - {name: Anchor 1, type: fixed, location: [779.6, 0, -200], anchor_type: suction}
  - {name: buoy, type: connection, location: [390, 0, -107], mass: 5.0e3, volume: 2}
  - {name: fairlead, type: vessel, location: [0, 0, -14]}
lines:
  - {name: lower, endA: Anchor 1, endB: buoy, type: chain, length: 405}
  - {name: upper, endA: buoy, endB: fairlead, type: chain, length: 405}
line_types:
  - {name: chain, diameter: 0.333, mass_density: 685, stiffness: 3.27e9, transverse_drag: 1.2, cost: 10}
"""


BODIES = """\
---------------------- BODIES --------------------------
ID Attachment X0 Y0 Z0 r0 p0 y0 Mass CG I Volume CdA Ca
(#) (-) (m) (m) (m) (deg) (deg) (deg) (kg) (m) (kg-m^2) (m^3) (m^2) (-)
1 {attachment} 1 2 -5 0 0 90 {mass} 0|0|-2 {moment} 3 2|4 0.5
---------------------- RODS ----------------------------
ID Type Attachment Xa Ya Za Xb Yb Zb NumSegs Outputs
(#) (-) (-) (m) (m) (m) (m) (m) (m) (-) (-)
1 can Body1 0 0 2 0 0 15 3 p
2 can free 0 0 2 0 0 15 3 p
3 can free 390 0 -107 390 0 -107 0 -
"""
HEAD = "---------------------- POINTS --------------------------\n"


def write_deck(folder: Path, *replacements: tuple[str, str], text: str = DECK, name: str = "deck.txt") -> str:
    """Write a deck, with replacements, and return its path."""
    for old, new in replacements:
        assert text.count(old) == 1, old
        text = text.replace(old, new)
    path = folder / name
    path.write_text(text, encoding="utf-8")
    return str(path)


def resolved(path: str) -> dict:
    """The scenario of a file as the engine reads it."""
    return kingpost.scenario.Scenario(convert(path).text, path).resolved


def where(notes) -> dict:
    """Reasons by line and first word."""
    return {(note.line, note.text.split()[0]): note.why for note in notes}
