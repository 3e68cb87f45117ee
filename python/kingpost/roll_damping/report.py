"""Reports of `kingpost roll-damping`."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from ..hydro.database import Water
from ..reports.tables import table
from . import simplified
from .coefficients import Coefficients
from .ikeda import COMPONENTS

if TYPE_CHECKING:
    import xarray

    from .bilge_keels import BilgeKeels
    from .decay import DecayFit
    from .sections import Sections

# Largest number of rows in the table of a long record.
MOST_SWINGS = 12


def hull(sections: Sections, source: str, keel_to_gravity_m: float) -> str:
    """The hull and its main dimensions, from its sections."""
    widest = sections.midship
    depth = sections.draught_m.max() - keel_to_gravity_m
    rows = [
        ("hull", f"{source}, {len(sections.x_m)} sections"),
        ("length, beam, draught", f"{sections.total_length_m:.4g}, {sections.beam_m.max():.4g}, "
                                  f"{sections.draught_m.max():.4g} m"),
        ("volume", f"{sections.volume_m3:.6g} m3"),
        ("coefficients", f"block {sections.block_coefficient:.3f}, "
                         f"largest section {sections.midship_coefficient:.4f}"),
        ("bilge radius", f"{sections.bilge_radius_m[widest]:.3g} m at the largest section"),
        ("roll axis", f"{abs(depth):.4g} m {'under' if depth >= 0 else 'above'} the water plane"),
    ]  # fmt: skip
    return "\n".join(f"{name:<22}{value}" for name, value in rows)


def components(found: xarray.Dataset) -> str:
    """Equivalent linear damping by component and amplitude, and the coefficients."""
    shown = [name for name in COMPONENTS if float(found["damping"].sel(component=name).max()) > 0]
    labels = {"bilge_keel_force": "keels, force", "bilge_keel_pressure": "keels, pressure"}
    rows = [["amplitude", *(labels.get(name, name) for name in shown), "together", "B1, B2"],
            ["deg", *["N m s"] * (len(shown) + 2)]]  # fmt: skip
    for amplitude in found["amplitude"].values:
        at = found.sel(amplitude=amplitude)
        values = [float(at["damping"].sel(component=name)) for name in shown]
        values += [float(at["total"]), float(at["fitted"])]
        rows.append([f"{math.degrees(amplitude):.3g}", *(f"{value:.4g}" for value in values)])
    off = float(np.abs(found["fitted"] / found["total"] - 1).max())
    lines = table(rows, ">" * len(rows[0]))
    lines.append(
        f"B1 {float(found['linear']):.4g} N m s, B2 {float(found['quadratic']):.4g} N m s2: "
        f"equivalent damping within {off:.1%} of it"
    )
    return "\n".join(lines)


def second_opinion(sections: Sections, found: xarray.Dataset, keels: BilgeKeels | None) -> str:
    """Comparison of eddies and keels with the regression of Kawahara et al., at the amplitude nearest to 10
    degrees."""
    beam, draught = float(sections.beam_m.max()), float(sections.draught_m.max())
    depth = draught - found.attrs["keel_to_gravity_m"]
    form = simplified.HullForm(
        sections.block_coefficient, sections.midship_coefficient, beam / draught, depth / draught
    )
    amplitude = min(found["amplitude"].values, key=lambda value: abs(value - math.radians(10)))
    root = math.sqrt(beam / (2 * Water.gravity_m_s2))
    frequency = found.attrs["frequency_rad_s"] * root
    unit = found.attrs["density_kg_m3"] * sections.volume_m3 * beam**2 / root
    ratios = () if keels is None else (keels.breadth_m / beam, keels.length_m / sections.total_length_m)
    outside = form.outside()
    for name, value in zip(simplified.KEEL_RANGES, ratios, strict=False):
        least, most = simplified.KEEL_RANGES[name]
        if not least <= value <= most:
            outside.append(f"bilge keels' {name} {value:.3g} is not within {least:g} to {most:g}")
    # The regression overflows far outside its range.
    if outside:
        return f"no comparison with Kawahara et al. (2009): {'; '.join(outside)}"
    expected = [simplified.eddy(form, frequency, amplitude) * unit]
    ours = [float(found["damping"].sel(component="eddies", amplitude=amplitude))]
    names = ["eddies"]
    if ratios:
        expected.append(simplified.bilge_keels(form, frequency, amplitude, *ratios) * unit)
        both = found["damping"].sel(
            component=["bilge_keel_force", "bilge_keel_pressure"], amplitude=amplitude
        )
        ours.append(float(both.sum()))
        names.append("bilge keels")
    pairs = ", ".join(
        f"{name} {theirs:.4g} ({mine:.4g})" for name, theirs, mine in zip(names, expected, ours, strict=True)
    )
    at = f"{math.degrees(amplitude):.3g} deg"
    return f"by the regression of Kawahara et al. (2009) at {at}, N m s, ours in brackets: {pairs}"


def decay(found: DecayFit, source: str, inertia_kg_m2: float | None) -> str:
    """Results of a decay test: period, damping with its uncertainty, amplitudes."""
    rows = [
        ("record", f"{source}: {len(found.swings.time_s)} swings from "
                   f"{math.degrees(found.swings.amplitude_rad[0]):.3g} to "
                   f"{math.degrees(found.swings.amplitude_rad[-1]):.3g} deg"),
        ("natural period", f"{found.period_s:.5g} s, +- {_of_period(found):.1g} s"),
        ("roll about", f"{math.degrees(found.offset_rad):.3g} deg"),
        ("left over", f"{math.degrees(found.rms_rad):.2g} deg rms of the {found.model} model"),
    ]  # fmt: skip
    units = (("linear", "1/s", "N m s"), ("quadratic", "", "N m s2"), ("cubic", "s", "N m s3"))
    for (name, unit, moment), value in zip(units, found.damping, strict=True):
        if name in found.deviations:
            text = f"{value:.4g} +- {found.deviations[name]:.1g} {unit}".rstrip()
            of_inertia = "" if inertia_kg_m2 is None else f", {inertia_kg_m2 * value:.4g} {moment}"
            rows.append((f"{name} damping", f"{text} of the inertia{of_inertia}"))
    if inertia_kg_m2 is not None:
        rows.append(("inertia", f"{inertia_kg_m2:.5g} kg m2, added inertia included"))
    head = "\n".join(f"{name:<18}{value}" for name, value in rows)
    return "\n".join([head, "", *_swings(found, inertia_kg_m2)])


def of_forces(found: DecayFit, forces: Coefficients, inertia_kg_m2: float, waves: float) -> str:
    """The misfit of the linear and quadratic damping of a scenario to the measured damping."""
    seen = found.swings.amplitude_rad
    amplitudes = np.linspace(seen.min(), seen.max(), 20)
    whole = found.coefficients(inertia_kg_m2).equivalent(found.frequency_rad_s, amplitudes) - waves
    off = float(np.abs(forces.equivalent(found.frequency_rad_s, amplitudes) / whole - 1).max())
    least, most = np.degrees(amplitudes[[0, -1]])
    return f"\nthe forces' equivalent damping is within {off:.1%} of it from {least:.3g} to {most:.3g} deg"


def _of_period(found: DecayFit) -> float:
    return found.period_s * found.deviations["frequency"] / found.frequency_rad_s


def _swings(found: DecayFit, inertia_kg_m2: float | None) -> list[str]:
    """The damping of each swing, and that of the model."""
    seen = found.swings
    every = -(-len(seen.between_rad) // MOST_SWINGS)
    rows = [["amplitude", "period", "damping ratio", "of the model"], ["deg", "s", "", ""]]
    if inertia_kg_m2 is not None:
        rows = [[*rows[0], "B"], [*rows[1], "N m s"]]
    for k in range(0, len(seen.between_rad), every):
        amplitude = float(seen.between_rad[k])
        ratio = seen.decay_per_s[k] / (2 * found.frequency_rad_s)
        row = [f"{math.degrees(amplitude):.3g}", f"{2 * math.pi / seen.frequency_rad_s[k]:.4g}",
               f"{ratio:.5f}", f"{float(found.damping_ratio(amplitude)):.5f}"]  # fmt: skip
        if inertia_kg_m2 is not None:
            whole = Coefficients(*found.damping).equivalent(found.frequency_rad_s, amplitude)
            row.append(f"{inertia_kg_m2 * float(whole):.4g}")
        rows.append(row)
    return table(rows, ">" * len(rows[0]))
