"""Many runs at once are the runs that each variant has alone."""

import os
import subprocess
import sys
import threading
from importlib.machinery import ExtensionFileLoader
from importlib.util import module_from_spec, spec_from_loader
from pathlib import Path
from types import ModuleType

import kingpost
import numpy as np
import pytest
import xarray
from kingpost.simulation import batch as batches
from kingpost.simulation import simulate

SHORT = {"simulation.duration_s": 0.2, "simulation.step_s": 0.002}


def test_each_run_of_a_batch_has_the_bits_of_the_run_alone() -> None:
    places = [-10, -5, 0.0, 2.5, 7, 10]
    found = kingpost.Batch("paper", {"crane_x_m": places, "load": [False] * 6}, SHORT).run(threads=2)
    assert found.sizes["run"] == 6
    for run, place in enumerate(places):
        alone = kingpost.run("paper", SHORT, crane_x_m=place)
        for name, variable in alone.data_vars.items():
            if "time" not in variable.dims:
                continue
            np.testing.assert_array_equal(found[name].isel(run=run).values, variable.values, err_msg=name)


@pytest.fixture(scope="module")
def plain() -> ModuleType:
    """The engine for any processor, hardly optimised and with assertions: `make test-thorough` builds it."""
    root = Path(__file__).resolve().parents[2]
    name = {"win32": "_engine.dll", "darwin": "lib_engine.dylib"}.get(sys.platform, "lib_engine.so")
    built = Path(os.environ.get("CARGO_TARGET_DIR", root / "target")) / "debug" / name
    loader = ExtensionFileLoader("_engine", str(built))
    module = module_from_spec(spec_from_loader("_engine", loader))
    loader.exec_module(module)
    return module


@pytest.mark.thorough
def test_a_batch_by_the_build_for_this_processor_has_the_bits_of_the_plain_one(
    plain: ModuleType, monkeypatch: pytest.MonkeyPatch
) -> None:
    batch = kingpost.Batch("paper", {"crane_y_m": np.linspace(-5, 5, 9)}, SHORT)
    wide = batch.run()
    monkeypatch.setattr(batches, "engine", plain)
    xarray.testing.assert_identical(wide, batch.run())


@pytest.mark.thorough
@pytest.mark.parametrize("name", ["paper", "offshore_vessel", "lift_off_from_barge"])
def test_a_run_by_the_build_for_this_processor_has_the_bits_of_the_plain_one(
    name: str, plain: ModuleType, monkeypatch: pytest.MonkeyPatch
) -> None:
    short = {"simulation.duration_s": 2.0}
    wide = kingpost.run(name, short)
    for module in (kingpost.scenario, simulate):
        monkeypatch.setattr(module, "engine", plain)
    for variable, values in kingpost.run(name, short).data_vars.items():
        np.testing.assert_array_equal(wide[variable].values, values.values, err_msg=variable)


def test_a_run_that_diverges_is_marked_and_ends_in_nan() -> None:
    overrides = SHORT | {"simulation.duration_s": 0.8, "simulation.rate_limit": 9.0}
    torques = {"drives.motor_1.motor.torque_N_m": [20_000, 100_000, 50_000]}
    found = kingpost.Batch("paper", torques, overrides).run()
    assert [status == "finished" for status in found.status.values] == [True, False, True]
    assert "diverged" in str(found.status[1].values)
    assert found.attrs["status"] == "2 of 3 runs finished"
    rates = found.joint_velocity.sel(coordinate="slew")
    assert not rates.isel(run=[0, 2]).isnull().any()
    assert rates.isel(run=1).isnull()[-1]
    assert not rates.isel(run=1).isnull()[10]
    assert not found.time.isnull().any()


@pytest.mark.parametrize(
    ("parameters", "said"),
    [
        ({"crane_x_m": [1, 2], "crane_y_m": [1]}, "2 of crane_x_m, 1 of crane_y_m"),
        ({}, "no parameters"),
        ({"crane_x_m": [0, 70]}, "run 1: --set crane_x_m: found 70"),
        ({"load": [False, True]}, "the same bodies"),
        ({"simulation.record_every_s": [0.01, 0.013]}, "the same simulation.record_every_s"),
        ({"nonsense": [1]}, "run 0: --set nonsense"),
    ],
)
def test_an_impossible_batch_gives_one_clear_error(parameters: dict[str, list[object]], said: str) -> None:
    with pytest.raises(kingpost.KingpostError, match=said):
        kingpost.Batch("paper", parameters, SHORT).run()


def test_a_batch_is_written_and_read_back(tmp_path) -> None:
    found = kingpost.Batch("paper", {"crane_x_m": [0, 5]}, SHORT).run()
    found.to_netcdf(tmp_path / "batch.nc", engine="h5netcdf")
    with xarray.open_dataset(tmp_path / "batch.nc", engine="h5netcdf") as again:
        assert again.status.values.tolist() == ["finished", "finished"]
        np.testing.assert_array_equal(again["roll"].values, found["roll"].values)


def test_the_progress_of_a_batch_counts_runs() -> None:
    seen: list[float] = []
    kingpost.Batch("paper", {"crane_x_m": np.linspace(-9, 9, 12)}, SHORT).run(1, seen.append)
    assert seen == sorted(seen)
    assert seen[-1] == 12


def test_a_batch_that_needs_too_much_memory_is_refused_with_advice() -> None:
    batch = kingpost.Batch("paper", {"crane_x_m": [0.0] * 100})
    with pytest.raises(
        kingpost.KingpostError,
        match=r"100 runs: found .* GB of rows and models, allowed: 0\.0 GB; record less often",
    ):
        batch.run(memory_gb=1e-3)
    with pytest.raises(kingpost.KingpostError, match=r"10000000 runs: found .* GB of rows and models"):
        kingpost.Batch("paper", {"crane_x_m": np.zeros(10**7)}).run()
    for nonsense in (0, -1, np.nan, np.inf):
        with pytest.raises(kingpost.KingpostError, match="memory_gb: found"):
            batch.run(memory_gb=nonsense)


INTERRUPTED = """
import os, signal, threading, time, kingpost
parameters = {"significant_height_m": [1, 2, 3, 4] * 2}
batch = kingpost.Batch("offshore_vessel", parameters, {"simulation.duration_s": 2e4})
sent = []
def send():
    sent.append(time.process_time())
    os.kill(os.getpid(), signal.SIGINT)
def begin(done):
    if not sent and threading.active_count() == 1:
        threading.Timer(0.3, send).start()
try:
    batch.run(progress=begin)
except KeyboardInterrupt:
    print("stopped after", time.process_time() - sent[0], "s")
"""


@pytest.mark.skipif(sys.platform == "win32", reason="a signal cannot be sent to oneself there")
def test_ctrl_c_stops_a_batch_within_seconds() -> None:
    """Of the processor, which a machine that is busy with other things takes no more of."""
    found = subprocess.run([sys.executable, "-c", INTERRUPTED], capture_output=True, text=True, timeout=600)
    assert found.returncode == 0, found.stderr
    # A step of all its runs takes milliseconds, its end less than a second.
    assert float(found.stdout.split()[2]) < 5


def test_progress_is_reported_on_the_calling_thread() -> None:
    threads = []
    batch = kingpost.Batch("paper", {"crane_x_m": [0.0, 1.0]}, {"simulation.duration_s": 0.1})
    batch.run(progress=lambda done: threads.append(threading.get_ident()))
    assert set(threads) == {threading.get_ident()}
