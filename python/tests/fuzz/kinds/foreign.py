"""Other programs' hydrodynamic files: WAMIT, AQWA, Nemoh, ShipX, BEMIO, Capytaine, OrcaFlex."""

from __future__ import annotations

import random
import tempfile
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import hydro_orcaflex as orcaflex
import hydro_programs as programs
import hydro_writers as writers
import numpy as np
from kingpost.cli import main
from kingpost.hydro import importers
from kingpost.hydro.importers import Options

from ..contract import Case, check_exit
from ..mutations import TEXT_WAYS, damaged, damaged_bytes, encoded
from .netcdf import quick_probe

SIZE = {"length_m": 12.0, "beam_m": 10.0}
HULL = {**SIZE, "draught_m": 5.0}
LISTED = {**HULL, "first_column": "period_s"}
GIVEN = {
    "wamit": {**LISTED, "density_kg_m3": 1000.0, "gravity_m_s2": 9.81, "water_depth_m": np.inf,
    "length_scale_m": 1.0,
              "time_sign": "+", "restoring_includes_weight": False, "reference_m": (1.0, 0.5, -2.0),
              "volume_m3": 262.0, "centre_of_buoyancy_m": (0.4, 0.0, -1.9)},
    "bemio": {**HULL, "restoring_includes_weight": True},
    "capytaine": SIZE,
    "orcaflex": {**HULL, "water_depth_m": np.inf, "vessel_type": "Type 1"},
    "shipx": {"water_depth_m": np.inf, "added_mass_infinite": "from_damping"},
    "nemoh": {**HULL, "added_mass_infinite": "from_damping"},
    "aqwa": SIZE, "aqwa_listing": SIZE, "listed": LISTED, "listing": LISTED,
}  # fmt: skip


@dataclass(frozen=True)
class Sample:
    """Files of one program, and the one to open."""

    files: dict[str, bytes]
    named: str


@cache
def samples() -> dict[str, Sample]:
    """Files that the tests' writers make from a small database."""
    base = writers.database(count=5)
    found = {}
    for kind in GIVEN:
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            path = _written(kind, folder, base)
            every = {
                each.relative_to(folder).as_posix(): each.read_bytes()
                for each in sorted(folder.rglob("*"))
                if each.is_file()
            }
            found[kind] = Sample(every, path.relative_to(folder).as_posix())
    return found


def _written(kind: str, folder: Path, base) -> Path:
    stem = folder / "hull"
    if kind == "wamit":
        return writers.Wamit(apart=True).write(stem, base)
    if kind == "bemio":
        writers.write_bemio(folder / "hull.h5", base)
        return folder / "hull.h5"
    if kind == "capytaine":
        writers.capytaine_dataset(base, 3).to_netcdf(folder / "hull.nc", engine="h5netcdf")
        return folder / "hull.nc"
    if kind == "orcaflex":
        return orcaflex.written(folder / "hull.yml", orcaflex.base(), orcaflex.Form())
    if kind == "listed":
        programs.wamit_listing(stem, base)
        return programs.wamit_six_digits(stem, base)
    if kind == "nemoh":
        return programs.nemoh(folder, base)
    writer = {"listing": programs.wamit_listing, "shipx": programs.shipx, "aqwa": programs.aqwa,
              "aqwa_listing": programs.aqwa_listing}[kind]  # fmt: skip
    return writer(stem, base)


def drawn(draw: random.Random) -> Case:
    """Draw a wrong file of a program, rarely a missing one."""
    kind = draw.choice(sorted(samples()))
    sample = samples()[kind]
    files = dict(sample.files)
    name = draw.choice(sorted(files))
    if draw.random() < 0.02:
        files.pop(name)
    else:
        files[name] = _damaged(draw, files[name])
    # The rest of the files' sizes is not needed, but what is asked for may be asked for again.
    how = "command" if draw.random() < 0.01 else "load"
    return Case("foreign", files, (kind, sample.named, how))


def _damaged(draw: random.Random, content: bytes) -> bytes:
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError:
        return damaged_bytes(draw, content)
    if "\x00" in text or draw.random() < 0.05:
        return damaged_bytes(draw, content)
    return encoded(draw, damaged(draw, text, TEXT_WAYS))


def use(case: Case, folder: Path) -> str:
    """Read the file, without the slow fit of the memory unless by the command line."""
    kind, named, how = case.arguments
    if how == "load":
        with quick_probe():
            importers.load(folder / named, Options(**GIVEN[kind]))
        return "taken"
    words = [f"--{name.replace('_', '-')}={_word(value)}" for name, value in GIVEN[kind].items()]
    with quick_probe():
        code = main(["hydro", str(folder / named), "-o", str(folder / "x.hydro.json"), *words])
    check_exit(code)
    return f"exit {code}"


def _word(value: object) -> str:
    if isinstance(value, bool):
        return "yes" if value else "no"
    return ",".join(map(str, value)) if isinstance(value, tuple) else str(value)
