"""The command `kingpost serve`: its address, its output, and its end.

The app's folder is a small stand-in where the real one is not needed, so that these tests do not
wait for a web build; the browser tests drive the real one.
"""

from __future__ import annotations

import signal
import socket
import subprocess
import sys
import threading

import kingpost
import pytest
from kingpost.cli import main
from kingpost.server import listening, serve
from served import PATIENCE_S, fetch


def test_the_check_fetches_page_engine_and_scenario(app, small, capsys):
    """Source: the public contract of --check."""
    assert main(["serve", str(small), "--port", "0", "--check"]) == 0
    lines = capsys.readouterr().out.splitlines()
    for words in ("text/html", "engine.wasm: application/wasm", "scenarios/small.yaml: application/yaml"):
        assert any(words in line for line in lines), words


def test_a_busy_requested_port_gives_exit_code_2(app, capsys):
    """Source: the public contract: one line."""
    with socket.create_server((serve.LOOPBACK, 0)) as busy:
        port = busy.getsockname()[1]
        assert main(["serve", "--port", str(port)]) == 2
    shown = capsys.readouterr().err
    assert shown.count("\n") == 1
    assert f"port {port} is busy" in shown


def test_without_a_given_port_the_next_free_one_is_used(app, monkeypatch):
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
def test_wrong_arguments_give_one_line_and_exit_code_2(app, arguments, says, capsys):
    """Source: the public contract."""
    assert main(["serve", *arguments]) == 2
    shown = capsys.readouterr().err
    assert shown.count("\n") == 1
    assert says in shown


def test_without_a_built_app_the_error_names_the_build_command(monkeypatch, tmp_path, capsys):
    """Source: the public contract."""
    monkeypatch.setattr(serve, "__file__", str(tmp_path / "python" / "kingpost" / "server" / "serve.py"))
    assert main(["serve"]) == 2
    assert "run: make web" in capsys.readouterr().err


def test_a_given_host_prints_an_address_for_other_machines_and_a_qr_code(app, monkeypatch, capsys):
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
    _, errors = started.communicate(timeout=PATIENCE_S)
    assert (started.returncode, errors) == (0, "")


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
def test_the_printed_address_is_reachable_from_other_machines(monkeypatch, host, printed):
    monkeypatch.setattr(listening, "lan_address", lambda: "192.168.7.9")
    monkeypatch.setattr(listening, "lan_address6", lambda: "2001:db8::7")
    assert listening.reachable(host) == printed


def test_the_ipv6_wildcard_address_also_accepts_ipv4(app):
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
