"""`kingpost serve`: what it serves, on which address, and how it ends.

The app's folder is a small stand-in where the real one is not needed, so that these tests do not
wait for a web build; the browser tests drive the real one.
"""

from __future__ import annotations

import gzip
import json
import signal
import socket
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from contextlib import closing
from dataclasses import dataclass
from http.client import HTTPConnection, HTTPMessage
from pathlib import Path
from urllib.error import HTTPError
from urllib.parse import urlsplit
from urllib.request import Request, urlopen

import kingpost
import pytest
from kingpost.cli import main
from kingpost.server import listening, serve

ENGINE = b"\0asm\1\0\0\0" + bytes(1000)
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


@pytest.fixture
def app(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with the kinds of file that a built app has, in the place of one."""
    folder = tmp_path / "app"
    (folder / "assets").mkdir(parents=True)
    (folder / "index.html").write_text("<!doctype html><title>Kingpost</title>" + "<p>A ship." * 9)
    (folder / "assets" / "engine.wasm").write_bytes(ENGINE)
    (folder / "assets" / "main.js").write_text("export {};")
    monkeypatch.setattr(serve, "app_folder", lambda: folder)
    return folder


@pytest.fixture
def address(app: Path, small: Path) -> Iterator[str]:
    """A server of the app with the gallery and one more scenario."""
    files, _ = serve.scenarios(str(small))
    databases = serve.databases(str(small))
    server = serve.open_server(app, files, serve.LOOPBACK, 0, databases)
    # It looks for the end as often as this, s.
    thread = threading.Thread(target=server.serve_forever, args=(0.01,))
    thread.start()
    yield f"http://127.0.0.1:{server.server_port}/"
    server.shutdown()
    thread.join()
    server.close()


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
def test_files_come_with_the_type_that_browsers_need(address, path, kind):
    """Source: the HTML and WebAssembly standards: modules and streamed engines need their types."""
    with urlopen(address + path) as answer:
        assert answer.headers.get_content_type() == kind
        body = answer.read()
    with urlopen(Request(address + path, method="HEAD")) as head:
        assert head.headers["Content-Length"] == str(len(body))
        assert head.read() == b""


def test_the_index_lists_the_gallery_and_the_given_scenario(address, small):
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
    assert urlopen(address + "scenarios/small.yaml").read() == small.read_bytes()


def test_every_scenario_of_the_gallery_is_in_one_group():
    """Source: the start page shows the groups, and a scenario in none would not be found there."""
    listed = json.loads((kingpost.gallery.folder() / "gallery.json").read_text())["groups"]
    grouped = [name for group in listed for name in group["scenarios"]]
    assert sorted(grouped) == kingpost.gallery.names()


def test_a_given_scenario_brings_the_database_beside_it(app, tmp_path):
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


def test_every_file_that_the_gallery_names_is_served():
    """Source: the files that each scenario is read with."""
    served = serve.databases(None)
    for name in kingpost.gallery.names():
        named = {file.removeprefix(kingpost.gallery.GALLERY) for file in kingpost.load(name).files}
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


def test_no_browser_keeps_the_app_for_when_the_server_is_gone(app):
    """Source: the next start can serve another scenario, or a newer app, at the same address."""
    (app / "offline.js").write_text("keep()")
    (app / "offline-leave.js").write_text("leave()")
    server = serve.open_server(app, {}, serve.LOOPBACK, 0)
    server.close()
    assert server.application.pages["/offline.js"] == b"leave()"


@dataclass(frozen=True)
class Answer:
    """What came over the line, nothing unpacked."""

    status: int
    headers: HTTPMessage
    body: bytes


def fetch(address: str, path: str, accept: str | None = None, known: str | None = None) -> Answer:
    """Ask with these `Accept-Encoding` and `If-None-Match`, or without."""
    headers = {"Accept-Encoding": accept, "If-None-Match": known}
    with closing(HTTPConnection(urlsplit(address).netloc, timeout=20)) as connection:
        # Else the library adds a header of its own.
        connection.putrequest("GET", f"/{path}", skip_accept_encoding=True)
        for name, value in headers.items():
            if value is not None:
                connection.putheader(name, value)
        connection.endheaders()
        answer = connection.getresponse()
        return Answer(answer.status, answer.headers, answer.read())


@pytest.mark.parametrize("path", ["", "assets/engine.wasm", "scenarios/index.json", "scenarios/paper.yaml",
                                  "scenarios/hydro/offshore_vessel.hydro.json"])  # fmt: skip
def test_a_browser_that_takes_gzip_gets_the_same_bytes_in_fewer(address, path):
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


def test_a_vessels_database_is_a_third_of_its_size_on_the_way(address):
    """Source: measured: 86 kB of 280; a phone on a weak net waits for each."""
    answer = fetch(address, "scenarios/hydro/offshore_vessel.hydro.json", accept="gzip")
    whole = (kingpost.gallery.folder() / "hydro" / "offshore_vessel.hydro.json").stat().st_size
    assert int(answer.headers["Content-Length"]) < whole / 3


@pytest.mark.parametrize("header", [None, "identity", "br", "gzip;q=0", "*;q=0.0", "gzip;q=0, *"])
def test_a_browser_that_does_not_take_gzip_gets_plain_bytes(address, header):
    """Source: RFC 9110, section 12.5.3: a weight of 0 means not acceptable."""
    answer = fetch(address, "scenarios/paper.yaml", accept=header)
    assert answer.headers["Content-Encoding"] is None
    assert answer.body == kingpost.gallery.read_text(kingpost.gallery.folder() / "paper.yaml").encode()


def test_pictures_and_what_would_grow_go_as_they_are(address, app):
    """Source: a picture is compressed already; gzip's own head and tail take 18 bytes."""
    (app / "icon.png").write_bytes(b"\x89PNG" + bytes(1000))
    assert fetch(address, "icon.png", accept="gzip").headers["Content-Encoding"] is None
    assert fetch(address, "assets/main.js", accept="gzip").headers["Content-Encoding"] is None
    assert fetch(address, "assets/main.js").headers["Vary"] == "Accept-Encoding"


def test_what_a_browser_has_is_not_sent_again_until_it_changes(address, app):
    """Source: RFC 9110, section 13.1.2; each coding has a tag of its own."""
    path = "assets/engine.wasm"
    plain, small = fetch(address, path), fetch(address, path, accept="gzip")
    assert plain.headers["ETag"] != small.headers["ETag"]
    again = fetch(address, path, accept="gzip", known=small.headers["ETag"])
    assert (again.status, again.body, again.headers["Vary"]) == (304, b"", "Accept-Encoding")
    (app / path).write_bytes(ENGINE + b"\1")
    changed = fetch(address, path, accept="gzip", known=small.headers["ETag"])
    assert (changed.status, gzip.decompress(changed.body)) == (200, ENGINE + b"\1")


def test_the_same_bytes_are_compressed_once(address, monkeypatch):
    """Source: the engine takes a tenth of a second, which no second visitor should wait for."""
    sizes = []
    compress = gzip.compress
    monkeypatch.setattr(
        gzip, "compress", lambda content, **given: sizes.append(len(content)) or compress(content, **given)
    )
    for _ in range(3):
        fetch(address, "assets/engine.wasm", accept="gzip")
    assert sizes == [len(ENGINE)]


@pytest.mark.parametrize("path", ["assets/", "no/such/file", "../conftest.py", "scenarios/none.yaml"])
def test_nothing_else_is_served(address, path):
    """Source: folders are not listed, and files outside of the app are not reachable."""
    with pytest.raises(HTTPError) as refused:
        urlopen(address + path)
    assert refused.value.code == 404


@pytest.mark.parametrize("path", ["%00", "a%00b", "%0d%0aX:1", "%7f"])
def test_an_address_with_characters_that_no_file_has_is_not_found(address, path):
    """Source: a path with a zero byte raises in the operating system's calls, and was a traceback."""
    assert fetch(address, path).status == 404


@pytest.mark.parametrize(
    ("host", "status"),
    [
        ("localhost:1", 200),
        ("[::1]:80", 200),
        ("192.168.1.7", 200),
        ("evil.example", 421),
        ("[x", 421),
        ("", 421),
    ],
)
def test_another_name_that_leads_to_this_machine_reads_nothing(address, host, status):
    """Source: DNS rebinding: a web page whose name is made to lead here would read a private scenario."""
    with closing(HTTPConnection(urlsplit(address).netloc, timeout=20)) as connection:
        connection.putrequest("GET", "/scenarios/index.json", skip_host=True)
        connection.putheader("Host", host)
        connection.endheaders()
        assert connection.getresponse().status == status


def test_every_answer_tells_the_browser_to_load_nothing_from_elsewhere(address):
    """Source: OWASP's secure headers."""
    for path in ("", "scenarios/index.json", "nonesuch"):
        headers = fetch(address, path).headers
        assert headers["X-Content-Type-Options"] == "nosniff"
        assert "default-src 'self'" in headers["Content-Security-Policy"]


def test_the_check_fetches_page_engine_and_scenario(app, small, capsys):
    """Source: the public contract of --check."""
    assert main(["serve", str(small), "--port", "0", "--check"]) == 0
    lines = capsys.readouterr().out.splitlines()
    for words in ("text/html", "engine.wasm: application/wasm", "scenarios/small.yaml: application/yaml"):
        assert any(words in line for line in lines), words


def test_a_busy_port_that_was_asked_for_is_exit_code_2(app, capsys):
    """Source: the public contract: one line."""
    with socket.create_server((serve.LOOPBACK, 0)) as busy:
        port = busy.getsockname()[1]
        assert main(["serve", "--port", str(port)]) == 2
    shown = capsys.readouterr().err
    assert shown.count("\n") == 1
    assert f"port {port} is busy" in shown


def test_without_a_port_the_next_free_one_is_taken(app, monkeypatch):
    """Source: the public contract."""
    with socket.create_server((serve.LOOPBACK, 0)) as busy:
        first = busy.getsockname()[1]
        monkeypatch.setattr(serve, "FIRST_PORT", first)
        server = serve.open_server(app, {}, serve.LOOPBACK, None)
        assert first < server.server_port <= first + serve.PORTS_TRIED
        server.close()


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        (["papre"], "did you mean 'paper'"),
        (["--port", "70000"], "0 to 65535"),
        (["--host", "no.such.host.invalid"], "cannot listen"),
    ],
)
def test_wrong_arguments_are_one_line_and_exit_code_2(app, arguments, says, capsys):
    """Source: the public contract."""
    assert main(["serve", *arguments]) == 2
    shown = capsys.readouterr().err
    assert shown.count("\n") == 1
    assert says in shown


