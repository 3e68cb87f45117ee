"""Figures 9 to 11 of the paper: pitch, yaw and roll rate of the ship, damped and undamped."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from .. import output
from ..scenario import load
from ..simulation.simulate import Simulation
from .style import DAMPED, UNDAMPED, plotting, save

if TYPE_CHECKING:
    import pandas
    import xarray

STEP_S = 0.001
DURATION_S = 3.0
RATES = {"pitch": "y", "yaw": "z", "roll": "x"}
"""The paper's w1, w2, w3, left to right, and the ship's axis of each."""
NOTHING = 1e-9
"""Rates below this are rounding errors, rad/s."""
AT_CENTRE = {"crane_x_m": 0.0, "crane_y_m": 0.0, "load": False}


@dataclass(frozen=True)
class Case:
    """Case of one figure: the motors that are on."""

    number: int
    title: str
    motors: dict[str, bool]


CASES = (
    Case(9, "tower motor", {"motor_1": True, "motor_2": False}),
    Case(10, "arm motor", {"motor_1": False, "motor_2": True}),
    Case(11, "both motors", {"motor_1": True, "motor_2": True}),
)


@dataclass(frozen=True)
class Figure:
    """Results of a case: rates in rad/s by name, undamped and damped."""

    case: Case
    time_s: np.ndarray
    undamped: dict[str, np.ndarray]
    damped: dict[str, np.ndarray]

    @property
    def name(self) -> str:
        """Name of the files of the figure, without the ending."""
        return f"figure_{self.case.number}"

    def table(self) -> pandas.DataFrame:
        """The numbers of the figure, one row per record."""
        import pandas

        columns = {"time_s": self.time_s}
        columns |= {f"{name}_rate_rad_s": values for name, values in self.undamped.items()}
        columns |= {f"{name}_rate_damped_rad_s": values for name, values in self.damped.items()}
        return pandas.DataFrame(columns)


def simulate(case: Case, **parameters: object) -> xarray.Dataset:
    """Run one case: crane at the centre, load off, constant torque, RK4 at 1 ms, with a record of each step.

    Peaks between records of 10 ms would be up to 1 % higher.
    """
    overrides = {
        **AT_CENTRE,
        **case.motors,
        "simulation.duration_s": DURATION_S,
        "simulation.record_every_s": STEP_S,
    }
    return Simulation(load("paper", overrides | parameters)).run()


def rates(results: xarray.Dataset, body: str = "ship") -> dict[str, np.ndarray]:
    """Pitch, yaw and roll rate: the body's angular velocity about its y, z and x axis, rad/s."""
    velocity = results["angular_velocity"].sel(body=body)
    return {name: velocity.sel(axis=axis).values for name, axis in RATES.items()}


def run(progress: Callable[[], None]) -> list[Figure]:
    """Run the three cases, each damped and undamped."""
    figures = []
    for case in CASES:
        undamped = simulate(case, damping=False)
        progress()
        damped = simulate(case, damping=True)
        progress()
        figures.append(Figure(case, undamped["time"].values, rates(undamped), rates(damped)))
    return figures


def write(folder: Path, figures: list[Figure]) -> None:
    """Write each figure as PNG, SVG and CSV."""
    for figure in figures:
        output.write_csv(figure.table(), folder / f"{figure.name}.csv")
        draw(folder, figure)


def draw(folder: Path, figure: Figure) -> None:
    """Draw one figure: three panels on one scale, rad/s to the left and degrees/s to the right."""
    from matplotlib.ticker import MultipleLocator

    with plotting() as pyplot:
        drawn, panels = pyplot.subplots(1, 3, figsize=(11, 3.9), sharex=True, sharey=True)
        for panel, name in zip(panels, RATES, strict=True):
            panel.plot(figure.time_s, figure.undamped[name], label="without damping", **UNDAMPED)
            panel.plot(figure.time_s, figure.damped[name], label="with damping", **DAMPED)
            panel.set(title=f"{name.capitalize()} rate", xlabel="Time, s")
            panel.set_xlim(0, figure.time_s[-1])
            panel.xaxis.set_major_locator(MultipleLocator(1))
            panel.xaxis.set_minor_locator(MultipleLocator(0.5))
            if np.abs(figure.undamped[name]).max() < NOTHING:
                plain = {"facecolor": "white", "edgecolor": "none", "pad": 2}
                panel.annotate(
                    "zero, by symmetry", (0.5, 0.85), xycoords="axes fraction", ha="center", bbox=plain
                )
        panels[0].set_ylabel("Angular velocity of the ship, rad/s")
        degrees = panels[-1].secondary_yaxis("right", functions=(np.degrees, np.radians))
        degrees.set_ylabel("degrees/s")
        drawn.legend(*panels[0].get_legend_handles_labels(), loc="outside upper right", ncols=2)
        title = f"Fig. {figure.case.number}: {figure.case.title}, crane at the centre, no load"
        drawn.suptitle(title, x=0.01, ha="left")
        save(drawn, folder / figure.name)
