"""The matrices of the moving frame method: units by row and column, LaTeX, formulas, CSV."""

from __future__ import annotations

import re

import kingpost
import latex2mathml.converter
import numpy as np
import pytest
from kingpost import Scenario, Simulation, load
from kingpost.paper.equations import EQUATIONS, arm_velocity
from kingpost.simulation.matrices import entry_unit, latex
from samples import read_csv


@pytest.fixture(scope="module")
def moving() -> Simulation:
    """The paper's crane in its corner, centre free, both motors on, in the middle of its motion."""
    simulation = Simulation(load("paper", motor_2=True, hold_centre=False))
    simulation.step(250)
    return simulation


def units(matrices, name: str, row: str, column: str) -> str:
    return matrices[name].sel(row=row, column=column)["unit"].item()


def test_a_matrix_has_units_by_row_and_column(moving):
    """Source: dimensions of K = 1/2 X'^T M X' (paper eq. 49) and X' = B q' (eq. 45)."""
    matrices = moving.moving_frame()
    assert units(matrices, "B", "arm.x_dot", "ship.x") == "1"
    assert units(matrices, "B", "arm.x_dot", "slew") == "m"
    assert units(matrices, "B_dot", "arm.x_dot", "slew") == "m/s"
    assert units(matrices, "M", "ship.x_dot", "ship.x_dot") == "kg"
    assert units(matrices, "M", "ship.omega_x", "ship.omega_x") == "kg m^2"
    assert units(matrices, "D", "ship.omega_x", "ship.omega_y") == "1/s"
    assert units(matrices, "M_star", "slew", "ship.x") == "kg m"
    assert units(matrices, "M_star", "slew", "luff") == "kg m^2"
    assert units(matrices, "N_star", "slew", "luff") == "kg m^2/s"
    assert list(matrices["F_star"]["unit"].values.ravel()) == ["N"] * 3 + ["N m"] * 5
    assert list(matrices["q_dot"]["unit"].values.ravel()) == ["m/s"] * 3 + ["rad/s"] * 5
    assert units(matrices, "E_arm/tower", "x", "1") == "m"
    assert units(matrices, "E_arm/tower", "x", "x") == "1"
    assert units(matrices, "Omega_arm", "x", "1") == "m/s"


def test_the_units_of_the_entries_give_energy_in_joules(moving):
    """Source: each entry's unit times those of its two rates is that of a load times a rate, W s."""
    mass = moving.moving_frame()["M_star"]
    for i, row in enumerate(mass["row_unit"].values):
        for j, column in enumerate(mass["column_unit"].values):
            assert mass["unit"].values[i, j] == entry_unit(row, column)
            assert mass["unit"].values[i, j] == mass["unit"].values[j, i]


@pytest.mark.parametrize("environment", ["bmatrix", "pmatrix", "array"])
def test_numbers_in_latex_read_back_to_their_digits(moving, environment):
    """Source: the numbers themselves, rounded to half a unit of the sixth digit."""
    mass = moving.moving_frame()["M_star"]
    text = moving.moving_frame().latex("M_star", environment, digits=6)
    assert text.startswith(rf"\begin{{{environment}}}")
    body = text.split(r"\hline")[-1].removeprefix(rf"\begin{{{environment}}}")
    rows = body.removesuffix(rf"\end{{{environment}}}").split(r"\\")
    start = 1 if environment == "array" else 0
    cells = [[_read(cell) for cell in row.split("&")[start:]] for row in rows]
    noise = 1e-12 * np.abs(mass.values).max()
    assert np.array(cells) == pytest.approx(mass.values, rel=5e-6, abs=noise)


def _read(cell: str) -> float:
    mantissa, _, exponent = cell.strip().partition(r" \times 10^{")
    return float(mantissa) * 10.0 ** int(exponent.rstrip("}") or 0)


def test_labels_are_valid_latex(moving):
    """Source: names of coordinates in upright letters; underscores escaped; a converter reads it."""
    matrices = moving.moving_frame()
    labelled = matrices.latex("B", "array")
    assert r"\mathrm{arm.omega\_y}" in labelled
    texts = [matrices.latex(name, "array") for name in matrices]
    texts += [formula.latex("array") for formula in matrices.formulas(names=True).values()]
    for text in texts:
        assert text.count("{") == text.count("}")
        assert len(re.findall(r"\\left", text)) == len(re.findall(r"\\right", text))
        assert "<mtable" in latex2mathml.converter.convert(text) or "matrix" not in text


