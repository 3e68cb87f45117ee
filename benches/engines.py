"""Benchmark programs: build and start of each engine's program, and the reason if one is left out."""

from __future__ import annotations

import importlib.metadata
import importlib.util
import json
import os
import shutil
import subprocess
import sys
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import models

BENCHES = Path(__file__).resolve().parent
BUILD = models.REPOSITORY / "target" / "bench"
FLAGS = ("-std=c++17", "-O3", "-DNDEBUG", "-w")
# as defined by Pinocchio's CMake target, so that its list of joints compiles
PINOCCHIO_DEFINITIONS = (
    "-DBOOST_MPL_LIMIT_LIST_SIZE=30",
    "-DBOOST_MPL_LIMIT_VECTOR_SIZE=30",
    "-DBOOST_MPL_CFG_NO_PREPROCESSED_HEADERS",
    "-DBOOST_FUSION_INVOKE_MAX_ARITY=12",
)
# many runs at once: scheme and threads
BATCHES = ("batch_euler_1", "batch_euler_2", "batch_rk4_1", "batch_rk4_2")
# for a ship in the water and for a lift: the step of the released engine
AFLOAT = ("rk4_step_ledger",)
WASM_PACKAGE = models.REPOSITORY / "web" / "src" / "engine" / "pkg"


class NotHereError(Exception):
    """Error of an engine that cannot be measured on this machine; the message gives the reason."""


@dataclass(frozen=True)
class Engine:
    """A program that runs ``OPERATION MODE NUMBERS`` on one model, and the conversion of its values to
    Kingpost's layout."""

    name: str
    case: models.Case
    command: tuple[str, ...]
    operations: tuple[str, ...]
    countable: bool
    version: str
    acceleration: Callable[[models.tree.Array], models.tree.Array]
    state: Callable[[models.tree.Array], models.tree.Array]


def same(values: models.tree.Array) -> models.tree.Array:
    """Values that are in Kingpost's layout already."""
    return values


def kingpost_native(case: models.Case, folder: Path, quick: bool) -> Engine:
    """The engine crate, called from a small Rust program; a quick run uses the library built for the
    tests."""
    # The features of the tests: with others cargo would build the engine once more.
    packages = ("kingpost", "kingpost-bench", "kingpost-py")
    tested = (*(word for name in packages for word in ("--package", name)), "--all-features")
    chosen = (*tested, "--bin", "kingpost-bench") if quick else ("--package", "kingpost-bench", "--release")
    _run([_tool("cargo"), "build", "--quiet", "--locked", *chosen])
    program = _target() / ("debug" if quick else "release") / "kingpost-bench"
    path = models.write_kingpost(case, folder)
    steps = ("euler_step", "rk4_step", "rk4_step_ledger", "lanes_euler", "lanes_rk4", *BATCHES)
    operations = ("forward",) if case.links else ("forward", *steps)
    if case.tree is None:
        operations = AFLOAT
    version = importlib.metadata.version("kingpost")
    return Engine("kingpost", case, (str(program), str(path)), operations, True, version, same, same)


def kingpost_avx2(case: models.Case, folder: Path, quick: bool) -> Engine:
    """Many runs with the wider lanes of the wheel's second build, if the processor supports them."""
    if quick:
        raise NotHereError("a quick run leaves out the second build")
    information = Path("/proc/cpuinfo")
    if not information.exists() or " avx2 " not in information.read_text():
        raise NotHereError("the processor has no AVX2, or does not say so")
    target = _target() / "bench-avx2"
    command = [_tool("cargo"), "build", "--quiet", "--locked", "--package", "kingpost-bench", "--release"]
    _run([*command, "--target-dir", str(target)], {"RUSTFLAGS": "-C target-feature=+avx2"})
    program = target / "release" / "kingpost-bench"
    path = models.write_kingpost(case, folder)
    version = importlib.metadata.version("kingpost")
    operations = ("lanes_euler", "lanes_rk4", *BATCHES)
    return Engine("kingpost-avx2", case, (str(program), str(path)), operations, True, version, same, same)


