"""Origin of a report's numbers: files with digests, versions, commands, verification."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from ..study.store.layout import About
from .blocks import Block, Command, Paragraph, Section, Table

VERIFICATION = "verification.json"
"""File that `kingpost verify --json` wrote, in the study's folder."""
VERIFY = "kingpost verify --json"
FINGERPRINT = (
    "It is the SHA-256 of all that decides the numbers: the scenario, the files that it names, axes, seeds, "
    "the recorded columns, the engine."
)
CHECKED = (
    "The engine is checked against closed forms, published values, other programs and model tests. It is not "
    "validated against a measurement of a whole ship with a crane at sea: no usable one was found."
)


def section(folder: Path, about: About, digests: Mapping[str, str]) -> Section:
    """Section with the files of the report and the commands that make it again.

    Parameters
    ----------
    folder
        Of the study.
    about
        Its ``study.json``.
    digests
        SHA-256 of the files that are named, by name.
    """
    blocks: list[Block] = [
        Paragraph(f"Fingerprint of the study: {about['fingerprint']}. {FINGERPRINT}"),
        Table("Files of the study", ("file", "SHA-256"), list(digests.items()), "Command: sha256sum DIR/*."),
        Table("Files that the scenario names", ("file", "SHA-256"), list(about["files"].items()),
              "File: study.json, field files."),
        Table("Parts of the fingerprint", ("part", "SHA-256"), list(about["depends_on"].items()),
              "File: study.json, field depends_on."),
        Table("Versions", ("program", "version"), list(about["versions"].items()),
              "File: study.json, field versions."),
        Paragraph("The study and this report again; what is finished is not computed a second time:"),
        Command("kingpost study study.yaml -o DIR --resume --report report.html"),
        Paragraph("Every number of the runs, in Python:"),
        Command('import kingpost\n\nruns = kingpost.open_study("DIR")   # an xarray.Dataset'),
    ]  # fmt: skip
    return Section("origin", "Where the numbers come from", blocks)


def verification_section(folder: Path) -> Section:
    """Section with the results of `kingpost verify` on this machine, if its file is in the folder."""
    blocks: list[Block] = [Paragraph(CHECKED)]
    path = folder / VERIFICATION
    if not path.is_file():
        blocks.append(Paragraph("The checks were not run for this report. To include them, run first:"))
        blocks.append(Command(f"{VERIFY} DIR/{VERIFICATION}"))
        return Section("verification", "Verification", blocks)
    found = json.loads(path.read_text(encoding="utf-8"))
    counts = found["counts"]
    rows = [(area, str(passed), str(failed)) for area, passed, failed in _by_area(found["rows"])]
    rows.append(("all", str(counts["pass"]), str(counts["FAIL"])))
    origin = f"File: {VERIFICATION}, by version {found['kingpost']}. Command: {VERIFY} DIR/{VERIFICATION}."
    blocks.append(Table("Checks, measured", ("area", "pass", "fail"), rows, origin, (1, 2)))
    failed = [(row["id"], row["what"], row["message"]) for row in found["rows"] if row["verdict"] == "FAIL"]
    if failed:
        blocks.append(Table("Checks that failed", ("row", "what", "why"), failed, origin))
    return Section("verification", "Verification", blocks)


def _by_area(rows: Sequence[Mapping[str, Any]]) -> list[tuple[str, int, int]]:
    areas = dict.fromkeys(row["area"] for row in rows)
    return [
        (
            area,
            sum(row["area"] == area and row["verdict"] == "pass" for row in rows),
            sum(row["area"] == area and row["verdict"] == "FAIL" for row in rows),
        )
        for area in areas
    ]
