"""Requests to the server of the app, as bytes."""

from __future__ import annotations

import contextlib
import random
import re
import socket
import tempfile
import threading
from functools import cache
from pathlib import Path

from kingpost import gallery
from kingpost.server import serve

from ..contract import Case, WrongError
from ..mutations import damaged, damaged_bytes

END = "Connection: close\r\n\r\n"
HEADS = [
    f"GET / HTTP/1.1\r\nHost: localhost\r\n{END}",
    f"GET /scenarios/index.json HTTP/1.1\r\nHost: 127.0.0.1:8000\r\nAccept-Encoding: gzip, br;q=0.5\r\n{END}",
    f'HEAD /assets/main.js HTTP/1.1\r\nHost: localhost\r\nIf-None-Match: "x"\r\n{END}',
    "GET /scenarios/paper.yaml?scenario=paper HTTP/1.0\r\nHost: localhost\r\n\r\n",
    f"POST / HTTP/1.1\r\nHost: localhost\r\nContent-Length: 40\r\n{END}"
    "GET /secret HTTP/1.1\r\nHost: localhost\r\n\r\n",
    f"POST / HTTP/1.1\r\nHost: localhost\r\nTransfer-Encoding: chunked\r\n{END}5\r\nhello\r\n0\r\n\r\n",
    f"GET /%2e%2e/%2e%2e/secret HTTP/1.1\r\nHost: localhost\r\n{END}",
    f"GET / HTTP/1.1\r\nHost: evil.example\r\n{END}",
    f"OPTIONS * HTTP/1.1\r\nHost: [::1]:80\r\nExpect: 100-continue\r\n{END}",
]
PATHS = ["%00", "%0d%0a", "..", "../..", "%c0%af", "//", "\\", "?", "#", "%", "%zz", "x" * 5000, "é",
"%F0%9F%9A%A2", "~",
         "scenarios/", "scenarios/%2e%2e/", "assets", "offline.js", ";", "\t", "con", "index.html/",
         "a" * 300]  # fmt: skip
LINES = ["Host: localhost", "Host:", "Host: a b", "Content-Length: -1",
"Content-Length: 99999999999999999999",
         "Content-Length: 5", "Transfer-Encoding: chunked", "Transfer-Encoding: gzip",
         "Accept-Encoding: gzip;q=",
         "If-None-Match: *", "Range: bytes=0-", "X: " + "y" * 9000, ": x", " folded", "Upgrade: h2c",
         "Cookie: \x01",
         "Connection: keep-alive", "Expect: 200"]  # fmt: skip
STATUS = re.compile(rb"HTTP/1\.[01] (\d\d\d) ")
SECRET = b"this stands beside the folder that is served"
PATIENCE_S = 60.0


@cache
def port() -> int:
    """A server of a small stand-in for the app, on a thread."""
    root = Path(tempfile.mkdtemp())
    folder = root / "app"
    (folder / "assets").mkdir(parents=True)
    (folder / "index.html").write_text("<!doctype html><title>Kingpost</title>" + "<p>A ship." * 9)
    (folder / "assets" / "main.js").write_text("export {};")
    (root / "secret").write_bytes(SECRET)
    server = serve.open_server(
        folder, {"paper.yaml": gallery.read_text(gallery.folder() / "paper.yaml")}, serve.LOOPBACK, 0
    )
    threading.Thread(target=server.serve_forever, args=(0.01,), daemon=True).start()
    return server.server_port


def drawn(draw: random.Random) -> Case:
    """Draw a request with an error in its line, its head or its body."""
    text = draw.choice(HEADS)
    way = draw.random()
    if way < 0.35:
        method, _, rest = text.partition(" /")
        end = rest.find(" ")
        path = "/".join(draw.choice(PATHS) for _ in range(draw.randrange(1, 4)))
        text = f"{method} /{path}{rest[end:] if end >= 0 else ''}"
    elif way < 0.6:
        lines = text.split("\r\n")
        lines.insert(draw.randrange(1, len(lines)), draw.choice(LINES))
        text = "\r\n".join(lines)
    elif way < 0.85:
        text = damaged(draw, text)
    content = text.encode("utf-8", "replace")
    if way >= 0.85:
        content = damaged_bytes(draw, content)
    return Case("requests", {"request": content})


def use(case: Case, folder: Path) -> str:
    """Send the request, close the sending side, and read the answers to their end."""
    content = case.files["request"]
    with socket.create_connection(("127.0.0.1", port()), timeout=PATIENCE_S) as connection:
        answers = bytearray()
        with contextlib.suppress(OSError):
            connection.sendall(content)
            connection.shutdown(socket.SHUT_WR)
            while part := _received(connection):
                answers += part
    if SECRET in answers:
        raise WrongError("a file beside the folder that is served")
    statuses = STATUS.findall(bytes(answers))
    if any(status.startswith(b"5") and status not in (b"501", b"505") for status in statuses):
        raise WrongError(f"answered {statuses}: {bytes(answers[:300])!r}")
    if answers and not answers.startswith(b"HTTP/"):
        raise WrongError(f"an answer without a status: {bytes(answers[:100])!r}")
    return f"answered {statuses[0].decode()}" if statuses else "closed"


def _received(connection: socket.socket) -> bytes:
    try:
        return connection.recv(1 << 16)
    except TimeoutError:
        raise WrongError(f"no end of an answer in {PATIENCE_S:g} s") from None
