"""Report on the model: picture, masses, hydrostatics, righting arms, natural periods, sea."""

from __future__ import annotations

from math import degrees
from typing import TYPE_CHECKING, Any

from ..analysis.eigenmodes import OSCILLATION, UNSTABLE
from ..analysis.vibration import modes
from ..errors import KingpostError
from ..reports import outline, sea
from ..reports.modes import of_ship_and_crane
from ..reports.tables import fixed, masses
from ..simulation.simulate import Simulation
from .blocks import Block, Command, Paragraph, Picture, Section, Table

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from ..scenario import Scenario

LONGEST_PERIOD_S = 60.0
"""Longest natural period in the list, s; longer ones belong to moorings and positioning."""
FILE = "scenario.json"
FROM_CHECK = f"Command: kingpost check {FILE}."


def section(scenario: Scenario) -> Section:
    """Section with the model at the start of a run, and the commands that print the same numbers."""
    simulation = Simulation(scenario)
    blocks: list[Block] = [Paragraph(str(scenario.resolved.get("description") or scenario.title))]
    blocks.append(_outline(simulation))
    blocks.append(_masses(scenario))
    for hull in scenario.hydrostatics["hulls"]:
        blocks.append(_floating(hull))
        if hull["righting_arm"]:
            blocks.append(_righting_arms(hull))
    blocks += _periods(scenario)
    return Section("model", "What was modelled", blocks)


def _outline(simulation: Simulation) -> Block:
    """Picture of the model, or a sentence with the reason why there is none."""
    try:
        drawn = outline.figure(simulation)
    except KingpostError as error:
        return Paragraph(f"No picture: {error}.")
    return Picture.of(
        drawn,
        "The outlines of the model from the side, from ahead and from above",
        "The model as a run begins, to scale; x forward, y to port, z up, the still water at z = 0.",
        f"File: {FILE}.",
    )


def _masses(scenario: Scenario) -> Table:
    bodies = scenario.model["bodies"]
    weights = [body["mass_kg"] for body in bodies]
    *each, in_all = masses([*weights, sum(weights)])
    rows = [(body["name"], body["parent"] or "world", mass) for body, mass in zip(bodies, each, strict=True)]
    rows.append(("all", "", in_all))
    return Table("Masses", ("body", "on", "mass"), rows, FROM_CHECK, (2,))


def _floating(hull: dict[str, Any]) -> Table:
    """Hydrostatics of a hull at rest in still water; heights are over the keel."""
    rows = [
        ("displacement", f"{hull['displacement_kg'] / 1000:.1f} t"),
        ("draught", f"{fixed(hull['draught_m'], 3)} m"),
        ("heel, positive to starboard", f"{fixed(degrees(hull['heel_rad']), 3)} deg"),
        ("trim, positive by the bow", f"{fixed(degrees(hull['trim_rad']), 3)} deg"),
        ("KB", f"{fixed(hull['keel_to_buoyancy_m'], 3)} m"),
        ("KG", f"{fixed(hull['keel_to_gravity_m'], 3)} m"),
        (
            "GM, with hanging loads where they hang from and free surfaces",
            f"{fixed(hull['metacentric_height_m'][0], 3)} m",
        ),
        ("GM, with all as if fixed", f"{fixed(hull['solid_metacentric_height_m'][0], 3)} m"),
    ]
    head = ("quantity", "value")
    return Table(f"{hull['body']} afloat at rest in still water", head, rows, FROM_CHECK, (1,))


def _righting_arms(hull: dict[str, Any]) -> Picture:
    curve = hull["righting_arm"]
    figure = _figure(3.2)
    axes = figure.subplots()
    heel = [degrees(point["heel_rad"]) for point in curve["points"]]
    axes.plot(heel, [point["arm_m"] for point in curve["points"]], "o-", ms=3)
    axes.axhline(0.0, color="black", lw=0.8)
    axes.set(xlabel=f"heel to {curve['side']}, deg", ylabel="GZ, m")
    axes.grid(alpha=0.3)
    top = curve["largest"]
    largest = f"largest {fixed(top['arm_m'], 3)} m at {degrees(top['heel_rad']):.1f} deg"
    caption = f"Righting arms of {hull['body']} to {curve['side']}, free to trim: {largest}."
    return Picture.of(figure, f"Righting arm against heel: {largest}", caption, FROM_CHECK)


def _periods(scenario: Scenario) -> list[Block]:
    """Natural periods about rest, or a sentence with the reason why there are none."""
    try:
        found = of_ship_and_crane(modes(scenario))
    except KingpostError as error:
        return [Paragraph(f"No natural periods: {error}.")]
    rows = []
    for number in found["mode"].values:
        mode = found.sel(mode=number)
        kind, frequency_hz = mode["kind"].item(), mode["frequency"].item()
        if kind == OSCILLATION and frequency_hz * LONGEST_PERIOD_S > 1:
            damping = f"{100 * mode['damping_ratio'].item():.1f} %"
            rows.append((mode["named_after"].item(), f"{1 / frequency_hz:.2f} s", damping))
        elif kind == UNSTABLE:
            rows.append((mode["named_after"].item(), "unstable", ""))
    head = ("coordinate with the largest share", "natural period", "damping ratio")
    origin = f"Command: kingpost modes {FILE}. Periods above {LONGEST_PERIOD_S:g} s are left out."
    return [Table("Natural periods about rest", head, rows, origin, (1, 2))] if rows else []


def sea_section(scenario: Scenario) -> Section:
    """Section with water, waves, current and wind of the scenario, before the study sets its axes."""
    printed = "\n".join(sea.lines(scenario))
    blocks: list[Block] = [
        Paragraph("As the scenario has it before the study sets its axes:"),
        Command(printed or "no sea and no wind"),
    ]
    return Section("sea", "Sea and wind", blocks)


def _figure(height_in: float) -> Figure:
    from matplotlib.figure import Figure

    return Figure(figsize=(9, height_in), layout="constrained")
