"""Partial results: a stopped run of the panel method resumes from its solved frequencies, and keeps no
matrices."""

from __future__ import annotations

import weakref

import numpy as np
import pytest
from kingpost.hydro import solve as solving
from kingpost.hydro.database import Water
from kingpost.hydro.hull_options import parse_shape
from kingpost.hydro.influence import Engine
from kingpost.hydro.meshes import parametric
from kingpost.hydro.partial import Partial, digest

pytest.importorskip("capytaine")

BARGE = "box:length_m=20,beam_m=10,draught_m=2,depth_m=5"


def test_a_partial_file_of_other_settings_or_cut_short_is_ignored(tmp_path) -> None:
    path = tmp_path / "x.partial.npz"
    first = Partial(path)
    first.open("a")
    first.put("0", (np.arange(3.0), np.eye(2)))
    assert Partial(path).open("b") == 0
    again = Partial(path)
    assert again.open("a") == 1
    np.testing.assert_array_equal(again.get("0")[1], np.eye(2))
    path.write_bytes(path.read_bytes()[:-40])
    assert Partial(path).open("a") == 0
    again.done()
    assert not path.exists()


def test_the_digest_depends_on_every_number() -> None:
    parts = [np.arange(4.0), 1.0, None]
    assert digest(parts) == digest([np.arange(4.0), 1.0, None])
    assert digest(parts) != digest([np.arange(4.0).reshape(2, 2), 1.0, None])
    assert digest(parts) != digest([np.arange(4.0), 1.0, 0.0])


def test_a_resumed_run_gives_the_same_bits(tmp_path, monkeypatch) -> None:
    hull, omega = parametric(parse_shape(BARGE), BARGE, 80), np.array([0.5, 0.8, 1.1])
    whole = solving.solve(hull, Water(), omega, 4, with_lid=False)
    path, solved, at = tmp_path / "x.partial.npz", [], solving._Problem.at

    def stopping(problem, frequency, angles):
        if len(solved) == 2:
            raise KeyboardInterrupt
        solved.append(frequency)
        return at(problem, frequency, angles)

    monkeypatch.setattr(solving._Problem, "at", stopping)
    with pytest.raises(KeyboardInterrupt):
        solving.solve(hull, Water(), omega, 4, with_lid=False, partial=Partial(path))
    solved.clear()
    found = solving.solve(hull, Water(), omega, 4, with_lid=False, partial=Partial(path))
    assert solved == [1.1]
    for name in ("added_mass", "radiation_damping", "added_mass_infinite", "diffraction"):
        np.testing.assert_array_equal(getattr(found, name), getattr(whole, name))
    np.testing.assert_array_equal(found.far_field.radiated, whole.far_field.radiated)


def test_matrices_are_freed_after_each_frequency(monkeypatch) -> None:
    built, build = [], Engine._build

    def counted(engine, parts, settings):
        assert all(one() is None for one in built)
        found = build(engine, parts, settings)
        built.extend(weakref.ref(block) for matrix in found for block in matrix.blocks)
        return found

    monkeypatch.setattr(Engine, "_build", counted)
    hull = parametric(parse_shape(BARGE), BARGE, 80)
    assert len(hull.reflections) == 2
    solving.solve(hull, Water(), np.array([0.5, 0.8]), 4, with_lid=False)
    # Two matrices of four blocks at three frequencies, the infinite one among them.
    assert len(built) == 24
    assert all(one() is None for one in built)
