"""Lines with mass by MoorDyn alone, for `kingpost verify --only lines`.

    pip install moordyn numpy
    python python/tests/peers/lines.py -o python/kingpost/verify/lines.json

gives the figures again, in ten minutes; with `--only chain-small-40` just those of one run. Nothing of
Kingpost is used.

Chain: 850 m of studless chain from a fairlead to an anchor, partly on a level bottom without friction
(`rest`); its fairlead moves in heave and surge with two periods (`small`, `large`). Wire: 3000 m of steel
wire with a load at its end, in deep water; its upper end moves in heave by half a metre (`half`). Motions
grow from rest by a polynomial of fifth degree.

Tension: that at the very end of the line, from the force of MoorDyn on its coupled point, less mass times
acceleration of the half node there. MoorDyn's own output is the tension of the last segment, which lacks
weight and inertia of this half node. After a step, forces are those of the last stage of MoorDyn's scheme,
half a step before its end: each sample is the mean of two of them.

Steps: one call of MoorDyn for each of its own steps, because it extrapolates the coupled point within a call.
"""

from __future__ import annotations

import argparse
import json
import os
import re
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from importlib.metadata import version
from pathlib import Path
from typing import Any

import moordyn
import numpy as np

COMMAND = "python python/tests/peers/lines.py -o python/kingpost/verify/lines.json"
SEA = {
    "gravity_m_s2": 9.80665,
    "density_kg_m3": 1025.0,
    "ground_stiffness_N_per_m3": 3e6,
    "ground_damping_N_s_per_m3": 3e5,
}
CHAIN = {
    "unstretched_length_m": 850.0,
    "mass_kg_per_m": 685.0,
    "diameter_m": 0.333,
    "axial_stiffness_N": 3.27e9,
    "damping_time_s": 0.02,
    "added_mass_across": 1.0,
    "added_mass_along": 0.5,
    "drag_across": 1.2,
    "drag_along": 0.05,
    "fairlead_m": [0.0, 0.0, -14.0],
    "anchor_m": [779.6, 0.0, -200.0],
    "depth_m": 200.0,
}
WIRE = {
    "unstretched_length_m": 3000.0,
    "mass_kg_per_m": 30.0,
    "diameter_m": 0.08,
    "axial_stiffness_N": 8e8,
    "damping_time_s": 0.01,
    "added_mass_across": 1.0,
    "added_mass_along": 0.0,
    "drag_across": 1.2,
    "drag_along": 0.0,
    "fairlead_m": [0.0, 0.0, -5.0],
    "depth_m": 3500.0,
    "load_kg": 80e3,
    "load_volume_m3": 80e3 / 7850,
    "load_added_mass_kg": 200e3,
}
LINES = {"chain": CHAIN, "wire": WIRE}


def _periodic(amplitude_m: float, period_s: float, phase_rad: float = 0.0) -> dict[str, float]:
    return {"amplitude_m": amplitude_m, "period_s": period_s, "phase_rad": phase_rad}


MOTIONS = {
    "chain-rest": {"duration_s": 5.0, "from_s": 0.0},
    "chain-small": {
        "surge": _periodic(1.5, 11.0, 0.7),
        "heave": _periodic(2.5, 9.0),
        "ramp_s": 20.0,
        "duration_s": 200.0,
        "from_s": 100.0,
    },
    "chain-large": {
        "surge": _periodic(3.0, 11.0, 0.7),
        "heave": _periodic(5.0, 9.0),
        "ramp_s": 20.0,
        "duration_s": 200.0,
        "from_s": 100.0,
    },
    "wire-half": {"heave": _periodic(0.5, 8.0), "ramp_s": 24.0, "duration_s": 120.0, "from_s": 80.0},
}
"""Motions of the fairlead; statistics are those from `from_s` on."""
STEPS_S = {
    "chain-rest": {40: 5e-4, 160: 1e-4},
    "chain-small": {40: 2.5e-4, 160: 1e-4},
    "chain-large": {40: 2.5e-4, 160: 1e-4},
    "wire-half": {40: 5e-4, 80: 5e-4},
}
"""MoorDyn's steps by the number of segments."""
AT_REST = {
    "chain": {40: (5e-3, 1e-7), 160: (2.5e-3, 1e-7)},
    "wire": {40: (5e-3, 1e-9), 80: (2e-3, 1e-9)},
}
"""Step and threshold of MoorDyn's relaxation to rest."""
EVERY_S = 0.05
SLIDING_M_S = 0.01
"""Speed at which a node that rests on the bottom slides, where there is friction."""
KEPT = 5
"""Of the samples every 0.05 s, from which the statistics are, each fifth is kept."""


def friction(line: dict[str, Any], segments: int) -> str:
    """Coulomb friction of MoorDyn: below the sliding speed it is viscous, by a constant for all nodes."""
    if "friction" not in line:
        return "0.0 FrictionCoefficient"
    water = SEA["density_kg_m3"] * np.pi / 4 * line["diameter_m"] ** 2
    node = (line["mass_kg_per_m"] - water) * SEA["gravity_m_s2"] * line["unstretched_length_m"] / segments
    return f"{line['friction']!r} FrictionCoefficient\n{float(node / SLIDING_M_S)!r} FricDamp"


