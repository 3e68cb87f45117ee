"""Server on a port, and the addresses at which other machines reach it."""

from __future__ import annotations

import socket
import sys
import threading
from collections.abc import Callable, Iterable

from waitress import wasyncore
from waitress.server import create_server

from .application import Application

LOOPBACK, LOOPBACK6 = "127.0.0.1", "::1"
EVERYWHERE, EVERYWHERE6 = ("0.0.0.0", ""), "::"
IDLE_S = 60
"""Time for which a connection may be idle, s."""
CONNECTIONS = 100
"""Largest number of open connections; further ones wait."""
THREADS = 6
LARGEST_REQUEST = 2**16
"""Largest body of a request, bytes; the body is read and ignored."""


class Server:
    """Server of the app on a port; a busy port is an error on every operating system.

    Parameters
    ----------
    address
        Host and port.
    application
        The application.
    answers
        Application in front of it that answers, instead.
    largest_request
        Largest body of a request, bytes.

    Attributes
    ----------
    application, server_port
        The application, and its port.

    Raises
    ------
    OSError, OverflowError
        If the port is not available, or is not a valid port.
    """

    def __init__(
        self,
        address: tuple[str, int],
        application: Application,
        answers: Callable[..., Iterable[bytes]] | None = None,
        largest_request: int = LARGEST_REQUEST,
    ) -> None:
        self.application = application
        self.host = address[0]
        self._ends = threading.Event()
        self._waitress = create_server(
            answers or application,
            sockets=[_bound(*address)],
            threads=THREADS,
            connection_limit=CONNECTIONS,
            channel_timeout=IDLE_S,
            max_request_body_size=largest_request,
            ident=None,
            log_socket_errors=False,
        )
        self.server_port = int(self._waitress.effective_port)

    def serve_forever(self, look_every_s: float = 0.5) -> None:
        """Answer requests until `shutdown`, which another thread may call."""
        while not self._ends.is_set():
            wasyncore.loop(timeout=look_every_s, map=self._waitress._map, count=1)

    def shutdown(self) -> None:
        """End `serve_forever`."""
        self._ends.set()

    def close(self) -> None:
        """Close the port and all connections."""
        self._waitress.task_dispatcher.shutdown()
        wasyncore.close_all(self._waitress._map)

    def __enter__(self) -> Server:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()


def _bound(host: str, port: int) -> socket.socket:
    made = socket.socket(socket.AF_INET6 if ":" in host else socket.AF_INET, socket.SOCK_STREAM)
    try:
        if sys.platform != "win32":
            made.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        if host == EVERYWHERE6:
            # Also accept IPv4, for phones without IPv6.
            made.setsockopt(socket.IPPROTO_IPV6, socket.IPV6_V6ONLY, 0)
        made.bind((host, port))
    except BaseException:
        made.close()
        raise
    return made


def reachable(host: str | None) -> str:
    """The host name in an address for other machines."""
    if host is None:
        return LOOPBACK
    if host in EVERYWHERE:
        host = lan_address()
    elif host == EVERYWHERE6:
        host = lan_address6() or lan_address()
    return f"[{host}]" if ":" in host else host


def from_here(host: str) -> str:
    """The host name in an address for this machine."""
    if host in EVERYWHERE or host == EVERYWHERE6:
        return LOOPBACK if host in EVERYWHERE else f"[{LOOPBACK6}]"
    return reachable(host)


def lan_address() -> str:
    """This machine's address on its network; the loopback address if there is none."""
    return _own(socket.AF_INET, "192.0.2.1") or LOOPBACK


def lan_address6() -> str:
    """This machine's IPv6 address on its network; empty if there is none."""
    return _own(socket.AF_INET6, "2001:db8::1")


def _own(family: socket.AddressFamily, elsewhere: str) -> str:
    try:
        with socket.socket(family, socket.SOCK_DGRAM) as probe:
            # Connecting a datagram socket sends nothing; it only picks the interface.
            probe.connect((elsewhere, 9))
            return probe.getsockname()[0]
    except OSError:
        return ""
