"""Listener of the command: it takes the film that the page makes, for one token on the loopback address."""

from __future__ import annotations

import hmac
import queue
from collections.abc import Iterable
from dataclasses import dataclass, field
from http import HTTPStatus
from typing import Any, Literal

from ..server.application import Application, Start
from ..server.bodies import is_host_of

Kind = Literal["progress", "part", "done", "failed"]
KINDS: tuple[Kind, ...] = ("progress", "part", "done", "failed")
ORDER = "order"
LARGEST_PART = 5_000_000
"""Largest body of a request, bytes; the page sends a film in parts of 4 MB."""
MOST_WAITING = 4
"""Largest number of messages that wait to be written."""


@dataclass(frozen=True)
class Message:
    """A message of the page."""

    kind: Kind
    body: bytes


@dataclass(frozen=True)
class Receiver:
    """The app, and below ``/film/TOKEN/`` the order of the film and the place to send it to.

    Attributes
    ----------
    app
        Application that answers everything else.
    token
        Secret of this film: another page of this machine does not know it.
    order
        The order, as JSON.
    heard
        Messages of the page, in order.
    """

    app: Application
    token: str
    order: bytes
    heard: queue.Queue[Message] = field(default_factory=lambda: queue.Queue(MOST_WAITING))

    def __call__(self, environ: dict[str, Any], start: Start) -> Iterable[bytes]:
        """Answer one request."""
        path = str(environ.get("PATH_INFO", "")).split("/")
        if path[:2] != ["", "film"]:
            return self.app(environ, start)
        token, name = path[2:] if len(path) == 4 else ("", "")
        is_ours = hmac.compare_digest(token.encode("latin-1"), self.token.encode())
        if not is_ours or not is_host_of(environ.get("HTTP_HOST"), self.app.named):
            return _answer(start, HTTPStatus.NOT_FOUND)
        asked = (environ["REQUEST_METHOD"], name)
        if asked == ("GET", ORDER):
            return _answer(start, HTTPStatus.OK, self.order)
        kind = next((kind for kind in KINDS if asked == ("POST", kind)), None)
        if kind is None:
            return _answer(start, HTTPStatus.NOT_FOUND)
        length = int(environ.get("CONTENT_LENGTH") or 0)
        self.heard.put(Message(kind, environ["wsgi.input"].read(length)))
        return _answer(start, HTTPStatus.OK)


def _answer(start: Start, status: HTTPStatus, body: bytes = b"") -> list[bytes]:
    about = {
        "Content-Type": "application/json",
        "Content-Length": str(len(body)),
        "Cache-Control": "no-store",
    }
    start(f"{status.value} {status.phrase}", list(about.items()))
    return [body]
