"""`kingpost serve`: refused requests: foreign host names, other files, bodies, idle connections."""

from __future__ import annotations

import socket
import threading
import time
from contextlib import closing
from http.client import HTTPConnection
from urllib.error import HTTPError
from urllib.parse import urlsplit
from urllib.request import urlopen

import pytest
from kingpost.cli import main
from kingpost.server import listening, serve
from served import PATIENCE_S, Answer, ask, fetch, running


@pytest.mark.parametrize("path", ["assets/", "no/such/file", "../conftest.py", "scenarios/none.yaml"])
def test_folders_and_files_outside_the_app_are_not_served(address, path):
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
def test_a_request_with_a_foreign_host_name_is_refused(address, host, status):
    """Source: DNS rebinding: a web page whose name is made to lead here would read a private scenario."""
    with closing(HTTPConnection(urlsplit(address).netloc, timeout=PATIENCE_S)) as connection:
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


@pytest.mark.parametrize("path", ["", "index.html", "scenarios/index.json", "nonesuch", "figure.html"])
def test_without_an_allowed_origin_no_page_may_be_framed_by_another_site(address, path):
    """Source: Content Security Policy Level 3, section 6.4.2."""
    assert ancestors_of(fetch(address, path)) == "frame-ancestors 'self'"


@pytest.mark.parametrize(
    ("path", "allowed"),
    [
        ("figure.html", "frame-ancestors 'self' https://ship.example http://[::1]:8001"),
        ("", "frame-ancestors 'self'"),
        ("index.html", "frame-ancestors 'self'"),
        ("assets/figure.html", "frame-ancestors 'self'"),
    ],
)
def test_an_allowed_origin_may_frame_the_figure_page_alone(app, path, allowed):
    """Source: Content Security Policy Level 3, section 6.4.2."""
    (app / "figure.html").write_text("<!doctype html><title>Kingpost</title>")
    origins = ("https://ship.example", "http://[::1]:8001")
    with serve.open_server(app, {}, serve.LOOPBACK, 0, framed_by=origins) as server:
        for place in running(server):
            assert ancestors_of(fetch(place, path)) == allowed
            known = fetch(place, path).headers["ETag"]
            assert ancestors_of(fetch(place, path, known=known)) == allowed


@pytest.mark.parametrize(
    "origin", ["*", "ship.example", "https://a.example/page", "https://a b", "https://a;b"]
)
def test_what_is_no_origin_is_refused_in_one_line(app, origin, capsys):
    """Source: the public contract; with a space or a semicolon it would change the policy."""
    assert main(["serve", "--embed-in", origin, "--port", "0", "--check"]) == 2
    shown = capsys.readouterr().err
    assert shown.count("\n") == 1
    assert "--embed-in: found" in shown
    assert "https://example.org" in shown


def ancestors_of(answer: Answer) -> str:
    """The part of the answer's policy that names the pages that may frame it."""
    return answer.headers["Content-Security-Policy"].split("; ")[-1]


def test_the_body_of_a_request_is_not_read_as_the_next_request(address):
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


def test_other_methods_than_get_and_head_are_refused(address):
    answer = ask(address, b"POST / HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Length: 2\r\n\r\n{}")
    assert answer.startswith(b"HTTP/1.1 405 ")
    assert b"Allow: GET, HEAD" in answer


def test_an_aborted_download_prints_nothing(app, capfd):
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


def test_the_number_of_idle_connections_is_limited(app, monkeypatch):
    monkeypatch.setattr(listening, "CONNECTIONS", 5)
    with serve.open_server(app, {}, serve.LOOPBACK, 0) as server:
        thread = threading.Thread(target=server.serve_forever, args=(0.01,))
        thread.start()
        lines = [socket.create_connection((serve.LOOPBACK, server.server_port)) for _ in range(12)]
        deadline = time.monotonic() + PATIENCE_S
        while time.monotonic() < deadline and not server._waitress.active_channels:
            time.sleep(0.01)
        # One too many would be taken at once.
        time.sleep(0.1)
        assert 1 <= len(server._waitress.active_channels) <= 5
        for line in lines:
            line.close()
        server.shutdown()
        thread.join()


def test_a_client_slower_than_the_time_limit_is_disconnected(app, monkeypatch):
    """Source: RFC 9112, section 9.5: a server may close a connection that is idle; one that has sent half a
    head of a request is idle too."""
    monkeypatch.setattr(listening, "IDLE_S", 0.2)
    with serve.open_server(app, {}, serve.LOOPBACK, 0) as server:
        # How often it looks for them, s.
        server._waitress.adj.cleanup_interval = 0.1
        thread = threading.Thread(target=server.serve_forever, args=(0.01,))
        thread.start()
        try:
            with socket.create_connection((serve.LOOPBACK, server.server_port), timeout=PATIENCE_S) as line:
                line.sendall(b"GET / HTTP/1.1\r\nHost: loc")
                assert line.recv(1000) == b""
        finally:
            server.shutdown()
            thread.join()
