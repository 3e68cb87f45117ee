"""`kingpost serve`: served files, their types, and their compression."""

from __future__ import annotations

import gzip
import json
from urllib.request import Request, urlopen

import kingpost
import pytest
from kingpost.server import serve
from samples import SMALL
from served import ENGINE, fetch

AFLOAT = """version: 1
title: Afloat
bodies:
  hull:
    mass_t: 410
    inertia: {radii_of_gyration: {radii_m: [3.5, 6, 6]}}
    joint: {floating: {}}
forces:
  gravity: {gravity: {}}
  water: {hydrodynamics: {body: hull, database: own.hydro.json}}
"""


@pytest.mark.parametrize(
    ("path", "kind"),
    [
        ("", "text/html"),
        ("assets/engine.wasm", "application/wasm"),
        ("assets/main.js", "text/javascript"),
        ("scenarios/index.json", "application/json"),
        ("scenarios/paper.yaml", "application/yaml"),
        ("scenarios/hydro/barge.hydro.json", "application/json"),
    ],
)
def test_files_are_served_with_the_mime_types_that_browsers_need(address, path, kind):
    """Source: the HTML and WebAssembly standards: modules and streamed engines need their types."""
    with urlopen(address + path) as answer:
        assert answer.headers.get_content_type() == kind
        body = answer.read()
    with urlopen(Request(address + path, method="HEAD")) as head:
        assert head.headers["Content-Length"] == str(len(body))
        assert head.read() == b""


def test_the_index_lists_the_gallery_and_the_given_scenario(address):
    """Source: the app's own reader; the gallery comes in the order of its groups, what is not in it last."""
    entries = json.load(urlopen(address + "scenarios/index.json"))
    paper = kingpost.load("paper")
    assert entries[0] == {
        "name": "paper",
        "title": paper.title,
        "file": "paper.yaml",
        "description": paper.resolved["description"],
        "group": "The paper: Jardim et al. (2019)",
    }
    assert [entry["name"] for entry in entries] == [*kingpost.gallery.groups(), "small"]
    assert entries[-1] == {
        "name": "small",
        "title": "A box with a boom",
        "file": "small.yaml",
        "description": "",
    }
    assert urlopen(address + "scenarios/small.yaml").read() == SMALL.encode()


def test_every_scenario_of_the_gallery_is_in_one_group():
    """Source: the start page shows the groups, and a scenario in none would not be found there."""
    listed = json.loads((kingpost.gallery.folder() / "gallery.json").read_text())["groups"]
    grouped = [name for group in listed for name in group["scenarios"]]
    assert sorted(grouped) == kingpost.gallery.names()


def test_the_database_beside_a_given_scenario_is_served(app, tmp_path):
    """Source: a user's own hull: its file lies beside the scenario, not in the gallery."""
    database = (kingpost.gallery.folder() / "hydro" / "barge.hydro.json").read_text()
    (tmp_path / "own.hydro.json").write_text(database)
    afloat = tmp_path / "afloat.yaml"
    afloat.write_text(AFLOAT)
    files, chosen = serve.scenarios(str(afloat))
    server = serve.open_server(app, files, serve.LOOPBACK, 0, serve.databases(str(afloat)))
    server.close()
    assert chosen == "afloat"
    assert server.application.pages["/scenarios/own.hydro.json"].decode() == database
    titles = {
        entry["file"]: entry["title"]
        for entry in json.loads(server.application.pages["/scenarios/index.json"])
    }
    assert titles["afloat.yaml"] == "Afloat"
    assert "own.hydro.json" not in titles


def test_every_file_that_the_gallery_names_is_served(shown):
    """Source: the files that each scenario is read with."""
    served = serve.databases(None)
    for name in kingpost.gallery.names():
        named = {file.removeprefix(kingpost.gallery.GALLERY) for file in shown[name]["files"]}
        assert named <= served.keys(), name


def test_the_bare_address_opens_the_given_scenario(app, small):
    """Source: the app opens what the index says, else its start page."""
    files, chosen = serve.scenarios(str(small))
    server = serve.open_server(app, files, serve.LOOPBACK, 0, serve.databases(str(small)), chosen)
    server.close()
    entries = json.loads(server.application.pages["/scenarios/index.json"])
    assert [entry["name"] for entry in entries if entry.get("opens")] == ["small"]


def test_a_database_with_the_name_of_another_of_the_gallery_is_refused(app, tmp_path):
    """Source: one address stands for one file; the gallery's barge would get another hull."""
    own = tmp_path / "hydro"
    own.mkdir()
    other = (kingpost.gallery.folder() / "hydro" / "offshore_vessel.hydro.json").read_text()
    (own / "barge.hydro.json").write_text(other)
    (tmp_path / "afloat.yaml").write_text(AFLOAT.replace("own.hydro.json", "hydro/barge.hydro.json"))
    with pytest.raises(kingpost.KingpostError, match=r"hydro/barge\.hydro\.json: found another file than"):
        serve.databases(str(tmp_path / "afloat.yaml"))


