"""Serving of the browser app from the package."""

from __future__ import annotations

import errno
import json
import re
import threading
from collections.abc import Sequence
from pathlib import Path
from typing import Any
from urllib.parse import quote
from urllib.request import urlopen

from .. import gallery
from ..engine import engine
from ..errors import KingpostError, shortened
from ..scenario import load
from .application import Application
from .bodies import content_type, is_origin
from .listening import LOOPBACK, Server, from_here, reachable

FIRST_PORT = 8000
PORTS_TRIED = 100


def command(
    scenario: str | None, port: int | None, host: str | None, check: bool, embed_in: Sequence[str] = ()
) -> int:
    """Serve the app until Ctrl-C; with `check`, fetch it once over HTTP and end.

    Pages of the origins `embed_in` may show the figure page in a frame.
    """
    host = host or None
    for origin in embed_in:
        if not is_origin(origin):
            found = shortened(repr(origin))
            raise KingpostError(f"--embed-in: found {found}, allowed: an origin such as https://example.org")
    files, chosen = scenarios(scenario)
    server = open_server(
        app_folder(), files, host or LOOPBACK, port, databases(scenario), chosen, tuple(embed_in)
    )
    query = f"?scenario={quote(chosen)}" if chosen else ""
    address = f"http://{reachable(host)}:{server.server_port}/{query}"
    with server:
        if check:
            return _check(server, query, chosen)
        try:
            print(f"Kingpost is at {address}", flush=True)
            if host:
                print(qr_code(address))
            print("Ctrl-C ends it.", flush=True)
            server.serve_forever()
        except KeyboardInterrupt:
            print()
    return 0


def app_folder() -> Path:
    """Folder of the built app: the package's own, or the repository's in a development install."""
    package = Path(__file__).parents[1]
    for folder in (package / "app", package.parents[1] / "web" / "dist"):
        if (folder / "index.html").is_file():
            return folder
    raise KingpostError("the browser app is not built; run: make web")


def scenarios(given: str | None) -> tuple[dict[str, str], str | None]:
    """Texts of the scenarios to serve by file name, and the name of the one to open.

    The given scenario is validated first; a file outside the gallery is added to its list.
    """
    paths = [gallery.find(name) for name in gallery.names()]
    files = {path.name: gallery.read_text(path) for path in paths}
    if given is None:
        return files, None
    scenario = load(given)
    # Some characters of a file name have a special meaning in a URL.
    name = re.sub(r"[^\w.-]", "-", Path(scenario.file).name)
    files[name] = scenario.text
    return files, Path(name).stem


def databases(given: str | None) -> dict[str, str]:
    """Texts of parts, hydrodynamic databases and tables of RAOs, by their paths below the scenarios' folder.

    These are the files of the gallery and those that the given scenario names; each name stands for one file.
    """
    below = gallery.folder()
    named = ("parts/*.yaml", "hydro/*.json", "hydro/*.csv")
    paths = [path for pattern in named for path in sorted(below.glob(pattern))]
    texts = {path.relative_to(below).as_posix(): gallery.read_text(path) for path in paths}
    if given is None:
        return texts
    own = {name: text for name, text in load(given).files.items() if not name.startswith(gallery.GALLERY)}
    for name in own.keys() & texts.keys():
        if own[name] != texts[name]:
            raise KingpostError(
                f"{given}: {name}: found another file than the gallery's, allowed: another name"
            )
    return texts | own


def index(
    files: dict[str, str], databases: dict[str, str], chosen: str | None = None
) -> list[dict[str, str | bool]]:
    """Entries of `scenarios/index.json`: name, title, file, description, group of the gallery, and whether
    the bare address opens the scenario; in the order of the groups."""
    groups = gallery.groups()
    order = {name: place for place, name in enumerate(groups)}
    ordered = sorted(files.items(), key=lambda item: (order.get(Path(item[0]).stem, len(order)), item[0]))
    known = databases | {f"{gallery.GALLERY}{name}": text for name, text in databases.items()}
    read = ((file, json.loads(engine.read(text, file, "[]", known))) for file, text in ordered)
    return [_listed(file, resolved, groups, chosen) for file, resolved in read]


