"""Typical difficulties of users: incomplete meshes and records, titles with terminal codes, fields in braces,
pages whose lines do not run."""

import re
import signal
import sys
from pathlib import Path

import kingpost
import kingpost_command
import numpy as np
import pytest
from kingpost import output
from kingpost.cli import main
from kingpost.commands.interrupts import finished_first
from kingpost.errors import HydrodynamicsError
from kingpost.hydro import hull_files
from kingpost.hydro.drift import Loading

AFLOAT = Path(__file__).resolve().parents[2] / "docs" / "afloat.md"
POINTS = "v 0 0 -1\nv 1 0 -1\nv 0 1 -1\n"
ESCAPES = 'version: 1\ntitle: "a\\e[31mred\\x07"\nbodies:\n  a: {mass_kg: 1, joint: {floating: {}}, shape: {box: {length_m: 1, width_m: 1, height_m: 1}}}\n'  # noqa: E501


@pytest.mark.parametrize(
    ("faces", "found"),
    [
        ("f 1 2 9\n", "found a face with a point that is not in the file, allowed: 1 to 3"),
        ("f 0 2 3\n", "found a face with a point that is not in the file"),
        ("f 1 1 2\nf 2 2 2\n", "found faces without an area only"),
    ],
)
def test_a_mesh_with_empty_faces_is_refused(tmp_path, faces, found) -> None:
    pytest.importorskip("meshio")
    path = tmp_path / "hull.obj"
    path.write_text(POINTS + faces, encoding="utf-8")
    with pytest.raises(HydrodynamicsError, match=found):
        hull_files.read(path)


def test_an_impossible_radius_of_gyration_is_named() -> None:
    """Source: of any body the moments hold to the inequality of a triangle; of a disc they meet it."""
    Loading(5.0, 3.0, 4.0, 5.0)
    with pytest.raises(HydrodynamicsError, match=r"--loading yaw_gyration_m: found 9, allowed: at most 5:"):
        Loading(5.0, 3.0, 4.0, 9.0)


def test_a_title_does_not_reach_the_terminal_as_commands(tmp_path, capsys) -> None:
    path = tmp_path / "red.yaml"
    path.write_text(ESCAPES, encoding="utf-8")
    for command in (["check"], ["run", "--set", "simulation.duration_s=0.01"]):
        assert main([command[0], str(path), *command[1:]]) == 0
        shown = capsys.readouterr().out
        assert shown.startswith("a?[31mred?\n")
        assert "\x1b" not in shown


def test_texts_that_begin_with_a_byte_order_mark_are_read(tmp_path) -> None:
    """Source: what a spreadsheet writes as CSV in UTF-8."""
    table = tmp_path / "ship.raos.csv"
    assert main(["rao", "offshore_vessel", "--displacement-raos", str(table), "--directions-deg",
                 "0", "90", "180", "--quiet"]) == 0  # fmt: skip
    (page,) = re.findall(r"## A ship that its RAOs move.*?```yaml\n(.*?)```", AFLOAT.read_text("utf-8"), re.S)
    path = tmp_path / "moved.yaml"
    path.write_text(page, encoding="utf-8")
    settings = {"simulation.duration_s": 1}
    plain = kingpost.run(path, settings)["position"].values
    for file in (table, path):
        file.write_bytes(b"\xef\xbb\xbf" + file.read_bytes())
    np.testing.assert_array_equal(kingpost.run(path, settings)["position"].values, plain)


def test_fields_in_braces_are_set(capsys) -> None:
    """Source: the same set one by one."""
    settings = ["--set", "motor_1=off", "--set", "simulation.duration_s=0.2"]
    assert main(["run", "paper", *settings, "--set",
                 "bodies.tower.joint.revolute.mode={prescribed: {rate_rad_s: 0.1}}"]) == 0  # fmt: skip
    in_braces = capsys.readouterr().out
    assert main(["run", "paper", *settings, "--set",
                 'bodies.tower.joint.revolute.mode={"prescribed": {"rate_rad_s": 0.1}}']) == 0  # fmt: skip
    assert capsys.readouterr().out == in_braces
    assert main(["run", "barge", "--set", "sea={waves: {}}", "--set", "simulation.duration_s=0.1"]) == 0
    assert main(["run", "barge", "--set", "sea={waves: "]) == 2
    assert "--set sea: found '{waves:', allowed: fields as" in capsys.readouterr().err


