"""Checks of a release: `release.py version v0.1.0` checks the tag, `release.py try dist` the wheel. `try`
installs the only wheel of a folder into a new environment outside the repository, and uses it as a user
without other files.
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
import tomllib
import venv
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
TRIED = [
    ["--version"],
    ["list"],
    ["check", "offshore_vessel"],
    ["run", "lift_off_from_barge", "--set", "simulation.duration_s=5", "-o", "lift.nc"],
    ["plot", "lift.nc", "-o", "lift.png"],
    ["serve", "paper", "--check", "--port", "0"],
    ["verify", "--only", "mooring"],
]


def main(words: list[str]) -> int:
    """Runs one check; returns 1 and prints the reason if it fails, returns 2 if the check is unknown."""
    checks = {"version": check_version, "try": try_wheel}
    if len(words) != 2 or words[0] not in checks:
        print(
            f"error: found {' '.join(words) or 'nothing'}, allowed: version TAG or try FOLDER",
            file=sys.stderr,
        )
        return 2
    wrong = checks[words[0]](words[1])
    if wrong:
        print(f"error: {wrong}", file=sys.stderr)
    return 1 if wrong else 0


def check_version(tag: str) -> str | None:
    """Returns the error of a tag, if any."""
    cargo = tomllib.loads((ROOT / "Cargo.toml").read_text(encoding="utf-8"))
    version = cargo["workspace"]["package"]["version"]
    return (
        None if tag == f"v{version}" else f"tag: found {tag}, allowed: v{version}, the version in Cargo.toml"
    )


def try_wheel(folder: str) -> str | None:
    """Returns the first failure of a wheel, if any."""
    wheels = sorted(Path(folder).glob("*.whl"))
    if len(wheels) != 1:
        return f"{folder}: found {len(wheels)} wheels, allowed: one"
    if "-abi3-" not in wheels[0].name:
        return f"{wheels[0].name}: found a wheel for one Python, allowed: abi3"
    if "-linux_" in wheels[0].name:
        return f"{wheels[0].name}: found a wheel for one Linux, allowed: manylinux"
    with tempfile.TemporaryDirectory() as away:
        environment = Path(away) / "environment"
        venv.create(environment, with_pip=True)
        programs = environment / ("Scripts" if sys.platform == "win32" else "bin")
        subprocess.run(
            [programs / "python", "-m", "pip", "install", "--quiet", wheels[0].resolve()], check=True
        )
        for words in TRIED:
            print("kingpost", *words, flush=True)
            done = subprocess.run(
                [programs / "kingpost", *words], cwd=away, check=False, stdout=subprocess.DEVNULL
            )
            if done.returncode != 0:
                return f"kingpost {' '.join(words)}: ended with {done.returncode}, allowed: 0"
    return None


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