def kingpost_wasm(case: models.Case, folder: Path, quick: bool) -> Engine:
    """WASM under node: the step with its ledger in the app's module, other operations in the benchmark's
    module."""
    node = _tool("node")
    packed = (WASM_PACKAGE / "kingpost_wasm_bg.wasm").exists()
    bare = None if quick else _wasm_program()
    if not packed and bare is None:
        raise NotHereError("the WASM package is not built")
    measured = AFLOAT if case.tree is None else ("forward", "rk4_step", "rk4_step_ledger")
    operations = tuple(name for name in measured if (packed if name == "rk4_step_ledger" else bare))
    path = models.write_kingpost(case, folder)
    command = (node, str(BENCHES / "wasm.mjs"), str(WASM_PACKAGE), str(bare), str(path))
    version = f"node {_output([node, '--version'])}"
    if len(operations) < len(measured):
        version += f"; not built here: {', '.join(name for name in measured if name not in operations)}"
    return Engine("kingpost-wasm", case, command, operations, False, version, same, same)


def _wasm_program() -> Path | None:
    """The benchmark program compiled for WASM; nothing if the compiler cannot build it."""
    triple = "wasm32-unknown-unknown"
    arguments = ["build", "--quiet", "--locked", "--package", "kingpost-bench", "--profile", "wasm"]
    try:
        _run([_tool("cargo"), *arguments, "--target", triple])
    except NotHereError:
        return None
    return _target() / triple / "wasm" / "kingpost-bench.wasm"


def _target() -> Path:
    """Target folder of cargo."""
    return Path(os.environ.get("CARGO_TARGET_DIR", models.REPOSITORY / "target"))


def mujoco(case: models.Case, folder: Path, quick: bool) -> Engine:
    """MuJoCo's C library from its wheel."""
    del quick
    root = _package("mujoco")
    libraries = sorted(root.glob("libmujoco.so*"))
    if not libraries or not (root / "include").is_dir():
        raise NotHereError("the wheel has no headers or library")
    source = BENCHES / "peers" / "mujoco_bench.cpp"
    options = ("-I", str(root / "include"), str(libraries[0]), f"-Wl,-rpath,{root}")
    program = _compile("mujoco_bench", source, options, quick=False)
    path = models.write_mujoco(case, folder)
    version = importlib.metadata.version("mujoco")
    operations = ("forward",) if case.links else ("forward", "euler_step", "rk4_step")
    state = same
    if case.lift is not None:
        operations, state = ("rk4_step",), partial(models.mujoco_lift_as_ours, case)
    return Engine("mujoco", case, (str(program), str(path)), operations, True, version, same, state)


def mujoco_wasm(case: models.Case, folder: Path, quick: bool) -> Engine:
    """MuJoCo's official WASM build under node, with one JavaScript call for each evaluation."""
    node, installed = _tool("node"), BENCHES / "node_modules" / "@mujoco" / "mujoco"
    if not installed.exists():
        if quick:
            raise NotHereError("its npm package is not installed, which a quick run leaves out")
        _run([_tool("npm"), "ci", "--prefix", str(BENCHES)])
    path = models.write_mujoco(case, folder)
    command = (node, str(BENCHES / "peers" / "mujoco_wasm.mjs"), str(path))
    version = json.loads((installed / "package.json").read_text())["version"]
    operations = ("forward", "euler_step", "rk4_step")
    return Engine("mujoco-wasm", case, command, operations, False, version, same, same)


def mujoco_rollout(case: models.Case, folder: Path, quick: bool) -> Engine:
    """MuJoCo's own program for many runs, from Python."""
    del quick
    _package("mujoco")
    path = models.write_mujoco(case, folder)
    command = (sys.executable, str(BENCHES / "peers" / "mujoco_rollout.py"), str(path))
    version = importlib.metadata.version("mujoco")
    return Engine("mujoco-rollout", case, command, BATCHES, False, version, same, same)


def exudyn(case: models.Case, folder: Path, quick: bool) -> Engine:
    """Exudyn's explicit RK4, from Python; its steps run in C++."""
    del quick
    _package("exudyn")
    path = models.write_exudyn(case, folder)
    command = (sys.executable, str(BENCHES / "peers" / "exudyn_lift.py"), str(path))
    version = importlib.metadata.version("exudyn")
    return Engine("exudyn", case, command, ("rk4_step",), False, version, same, same)


