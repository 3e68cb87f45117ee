"""Answers of the server to requests for its host name: files of the app's folder, and pages from memory."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from http import HTTPStatus
from pathlib import Path
from typing import Any

from .bodies import Body, Compressor, accepts, built, content_type, is_host_of, policy

METHODS = ("GET", "HEAD")
Start = Callable[[str, list[tuple[str, str]]], Any]


@dataclass(frozen=True)
class Application:
    """The app as a WSGI application (PEP 3333).

    Attributes
    ----------
    folder
        The built app.
    pages
        The scenarios: contents by URL path; they take precedence over files.
    named
        Given host on which the server listens.
    framed_by
        Origins of pages that may show the figure page in a frame.
    """

    folder: Path
    pages: Mapping[str, bytes]
    named: str
    framed_by: tuple[str, ...] = ()
    compressor: Compressor = field(default_factory=Compressor)

    def __call__(self, environ: dict[str, Any], start: Start) -> Iterable[bytes]:
        """Answer one request. A body that the browser already has is not sent again."""
        security = policy(_path(environ), self.framed_by)
        answer = self._answer(environ, lambda status, headers: start(status, [*headers, *security.items()]))
        return [] if environ["REQUEST_METHOD"] == "HEAD" else answer

    def _answer(self, environ: dict[str, Any], start: Start) -> list[bytes]:
        if environ["REQUEST_METHOD"] not in METHODS:
            return _refused(start, HTTPStatus.METHOD_NOT_ALLOWED, {"Allow": ", ".join(METHODS)})
        if not is_host_of(environ.get("HTTP_HOST"), self.named):
            return _refused(start, HTTPStatus.MISDIRECTED_REQUEST)
        body = self._body(_path(environ), environ.get("HTTP_ACCEPT_ENCODING"))
        if body is None:
            return _refused(start, HTTPStatus.NOT_FOUND)
        if body.tag in environ.get("HTTP_IF_NONE_MATCH", ""):
            _begin(start, HTTPStatus.NOT_MODIFIED, body.validators())
            return []
        _begin(start, HTTPStatus.OK, body.headers())
        return [body.content]

    def _body(self, path: str, accept_encoding: str | None) -> Body | None:
        """Return the page at this URL path, otherwise the file; None if there is neither."""
        if not path.isprintable():
            return None
        kind, gzipped = content_type(path), accepts("gzip", accept_encoding)
        if path in self.pages:
            return self.compressor.body(self.pages[path], kind, gzipped)
        folder = self.folder.resolve()
        try:
            place = (folder / path.lstrip("/")).resolve()
            place = place / "index.html" if path.endswith("/") else place
            if not place.is_relative_to(folder):
                return None
            smallest = built(place, kind) if accepts("br", accept_encoding) else None
            return smallest or self.compressor.body(place.read_bytes(), content_type(place.name), gzipped)
        except (OSError, ValueError):
            return None


def _path(environ: Mapping[str, Any]) -> str:
    """Return the URL path of a request."""
    return str(environ.get("PATH_INFO", "")).encode("latin-1").decode("utf-8", "replace")


def _begin(start: Start, status: HTTPStatus, headers: Mapping[str, str]) -> None:
    """Start the answer, with a header by which the browser keeps no older build."""
    every = {**headers, "Cache-Control": "no-cache"}
    start(f"{status.value} {status.phrase}", list(every.items()))


def _refused(start: Start, status: HTTPStatus, headers: Mapping[str, str] | None = None) -> list[bytes]:
    words = f"{status.phrase}\n".encode()
    about = {"Content-Type": "text/plain; charset=utf-8", "Content-Length": str(len(words))}
    _begin(start, status, about | dict(headers or {}))
    return [words]
