"""The command line: what it prints, its exit codes, and that a pipe gets no progress bar."""

from __future__ import annotations

import contextlib
import math
import os
import re
import signal
import subprocess
import sys
import threading
from collections.abc import Callable

import kingpost
import pytest
from kingpost.cli import main
from samples import CALIBRATION, TRUTH

SETTINGS = [f"--set={name}={value}" for name, value in CALIBRATION.items()]


def test_run_prints_the_digits_of_three_independent_codes(capsys):
    """Source: samples.TRUTH, read from the printed summary."""
    assert main(["run", "paper", *SETTINGS]) == 0
    shown = capsys.readouterr()
    assert shown.err == ""
    rates = numbers(shown.out, "rate at the end, rad/s")
    assert list(rates) == pytest.approx(
        [TRUTH[f"{name} rate"][0] for name in ("roll", "pitch", "yaw")], abs=1e-5
    )
    joints = shown.out[shown.out.index("joint ") : shown.out.index("reaction, largest")]
    for joint in ("slew", "luff"):
        position, _, rate, _ = numbers(joints, joint)[:4]
        # Printed in degrees, with four places.
        assert math.radians(position) == pytest.approx(TRUTH[joint][0], abs=max(TRUTH[joint][1], 1e-6))
        assert rate == pytest.approx(TRUTH[f"{joint} rate"][0], abs=TRUTH[f"{joint} rate"][1])


def numbers(text: str, label: str) -> list[float]:
    (line,) = (line for line in text.splitlines() if line.startswith(label))
    return [float(word) for word in re.findall(r"(?<![\w/])-?\d+\.\d+(?:e[+-]\d+)?", line[len(label) :])]


def test_run_prints_time_peaks_energy_and_momentum(capsys):
    """Source: the public contract of the summary."""
    assert main(["run", "paper", *SETTINGS]) == 0
    text = capsys.readouterr().out
    for words in ("0.5 s by rk4 in steps of 0.001 s", "largest angle, deg", "largest rate, rad/s",
                  "largest force", "reaction, largest", "energy error", "momentum error"):  # fmt: skip
        assert words in text


def test_the_option_set_accepts_on_and_off(capsys):
    """Source: the public contract of --set."""
    assert main(["check", "paper", "--set", "motor_1=off", "--set", "motor_2=on"]) == 0
    text = capsys.readouterr().out
    assert re.search(r"^motor_1 +motor +off +joint slew", text, re.MULTILINE)
    assert re.search(r"^motor_2 +motor +on +joint luff", text, re.MULTILINE)


def test_run_prints_the_largest_force_of_a_drive_and_the_largest_reaction(capsys):
    """Source: motor 1 turns the tower with 1e5 N m; the weight of 1000 kg stands in its joint."""
    settings = [
        "--set",
        "simulation.duration_s=0.01",
        "--set",
        "bodies.ship.joint.floating.hold_rotation=true",
    ]
    assert main(["run", "paper", *settings]) == 0
    text = capsys.readouterr().out
    assert re.search(r"^slew .* 100  kN m$", text, re.MULTILINE)
    assert (
        main(
            [
                "run",
                "paper",
                "--set",
                "motor_1=off",
                "--set",
                "gravity=on",
                "--set",
                "bodies.arm.joint.revolute.mode=held",
                *settings,
            ]
        )
        == 0
    )
    text = capsys.readouterr().out
    assert re.search(r"^slew +9\.806[67]\d?  kN ", text, re.MULTILINE), text


def test_check_prints_the_model(capsys):
    """Source: the paper's Table 2: 10,000, 500 and 500 kg; 5 coordinates with the centre held."""
    assert main(["check", "paper"]) == 0
    text = capsys.readouterr().out
    for words in ("Crane ship of Jardim", "10000 kg", "total mass: 11000 kg", "revolute slew",
                  "free ship",
                  "free coordinates (5): ship.roll, ship.pitch, ship.yaw, slew, luff", "crane_x_m", "-10",
                  "gravity", "off"):  # fmt: skip
        assert words in text


