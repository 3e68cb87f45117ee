"""Pictures of docs/validation.md: their style, and those of forces, coefficients and motions in waves."""

from __future__ import annotations

from typing import Any

import numpy as np

from ..roll_damping import Coefficients
from . import cylinders, flume_forces, rolling, spheres
from .measured import decay

OURS: dict[str, Any] = {"color": "#0072B2", "linewidth": 1.8, "marker": "o", "markersize": 4}
MEASURED: dict[str, Any] = {"color": "#D55E00", "linestyle": "none", "marker": "s"}
OTHERS: dict[str, Any] = {"color": "#444444", "linestyle": "none", "marker": "x", "markersize": 7}
LINE = OURS | {"marker": None}


def held_section(pyplot: Any) -> Any:
    """Draw the forces of beam waves on the held section, and the mean drift forces on the held and the free
    section."""
    figure, panels = pyplot.subplots(1, 3, figsize=(12, 3.9))
    at = sorted(flume_forces.HELD)
    ours = np.array([flume_forces.held(one) for one in at])
    theirs = np.array([flume_forces.HELD[one] for one in at])
    periods = 2 * np.pi / np.array(at)
    labels = ("sway force / (rho g L B a)", "heave force / (rho g L B a)", "mean sway force / (rho g L a²/2)")
    for panel, which, label in zip(panels, range(3), labels, strict=True):
        panel.plot(periods, ours[:, which], label="Kingpost, held", **OURS)
        panel.plot(periods, theirs[:, which], label="measured, held", **MEASURED)
        panel.set(ylabel=label, xlabel="period of the wave, s", ylim=(0, 1.12 * theirs[:, which].max()))
    low, high = np.array([flume_forces.SPREAD.get(one, (np.nan, np.nan)) for one in at]).T
    panels[2].vlines(periods, low, high, color=MEASURED["color"], linewidth=1.2)
    loose = np.array(
        [(2 * np.pi / one, flume_forces.free(one), mean) for one, mean in flume_forces.FREE.items()]
    )
    green = {"color": "#009E73"}
    panels[2].plot(loose[:, 0], loose[:, 1], label="Kingpost, free", **(OURS | green | {"linestyle": ":"}))
    panels[2].plot(loose[:, 0], loose[:, 2], label="measured, free", **(MEASURED | green | {"marker": "^"}))
    panels[2].set(ylim=(0, 1.35))
    panels[0].legend(fontsize=9, loc="lower center")
    panels[1].legend(fontsize=9)
    panels[2].legend(fontsize=9, ncols=2, loc="lower left")
    return figure


def vugts(pyplot: Any) -> Any:
    """Draw added mass, damping and wave force of two cylinders, sway above and heave below."""
    figure, rows = pyplot.subplots(2, 3, figsize=(12, 6.6), sharex=True)
    names = {"a": "added mass / (rho A)", "b": "damping √(B/2g) / (rho A)", "F": "wave force"}
    units = {"2": "sway", "3": "heave"}
    forces = {"2": "wave force / (rho g k A)", "3": "wave force / (rho g B)"}
    looks = {"circle": ("#0072B2", "o", "half circle"), "rectangle": ("#D55E00", "s", "rectangle")}
    for panels, (motion, title) in zip(rows, units.items(), strict=True):
        for panel, (letter, label) in zip(panels, names.items(), strict=True):
            quantity = letter + motion * (1 if letter == "F" else 2)
            for shape, (colour, mark, name) in looks.items():
                ours = cylinders.section(shape).values[quantity]
                panel.plot(cylinders.SHARES, ours, color=colour, label=f"Kingpost, {name}")
                points = np.array(cylinders.VUGTS[shape][quantity])
                panel.plot(*points.T, color=colour, marker=mark, linestyle="none", label=f"measured, {name}")
            panel.set(ylabel=f"{title}: {forces[motion] if letter == 'F' else label}", ylim=(0, None))
    for panel in rows[1]:
        panel.set(xlabel="omega √(B/2g)")
    rows[0][0].legend(fontsize=9)
    return figure


