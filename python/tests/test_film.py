"""`kingpost film`: its choices, what it says without a browser or with one that fails, and a real film."""

from __future__ import annotations

import json
import os
import re
import socket
import sys
import threading
import time
from collections.abc import Iterator
from contextlib import closing
from http.client import HTTPConnection
from pathlib import Path

import kingpost
import pytest
from kingpost import browser
from kingpost.cli import main
from kingpost.film import make, order
from kingpost.film.receiver import LARGEST_PART, Message, Receiver
from kingpost.server import serve
from kingpost.server.application import Application
from kingpost.server.listening import LOOPBACK, Server
from served import PATIENCE_S, made_app

ROOT = Path(__file__).resolve().parents[2]
EBML = b"\x1a\x45\xdf\xa3"
"""First bytes of every WebM file."""
POSIX = pytest.mark.skipif(os.name != "posix", reason="the stand-in for a browser is a script")


@pytest.fixture
def app(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A stand-in for the built app."""
    built = made_app(tmp_path / "built")
    monkeypatch.setattr(serve, "app_folder", lambda: built)
    return built


def stand_in(within: Path, monkeypatch: pytest.MonkeyPatch, program: str) -> None:
    """Take a Python program for the browser; `send(kind, body)` and `ask()` speak as the page does."""
    path = within / "browser"
    head = f"""#!{sys.executable}
import sys, time
from urllib.request import urlopen
address, token = sys.argv[-1].split("#film=")
address = address.split("?")[0] + "film/" + token + "/"
ask = lambda: urlopen(address + "order").read()
send = lambda kind, body: urlopen(address + kind, data=body).read()
"""
    path.write_text(head + program, encoding="utf-8")
    path.chmod(0o755)
    monkeypatch.setenv(browser.VARIABLE, str(path))


@pytest.mark.parametrize(
    ("options", "says"),
    [
        (
            ["--size", "1281x720"],
            "--size: found '1281x720', allowed: WIDTHxHEIGHT, even numbers of 64 to 8192",
        ),
        (["--size", "large"], "--size: found 'large'"),
        (["--fps", "0"], "--fps: found 0, allowed: 1 to 120"),
        (["--fps", "nan"], "--fps: found nan"),
        (["--speed", "-1"], "--speed: found -1, allowed: 0.01 to 1000"),
        (["--to", "4"], "--from, --to: found 0 to 4 s, allowed: a first and a later last time, 0 to 3 s"),
        (["--from", "2", "--to", "1"], "found 2 to 1 s"),
        (
            ["--camera", "crow"],
            "--camera: found 'crow', allowed: free, load, cab, bridge, top, section, or six",
        ),
        (["--caption", "a" * 301], "--caption: found 301 characters, allowed: up to 300"),
        (["-o", "lift.avi"], "unknown ending, allowed: .webm, .mp4"),
    ],
)
def test_wrong_options_are_refused_before_a_browser_is_started(options, says, tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(browser, "find_browser", lambda: pytest.fail("a browser was looked for"))
    monkeypatch.chdir(tmp_path)
    assert main(["film", "paper", "-o", "lift.webm", *options]) == 2
    assert says in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []


def test_the_limits_are_those_of_the_app() -> None:
    """Source: `web/src/film/choice.ts`."""
    text = (ROOT / "web/src/film/choice.ts").read_text(encoding="utf-8")
    found = re.search(r"ALLOWED = (\{.*?\}) as const", text)
    assert found is not None
    allowed = json.loads(re.sub(r"(\w+):", r'"\1":', found[1]))
    assert allowed == {
        "edge": list(order.EDGE_PX),
        "frames_per_s": list(order.FPS),
        "speed": list(order.SPEED),
        "caption": order.LONGEST_CAPTION,
    }
    cameras = re.search(
        r"CAMERAS = (\[.*?\])", (ROOT / "web/src/view/viewpoint.ts").read_text(encoding="utf-8")
    )
    assert cameras is not None
    assert json.loads(cameras[1]) == list(order.CAMERAS)


def test_without_a_browser_the_error_says_what_to_install(app, tmp_path, monkeypatch, capsys):
    monkeypatch.delenv(browser.VARIABLE, raising=False)
    monkeypatch.setattr(browser, "BROWSERS", ())
    assert main(["film", "paper", "-o", str(tmp_path / "lift.webm")]) == 2
    said = capsys.readouterr().err
    assert "found no browser, allowed: Chromium, Chrome or Edge on the path, or named by CHROMIUM" in said
    assert said.count("\n") == 1


@POSIX
def test_the_film_that_the_page_sends_is_written_whole(app, tmp_path, monkeypatch, capsys):
    program = "open(sys.argv[0] + '.json', 'wb').write(ask()); send('progress', b'{}')\n"
    parts = "send('part', b'a' * 4000000); send('part', b'b'); send('done', b''); time.sleep(60)"
    stand_in(tmp_path, monkeypatch, program + parts)
    path = tmp_path / "lift.mp4"
    given = [
        "--size",
        "640x360",
        "--from",
        "1",
        "--to",
        "2",
        "--plots",
        "--caption",
        "A lift.",
        "--camera",
        "top",
    ]
    assert main(["film", "paper", "-o", str(path), *given]) == 0
    assert path.read_bytes() == b"a" * 4000000 + b"b"
    assert str(path) in capsys.readouterr().out
    assert json.loads((tmp_path / "browser.json").read_text()) == {
        "format": "mp4", "size": {"width": 640, "height": 360}, "hasPlots": True, "from_s": 1.0, "to_s": 2.0,
        "frames_per_s": 30.0, "speed": 1.0, "caption": "A lift.", "camera": "top",
    }  # fmt: skip


@POSIX
def test_a_run_that_stops_early_gives_its_film_and_exit_code_1(app, tmp_path, monkeypatch, capsys):
    stand_in(tmp_path, monkeypatch, "send('part', b'film'); send('done', b'the ship capsized')")
    assert main(["film", "paper", "-o", str(tmp_path / "lift.webm")]) == 1
    assert "the ship capsized" in capsys.readouterr().err
    assert (tmp_path / "lift.webm").read_bytes() == b"film"


@POSIX
@pytest.mark.parametrize(
    ("program", "says"),
    [
        ("send('part', b'half'); send('failed', b'no picture')", "film: no picture"),
        (
            "send('progress', b'almost there'); sys.exit(3)",
            "the browser ended with 3; the page said last: almost there",
        ),
        (
            "send('progress', b'{\"stage\": \"run\"}'); time.sleep(600)",
            'said nothing for 3 s; before that: {"stage": "run"}',
        ),
    ],
)
def test_a_browser_that_fails_or_falls_silent_is_reported_with_its_last_words(
    program, says, app, tmp_path, monkeypatch
) -> None:
    stand_in(tmp_path, monkeypatch, program)
    path = tmp_path / "lift.webm"
    path.write_bytes(b"an older film")
    started_s = time.monotonic()
    with pytest.raises(kingpost.KingpostError) as raised:
        make.make(kingpost.load("paper"), path, order.Order(), silent_s=3)
    assert says in str(raised.value)
    assert time.monotonic() - started_s < PATIENCE_S
    assert path.read_bytes() == b"an older film"
    assert [one.name for one in tmp_path.iterdir() if one.name.startswith(".")] == []


@pytest.fixture
def receiver(tmp_path: Path) -> Iterator[tuple[Receiver, int]]:
    """A receiver that listens, and its port."""
    made = Receiver(Application(made_app(tmp_path), {}, LOOPBACK), "secret", b"{}")
    with Server((LOOPBACK, 0), made.app, made, LARGEST_PART) as server:
        thread = threading.Thread(target=server.serve_forever, args=(0.01,))
        thread.start()
        yield made, server.server_port
        server.shutdown()
        thread.join()


def test_only_the_token_of_the_film_opens_the_receiver(receiver) -> None:
    """Source: another page or user of this machine must not read the order or write the file."""
    made, port = receiver

    def asked(method: str, path: str, body: bytes | None = None, host: str = "127.0.0.1") -> int:
        with closing(HTTPConnection(LOOPBACK, port, timeout=PATIENCE_S)) as connection:
            connection.request(method, path, body, {"Host": host})
            return connection.getresponse().status

    def announced(size: int) -> int:
        with closing(HTTPConnection(LOOPBACK, port, timeout=PATIENCE_S)) as connection:
            connection.putrequest("POST", "/film/secret/part")
            connection.putheader("Content-Length", str(size))
            connection.endheaders()
            return connection.getresponse().status

    assert asked("GET", "/film/secret/order") == 200
    assert asked("POST", "/film/secret/part", b"film") == 200
    assert made.heard.get_nowait() == Message("part", b"film")
    for path in (
        "/film/guess/part",
        "/film//part",
        "/film/secret/other",
        "/film/secret",
        "/film/secret/part/x",
    ):
        assert asked("POST", path, b"film") == 404, path
    assert asked("GET", "/film/secret/part") == 404
    assert asked("POST", "/film/secret/part", b"film", host="evil.example") == 404
    assert announced(LARGEST_PART + 1) == 413
    assert asked("POST", "/", b"film") == 405
    assert asked("GET", "/") == 200
    assert made.heard.empty()


def test_the_receiver_is_on_the_loopback_address_alone(app) -> None:
    scenario = kingpost.load("paper")
    with make._listening(scenario, "secret", b"{}") as (_, address):
        assert address.startswith("http://127.0.0.1:")
        port = int(address.split(":")[2].split("/")[0])
        with pytest.raises(OSError, match=r"refused|unreachable|not available|address"):
            socket.create_connection(("::1", port), timeout=1)


def test_a_film_of_half_a_second_is_made_by_a_browser(tmp_path, capsys) -> None:
    """Source: the EBML header of WebM, and the size in its track."""
    if browser.find_browser() is None or not (ROOT / "web/dist/index.html").is_file():
        pytest.skip("no browser, or no built app, on this machine")
    path = tmp_path / "paper.webm"
    given = ["--size", "320x180", "--fps", "10", "--to", "0.5", "--plots"]
    assert main(["film", "paper", "-o", str(path), *given]) == 0
    film = path.read_bytes()
    assert film.startswith(EBML)
    # PixelWidth and PixelHeight, two bytes each.
    assert b"\xb0\x82\x01\x40\xba\x82\x00\xb4" in film or b"\xb0\x82\x01\x40\xba\x81\xb4" in film
    # A block for each of the six frames.
    assert film.count(b"\xa3") >= 6
