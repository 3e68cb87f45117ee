"""Hooks of MkDocs that generate further content of the documentation site. The pages on the gallery, on the
fields of a scenario and of a study, and on the command line are made at every build, so that they are never
outdated. Links of a page to other files of the repository lead to copies of these files on the site.
"""

from __future__ import annotations

import posixpath
import re
import sys
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).parent))

import docs_book
import docs_commands
import docs_gallery
import docs_math
import docs_schema
from mkdocs.structure.files import File, Files

ROOT = Path(__file__).resolve().parents[1]
LINK = re.compile(r"(\]\()([^)\s#]+)(#[^)\s]*)?(\))")
# A link to a folder leads to the page on its content.
FOLDERS = {
    "scenarios": "gallery.md",
    "scenarios/parts": "parts.md",
    "lessons": "teaching.md",
    "schema": "reference/scenario.md",
    "docs/decisions": "decisions/README.md",
}
# Pages of the menu from elsewhere in the repository.
PROJECT = ["ARCHITECTURE.md", "CONTRIBUTING.md", "CHANGELOG.md"]


def on_config(config: Any) -> Any:
    """Adds what pages may have beside Markdown: formulas."""
    config.markdown_extensions.append(docs_math.extension())
    fences = config.mdx_configs.setdefault("pymdownx.superfences", {}).setdefault("custom_fences", [])
    fences += [{"name": "math", "class": "equation", "format": docs_math.formatter}]
    return config


def on_files(files: Files, config: Any) -> Files:
    """Adds the generated pages, the pictures of the gallery, and linked files from elsewhere in the
    repository."""
    made = {
        "gallery.md": docs_gallery.page(ROOT),
        "reference/scenario.md": docs_schema.page(ROOT / "schema" / "scenario.schema.json"),
        "reference/study.md": docs_schema.page(ROOT / "schema" / "study.schema.json"),
        "reference/command_line.md": docs_commands.page(),
    }
    for path, text in made.items():
        files.append(File.generated(config, path, content=text))
    for card in sorted((ROOT / "web" / "public" / "cards").glob("*.webp")):
        files.append(File.generated(config, f"cards/{card.name}", abs_src_path=str(card)))
    if docs_book.has_app():
        for file in sorted(path for path in docs_book.BUILT_APP.rglob("*") if path.is_file()):
            place = docs_book.IN_SITE + file.relative_to(docs_book.BUILT_APP).as_posix()
            files.append(File.generated(config, place, abs_src_path=str(file)))
    icon = ROOT / "web" / "public" / "icon.svg"
    files.append(File.generated(config, "images/icon.svg", abs_src_path=str(icon)))
    pages = {f"docs/{file.src_uri}": file.content_string for file in files.documentation_pages()}
    for path in elsewhere(pages):
        files.append(File.generated(config, f"source/{path}", abs_src_path=str(ROOT / path)))
    return files


def on_page_markdown(markdown: str, page: Any, **_: Any) -> str:
    """Changes the links of a page to addresses on the site; sets the figures and exercises of the book."""
    here = page.file.src_uri
    markdown = docs_book.rendered(markdown, posixpath.relpath(".", posixpath.dirname(here) or "."))
    origin = here.removeprefix("source/") if here.startswith("source/") else f"docs/{here}"

    def moved(link: re.Match[str]) -> str:
        target = inside(origin, link[2])
        if target is None:
            return link[0]
        away = posixpath.relpath(place_of(target), posixpath.dirname(here) or ".")
        return f"{link[1]}{away}{link[3] or ''}{link[4]}"

    return outside_code(markdown, lambda text: LINK.sub(moved, text))


def on_post_build(config: Any) -> None:
    """Adds the font of the formulas, with the characters that the site uses."""
    site = Path(config.site_dir)
    html = "".join(page.read_text(encoding="utf-8") for page in site.rglob("*.html"))
    (site / "assets" / "math.woff").write_bytes(docs_math.font(html))


def elsewhere(pages: dict[str, str]) -> list[str]:
    """Files outside docs/ that pages link to, and those that these link to."""
    found: list[str] = []
    waiting = list(PROJECT)
    for path, text in pages.items():
        waiting += links(path, text)
    while waiting:
        path = waiting.pop(0)
        if path.startswith("docs/") or path in found or not (ROOT / path).is_file():
            continue
        found.append(path)
        if path.endswith(".md"):
            waiting += links(path, (ROOT / path).read_text(encoding="utf-8"))
    return found


def links(origin: str, text: str) -> list[str]:
    """Paths in the repository that a page links to."""
    found: list[str] = []
    outside_code(text, lambda part: found.extend(link[2] for link in LINK.finditer(part)) or part)
    return [target for target in (inside(origin, link) for link in found) if target]


def inside(origin: str, target: str) -> str | None:
    """Path in the repository to which a link of a page points; None for a web address."""
    if re.match(r"[a-z]+:", target):
        return None
    return posixpath.normpath(posixpath.join(posixpath.dirname(origin), target))


def place_of(path: str) -> str:
    """Address of a file of the repository on the site."""
    path = path.rstrip("/")
    return FOLDERS.get(path) or (path.removeprefix("docs/") if path.startswith("docs/") else f"source/{path}")


def outside_code(markdown: str, change: Any) -> str:
    """Applies a change to the text outside fenced blocks."""
    parts = re.split(r"(^```.*?^```[ ]*$)", markdown, flags=re.MULTILINE | re.DOTALL)
    return "".join(part if part.startswith("```") else change(part) for part in parts)