def tanker(pyplot: Any) -> Any:
    """Draw the measured and the computed decay of a tanker's model, and the damping over the amplitude."""
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(11, 4.2))
    number = np.arange(len(rolling.SWINGS))
    left.plot(number, rolling.decay()[1][: len(number)], label="Kingpost, damping from its sections", **LINE)
    left.plot(number, rolling.SWINGS, label="measured, run 21338", **(MEASURED | {"markersize": 5}))
    left.set(xlabel="swing", ylabel="roll, degrees", ylim=(0, None))
    degrees = np.linspace(2.0, 10.0, 33)
    found = rolling.tanker(np.radians(degrees))
    parts = [np.full(len(degrees), rolling.RADIATED[1])]
    parts += [found.damping.sel(component=name).values for name in ("friction", "eddies")]
    names = ("Kingpost: waves", "friction", "eddies")
    right.stackplot(degrees, parts, labels=names, colors=("#9ecae1", "#4292c6", "#084594"), alpha=0.85)
    for number, (run, (omega, *b)) in enumerate(rolling.FITTED.items()):
        style = {"color": MEASURED["color"], "linestyle": ("-", "--")[number], "linewidth": 2}
        curve = Coefficients(*b).equivalent(omega, np.radians(degrees))
        right.plot(degrees, curve, label=f"measured, run {run}", **style)
    right.set(xlabel="amplitude, degrees", ylabel="equivalent damping of the model, N m s", xlim=(2, 10))
    left.legend(fontsize=9)
    right.legend(fontsize=9, loc="upper left")
    return figure


def eddies(pyplot: Any) -> Any:
    """Draw computed against measured eddies of ten cylinders, on logarithmic scales."""
    figure, axes = pyplot.subplots(figsize=(5.6, 5.2))
    ends = np.array([0.01, 12.0])
    axes.loglog(ends, ends, color="#444444", linewidth=1)
    axes.fill_between(ends, 0.75 * ends, 1.25 * ends, color="#dddddd", label="within 25 %")
    for i, (name, *_, theirs) in enumerate(rolling.CYLINDERS):
        ours = rolling.eddies(i)
        axes.plot(
            theirs, [ours] * len(theirs), color=MEASURED["color"], marker="o", markersize=5, linewidth=1
        )
        axes.annotate(name, (max(theirs), ours), xytext=(6, -4), textcoords="offset points")
    axes.set(xlabel="C_R measured, Ikeda et al. 1977", ylabel="C_R by Kingpost", xlim=ends, ylim=ends)
    axes.set_aspect("equal")
    axes.legend(fontsize=9, loc="upper left")
    return figure


def oes(pyplot: Any) -> Any:
    """Draw the differences in height and time of a dropped sphere's extrema from those of the Navier-Stokes
    code."""
    figure, panels = pyplot.subplots(1, 2, figsize=(11, 4.2))
    count = len(spheres.NAVIER_STOKES[0])
    number = np.arange(1, count + 1)
    ours = tuple(one[:count] for one in decay())
    codes = {"Kingpost": ours} | spheres.LINEAR | {"MARIN, hull's true form": spheres.TRUE_HULL}
    marks = ("o", "x", "+", "v", "^", "s")
    sign = np.sign(spheres.NAVIER_STOKES[1])
    for (name, (times, heights)), mark in zip(codes.items(), marks, strict=True):
        style = OURS if name == "Kingpost" else OTHERS | {"marker": mark, "fillstyle": "none"}
        miss = 100 * sign * (np.array(heights) - spheres.NAVIER_STOKES[1])
        panels[0].plot(number, miss, label=name, **style)
        panels[1].plot(number, np.array(times) - spheres.NAVIER_STOKES[0], label=name, **style)
    labels = ("size less Navier-Stokes, % of the drop", "time less Navier-Stokes, s")
    for panel, label in zip(panels, labels, strict=True):
        panel.axhline(0, color=MEASURED["color"], linewidth=1)
        panel.set(xlabel="extremum", ylabel=label, xticks=number)
    panels[1].legend(fontsize=9, loc="lower left")
    return figure


def sphere_drift(pyplot: Any) -> Any:
    """Draw the mean drift force of a free hemisphere, with two results of WAMIT."""
    figure, axes = pyplot.subplots(figsize=(7.5, 4.4))
    k = np.array(list(spheres.WAMIT)) ** 2 / spheres.GRAVITY_M_S2
    theirs = np.array(list(spheres.WAMIT.values()))
    axes.plot(k, spheres.drift(), label="Kingpost, far field, 900 panels", **OURS)
    axes.plot(k, theirs[:, 0], label="WAMIT, momentum, 200 panels", **OTHERS)
    axes.plot(
        k, theirs[:, 1], label="WAMIT, pressure, 200 panels", **(OTHERS | {"marker": "+", "markersize": 9})
    )
    axes.set(xlabel="k R", ylabel="mean surge force / (rho g R a²)", ylim=(0, None))
    axes.legend(fontsize=9)
    return figure
