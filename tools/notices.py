"""Writes the notices of third parties: authors and licences of the code in the built app and the compiled
module.

Crates are found by `cargo metadata`, packages of the app by its `node_modules`: only linked ones, not those
for building or testing. Each licence text appears once, with the names of all packages under it.
"""

from __future__ import annotations

import json
import re
import subprocess
import sys
from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
NOTICES = ROOT / "THIRD_PARTY_NOTICES.txt"
CRATES = ("kingpost-wasm", "kingpost-py")
TEXTS = ("LICENSE*", "LICENCE*", "COPYING*", "NOTICE*", "license*", "UNLICENSE*")
HEAD = """Kingpost is made with the work of others, which its app and its compiled module contain.
These are their names and terms. `make notices` writes this file.
"""

Part = tuple[str, str, Path]
"""Name and version, short name of the licence, folder."""


def main() -> int:
    """Write the notices; with `--check` report whether the existing ones match the linked packages."""
    parts = sorted({*crates(), *packages()})
    if "--check" in sys.argv:
        listed = set(re.findall(r"^  (\S+ \S+) \(", NOTICES.read_text(encoding="utf-8"), re.MULTILINE))
        missing = {name for name, _, _ in parts} - listed
        for name in sorted(missing):
            print(f"not in {NOTICES.name}: {name}; run: make notices")
        return 1 if missing else 0
    NOTICES.write_text(notices(parts), encoding="utf-8")
    return 0


def crates() -> Iterator[Part]:
    """The crates that the app's engine and the Python module link."""
    command = ["cargo", "metadata", "--format-version", "1", "--locked"]
    found = json.loads(subprocess.run(command, cwd=ROOT, capture_output=True, check=True).stdout)
    by_id = {package["id"]: package for package in found["packages"]}
    uses = {
        node["id"]: [
            of["pkg"] for of in node["deps"] if any(kind["kind"] is None for kind in of["dep_kinds"])
        ]
        for node in found["resolve"]["nodes"]
    }
    left, linked = [one for one, package in by_id.items() if package["name"] in CRATES], set()
    while left:
        one = left.pop()
        if one not in linked:
            linked.add(one)
            left += uses[one]
    for package in (by_id[one] for one in linked):
        if package["source"]:
            folder = Path(package["manifest_path"]).parent
            yield f"{package['name']} {package['version']}", package["license"] or "see its text", folder


def packages() -> Iterator[Part]:
    """The packages that the app bundles."""
    web = ROOT / "web"
    lock = json.loads((web / "package-lock.json").read_text(encoding="utf-8"))["packages"]
    for place, about in lock.items():
        if place and not about.get("dev") and not about.get("peer"):
            name = place.removeprefix("node_modules/")
            yield f"{name} {about['version']}", about.get("license", "see its text"), web / place


def notices(parts: list[Part]) -> str:
    """The file: names with their licences, then each licence text once."""
    texts: dict[str, str] = {}
    of_text: defaultdict[str, list[str]] = defaultdict(list)
    for name, _, folder in parts:
        files = sorted({file for pattern in TEXTS for file in folder.glob(pattern) if file.is_file()})
        for file in files:
            text = file.read_text(encoding="utf-8", errors="replace").strip()
            # Texts that differ only in spaces appear once.
            texts.setdefault(" ".join(text.split()), text)
            of_text[" ".join(text.split())].append(name)
    lines = [HEAD, *(f"  {name} ({terms}){_source(terms, folder)}" for name, terms, folder in parts)]
    for key, names in sorted(of_text.items(), key=lambda item: item[1]):
        lines += ["", "=" * 100, ", ".join(dict.fromkeys(names)), "", texts[key]]
    return "\n".join(lines) + "\n"


def _source(terms: str, folder: Path) -> str:
    """Name the place of the source of a package whose licence asks for it; empty for others."""
    if "MPL" not in terms:
        return ""
    url = json.loads((folder / "package.json").read_text(encoding="utf-8"))["repository"]["url"]
    return f", unchanged; source: {url.removeprefix('git+').removesuffix('.git')}"


if __name__ == "__main__":
    sys.exit(main())
