"""Helpers of the server's tests: a stand-in for the built app, and raw answers."""

from __future__ import annotations

import socket
import threading
from collections.abc import Iterator
from contextlib import closing
from dataclasses import dataclass
from http.client import HTTPConnection, HTTPMessage
from pathlib import Path
from urllib.parse import urlsplit

from kingpost.server.listening import Server

PATIENCE_S = 300
"""Longest time that a test waits for a server on a busy machine, s."""
ENGINE = b"\0asm\1\0\0\0" + bytes(1000)


def made_app(within: Path) -> Path:
    """A folder with the kinds of file that a built app has."""
    folder = within / "app"
    (folder / "assets").mkdir(parents=True)
    (folder / "index.html").write_text("<!doctype html><title>Kingpost</title>" + "<p>A ship." * 9)
    (folder / "assets" / "engine.wasm").write_bytes(ENGINE)
    (folder / "assets" / "main.js").write_text("export {};")
    return folder


def running(server: Server) -> Iterator[str]:
    """The address of a server that answers until the iterator is resumed."""
    # It looks for the end as often as this, s.
    thread = threading.Thread(target=server.serve_forever, args=(0.01,))
    thread.start()
    yield f"http://127.0.0.1:{server.server_port}/"
    server.shutdown()
    thread.join()
    server.close()


@dataclass(frozen=True)
class Answer:
    """A raw answer, not decompressed."""

    status: int
    headers: HTTPMessage
    body: bytes


def fetch(address: str, path: str, accept: str | None = None, known: str | None = None) -> Answer:
    """Ask with these `Accept-Encoding` and `If-None-Match`, or without."""
    headers = {"Accept-Encoding": accept, "If-None-Match": known}
    with closing(HTTPConnection(urlsplit(address).netloc, timeout=PATIENCE_S)) as connection:
        # Otherwise the library adds its default header.
        connection.putrequest("GET", f"/{path}", skip_accept_encoding=True)
        for name, value in headers.items():
            if value is not None:
                connection.putheader(name, value)
        connection.endheaders()
        answer = connection.getresponse()
        return Answer(answer.status, answer.headers, answer.read())


def ask(address: str, request: bytes) -> bytes:
    """Send bytes and read the whole answer until the server closes the connection."""
    place = urlsplit(address)
    with socket.create_connection((place.hostname, place.port), timeout=PATIENCE_S) as line:
        line.sendall(request)
        line.shutdown(socket.SHUT_WR)
        return b"".join(iter(lambda: line.recv(65536), b""))
