"""Motions of the fairleads of a moored ship, for `moored_lines.py`.

    python python/tests/peers/fairleads.py -o python/kingpost/verify/fairleads.json

computes them again, in two minutes: the gallery's `offshore_vessel_moored_quasi_static` on four lines with
mass instead of massless chains that damp its motions, in seas of 2.5 and 5 m.

A motion is its speeds at equal times, in mm/s, with straight lines between them: those whose integral is
nearest to the record.
"""

from __future__ import annotations

import argparse
import json
import math
import re
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr
from kingpost import gallery
from kingpost.scenario import Scenario
from kingpost.simulation.simulate import run

COMMAND = "python python/tests/peers/fairleads.py -o python/kingpost/verify/fairleads.json"
FROM = "offshore_vessel_moored_quasi_static"
HEIGHTS_M = {"moderate": 2.5, "high": 5.0}
KEPT = {"windward": "starboard_bow", "leeward": "port_stern", "side": "starboard_stern"}
"""The line with the largest tensions, its opposite, and the other one of the loaded side."""
EVERY_S = 0.5
DURATION_S = 300.0
SECTION = {
    "diameter_m": 0.1139,
    "drag_across": 1.3,
    "drag_along": 0.05,
    "added_mass_across": 1.0,
    "added_mass_along": 0.5,
    "damping_time_s": 0.01,
}
FRICTION = 0.7
GRAVITY_M_S2, DENSITY_KG_M3 = 9.80665, 1025.0


def massless() -> Scenario:
    """The ship of the gallery, on massless chains that damp its motions."""
    path = gallery.find(FROM)
    return Scenario(gallery.read_text(path), str(path))


def moored(height_m: float, elements: int = 20, duration_s: float = DURATION_S) -> Scenario:
    """The ship on lines as long, heavy and stiff as its chains, in a sea of this height."""
    model = massless().resolved
    points = model["bodies"]["hull"]["points"]
    for name, force in model["forces"].items():
        if "catenary_line" in force:
            points[name] = {"position_m": force["catenary_line"]["fairlead"]["position_m"]}
            model["forces"][name] = {"line": with_mass(force["catenary_line"], elements)}
    del model["forces"]["chains"]
    model["sea"]["waves"]["wind_sea"]["jonswap"]["significant_height_m"] = height_m
    model["simulation"] |= {"duration_s": duration_s, "record_every_s": 0.05}
    return Scenario(json.dumps(model), massless().file)


def with_mass(chain: dict[str, Any], elements: int) -> dict[str, Any]:
    """A `line` instead of a `catenary_line`, on a bottom as deep as its anchor."""
    displaced = DENSITY_KG_M3 * math.pi / 4 * SECTION["diameter_m"] ** 2
    section = SECTION | {
        "unstretched_length_m": chain["unstretched_length_m"],
        "mass_kg_per_m": chain["weight_in_water_N_per_m"] / GRAVITY_M_S2 + displaced,
        "axial_stiffness_N": chain["axial_stiffness_N"],
        "elements": elements,
    }
    return {
        "first": chain["fairlead"],
        "second": {"body": "world", "position_m": chain["anchor_m"]},
        "sections": [section],
        "seabed": {"depth_m": -chain["anchor_m"][2], "friction": FRICTION},
    }


def speeds(t: np.ndarray, places: np.ndarray) -> np.ndarray:
    """Speeds every half second whose integral is nearest to these places, from rest, rounded to mm/s.

    >>> t = np.arange(0.0, 2.01, 0.05)
    >>> speeds(t, 0.1 * t[:, None] ** 2).ravel()
    array([  0, 100, 200, 300, 400])
    """
    knots = EVERY_S * np.arange(round(t[-1] / EVERY_S) + 1)
    later = t[:, None] - knots[None, :]

    def twice(s: np.ndarray) -> np.ndarray:
        """Twofold integral of a jump of the acceleration."""
        return np.maximum(s, 0.0) ** 2 / 2

    hats = (twice(later + EVERY_S) - 2 * twice(later) + twice(later - EVERY_S)) / EVERY_S
    found = np.linalg.lstsq(hats[:, 1:], places - places[0], rcond=None)[0]
    return np.round(1e3 * np.vstack([np.zeros(places.shape[1]), found])).astype(int)


def motion(found: xr.Dataset, name: str) -> dict[str, Any]:
    """Start, and speeds along x, y and z, of a fairlead."""
    places = found["point_position"].sel(point=f"hull.{name}").values
    way = speeds(found["time"].values, places)
    return {
        "start_m": [round(float(one), 4) for one in places[0]],
        **{f"speed_{axis}_mm_s": way[:, i].tolist() for i, axis in enumerate("xyz")},
    }


def line(name: str) -> dict[str, Any]:
    """Properties of a line, without its elements."""
    force = moored(1.0).resolved["forces"][name]["line"]
    section = {key: value for key, value in force["sections"][0].items() if key != "elements"}
    ground = {"depth_m": force["seabed"]["depth_m"], "friction": FRICTION}
    return section | {"anchor_m": force["second"]["position_m"]} | ground


def main() -> None:
    """Runs the command line."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("-o", "--output", type=Path, required=True, help="the file to write")
    output = parser.parse_args().output
    runs = {sea: run(moored(height_m)) for sea, height_m in HEIGHTS_M.items()}
    motions = {sea: {side: motion(found, name) for side, name in KEPT.items()} for sea, found in runs.items()}
    written = {
        "command": COMMAND,
        "every_s": EVERY_S,
        "duration_s": DURATION_S,
        "heights_m": HEIGHTS_M,
        "lines": {side: line(name) for side, name in KEPT.items()},
        "motions": motions,
    }
    text = re.sub(r"\[[^][]*\]", lambda one: " ".join(one[0].split()), json.dumps(written, indent=1))
    output.write_text(text + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