def deck(line: dict[str, Any], segments: int, step_s: float, damping: float, options: str = "") -> str:
    """Write MoorDyn's file; a damping below zero is a share of the critical one, with the sign changed."""
    if "anchor_m" in line:
        far = ["Fixed", *line["anchor_m"], 0, 0, 0, 0]
    else:
        volume = line["load_volume_m3"]
        added = line["load_added_mass_kg"] / (SEA["density_kg_m3"] * volume)
        far = ["Free", 0.0, 0.0, load_height(line, segments), line["load_kg"], volume, 0, added]
    kind = [line[name] for name in ("diameter_m", "mass_kg_per_m", "axial_stiffness_N")]
    water = [line[name] for name in ("drag_across", "added_mass_across", "drag_along", "added_mass_along")]

    def row(*values: Any) -> str:
        return " ".join(str(one) for one in values)

    return f"""MoorDyn v2 input
---------------------- LINE TYPES ----------------------
TypeName Diam Mass/m EA BA/-zeta EI Cd Ca CdAx CaAx
(name) (m) (kg/m) (N) (N-s/-) (N-m^2) (-) (-) (-) (-)
line {row(*kind, damping, 0, *water)}
---------------------- POINTS ----------------------
ID Attachment X Y Z Mass Volume CdA Ca
(#) (-) (m) (m) (m) (kg) (m^3) (m^2) (-)
{row(1, *far)}
{row(2, "Coupled", *line["fairlead_m"], 0, 0, 0, 0)}
---------------------- LINES ----------------------
ID LineType AttachA AttachB UnstrLen NumSegs LineOutputs
(#) (name) (#) (#) (m) (-) (-)
{row(1, "line", 1, 2, line["unstretched_length_m"], segments, "-")}
---------------------- OPTIONS ----------------------
0 writeLog
{step_s!r} dtM
{SEA["gravity_m_s2"]!r} g
{SEA["density_kg_m3"]!r} rho
{line["depth_m"]!r} WtrDpth
{SEA["ground_stiffness_N_per_m3"]!r} kBot
{SEA["ground_damping_N_s_per_m3"]!r} cBot
{friction(line, segments)}
0 WaveKin
1 disableOutput
1 disableOutTime
1e9 dtOut
{options}---------------------- need this line ----------------------
"""


def load_height(line: dict[str, Any], segments: int) -> float:
    """Height of the load under the wire at rest, m; each segment bears the weight below its middle."""
    gravity, density = SEA["gravity_m_s2"], SEA["density_kg_m3"]
    load = (line["load_kg"] - density * line["load_volume_m3"]) * gravity
    per_m = (line["mass_kg_per_m"] - density * np.pi / 4 * line["diameter_m"] ** 2) * gravity
    length = line["unstretched_length_m"] / segments
    tensions = load + per_m * length * (0.5 + np.arange(segments))
    return float(line["fairlead_m"][2] - np.sum(length * (1 + tensions / line["axial_stiffness_N"])))


@contextmanager
def _quiet() -> Iterator[None]:
    """Keep what MoorDyn prints from the terminal."""
    shown, nowhere = os.dup(1), os.open(os.devnull, os.O_WRONLY)
    os.dup2(nowhere, 1)
    try:
        yield
    finally:
        os.dup2(shown, 1)
        os.close(shown)
        os.close(nowhere)


@contextmanager
def _system(text: str, folder: str) -> Iterator[Any]:
    path = Path(folder) / "line.txt"
    path.write_text(text, encoding="utf-8")
    with _quiet():
        system = moordyn.Create(str(path))
        moordyn.SetVerbosity(system, moordyn.LEVEL_ERR)
    try:
        yield system
    finally:
        moordyn.Close(system)


def rest(line: dict[str, Any], segments: int, relaxed: tuple[float, float], folder: str) -> str:
    """Let MoorDyn find the line at rest, without friction, by this step and threshold; returns the file of
    this state."""
    step_s, threshold = relaxed
    line = {name: value for name, value in line.items() if name != "friction"}
    options = f"{threshold} threshIC\n20000 TmaxIC\n1.0 dtIC\n"
    damping = -0.5 if "anchor_m" in line else line["axial_stiffness_N"] * line["damping_time_s"]
    state = str(Path(folder) / "rest.ic")
    with _system(deck(line, segments, step_s, damping, options), folder) as system, _quiet():
        moordyn.Init(system, line["fairlead_m"], [0.0, 0.0, 0.0])
        moordyn.SaveState(system, state)
    return state


def place(motion: dict[str, Any], fairlead: list[float], t: np.ndarray) -> np.ndarray:
    """Positions of the fairlead at these times, m."""
    share = np.clip(t / motion.get("ramp_s", 1.0), 0.0, 1.0)
    ramp = share**3 * (10 - 15 * share + 6 * share**2)
    places = np.tile(fairlead, (len(t), 1))
    for axis, way in ((0, "surge"), (2, "heave")):
        if way in motion:
            one = motion[way]
            turned = 2 * np.pi / one["period_s"] * t + one["phase_rad"]
            places[:, axis] += one["amplitude_m"] * ramp * np.sin(turned)
    return places


