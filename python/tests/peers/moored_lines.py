"""Lines of a moored ship by MoorDyn alone, for `kingpost verify --only lines`.

    pip install moordyn numpy
    python python/tests/peers/moored_lines.py -o python/kingpost/verify/moored_lines.json

gives the figures again, in half an hour; with `--only windward-high-40` just those of one run. Their
fairleads move as `fairleads.json` says, in still water; the bottom has friction. `lines.py` describes the
tension that is compared, and the steps.
"""

from __future__ import annotations

import argparse
import json
from importlib.metadata import version
from pathlib import Path
from typing import Any

import numpy as np
from lines import EVERY_S, SEA, SLIDING_M_S, follow, text

COMMAND = "python python/tests/peers/moored_lines.py -o python/kingpost/verify/moored_lines.json"
GIVEN = json.loads(
    (Path(__file__).resolve().parents[2] / "kingpost/verify/fairleads.json").read_text(encoding="utf-8")
)
STEPS_S = {40: (1e-3, (5e-3, 1e-7)), 80: (2.5e-4, (2.5e-3, 1e-7))}
"""MoorDyn's step by the number of segments, and step and threshold of its relaxation to rest."""
FROM_S = 60.0
"""Time from which statistics are: that when the sea has its full height."""


class Path3:
    """Positions of a fairlead: the integral of its speeds, with straight lines between them."""

    def __init__(self, motion: dict[str, Any]) -> None:
        self.speeds = 1e-3 * np.array([motion[f"speed_{axis}_mm_s"] for axis in "xyz"]).T
        ways = GIVEN["every_s"] * (self.speeds[1:] + self.speeds[:-1]) / 2
        self.places = np.array(motion["start_m"]) + np.vstack([np.zeros(3), np.cumsum(ways, axis=0)])

    def __call__(self, t: np.ndarray) -> np.ndarray:
        every = GIVEN["every_s"]
        part = np.clip((t / every).astype(int), 0, len(self.speeds) - 2)
        later = (np.clip(t, 0.0, None) - every * part)[:, None]
        rise = (self.speeds[part + 1] - self.speeds[part]) / every
        return self.places[part] + self.speeds[part] * later + rise * later**2 / 2


def run(side: str, sea: str, segments: int) -> np.ndarray:
    """Tension at the fairlead every 0.05 s, N."""
    motion = GIVEN["motions"][sea][side]
    line = GIVEN["lines"][side] | {"fairlead_m": motion["start_m"]}
    return follow(line, segments, STEPS_S[segments], Path3(motion), GIVEN["duration_s"])


def packed(segments: int, tensions: np.ndarray) -> dict[str, Any]:
    """The part of a run that is written."""
    late = tensions[round(FROM_S / EVERY_S) :]
    figures = {
        "rest_N": tensions[0],
        "mean_N": late.mean(),
        "std_N": late.std(),
        "max_N": late.max(),
        "min_N": late.min(),
    }
    return {"step_s": STEPS_S[segments][0], **{key: round(float(one), 1) for key, one in figures.items()}}


def runs() -> dict[str, tuple[str, str, int]]:
    """Every run by its name: side, sea, segments."""
    return {
        f"{side}-{sea}-{segments}": (side, sea, segments)
        for side in GIVEN["lines"]
        for sea in GIVEN["motions"]
        for segments in STEPS_S
    }


def main() -> None:
    """Runs the command line."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("-o", "--output", type=Path, required=True, help="the file to write")
    parser.add_argument("--only", nargs="+", choices=list(runs()), metavar="RUN", help="only these runs")
    parser.add_argument("--histories", type=Path, help="folder for the tensions of each run, as text")
    options = parser.parse_args()
    found: dict[str, Any] = {}
    for label, (side, sea, segments) in runs().items():
        if options.only is None or label in options.only:
            tensions = run(side, sea, segments)
            of_line = found.setdefault(side, {}).setdefault(sea, {"segments": {}})
            of_line["segments"][str(segments)] = packed(segments, tensions)
            if options.histories is not None:
                np.savetxt(options.histories / f"{label}.txt", tensions, fmt="%.1f")
    head = {"command": COMMAND, "moordyn": version("moordyn"), "sea": SEA, "sliding_speed_m_s": SLIDING_M_S}
    options.output.write_text(text({**head, "from_s": FROM_S, "lines": found}), encoding="utf-8")


if __name__ == "__main__":
    main()