def test_without_a_built_app_it_says_how_to_build_one(monkeypatch, tmp_path, capsys):
    """Source: the public contract."""
    monkeypatch.setattr(serve, "__file__", str(tmp_path / "python" / "kingpost" / "server" / "serve.py"))
    assert main(["serve"]) == 2
    assert "run: make web" in capsys.readouterr().err


def test_a_given_host_gets_an_address_for_others_and_a_qr_code(app, monkeypatch, capsys):
    """Source: the public contract; the code's modules are drawn with block characters."""

    def interrupted(_server: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(serve.Server, "serve_forever", interrupted)
    monkeypatch.setattr(listening, "lan_address", lambda: "192.168.7.9")
    assert main(["serve", "paper", "--host", "0.0.0.0", "--port", "0"]) == 0
    text = capsys.readouterr().out
    assert "Kingpost is at http://192.168.7.9:" in text
    assert "/?scenario=paper" in text
    assert sum(line.count("█") for line in text.splitlines()) > 100


@pytest.mark.skipif(sys.platform == "win32", reason="signals are POSIX's")
def test_ctrl_c_ends_the_server_cleanly(app):
    """Source: the public contract: exit code 0, nothing on stderr."""
    # A job in the background starts with the signal ignored.
    program = (
        "import signal, sys; from pathlib import Path; from kingpost import cli;"
        "from kingpost.server import serve;"
        "signal.signal(signal.SIGINT, signal.default_int_handler);"
        f"serve.app_folder = lambda: Path({str(app)!r}); sys.exit(cli.main(['serve', '--port', '0']))"
    )
    started = subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE,
                               stderr=subprocess.PIPE, text=True)  # fmt: skip
    assert started.stdout is not None
    assert started.stdout.readline().startswith("Kingpost is at http://127.0.0.1:")
    started.send_signal(signal.SIGINT)
    _, errors = started.communicate(timeout=20)
    assert (started.returncode, errors) == (0, "")


