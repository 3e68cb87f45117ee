"""Physical bounds of columns: values that no run can pass, so that no extrapolation may."""

from __future__ import annotations

from math import inf, pi

NOT_NEGATIVE = frozenset({
    "rope_tension", "rope_first_tension", "winch_tension", "rope_daf", "rope_length", "tugger_length",
    "hook_load", "load_radius", "load_utilisation", "contact_normal_force", "contact_friction_force",
    "contact_impulse", "contact_penetration", "contact_points", "line_grounded_length", "flow_speed",
    "thruster_utilisation",
})  # fmt: skip
"""Variables that are 0 or more: a rope and a contact only pull or only push."""
HALF_TURN = frozenset({"roll", "rope_offlead"})
"""Angles by an arctangent of two arguments, from -180 to 180 degrees."""
QUARTER_TURN = frozenset({"pitch", "rope_sidelead"})
"""Angles by an arcsine, from -90 to 90 degrees."""


def bounds(column: str) -> tuple[float, float]:
    """Least and largest value that a column can have, in SI units; infinite without a bound.

    A clearance has none: it is negative inside a solid.

    >>> bounds("hoist_rope.rope_tension"), bounds("side.clearance")
    ((0.0, inf), (-inf, inf))
    >>> bounds("hull.pitch")[1] * 2 == pi
    True
    """
    variable = column.rpartition(".")[2]
    if variable in NOT_NEGATIVE:
        return 0.0, inf
    if variable == "submerged_share":
        return 0.0, 1.0
    most = pi if variable in HALF_TURN else 0.5 * pi if variable in QUARTER_TURN else inf
    return -most, most
