"""Table 2 of the paper, with units, from the values of the scenario."""

from __future__ import annotations

import csv
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from .. import output
from ..scenario import load


@dataclass(frozen=True)
class Row:
    """One quantity: the paper's symbol in LaTeX, the value (SI), its unit, the scenario's field."""

    quantity: str
    symbol: str
    value: float
    unit: str
    field: str


# Quantity, the paper's symbol, field of the scenario, unit, table value per field value.
_TOWER = "bodies.tower.joint.revolute.position_m"
_DAMPING = "forces.damping.viscous_damping.angular_N_m_s"
_ROWS: Sequence[tuple[str, str, str, str, float]] = (
    ("Mass of ship", "m^{(1)}", "bodies.ship.mass_kg", "kg", 1.0),
    ("Mass of tower", "m^{(2)}", "bodies.tower.mass_kg", "kg", 1.0),
    ("Mass of arm", "m^{(3)}", "bodies.arm.mass_kg", "kg", 1.0),
    ("Mass of crane load", "m^{(4)}", "bodies.load.mass_kg", "kg", 1.0),
    ("Tower position along the ship (forward)", "d^{(1)}", f"{_TOWER}.0", "m", 1.0),
    ("Tower position athwartship (to port)", "b^{(1)}", f"{_TOWER}.1", "m", 1.0),
    ("Half the height of tower", "l^{(2)}", "bodies.tower.shape.cylinder.length_m", "m", 0.5),
    ("Half the length of arm", "l^{(3)}", "bodies.arm.shape.cylinder.length_m", "m", 0.5),
    ("Radius of tower", "r^{(2)}", "bodies.tower.shape.cylinder.radius_m", "m", 1.0),
    ("Radius of arm", "r^{(3)}", "bodies.arm.shape.cylinder.radius_m", "m", 1.0),
    ("Width of ship", "L_{ps}", "bodies.ship.shape.box.width_m", "m", 1.0),
    ("Length of ship", "L_{sb}", "bodies.ship.shape.box.length_m", "m", 1.0),
    ("Height of ship", "L_{h}", "bodies.ship.shape.box.height_m", "m", 1.0),
    ("Torque applied to tower", "M^{(1)}", "drives.motor_1.motor.torque_N_m", "N m", 1.0),
    ("Torque applied to arm", "M^{(2)}", "drives.motor_2.motor.torque_N_m", "N m", 1.0),
    ("Damping of pitch", r"\zeta_1", f"{_DAMPING}.1", "N m s", 1.0),
    ("Damping of yaw", r"\zeta_2", f"{_DAMPING}.2", "N m s", 1.0),
    ("Damping of roll", r"\zeta_3", f"{_DAMPING}.0", "N m s", 1.0),
)


def rows() -> list[Row]:
    """Table 2, every value read from the gallery's `paper` scenario."""
    resolved = load("paper").resolved
    return [
        Row(quantity, symbol, scale * float(at(resolved, field)), unit, field)
        for quantity, symbol, field, unit, scale in _ROWS
    ]


def at(tree: Any, path: str) -> Any:
    """Value at a dotted path, entries of lists by index.

    >>> at({"bodies": {"ship": {"mass_kg": [1, 2]}}}, "bodies.ship.mass_kg.1")
    2
    """
    for key in path.split("."):
        tree = tree[int(key)] if isinstance(tree, list) else tree[key]
    return tree


def write(folder: Path) -> list[Row]:
    """Write `table_2.csv` and `table_2.md`."""
    table = rows()
    with (
        output.whole(folder / "table_2.csv") as beside,
        beside.open("w", newline="", encoding="utf-8") as file,
    ):
        lines = csv.writer(file)
        lines.writerow(("quantity", "symbol", "value", "unit", "field"))
        lines.writerows((row.quantity, row.symbol, f"{row.value:g}", row.unit, row.field) for row in table)
    text = ["| Quantity | Symbol | Value | Unit | Field of the scenario |"]
    text.append("| --- | --- | ---: | --- | --- |")
    text += [f"| {r.quantity} | ${r.symbol}$ | {r.value:,g} | {r.unit} | `{r.field}` |" for r in table]
    output.write_text(folder / "table_2.md", "\n".join(text) + "\n")
    return table
