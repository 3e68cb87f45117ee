"""Builds the wheel's second engine, for processors with AVX2, into python/kingpost/avx2.

The package uses it if the processor supports it. Both give the same bits: AVX2 only makes the registers
wider, and nothing fuses multiplication and addition.
"""

from __future__ import annotations

import os
import platform
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
TARGET = ROOT / "target" / "avx2"
FOLDER = ROOT / "python" / "kingpost" / "avx2"
BUILT = {"Linux": ("lib_engine.so", "_engine.abi3.so"), "Windows": ("_engine.dll", "_engine.pyd"),
         "Darwin": ("lib_engine.dylib", "_engine.abi3.so")}  # fmt: skip


def main() -> int:
    """Builds and copies the engine; does nothing on other processor families."""
    if platform.machine().lower() not in ("x86_64", "amd64") or platform.system() not in BUILT:
        return 0
    flags = f"{os.environ.get('RUSTFLAGS', '')} -C target-feature=+avx2".strip()
    environment = os.environ | {"RUSTFLAGS": flags, "PYO3_BUILD_EXTENSION_MODULE": "1"}
    command = ["cargo", "build", "--quiet", "--locked", "--release", "--package", "kingpost-py"]
    done = subprocess.run([*command, "--target-dir", TARGET], cwd=ROOT, env=environment, check=False)
    if done.returncode == 0:
        built, module = BUILT[platform.system()]
        FOLDER.mkdir(exist_ok=True)
        shutil.copyfile(TARGET / "release" / built, FOLDER / module)
    return done.returncode


if __name__ == "__main__":
    sys.exit(main())