def pinocchio(case: models.Case, folder: Path, quick: bool) -> Engine:
    """Pinocchio's C++ headers from its wheel."""
    prefix = _package("pinocchio").parents[3]
    include = prefix / "include"
    if not (include / "eigen3").is_dir() or not (include / "boost").is_dir():
        raise NotHereError("Eigen's or Boost's headers are not installed (cmeel-eigen, cmeel-boost)")
    source = BENCHES / "peers" / "pinocchio_bench.cpp"
    options = (*PINOCCHIO_DEFINITIONS, "-I", str(include), "-I", str(include / "eigen3"))
    program = _compile("pinocchio_bench", source, options, quick=quick)
    path = models.write_pinocchio(case, folder)
    return Engine(
        "pinocchio",
        case,
        (str(program), str(path)),
        ("forward",) if case.links else ("forward", "rk4_step"),
        True,
        importlib.metadata.version("pin"),
        lambda values: models.pinocchio_acceleration_as_ours(case, values),
        lambda values: models.pinocchio_as_ours(case, values),
    )


Builder = Callable[[models.Case, Path, bool], Engine]
BUILDERS: dict[str, Builder] = {
    "kingpost": kingpost_native,
    "kingpost-avx2": kingpost_avx2,
    "kingpost-wasm": kingpost_wasm,
    "pinocchio": pinocchio,
    "mujoco": mujoco,
    "mujoco-wasm": mujoco_wasm,
    "mujoco-rollout": mujoco_rollout,
    "exudyn": exudyn,
}
# engines that also run other models than the paper's: chains, a ship in the water, a lift
ON_CHAINS = ("kingpost", "pinocchio", "mujoco")
ON_WATER = ("kingpost", "kingpost-wasm")
ON_A_ROPE = ("kingpost", "kingpost-wasm", "mujoco", "exudyn")


def takes(name: str, case: models.Case) -> bool:
    """Whether an engine is measured on a model."""
    if case.lift is not None:
        return name in ON_A_ROPE
    if case.tree is None:
        return name in ON_WATER
    return name in ON_CHAINS or not (case.links or name == "exudyn")


def _tool(name: str) -> str:
    """The path of a program."""
    found = shutil.which(name)
    if found is None:
        raise NotHereError(f"{name} is not installed")
    return found


def _package(name: str) -> Path:
    """The folder of an installed Python package, without importing it."""
    found = importlib.util.find_spec(name)
    if found is None or found.origin is None:
        raise NotHereError(f"the package {name} is not installed")
    return Path(found.origin).resolve().parent


def _compile(name: str, source: Path, options: Sequence[str], *, quick: bool) -> Path:
    """Compiles a peer's program, unless it was already built with the same command and sources. Pinocchio's
    takes a minute or two; a quick run leaves it out if it is not built.
    """
    compiler = _tool("g++")
    program, stamp = BUILD / name, BUILD / f"{name}.stamp"
    command = [compiler, *FLAGS, str(source), *options, "-o", str(program)]
    header = source.parent / "bench.hpp"
    text = "\n".join([*command, source.read_text(), header.read_text()])
    if program.exists() and stamp.exists() and stamp.read_text() == text:
        return program
    if quick:
        raise NotHereError("its program is not built yet, which a quick run leaves out")
    BUILD.mkdir(parents=True, exist_ok=True)
    _run(command)
    stamp.write_text(text)
    return program


def _run(command: Sequence[str], environment: Mapping[str, str] | None = None) -> None:
    """Runs a build command; if it fails, its last error line is the reason."""
    done = subprocess.run(
        command,
        cwd=models.REPOSITORY,
        env=os.environ | (environment or {}),
        capture_output=True,
        text=True,
        check=False,
    )
    if done.returncode:
        errors = [line for line in done.stderr.splitlines() if "error" in line] or [done.stderr.strip()]
        raise NotHereError(f"{Path(command[0]).name} failed: {errors[0][:200]}")


def _output(command: Sequence[str]) -> str:
    """Output of a command in one line."""
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout.strip()
