"""The release workflow is valid, its commands exist, and a tag must equal the version."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
import release
import yaml

ROOT = Path(__file__).resolve().parents[2]
WORKFLOW = ROOT / ".github" / "workflows" / "release.yml"
ADVISORIES = WORKFLOW.with_name("advisories.yml")


@pytest.fixture(scope="module")
def jobs() -> dict:
    return yaml.safe_load(WORKFLOW.read_text(encoding="utf-8"))["jobs"]


def commands(jobs: dict) -> list[str]:
    return [
        line for job in jobs.values() for step in job["steps"] for line in step.get("run", "").splitlines()
    ]


def test_every_make_target_and_tool_of_the_workflow_exists(jobs) -> None:
    targets = re.findall(r"^([a-z-]+):", (ROOT / "Makefile").read_text(encoding="utf-8"), re.MULTILINE)
    asked = [word for line in commands(jobs) for word in re.findall(r"^make (\S+)", line)]
    tools = {word for line in commands(jobs) for word in re.findall(r"tools/\w+\.py", line)}
    assert asked == ["web", "docs"]
    assert set(asked) <= set(targets)
    assert tools == {"tools/release.py", "tools/wheel.py"}
    assert all((ROOT / tool).is_file() for tool in tools)


def test_every_wheel_is_tried_before_anything_is_published(jobs) -> None:
    for name in ("linux", "others"):
        steps = [step.get("run", "") for step in jobs[name]["steps"]]
        assert any("release.py try dist" in step for step in steps)
        assert name in jobs["publish"]["needs"]
        assert name in jobs["pages"]["needs"]


def test_actions_and_uv_are_pinned() -> None:
    """A tag of an action can be moved by whoever holds its repository; a commit cannot."""
    makefile = (ROOT / "Makefile").read_text(encoding="utf-8")
    (uv,) = re.findall(r"^UV_VERSION := (\S+)$", makefile, re.MULTILINE)
    for path in WORKFLOW.parent.glob("*.yml"):
        text = path.read_text(encoding="utf-8")
        assert all(version == uv for version in re.findall(r"\buv==(\S+)", text)), path.name
        assert not re.search(r"pip install uv$", text, re.MULTILINE), path.name
        for line in re.findall(r"uses: (.*)", text):
            assert re.fullmatch(r"actions/[\w-]+@[0-9a-f]{40} # v\d+\.\d+\.\d+", line), line


def test_advisories_are_looked_up_for_every_lock_file() -> None:
    (trigger,) = [
        keys for key, keys in yaml.safe_load(ADVISORIES.read_text("utf-8")).items() if key in (True, "on")
    ]
    locks = {path for path in trigger["push"]["paths"] if "lock" in path}
    assert locks == {"Cargo.lock", "uv.lock", "web/package-lock.json"}
    assert all((ROOT / path).is_file() for path in locks)


def test_only_a_tag_publishes(jobs) -> None:
    writing = {name for name, job in jobs.items() if "write" in (job.get("permissions") or {}).values()}
    assert writing == {"pages", "publish"}
    assert all(jobs[name]["if"] == "startsWith(github.ref, 'refs/tags/')" for name in writing)


def test_a_tag_that_is_not_the_version_is_refused(capsys) -> None:
    assert release.main(["version", "v9.9.9"]) == 1
    assert "found v9.9.9, allowed: v0.1.0" in capsys.readouterr().err
    assert release.main(["version", "v0.1.0"]) == 0
    assert release.main(["publish", "dist"]) == 2


def test_a_folder_without_a_wheel_for_every_python_is_refused(tmp_path: Path, capsys) -> None:
    assert release.main(["try", str(tmp_path)]) == 1
    assert "found 0 wheels, allowed: one" in capsys.readouterr().err
    (tmp_path / "kingpost-0.1.0-cp311-cp311-linux_x86_64.whl").touch()
    assert release.main(["try", str(tmp_path)]) == 1
    assert "allowed: abi3" in capsys.readouterr().err
    (tmp_path / "kingpost-0.1.0-cp311-cp311-linux_x86_64.whl").rename(
        tmp_path / "kingpost-0.1.0-cp311-abi3-linux_x86_64.whl"
    )
    assert release.main(["try", str(tmp_path)]) == 1
    assert "allowed: manylinux" in capsys.readouterr().err