def _listed(
    file: str, resolved: dict[str, Any], groups: dict[str, str], chosen: str | None
) -> dict[str, str | bool]:
    name = Path(file).stem
    entry = {"name": name, "title": resolved.get("title") or name, "file": file}
    entry["description"] = resolved.get("description") or ""
    in_group = {"group": groups[name]} if name in groups else {}
    return entry | in_group | ({"opens": True} if name == chosen else {})


def open_server(
    folder: Path,
    files: dict[str, str],
    host: str,
    port: int | None,
    databases: dict[str, str] | None = None,
    chosen: str | None = None,
    framed_by: tuple[str, ...] = (),
) -> Server:
    """Listen on `port`, or on the first free port from 8000.

    Serves the folder, and under `scenarios/` the scenarios and the databases that they name; the page opens
    the chosen scenario. Pages of the origins `framed_by` may show the figure page in a frame.

    Raises
    ------
    KingpostError
        If the port is busy or not allowed, or the host is not an address of this machine.
    """
    served = pages(folder, files, databases or {}, chosen)
    ports = range(FIRST_PORT, FIRST_PORT + PORTS_TRIED) if port is None else [port]
    for candidate in ports:
        try:
            return Server((host, candidate), Application(folder, served, host, framed_by))
        except (TypeError, UnicodeError):
            found = shortened(repr(host))
            raise KingpostError(f"--host: found {found}, allowed: an address of this machine") from None
        except OverflowError:
            raise KingpostError(f"--port: found {port}, allowed: 0 to 65535") from None
        except OSError as error:
            if error.errno != errno.EADDRINUSE:
                raise KingpostError(f"cannot listen on {host}:{candidate}: {error.strerror}") from None
    if port is None:
        raise KingpostError(f"no free port from {ports[0]} to {ports[-1]}; give one with --port")
    raise KingpostError(f"port {port} is busy; choose another, or --port 0 for any free one")


def pages(
    folder: Path, files: dict[str, str], databases: dict[str, str], chosen: str | None = None
) -> dict[str, bytes]:
    """Contents by URL path that a server of the app's folder has in memory: scenarios and what they name."""
    found = {f"/scenarios/{file}": text.encode() for file, text in (files | databases).items()}
    found["/offline.js"] = _leaving(folder)
    found["/scenarios/index.json"] = json.dumps(index(files, databases, chosen)).encode()
    return found


def _leaving(folder: Path) -> bytes:
    """A service worker that replaces the app's and removes the app's files from the browser's cache.

    A local server can serve another build at each start.
    """
    script = folder / "offline-leave.js"
    return script.read_bytes() if script.is_file() else b""


def qr_code(address: str) -> str:
    """A QR code of the address, for a terminal."""
    import io

    import segno

    drawn = io.StringIO()
    segno.make(address, micro=False).terminal(drawn, compact=True)
    return drawn.getvalue()


def _check(server: Server, query: str, chosen: str | None) -> int:
    """Fetch the page, the engine and the scenarios over HTTP and print the results."""
    thread = threading.Thread(target=server.serve_forever, daemon=True)
    thread.start()
    try:
        for path, kind in _expected(server, chosen):
            address = f"http://{from_here(server.host)}:{server.server_port}/{path}"
            with urlopen(address + (query if not path else ""), timeout=30) as answer:
                size, found = len(answer.read()), answer.headers.get_content_type()
            if found != kind or not size:
                raise KingpostError(f"{address}: found {found} of {size} bytes, allowed: {kind}")
            print(f"{address}: {found}, {size} bytes")
    except OSError as error:
        raise KingpostError(f"the app does not answer: {error}") from None
    finally:
        server.shutdown()
        thread.join()
    return 0


def _expected(server: Server, chosen: str | None) -> list[tuple[str, str]]:
    """Paths to fetch and the type of each: the page, the engine, the scenarios."""
    folder, pages = server.application.folder, server.application.pages
    engines = sorted(folder.rglob("*.wasm"))
    if not engines:
        raise KingpostError(f"{folder}: the built app has no engine (.wasm); run: make web")
    paths = ["scenarios/index.json", *(path.relative_to(folder).as_posix() for path in engines)]
    paths += [page.lstrip("/") for page in pages if chosen and Path(page).stem == chosen]
    return [("", "text/html"), *((path, content_type(path).split(";")[0]) for path in paths)]
