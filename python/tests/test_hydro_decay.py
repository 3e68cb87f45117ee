"""The decay of a floating sphere as the engine runs it, against direct convolution with the same memory."""

from dataclasses import replace
from pathlib import Path

import hydro_samples as samples
import kingpost
import numpy as np
import pytest
from kingpost.hydro import fit, read, retardation, write
from kingpost.hydro.database import Database
from lanes import sampled

SCENARIO = Path(__file__).resolve().parents[2] / "scenarios" / "sphere_decay.yaml"
MASS_KG, CENTRE_OF_MASS_M, DROP_M = 261.8e3, -2.0, 1.0
DURATION_S, STEP_S = 10.0, 0.01


def direct_convolution(database: Database) -> np.ndarray:
    """Heave every `STEP_S`; the weight is not quite the buoyancy of the mesh."""
    water, hull, parts = database.water, database.hull, 2
    step = STEP_S / parts
    kernel = retardation(database, step * np.arange(round(DURATION_S / step) + 1))[:, 2, 2]
    stiffness = water.density_kg_m3 * water.gravity_m_s2 * hull.waterplane.area_m2
    mass = MASS_KG + database.added_mass_infinite[2, 2]
    floating_at = (water.density_kg_m3 * hull.volume_m3 - MASS_KG) * water.gravity_m_s2 / stiffness
    heave = samples.decay_by_convolution(kernel, mass, stiffness, step)
    return floating_at + (DROP_M - floating_at) * heave[::parts]


def engine(database: Path, gravity_m_s2: float) -> np.ndarray:
    overrides = {
        "forces.water.hydrodynamics.database": str(database),
        "forces.gravity.gravity.acceleration_m_s2": gravity_m_s2,
        "simulation.duration_s": DURATION_S,
        "simulation.record_every_s": STEP_S,
    }
    results = kingpost.run(SCENARIO, overrides)
    assert results.status == "finished"
    position = results.position.sel(body="sphere")
    assert float(np.abs(position.sel(axis=["x", "y"])).max()) < 1e-9
    return position.sel(axis="z").values - CENTRE_OF_MASS_M


@pytest.fixture
def table(tmp_path) -> Path:
    """Hulme's table as a database, its memory fitted."""
    found = samples.floating_hemisphere()
    return write(replace(found, radiation=fit(found)), tmp_path / "table.hydro.json")


@pytest.fixture
def panel_method() -> Path:
    return SCENARIO.parent / "hydro" / "sphere.hydro.json"


@pytest.mark.parametrize("source", sampled(["table", "panel_method"], keep=["table"]))
def test_every_extremum_of_the_decay_is_that_of_direct_convolution(source, request):
    path = request.getfixturevalue(source)
    database = read(path)
    direct, run = direct_convolution(database), engine(path, database.water.gravity_m_s2)
    extrema = 1 + np.flatnonzero(np.diff(np.sign(np.diff(direct))))
    assert len(extrema) == 4
    assert (np.abs(run - direct)[extrema] < 0.005 * DROP_M).all()


@pytest.mark.thorough
def test_table_and_panel_method_decay_alike(table, panel_method):
    # Coefficients within 2 % in mass and damping: the fourth extremum, a third of the drop, is within that
    # of the drop.
    first, second = (engine(path, read(path).water.gravity_m_s2) for path in (table, panel_method))
    assert np.abs(first - second).max() < 0.02 * DROP_M
