"""Influence matrices of mirrored parts: compared with the whole matrix and with Capytaine, and their
memory."""

import tracemalloc
from dataclasses import replace

import numpy as np
import pytest
from kingpost.errors import HydrodynamicsError
from kingpost.hydro import solve as solving
from kingpost.hydro.database import Water
from kingpost.hydro.hull_options import parse_shape
from kingpost.hydro.influence import Engine, Influence, transform
from kingpost.hydro.meshes import parametric, whole
from kingpost.hydro.panels import of_triangles
from lanes import sampled

pytest.importorskip("capytaine")

BARGE = "box:length_m=20,beam_m=10,draught_m=2,depth_m=5"
VESSEL = "offshore_vessel:length_m=80,beam_m=18,draught_m=5.5,depth_m=8,block_coefficient=0.68"


def hull(description: str, panels: int):
    return parametric(parse_shape(description), description, panels)


@pytest.mark.parametrize("parts", [1, 2, 4, 8])
def test_products_and_solutions_by_blocks_equal_those_of_the_whole_matrix(parts) -> None:
    rng, n = np.random.default_rng(parts), 7
    blocks = rng.normal(size=(parts, n, n)) + 1j * rng.normal(size=(parts, n, n))
    full = np.block([[blocks[i ^ j] for j in range(parts)] for i in range(parts)])
    vector = rng.normal(size=parts * n) + 0j
    influence = Influence([np.asfortranarray(block) for block in blocks])
    assert influence.shape == full.shape
    np.testing.assert_allclose(influence @ vector, full @ vector, rtol=1e-12)
    for _ in range(2):
        np.testing.assert_allclose(influence.solve(vector), np.linalg.solve(full, vector), rtol=1e-10)


def test_the_transform_is_that_of_hadamards_matrix() -> None:
    from scipy.linalg import hadamard

    parts = np.random.default_rng(1).normal(size=(8, 3))
    found = parts.copy()
    transform(found)
    np.testing.assert_allclose(found, hadamard(8) @ parts, rtol=1e-13, atol=1e-13)


def test_factors_overwrite_the_matrix() -> None:
    blocks = [np.asfortranarray(np.random.default_rng(k).normal(size=(5, 5)) + 0j) for k in range(4)]
    influence = Influence(list(blocks))
    influence.solve(np.ones(20, complex))
    assert all(factors is block for (factors, _), block in zip(influence.factors, blocks, strict=True))


@pytest.mark.parametrize("description", sampled([BARGE, VESSEL], keep=[BARGE]))
def test_coefficients_equal_those_of_capytaines_engine(description, monkeypatch) -> None:
    from capytaine.bem.engines import DefaultMatrixEngine

    class Theirs(DefaultMatrixEngine):
        def __init__(self, green_function):
            super().__init__(green_function=green_function)

        def forget(self):
            self.last_computed_inputs = self.last_computed_matrices = None

    some, omega = hull(description, 100), np.array([0.7])
    ours = solving.solve(some, Water(), omega, 8, with_lid=True)
    monkeypatch.setattr(solving, "Engine", Theirs)
    theirs = solving.solve(some, Water(), omega, 8, with_lid=True)
    for name in ("added_mass", "radiation_damping", "added_mass_infinite", "diffraction"):
        found, expected = getattr(ours, name), getattr(theirs, name)
        np.testing.assert_allclose(found, expected, rtol=0, atol=1e-12 * np.abs(expected).max())


def test_panels_without_an_influence_are_refused() -> None:
    class Broken:
        exportable_settings: dict = {}  # noqa: RUF012

        def evaluate(self, *_meshes, **_settings):
            return np.full((3, 3), np.nan + 0j), np.eye(3) + 0j

    with pytest.raises(HydrodynamicsError, match="do not overlap"):
        Engine(Broken()).build_matrices(object(), None, wavenumber=1.0)


@pytest.mark.parametrize("planes", [0, 2])
def test_one_frequency_needs_little_more_memory_than_two_matrices_for_each_part(planes) -> None:
    some = hull(BARGE, 250 * 2**planes)
    axes = some.reflections[planes:]
    part = of_triangles(whole(some.panels.surface, axes)) if axes else some.panels
    some = replace(some, reflections=some.reflections[:planes], panels=part)
    n = len(part.faces)
    problem = solving._Problem(solving.capytaine(), some, Water(), None, 240)
    problem.at(0.5, np.zeros(1))
    tracemalloc.start()
    try:
        problem.at(0.8, np.zeros(1))
        _, peak = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    matrices = 2 * 2**planes * 16 * n**2
    # Vectors of the whole hull, and of a few angles of the ring waves, beside them.
    assert matrices <= peak < matrices + 16 * 100 * n * 2**planes
    assert problem.engine._matrices is None
