"""What tests of the server share: a stand-in for the built app, and answers as they come over the line."""

from __future__ import annotations

import socket
from contextlib import closing
from dataclasses import dataclass
from http.client import HTTPConnection, HTTPMessage
from urllib.parse import urlsplit

PATIENCE_S = 300
"""How long a test waits for a server on a machine that is busy with other things."""
ENGINE = b"\0asm\1\0\0\0" + bytes(1000)


@dataclass(frozen=True)
class Answer:
    """What came over the line, nothing unpacked."""

    status: int
    headers: HTTPMessage
    body: bytes


def fetch(address: str, path: str, accept: str | None = None, known: str | None = None) -> Answer:
    """Ask with these `Accept-Encoding` and `If-None-Match`, or without."""
    headers = {"Accept-Encoding": accept, "If-None-Match": known}
    with closing(HTTPConnection(urlsplit(address).netloc, timeout=PATIENCE_S)) as connection:
        # Else the library adds a header of its own.
        connection.putrequest("GET", f"/{path}", skip_accept_encoding=True)
        for name, value in headers.items():
            if value is not None:
                connection.putheader(name, value)
        connection.endheaders()
        answer = connection.getresponse()
        return Answer(answer.status, answer.headers, answer.read())


def ask(address: str, request: bytes) -> bytes:
    """All that a server says to some bytes until it closes the connection."""
    place = urlsplit(address)
    with socket.create_connection((place.hostname, place.port), timeout=PATIENCE_S) as line:
        line.sendall(request)
        line.shutdown(socket.SHUT_WR)
        return b"".join(iter(lambda: line.recv(65536), b""))