def ask(address: str, request: bytes) -> bytes:
    """All that a server says to some bytes until it closes the connection."""
    place = urlsplit(address)
    with socket.create_connection((place.hostname, place.port), timeout=20) as line:
        line.sendall(request)
        line.shutdown(socket.SHUT_WR)
        return b"".join(iter(lambda: line.recv(65536), b""))


def test_a_body_is_not_read_as_the_next_request(address):
    """Source: RFC 9112, section 6: what follows the head of a request with a length is its body."""
    inner = b"GET /scenarios/index.json HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n"
    outer = b"GET /nonesuch HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Length: %d\r\n\r\n"
    answer = ask(address, outer % len(inner) + inner)
    assert answer.count(b"HTTP/1.1 ") == 1
    assert answer.startswith(b"HTTP/1.1 404 ")


def test_the_answer_to_head_has_no_body_on_errors_either(address):
    """Source: RFC 9110, section 9.3.2: else its bytes would be read as the start of the next answer."""
    answer = ask(address, b"HEAD /nonesuch HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n")
    assert answer.startswith(b"HTTP/1.1 404 ")
    assert answer.endswith(b"\r\n\r\n")


def test_nothing_can_be_sent_to_it(address):
    answer = ask(address, b"POST / HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Length: 2\r\n\r\n{}")
    assert answer.startswith(b"HTTP/1.1 405 ")
    assert b"Allow: GET, HEAD" in answer


