"""Pictures of docs/validation.md (curves of the engine with measurements and computations of others) and of
docs/control.md."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from .. import output
from ..analysis import response
from ..paper.style import plotting
from . import pictures
from .control import frequency
from .hydrodynamics import HULME, SOLVED, heave
from .measured import FLUME_FREQUENCIES, KRAMER, OES, RECORDS, decay, flume_response
from .models import G
from .pictures import MEASURED, OTHERS, OURS
from .response import RADIUS, convolved, hulme_heave


def draw(folder: Path) -> list[Path]:
    """Draw every picture as PNG into an existing folder, and return their names."""
    written = []
    with plotting() as pyplot:
        for name, picture in PICTURES.items():
            figure = picture(pyplot)
            written.append(folder / f"{name}.png")
            with output.whole(written[-1]) as beside:
                figure.savefig(beside, dpi=110, metadata={"Software": None})
            pyplot.close(figure)
    return written


def _decay(pyplot: Any) -> Any:
    """Draw the successive extrema of a dropped sphere."""
    figure, axes = pyplot.subplots(figsize=(7.5, 4.4))
    number = np.arange(1, len(KRAMER) + 1)
    axes.semilogy(number, np.abs(decay()[1][: len(KRAMER)]), label="Kingpost", **OURS)
    axes.semilogy(number, np.abs(KRAMER), label="measured, Kramer et al. 2021", **MEASURED)
    axes.semilogy([1] * len(OES), np.abs(OES), label="four linear codes, OES Task 10", **OTHERS)
    theirs = [abs(convolved(i)) for i in range(3)]
    hulme = OTHERS | {"color": "#009E73", "marker": "+", "markersize": 12}
    axes.semilogy(number[:3], theirs, label="Hulme's table, convolved", **hulme)
    axes.set(xlabel="extremum of heave", ylabel="height over the drop", xticks=number)
    axes.legend()
    return figure


def _flume(pyplot: Any) -> Any:
    """Draw sway, heave and roll of the section in beam waves."""
    figure, panels = pyplot.subplots(1, 3, figsize=(12, 3.9))
    periods = 2 * np.pi / FLUME_FREQUENCIES
    ours = np.array([flume_response(omega) for omega in FLUME_FREQUENCIES])
    at = 2 * np.pi / np.array(list(RECORDS))
    records = np.array(list(RECORDS.values()))
    titles = ("sway, m/m", "heave, m/m", "roll, rad/m")
    for panel, motion, title in zip(panels, range(3), titles, strict=True):
        panel.plot(periods, ours[:, motion], label="Kingpost", **(OURS | {"linestyle": ":", "linewidth": 1}))
        panel.set(title=title, xlabel="period of the wave, s")
    panels[0].plot(at, records[:, 2], label="measured", **MEASURED)
    panels[1].plot(at, records[:, 0], label="measured, camera", **MEASURED)
    panels[1].plot(at, records[:, 1], label="measured, accelerometers", **(MEASURED | {"marker": "^"}))
    panels[2].plot(at, records[:, 3], label="measured", **MEASURED)
    for panel in panels:
        panel.legend(fontsize=9)
    return figure


def _hemisphere(pyplot: Any) -> Any:
    """Draw added mass and damping with Hulme's table, and the heave in waves by this table."""
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(11, 4.0))
    table = np.array([(ka, *values) for ka, values in HULME.items()])
    found = np.array([heave(ka) for ka in SOLVED])
    for i, (name, colour) in enumerate((("added mass", "#0072B2"), ("damping", "#D55E00"))):
        theirs = OTHERS | {"color": colour, "label": f"{name}, Hulme 1982"}
        left.semilogx(table[:, 0], table[:, 1 + i], **theirs)
        ours = OURS | {"color": colour, "linestyle": "none", "fillstyle": "none", "markersize": 7}
        left.semilogx(SOLVED, found[:, i], label=f"{name}, Kingpost", **ours)
    left.set(xlabel="k a", ylabel="over the displaced mass")
    ka, fine = [one for one in HULME if one <= 3.0], np.linspace(0.1, 3.0, 120)
    answer = response.rao("floating_hemisphere", [0.0], np.sqrt(G * fine / RADIUS), ["hemisphere"])
    heaves = answer.displacement.sel(point="hemisphere", axis="z").values[0]
    right.plot(fine, heaves, label="Kingpost", **(OURS | {"marker": None}))
    right.plot(
        ka, [abs(hulme_heave(one)) for one in ka], label="Hulme's table with Haskind's force", **OTHERS
    )
    right.set(xlabel="k a", ylabel="heave for each metre of wave")
    for panel in (left, right):
        panel.legend(fontsize=9)
    return figure


PICTURES = {
    "sphere_decay": _decay,
    "flume": _flume,
    "flume_forces": pictures.held_section,
    "vugts": pictures.vugts,
    "tanker": pictures.tanker,
    "eddies": pictures.eddies,
    "oes_sphere": pictures.oes,
    "sphere_drift": pictures.sphere_drift,
    "hemisphere": _hemisphere,
    "heave_residual": frequency.picture,
}
"""Drawing function of each picture, by name."""