def test_formulas_have_the_corrected_blocks_of_eq_46b(moving):
    """Source: remarks 2 and 3 on the paper; our e_z is its e2, and R(1) R(2/1) stands outside."""
    formula = moving.moving_frame().formulas()["B"]
    plain = [formula.block(5, i).replace("{", "").replace("}", "") for i in (2, 3)]
    corrected = EQUATIONS["B52"].corrected[0].removeprefix("B_{52} = ").replace("{", "").replace("}", "")
    assert plain[0] == corrected
    assert plain[1] == r"R^(1) R^(2/1) \left( R^(3/2) S(s_C_3)^T (R^(3/2))^T + S(s_J_2)^T \right) e_z"
    assert formula.equation == "46"
    with pytest.raises(kingpost.KingpostError, match=r"\(7, 1\).*1 to 6"):
        formula.block(7, 1)


@pytest.mark.parametrize("equation", ["43", "46b"])
def test_the_corrected_equations_give_the_arms_velocity_and_the_printed_ones_do_not(moving, equation):
    """Source: X' = B q' of the engine; with the crane off the centre the slips are metres a second."""
    rows = [f"arm.{axis}_dot" for axis in "xyz"]
    true = moving.moving_frame()["X_dot"].sel(row=rows).values.ravel()
    assert arm_velocity(moving, equation, "corrected") == pytest.approx(true, abs=1e-12)
    assert np.linalg.norm(arm_velocity(moving, equation, "printed") - true) > 0.1


def test_every_formula_of_the_gallery_is_made_and_named_as_its_matrix():
    """Source: one formula or more a matrix, for every scenario that there is."""
    for name in ("paper", "chain", "tennis_racket"):
        matrices = Simulation(load(name)).moving_frame()
        formulas = matrices.formulas()
        assert set(formulas) - set(matrices) == set()
        b = formulas["B"]
        assert len(b.blocks) == 2 * len(load(name).model["bodies"])
        assert all(len(row) == len(b.columns) for row in b.blocks)


def test_csv_files_hold_every_bit_with_labels_and_units(moving, tmp_path):
    """Source: what was written; 17 digits carry a double."""
    matrices = moving.moving_frame()
    files = matrices.write_csv(tmp_path / "matrices")
    assert len(files) == len(matrices) == len(set(files))
    assert tmp_path / "matrices" / "E_tower-ship.csv" in files
    for (name, matrix), path in zip(matrices.items(), files, strict=True):
        table = read_csv(path, header=[0, 1], index_col=[0, 1])
        assert np.array_equal(table.values, matrix.values), name
        assert list(table.index.get_level_values(0)) == list(matrix["row"].values)
        assert list(table.index.get_level_values(1).astype(str)) == list(matrix["row_unit"].values)
        assert [column[0] for column in table.columns] == list(matrix["column"].values)
        assert [column[1] for column in table.columns] == list(matrix["column_unit"].values)


def test_a_wrong_request_is_refused_with_the_allowed_values(moving, tmp_path):
    """Source: the public contract: one base exception, found and allowed."""
    matrices = moving.moving_frame()
    with pytest.raises(kingpost.KingpostError, match="vmatrix, allowed: bmatrix"):
        latex(matrices["B"], "vmatrix")
    with pytest.raises(kingpost.KingpostError, match="digits: found 0"):
        matrices.latex("B", digits=0)
    with pytest.raises(kingpost.KingpostError, match="form: found wrong"):
        arm_velocity(moving, "43", "wrong")
    with pytest.raises(kingpost.KingpostError, match="equation: found 44"):
        arm_velocity(moving, "44")
    with pytest.raises(kingpost.KingpostError, match="hinge of tower"):
        arm_velocity(Simulation(load("chain")), "43")
    (tmp_path / "file").write_text("in the way", encoding="utf-8")
    with pytest.raises(kingpost.KingpostError, match="cannot be written"):
        matrices.write_csv(tmp_path / "file")


def test_the_formulas_of_a_body_with_two_joints_distinguish_them():
    """Source: joints are numbered by the body they stand on; two on one need the body carried, too."""
    text = """
version: 1
title: Two arms
simulation: {integrator: rk4, step_s: 0.01, duration_s: 1, record_every_s: 0.1}
bodies:
  hull: {mass_kg: 10, shape: {box: {length_m: 4, width_m: 2, height_m: 1}}, joint: {floating: {}}}
  fore:
    parent: hull
    mass_kg: 1
    shape: {box: {length_m: 1, width_m: 1, height_m: 1}}
    joint: {revolute: {axis: [0, 1, 0], position_m: [1, 0, 0], child_position_m: [0, 0, -1]}}
  aft:
    parent: hull
    mass_kg: 1
    shape: {box: {length_m: 1, width_m: 1, height_m: 1}}
    joint: {revolute: {axis: [0, 1, 0], position_m: [-1, 0, 0], child_position_m: [0, 0, -1]}}
"""
    b = Simulation(Scenario(text, "two_arms.yaml")).moving_frame().formulas()["B"]
    assert "s_{J_{1,2}}" in b.block(3, 2)
    assert "s_{J_{1,3}}" in b.block(5, 2)