def run(name: str, segments: int, step_s: float, duration_s: float | None = None) -> np.ndarray:
    """Tension at the fairlead every 0.05 s of a motion, N."""
    of, motion = name.split("-")[0], MOTIONS[name]
    line = LINES[of]

    def places(t: np.ndarray) -> np.ndarray:
        return place(motion, line["fairlead_m"], t)

    return follow(line, segments, (step_s, AT_REST[of][segments]), places, duration_s or motion["duration_s"])


def follow(
    line: dict[str, Any],
    segments: int,
    steps: tuple[float, tuple[float, float]],
    places: Callable[[np.ndarray], np.ndarray],
    duration_s: float,
) -> np.ndarray:
    """Tension at the fairlead every 0.05 s, N, of a line whose fairlead is at these places at given times, by
    this step, and the step and threshold of the relaxation."""
    step_s, relaxed = steps
    with tempfile.TemporaryDirectory() as folder:
        return moved(line, segments, (step_s, rest(line, segments, relaxed, folder)), places, duration_s)


def moved(
    line: dict[str, Any],
    segments: int,
    start: tuple[float, str],
    places: Callable[[np.ndarray], np.ndarray],
    duration_s: float,
) -> np.ndarray:
    """Tension as of `follow`, by this step, from the state in this file."""
    step_s, state = start
    per_sample, apart = round(EVERY_S / step_s), 1e-3
    damping = line["axial_stiffness_N"] * line["damping_time_s"]
    with (
        tempfile.TemporaryDirectory() as folder,
        _system(deck(line, segments, step_s, damping), folder) as system,
    ):
        with _quiet():
            moordyn.Init_NoIC(system, line["fairlead_m"], [0.0, 0.0, 0.0])
            moordyn.LoadState(system, state)
        chain, tensions, before = moordyn.GetLine(system, 1), [], None
        for sample in range(round(duration_s / EVERY_S) + 1):
            t = sample * EVERY_S + step_s * np.arange(per_sample + 1)
            x = places(t)
            v = (np.diff(x, axis=0) / step_s).tolist()
            for i, (at, to) in enumerate(zip(x.tolist(), v, strict=False)):
                force = np.array(moordyn.Step(system, at, to, float(t[i]), step_s)[:3])
                if i == 0:
                    after, mass = force, np.array(moordyn.GetLineNodeM(chain, segments))
            near = places(t[0] + apart * np.array([-1.0, 0.0, 1.0]))
            acceleration = (near[0] - 2 * near[1] + near[2]) / apart**2
            mean = after if before is None else (before + after) / 2
            tensions.append(float(np.linalg.norm(mean - mass @ acceleration)))
            before = force
    return np.array(tensions)


def packed(name: str, step_s: float, tensions: np.ndarray) -> dict[str, Any]:
    """The part of a run that is written."""
    if name.endswith("rest"):
        drift = float(np.ptp(tensions))
        return {"step_s": step_s, "tension_N": round(float(tensions[-1]), 2), "drift_N": round(drift, 2)}
    late = tensions[round(MOTIONS[name]["from_s"] / EVERY_S) :]
    figures = {"mean_N": late.mean(), "std_N": late.std(), "max_N": late.max(), "min_N": late.min()}
    return {
        "step_s": step_s,
        **{key: round(float(one), 1) for key, one in figures.items()},
        "tension_N": [round(float(one)) for one in tensions[::KEPT]],
    }


def runs() -> dict[str, tuple[str, int, float]]:
    """Every run by its name: motion, segments, step."""
    return {
        f"{name}-{segments}": (name, segments, step_s)
        for name, steps in STEPS_S.items()
        for segments, step_s in steps.items()
    }


def figures(found: dict[str, dict[str, Any]]) -> dict[str, Any]:
    """All that is written, from the parts of these runs."""
    lines: dict[str, Any] = {name: dict(line) for name, line in LINES.items()}
    for name, motion in MOTIONS.items():
        of, called = name.split("-")
        parts = {key: found[f"{name}-{key}"] for key in STEPS_S[name] if f"{name}-{key}" in found}
        lines[of][called] = motion | {"every_s": KEPT * EVERY_S, "segments": parts}
    return {"command": COMMAND, "moordyn": version("moordyn"), "sea": SEA, **lines}


def text(written: dict[str, Any]) -> str:
    """Write as JSON, innermost lists on a line each."""
    return re.sub(r"\[[^][]*\]", lambda one: " ".join(one[0].split()), json.dumps(written, indent=1)) + "\n"


def main() -> None:
    """Runs the command line."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("-o", "--output", type=Path, required=True, help="the file to write")
    parser.add_argument("--only", nargs="+", choices=list(runs()), metavar="RUN", help="only these runs")
    options = parser.parse_args()
    found = {}
    for label, (name, segments, step_s) in runs().items():
        if options.only is None or label in options.only:
            found[label] = packed(name, step_s, run(name, segments, step_s))
    options.output.write_text(text(figures(found)), encoding="utf-8")


if __name__ == "__main__":
    main()