def test_browsers_do_not_cache_the_app_of_a_local_server(app):
    """Source: the next start can serve another scenario, or a newer app, at the same address."""
    (app / "offline.js").write_text("keep()")
    (app / "offline-leave.js").write_text("leave()")
    server = serve.open_server(app, {}, serve.LOOPBACK, 0)
    server.close()
    assert server.application.pages["/offline.js"] == b"leave()"


@pytest.mark.parametrize("path", ["", "assets/engine.wasm", "scenarios/index.json", "scenarios/paper.yaml",
                                  "scenarios/hydro/offshore_vessel.hydro.json"])  # fmt: skip
def test_a_browser_that_accepts_gzip_gets_the_same_content_compressed(address, path):
    """Source: RFC 9110: the length is that of what is sent, and caches are told what it depends on."""
    plain, small = fetch(address, path), fetch(address, path, accept="gzip, deflate, br")
    assert gzip.decompress(small.body) == plain.body
    assert (plain.headers["Content-Encoding"], small.headers["Content-Encoding"]) == (None, "gzip")
    assert [plain.headers["Content-Length"], small.headers["Content-Length"]] == [
        str(len(plain.body)), str(len(small.body))
    ]  # fmt: skip
    assert plain.headers["Vary"] == small.headers["Vary"] == "Accept-Encoding"
    assert plain.headers["Content-Type"] == small.headers["Content-Type"]
    assert len(small.body) < len(plain.body)


def test_a_vessels_database_is_compressed_to_a_third(address):
    """Source: measured: 86 kB of 280; a phone on a weak net waits for each."""
    answer = fetch(address, "scenarios/hydro/offshore_vessel.hydro.json", accept="gzip")
    whole = (kingpost.gallery.folder() / "hydro" / "offshore_vessel.hydro.json").stat().st_size
    assert int(answer.headers["Content-Length"]) < whole / 3


@pytest.mark.parametrize("header", [None, "identity", "br", "gzip;q=0", "*;q=0.0", "gzip;q=0, *"])
def test_a_browser_that_does_not_accept_gzip_gets_plain_bytes(address, header):
    """Source: RFC 9110, section 12.5.3: a weight of 0 means not acceptable."""
    answer = fetch(address, "scenarios/paper.yaml", accept=header)
    assert answer.headers["Content-Encoding"] is None
    assert answer.body == kingpost.gallery.read_text(kingpost.gallery.folder() / "paper.yaml").encode()


def test_pictures_and_files_that_would_grow_are_not_compressed(own_address, app):
    """Source: a picture is compressed already; gzip's own head and tail take 18 bytes."""
    (app / "icon.png").write_bytes(b"\x89PNG" + bytes(1000))
    assert fetch(own_address, "icon.png", accept="gzip").headers["Content-Encoding"] is None
    assert fetch(own_address, "assets/main.js", accept="gzip").headers["Content-Encoding"] is None
    assert fetch(own_address, "assets/main.js").headers["Vary"] == "Accept-Encoding"


def test_a_cached_file_is_not_sent_again_until_it_changes(own_address, app):
    """Source: RFC 9110, section 13.1.2; each coding has a tag of its own."""
    path = "assets/engine.wasm"
    plain, small = fetch(own_address, path), fetch(own_address, path, accept="gzip")
    assert plain.headers["ETag"] != small.headers["ETag"]
    again = fetch(own_address, path, accept="gzip", known=small.headers["ETag"])
    assert (again.status, again.body, again.headers["Vary"]) == (304, b"", "Accept-Encoding")
    (app / path).write_bytes(ENGINE + b"\1")
    changed = fetch(own_address, path, accept="gzip", known=small.headers["ETag"])
    assert (changed.status, gzip.decompress(changed.body)) == (200, ENGINE + b"\1")


def test_a_browser_that_accepts_brotli_gets_the_copy_that_the_build_has_compressed(own_address, app):
    """Source: RFC 9110: the type is that of the plain file; without a copy, gzip serves."""
    path = "assets/engine.wasm"
    (app / f"{path}.br").write_bytes(b"in Brotli")
    plain, small = fetch(own_address, path), fetch(own_address, path, accept="gzip, deflate, br")
    assert (small.headers["Content-Encoding"], small.body) == ("br", b"in Brotli")
    assert (small.headers["Content-Type"], small.headers["Vary"]) == ("application/wasm", "Accept-Encoding")
    assert small.headers["ETag"] != plain.headers["ETag"]
    assert fetch(own_address, path, accept="gzip").headers["Content-Encoding"] == "gzip"
    assert fetch(own_address, path, accept="gzip, br;q=0").headers["Content-Encoding"] == "gzip"


def test_the_same_bytes_are_compressed_once(own_address, monkeypatch):
    """Source: the engine takes a tenth of a second, which no second visitor should wait for."""
    sizes = []
    compress = gzip.compress
    monkeypatch.setattr(
        gzip, "compress", lambda content, **given: sizes.append(len(content)) or compress(content, **given)
    )
    for _ in range(3):
        fetch(own_address, "assets/engine.wasm", accept="gzip")
    assert sizes == [len(ENGINE)]
