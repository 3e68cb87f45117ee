"""Bodies of HTTP answers, compressed for browsers that accept it.

This helps a phone on a slow network: by gzip the engine and the hydrodynamic databases shrink to a third, and
the built app has its files in Brotli, which makes the engine a third smaller again.
"""

from __future__ import annotations

import gzip
import hashlib
import re
import threading
from collections.abc import Iterable
from dataclasses import dataclass
from ipaddress import ip_address
from pathlib import Path
from socket import gethostname
from urllib.parse import urlsplit

TYPES = {
    ".html": "text/html; charset=utf-8",
    ".js": "text/javascript; charset=utf-8",
    ".css": "text/css; charset=utf-8",
    ".json": "application/json",
    ".yaml": "application/yaml; charset=utf-8",
    ".yml": "application/yaml; charset=utf-8",
    ".svg": "image/svg+xml",
    ".wasm": "application/wasm",
    ".webmanifest": "application/manifest+json",
}
"""MIME types by the ending of a path; browsers require them, and the system tables differ."""

PICTURES = {".webp": "image/webp", ".png": "image/png"}
"""MIME types of compressed content."""

CONTENT_POLICY = (
    "default-src 'self'",
    "script-src 'self' 'wasm-unsafe-eval'",
    "style-src 'self' 'unsafe-inline'",
    "img-src 'self' data: blob:",
    "worker-src 'self' blob:",
    "object-src 'none'",
    "base-uri 'none'",
    "form-action 'none'",
)
"""Content security policy of every answer, without the pages that may frame it."""

FIGURE_PAGE = "/figure.html"
"""URL path of the page that other sites may show in a frame."""

PLAIN_TEXT = "text/plain; charset=utf-8"
# Content of these types is not yet compressed, unlike pictures.
COMPRESSIBLE = {*TYPES.values(), PLAIN_TEXT}


def content_type(path: str) -> str:
    """MIME type of a path by its ending.

    >>> content_type("engine/kingpost_bg.wasm")
    'application/wasm'
    """
    return (TYPES | PICTURES).get(Path(path).suffix.lower(), PLAIN_TEXT)


def accepts(coding: str, accept_encoding: str | None) -> bool:
    """Whether a request with this `Accept-Encoding` takes a coding (RFC 9110, section 12.5.3).

    A weight of 0 refuses; `*` matches every coding that is not named; without the header only the plain
    bytes are safe.

    >>> [accepts("gzip", header) for header in ("gzip, deflate, br", "gzip;q=0, *", "br;q=1, *;q=0.5", None)]
    [True, False, True, False]
    >>> [accepts("br", header) for header in ("gzip, deflate, br", "gzip")]
    [True, False]
    """
    weights = {}
    for entry in (accept_encoding or "").lower().split(","):
        name, *parameters = (part.strip() for part in entry.split(";"))
        weight = next((found[1] for part in parameters if (found := re.fullmatch(r"q=([\d.]+)", part))), "1")
        weights["gzip" if name == "x-gzip" else name] = weight
    return re.fullmatch(r"0(\.0*)?", weights.get(coding, weights.get("*", "0"))) is None


def is_host_of(header: str | None, named: str) -> bool:
    """Whether a `Host` header names the server: by an address, as localhost, or by its own name.

    With any other name a foreign web page may have resolved its own name to this machine, to read the served
    files (DNS rebinding).

    >>> [is_host_of(header, "ship.lan") for header in ("127.0.0.1:8000", "Ship.lan:80", "evil.example", "[x")]
    [True, True, False, False]
    """
    try:
        host = urlsplit(f"//{header or ''}").hostname or ""
    except ValueError:
        return False
    if host in {"localhost", named.lower(), gethostname().lower(), f"{gethostname().lower()}.local"}:
        return True
    try:
        ip_address(host)
    except ValueError:
        return False
    return True


def policy(path: str, framed_by: Iterable[str] = ()) -> dict[str, str]:
    """Security headers of the answer for a URL path: no guessing of MIME types, no content from other sites.

    Pages of the origins `framed_by` may show the figure page in a frame, and no other page.

    >>> policy("/figure.html", ["https://ship.example"])["Content-Security-Policy"].split("; ")[-1]
    "frame-ancestors 'self' https://ship.example"
    >>> policy("/", ["https://ship.example"])["Content-Security-Policy"].split("; ")[-1]
    "frame-ancestors 'self'"
    """
    origins = list(framed_by) if path == FIGURE_PAGE else []
    ancestors = " ".join(["frame-ancestors", "'self'", *origins])
    return {
        "X-Content-Type-Options": "nosniff",
        "Referrer-Policy": "no-referrer",
        "Content-Security-Policy": "; ".join([*CONTENT_POLICY, ancestors]),
    }


def is_origin(text: str) -> bool:
    """Whether a text is the origin of web pages: a scheme, a host and a port if it is not the usual one.

    >>> [is_origin(text) for text in ("https://ship.example", "http://[::1]:8080", "ship.example", "*")]
    [True, True, False, False]
    """
    return re.fullmatch(r"https?://([a-zA-Z0-9.-]+|\[[0-9a-fA-F:.]+\])(:\d{1,5})?", text) is not None


@dataclass(frozen=True)
class Body:
    """The bytes of one answer and their headers."""

    content: bytes
    kind: str
    """MIME type."""
    coding: str | None
    """`gzip` or `br`, or None for the plain bytes."""
    tag: str
    """`ETag`, unique for the bytes."""

    def headers(self) -> dict[str, str]:
        """The headers of an answer with these bytes (RFC 9110, section 8)."""
        said = {"Content-Type": self.kind, "Content-Length": str(len(self.content))}
        return said | ({"Content-Encoding": self.coding} if self.coding else {}) | self.validators()

    def validators(self) -> dict[str, str]:
        """Headers for a cache; the only headers if the browser already has these bytes (section 15.4.5)."""
        return {"ETag": self.tag} | ({"Vary": "Accept-Encoding"} if self.kind in COMPRESSIBLE else {})


def built(place: Path, kind: str) -> Body | None:
    """The body of a file that the build has compressed in Brotli; None if there is no such copy beside it."""
    copy = place.with_name(f"{place.name}.br")
    if not copy.is_file():
        return None
    content = copy.read_bytes()
    return Body(content, kind, "br", f'"{hashlib.sha256(content).hexdigest()}-br"')


class Compressor:
    """Maker of bodies that compresses the same bytes only once."""

    def __init__(self) -> None:
        self._gzipped: dict[str, bytes] = {}
        self._lock = threading.Lock()

    def body(self, content: bytes, kind: str, gzipped: bool) -> Body:
        """The body of these plain bytes, gzipped if the browser accepts it, the type allows it and it is
        smaller."""
        digest = hashlib.sha256(content).hexdigest()
        if gzipped and kind in COMPRESSIBLE:
            with self._lock:
                if digest not in self._gzipped:
                    self._gzipped[digest] = gzip.compress(content, compresslevel=6, mtime=0)
            smaller = self._gzipped[digest]
            if len(smaller) < len(content):
                return Body(smaller, kind, "gzip", f'"{digest}-gzip"')
        return Body(content, kind, None, f'"{digest}"')