def test_an_aborted_download_says_nothing(app, capfd):
    """Source: a phone that leaves in the middle of the engine; the next one is served."""
    (app / "assets" / "engine.wasm").write_bytes(bytes(20_000_000))
    with serve.open_server(app, {}, serve.LOOPBACK, 0) as server:
        thread = threading.Thread(target=server.serve_forever, args=(0.01,))
        thread.start()
        place = f"http://127.0.0.1:{server.server_port}/"
        for _ in range(3):
            with socket.create_connection((serve.LOOPBACK, server.server_port)) as line:
                line.sendall(b"GET /assets/engine.wasm HTTP/1.1\r\nHost: localhost\r\n\r\n")
                line.recv(1000)
                # Closed with data that are not read: the other side gets a reset.
                line.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, b"\1\0\0\0\0\0\0\0")
        assert fetch(place, "").status == 200
        server.shutdown()
        thread.join()
    assert capfd.readouterr().err == ""


def test_connections_that_say_nothing_are_limited_in_number(app, monkeypatch):
    monkeypatch.setattr(listening, "CONNECTIONS", 5)
    with serve.open_server(app, {}, serve.LOOPBACK, 0) as server:
        thread = threading.Thread(target=server.serve_forever, args=(0.01,))
        thread.start()
        lines = [socket.create_connection((serve.LOOPBACK, server.server_port)) for _ in range(12)]
        deadline = time.monotonic() + 2
        while time.monotonic() < deadline and len(server._waitress.active_channels) < 4:
            time.sleep(0.01)
        time.sleep(0.1)
        assert 1 <= len(server._waitress.active_channels) <= 5
        for line in lines:
            line.close()
        server.shutdown()
        thread.join()


def test_a_client_that_is_slower_than_the_time_it_has_is_let_go(app, monkeypatch):
    """Source: RFC 9112, section 9.5: a server may close a connection that is idle; one that has sent half a
    head of a request is idle too."""
    monkeypatch.setattr(listening, "IDLE_S", 0.2)
    with serve.open_server(app, {}, serve.LOOPBACK, 0) as server:
        # How often it looks for them, s.
        server._waitress.adj.cleanup_interval = 0.1
        thread = threading.Thread(target=server.serve_forever, args=(0.01,))
        thread.start()
        try:
            with socket.create_connection((serve.LOOPBACK, server.server_port), timeout=30) as line:
                line.sendall(b"GET / HTTP/1.1\r\nHost: loc")
                assert line.recv(1000) == b""
        finally:
            server.shutdown()
            thread.join()


@pytest.mark.parametrize(
    ("host", "printed"),
    [
        (None, "127.0.0.1"),
        ("0.0.0.0", "192.168.7.9"),
        ("::", "[2001:db8::7]"),
        ("::1", "[::1]"),
        ("10.0.0.2", "10.0.0.2"),
    ],
)
def test_the_address_is_one_that_others_reach(monkeypatch, host, printed):
    monkeypatch.setattr(listening, "lan_address", lambda: "192.168.7.9")
    monkeypatch.setattr(listening, "lan_address6", lambda: "2001:db8::7")
    assert listening.reachable(host) == printed


def test_everywhere_in_ipv6_is_everywhere(app):
    """Source: phones without IPv6 reach it by the other address."""
    try:
        server = serve.open_server(app, {}, "::", 0)
    except kingpost.KingpostError:
        pytest.skip("this machine has no IPv6")
    with server:
        thread = threading.Thread(target=server.serve_forever, args=(0.01,))
        thread.start()
        for host in ("127.0.0.1", "[::1]"):
            assert fetch(f"http://{host}:{server.server_port}/", "").status == 200
        server.shutdown()
        thread.join()