@pytest.mark.parametrize("option", ["--directions-deg", "--directions_deg"])
def test_hyphens_and_underscores_of_an_option_are_one(option, capsys) -> None:
    assert main(["rao", "barge", option, "180", "--quiet"]) == 0
    assert capsys.readouterr().out == ""


@pytest.mark.parametrize(
    "command",
    [
        ["run", "barge", "--seeds", "99999999999", "-o", "run_*.nc"],
        ["rao", "barge", "--frequencies-rad-s", "1:2:999999999999"],
        ["modes", "chain", "--sweep", "damping=0:1:99999999999"],
    ],
)
def test_counts_beyond_any_memory_are_refused_at_once(command, capsys) -> None:
    assert main(command) == 2
    assert re.search(r"found .*9999.*, allowed: .* (up )?to 10", capsys.readouterr().err)


def test_a_misspelt_file_gets_the_nearest_name_in_its_folder(tmp_path, capsys) -> None:
    (tmp_path / "harbour_lift.yaml").write_text("version: 1\n", encoding="utf-8")
    wrong = tmp_path / "harbor_lift.yaml"
    assert main(["run", str(wrong)]) == 2
    assert f"no such file; did you mean {tmp_path / 'harbour_lift.yaml'}?" in capsys.readouterr().err
    assert main(["run", str(tmp_path / "no_folder" / "lift.yaml")]) == 2
    assert capsys.readouterr().err.endswith("lift.yaml: no such file\n")


def test_a_misspelt_option_gets_the_nearest_option_of_its_command(capsys) -> None:
    with pytest.raises(SystemExit):
        main(["run", "barge", "--outptu", "run.csv"])
    assert "--outptu run.csv; did you mean --output? (see kingpost run --help)" in capsys.readouterr().err


def test_a_misspelt_column_gets_the_nearest_column_of_the_scenario(capsys) -> None:
    """Source: a hull that is not named ship, so that no fixed example is right."""
    assert main(["run", "offshore_vessel", "--record", "hull.rol"]) == 2
    assert "--record: found 'hull.rol', allowed: columns such as hull.roll" in capsys.readouterr().err


def test_the_error_for_a_column_in_place_of_a_file_names_the_option(capsys) -> None:
    assert main(["statistics", "ship.roll"]) == 2
    assert capsys.readouterr().err.endswith("writes them; columns follow --channels\n")


def test_an_interrupt_during_imports_gives_one_line(monkeypatch, capsys) -> None:
    class Interrupt:
        def find_spec(self, name: str, *_: object) -> None:
            if name == "kingpost.cli":
                raise KeyboardInterrupt

    monkeypatch.delitem(sys.modules, "kingpost.cli")
    monkeypatch.setattr(sys, "meta_path", [Interrupt(), *sys.meta_path])
    assert kingpost_command.main() == 130
    assert capsys.readouterr().err == "error: interrupted\n"


@pytest.mark.parametrize("end", ["SIGINT", "SIGTERM"])
def test_an_interrupt_while_a_run_is_written_does_not_lose_it(tmp_path, monkeypatch, capsys, end) -> None:
    """Source: exit code 130 says that what was computed is kept."""
    target, written = tmp_path / "run.csv", output.write_text

    def interrupted(*given) -> Path:
        signal.raise_signal(getattr(signal, end))
        return written(*given)

    target.write_text("old", encoding="utf-8")
    monkeypatch.setattr(output, "write_csv", lambda table, path: interrupted(path, table.to_csv(index=False)))
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        settings = ["--set", "simulation.duration_s=0.1"]
        assert main(["run", "barge", *settings, "-o", str(target)]) == 130
        assert target.read_text().splitlines()[-1].startswith("0.1,")
        assert "error: interrupted at 0.1 s" in capsys.readouterr().err
    finally:
        signal.signal(signal.SIGINT, before)


def test_a_second_interrupt_stops_the_writing() -> None:
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        ended = False
        with pytest.raises(KeyboardInterrupt), finished_first():  # noqa: PT012
            signal.raise_signal(signal.SIGINT)
            ended = True
            signal.raise_signal(signal.SIGINT)
            ended = False
        assert ended
        assert signal.getsignal(signal.SIGINT) is signal.default_int_handler
    finally:
        signal.signal(signal.SIGINT, before)
