"""Builds the wheel into dist/, with the app, the gallery and the schema next to the Python files.

maturin packs the package's folder, so these files are copied there for the build.
"""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

import avx2

ROOT = Path(__file__).resolve().parents[1]
PACKAGE = ROOT / "python" / "kingpost"
CARRIED = {"app": "web/dist", "scenarios": "scenarios", "schema": "schema"}


def main(build: list[str]) -> int:
    """Runs the build command, `uv build --wheel ...`, between copying and removing."""
    if failed := avx2.main():
        return failed
    copies = {PACKAGE / name: ROOT / source for name, source in CARRIED.items()}
    try:
        for copy, source in copies.items():
            shutil.rmtree(copy, ignore_errors=True)
            shutil.copytree(source, copy)
        return subprocess.run(build, cwd=ROOT, check=False).returncode
    finally:
        for folder in (*copies, avx2.FOLDER):
            shutil.rmtree(folder, ignore_errors=True)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