def test_list_has_a_line_for_each_scenario_of_the_gallery(capsys):
    """Source: the gallery's folder and the titles in its files."""
    assert main(["list"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert f"paper  {kingpost.load('paper').title}" in [re.sub(" {2,}", "  ", line) for line in lines]


def test_the_printed_version_is_that_of_the_engine(capsys):
    """Source: one version for engine and package."""
    with pytest.raises(SystemExit) as ended:
        main(["--version"])
    assert ended.value.code == 0
    assert capsys.readouterr().out == f"kingpost {kingpost.__version__}\n"


def test_the_installed_command_returns_its_exit_codes_and_shows_no_progress_bar_in_a_pipe(tmp_path):
    """Source: the public contract."""
    ran = command("run", "paper", "--set", "simulation.duration_s=0.05", "-o", str(tmp_path / "run.csv"))
    assert (ran.returncode, ran.stderr) == (0, "")
    wrong = command("run", "papre")
    assert wrong.returncode == 2
    assert wrong.stderr.count("\n") == 1
    assert "Traceback" not in wrong.stderr


def command(*arguments: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-m", "kingpost", *arguments], capture_output=True, text=True, timeout=600
    )


@pytest.mark.parametrize("end", ["SIGINT", "SIGTERM", "SIGHUP"])
def test_an_interrupted_long_run_reports_one_line_and_keeps_its_results(capsys, tmp_path, monkeypatch, end):
    """Source: the shell's convention, 128 + SIGINT; a run that ends early keeps its results: at Ctrl-C,
    where the system shuts down, and where the terminal closes."""
    output = tmp_path / "run.csv"
    monkeypatch.setattr(kingpost.Simulation, "run", stopped_on_its_way(getattr(signal, end)))
    # A job in the background starts with SIGINT ignored.
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    settings = [
        "--set",
        "motor_1=off",
        "--set=simulation.duration_s=1e6",
        "--set=simulation.record_every_s=1",
    ]
    try:
        assert main(["run", "paper", "-o", str(output), *settings]) == 130
    finally:
        signal.signal(signal.SIGINT, before)
    shown = capsys.readouterr()
    ended = re.fullmatch(r"error: interrupted at (\d+) s\n", shown.err)
    assert ended, shown.err
    assert f"written         {output}" in shown.out
    assert output.read_text().splitlines()[-1].startswith(f"{ended[1]}.0,")


def stopped_on_its_way(end: signal.Signals) -> Callable:
    """`Simulation.run` with a signal that comes soon after it has recorded something."""
    run, begun = kingpost.Simulation.run, []

    def run_and_stop(simulation, progress=None):
        def told(time_s):
            if not begun:
                begun.append(time_s)
                threading.Timer(0.1, signal.raise_signal, [end]).start()
            if progress is not None:
                progress(time_s)

        return run(simulation, told)

    return run_and_stop


@pytest.mark.skipif(sys.platform == "win32", reason="terminals are POSIX's")
def test_a_long_run_shows_a_progress_bar_on_a_terminal():
    """Source: the public contract; the bar is drawn on stderr and taken away at the end."""
    import pty
    import termios

    reader, terminal = pty.openpty()
    termios.tcsetwinsize(terminal, (24, 80))
    arguments = ["run", "paper", "--set", "motor_1=off", "--set", "simulation.duration_s=60"]
    with subprocess.Popen(
        [sys.executable, "-m", "kingpost", *arguments], stdout=subprocess.DEVNULL, stderr=terminal
    ) as started:
        os.close(terminal)
        shown = b""
        # Linux ends a terminal that nobody holds any more by an error, others by an empty read.
        with contextlib.suppress(OSError):
            while part := os.read(reader, 100_000):
                shown += part
        os.close(reader)
    assert started.returncode == 0
    assert b"%|" in shown
    assert b"/60 s" in shown


def test_the_command_starts_without_any_extra():
    """What only an extra brings is loaded where it is used: a run and the app need none of it."""
    extras = ["scipy", "capytaine", "meshio", "mujoco", "pinocchio", "gymnasium", "netCDF4"]
    code = (
        "import sys\n"
        f"for name in {extras}: sys.modules[name] = None\n"
        "from kingpost.cli import main\n"
        "sys.exit(main(['list']))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert "paper" in done.stdout
