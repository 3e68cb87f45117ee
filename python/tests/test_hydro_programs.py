"""Databases of WAMIT, ShipX, AQWA and Nemoh: reading with the values in the files, and repairs with notes."""

from __future__ import annotations

import argparse
import re
from dataclasses import replace

import hydro_programs as programs
import hydro_samples as samples
import hydro_writers as writers
import numpy as np
import pytest
from kingpost.errors import HydrodynamicsError
from kingpost.hydro import command_output, importers, radiation_fit
from kingpost.hydro.importers import Options, repair, wamit_rows
from kingpost.hydro.importers.long_waves import check_long_waves
from kingpost.hydro.infinite_mass import joint_added_mass_infinite
from kingpost.hydro.memory import added_mass_infinite

SIZE = {"length_m": 12.0, "beam_m": 10.0}
HEADER_SAYS_NOT = {**SIZE, "draught_m": 5.0}
# The sample's heave force does not go to nothing in short waves, by which the first column would be known.
LISTED = {**HEADER_SAYS_NOT, "first_column": "period_s"}


def near(found, base, tolerance: float) -> None:
    """Equal to a part of the largest of each kind: of forces, moments and what stands between them."""
    kinds = np.repeat([0, 1], 3)
    for name in ("added_mass", "radiation_damping", "added_mass_infinite", "excitation"):
        wanted, given = getattr(base, name), getattr(found, name)
        for i in range(6):
            same = np.abs(wanted[..., kinds == kinds[i]]).max()
            assert np.abs(given[..., i] - wanted[..., i]).max() <= tolerance * same, name
    # Second moments follow from restoring less the buoyancy's share, both of about 500 m4.
    wanted = base.hull.waterplane.second_moments_m4
    np.testing.assert_allclose(found.hull.waterplane.second_moments_m4, wanted, atol=1500 * tolerance)
    np.testing.assert_allclose(found.hull.centre_of_buoyancy_m, base.hull.centre_of_buoyancy_m, atol=1e-3)


@pytest.mark.parametrize("version", [6, 7])
def test_wamit_files_of_six_digits_need_only_values_that_no_other_file_has(tmp_path, version) -> None:
    base = writers.database()
    path = programs.wamit_six_digits(tmp_path / "hull", base, version=version)
    programs.wamit_listing(tmp_path / "hull", base)
    found = importers.load(path, Options(**LISTED))
    # Half of the sixth digit of numbers, and as much again from carrying moments to the origin.
    near(found, base, 2 * wamit_rows.SIX_DIGITS)
    assert np.abs(found.froude_krylov - base.froude_krylov).max() < 1e-5 * np.abs(base.froude_krylov).max()
    assert not any("together miss" in note for note in found.provenance.notes)


@pytest.mark.parametrize(("column", "said"), [(0, "period_s"), (1, "frequency_rad_s"), (2, None)])
def test_the_first_column_is_recognised_by_the_heave_force_of_long_waves(column, said) -> None:
    omega = np.linspace(0.2, 3.0, 20)
    # exp(-k T) of a wall-sided hull of unit draught; a file of long waves alone does not tell.
    heave = 10.0 * np.exp(-(omega**2)) if column < 2 else np.full(20, 10.0)
    waves = np.zeros((20, 7))
    waves[:, 0], waves[:, 2], waves[:, 5] = (omega if column else 2 * np.pi / omega), 3, heave
    assert wamit_rows.first_column(np.zeros((0, 5)), waves, 10.0) == said


def test_parts_that_do_not_add_up_to_the_excitation_give_a_note(tmp_path) -> None:
    base = writers.database()
    path = programs.wamit_six_digits(tmp_path / "hull", base)
    programs.wamit_six_digits(tmp_path / "other", replace(base, diffraction=1.1 * base.diffraction))
    (tmp_path / "hull.3sc").write_text((tmp_path / "other.3sc").read_text())
    programs.wamit_listing(tmp_path / "hull", base)
    found = importers.load(path, Options(**LISTED))
    # A tenth of 0.3 of the largest force.
    assert any("miss .3 by up to 3.00%" in note for note in found.provenance.notes)


def test_a_wamit_listing_alone_is_read_with_phases_to_one_degree(tmp_path) -> None:
    base = writers.database()
    found = importers.load(programs.wamit_listing(tmp_path / "hull", base), Options(**LISTED))
    near(replace(found, froude_krylov=base.froude_krylov, diffraction=base.diffraction), base, 1e-5)
    # Half a degree is 0.0087 of a modulus, about the point that the listing's moments are about.
    given, wanted = (writers.About(one, programs.ABOVE).force(one.excitation) for one in (found, base))
    floor = 1e-6 * np.abs(wanted).max(axis=(0, 1))
    assert (np.abs(given - wanted) <= np.radians(0.5) * np.abs(wanted) + floor).all()
    assert any("whole degree" in note for note in found.provenance.notes)


def test_motions_beyond_six_are_skipped_with_a_note(tmp_path) -> None:
    base = writers.database()
    path = programs.wamit_six_digits(tmp_path / "hull", base)
    programs.wamit_listing(tmp_path / "hull", base)
    lines = path.read_text().splitlines()
    flexible = [
        line[:14] + line[14:].replace("     6     6", "     7     7", 1)
        for line in lines[1:]
        if "     6     6" in line
    ]
    path.write_text("\n".join(lines + flexible) + "\n")
    found = importers.load(path, Options(**LISTED))
    near(found, base, 2 * wamit_rows.SIX_DIGITS)
    assert any("motions 7 to 7 are left out" in note for note in found.provenance.notes)


def test_shipx_files_are_imported_as_the_original_database(tmp_path) -> None:
    base = writers.database()
    given = {"water_depth_m": np.inf, "added_mass_infinite": "from_damping"}
    found = importers.load(programs.shipx(tmp_path / "input", base), Options(**given))
    # Eight digits, and the infinite added mass, which is not in the file, taken from the base.
    centred = replace(found.hull, centre_of_buoyancy_m=base.hull.centre_of_buoyancy_m)
    near(replace(found, added_mass_infinite=base.added_mass_infinite, hull=centred), base, 1e-6)
    assert any("2 m aft of Lpp/2" in note for note in found.provenance.notes)


def test_strip_theory_without_surge_is_accepted_with_a_note(tmp_path) -> None:
    base = writers.database()
    without = [matrices.copy() for matrices in (base.added_mass, base.radiation_damping)]
    for matrices in without:
        matrices[:, 0] = matrices[:, :, 0] = 0.0
    excitation = base.excitation.copy()
    mass = base.water.density_kg_m3 * base.hull.volume_m3
    omega = base.frequencies_rad_s[:, None]
    excitation[:, :, 0] = -1j * omega**2 * mass * np.cos(base.wave_directions_rad)
    excitation[:, :, 4] -= -1j * omega**2 * base.added_mass[:, 4, 0, None] * np.cos(base.wave_directions_rad)
    strips = replace(base, added_mass=without[0], radiation_damping=without[1],
                     froude_krylov=0.0 * excitation, diffraction=excitation)  # fmt: skip
    # About the origin itself: carried to another point, pitch would have a surge again.
    given = {"water_depth_m": np.inf, "added_mass_infinite": "from_damping"}
    at = programs.ABOVE.copy()
    programs.ABOVE[:] = 0.0
    try:
        path = programs.shipx(tmp_path / "input", strips)
    finally:
        programs.ABOVE[:] = at
    found = importers.load(path, Options(**given))
    assert (found.added_mass[:, 0] == 0).all()
    assert (found.added_mass_infinite[0] == 0).all()
    assert any("strip theory" in note for note in found.provenance.notes)


def test_an_aqwa_file_is_imported_as_the_original_database(tmp_path) -> None:
    base = writers.database()
    found = importers.load(programs.aqwa(tmp_path / "hull", base), Options(**SIZE))
    near(found, base, 1e-5)
    assert found.hull.draught_m == 5.0
    assert found.water.depth_m == 1000.0


@pytest.mark.parametrize("structures", [2, 3])
def test_the_first_of_several_structures_of_aqwa_is_read_with_a_note(tmp_path, structures: int) -> None:
    """Source: the header, which has number, directions and frequencies of each structure, and two labels
    before each pair of ADDEDMASS_HF, as AQWA-LINE 2020 R1 writes them."""
    base = writers.database()
    found = importers.load(programs.aqwa(tmp_path / "hull", base, structures), Options(**SIZE))
    near(found, base, 1e-5)
    assert f"structures 2 to {structures} are left out: they are held still" in found.provenance.notes


def test_a_folder_of_nemoh_is_imported_as_the_original_database(tmp_path) -> None:
    base = writers.database()
    given = {**HEADER_SAYS_NOT, "added_mass_infinite": "from_damping"}
    found = importers.load(programs.nemoh(tmp_path / "case", base), Options(**given))
    near(replace(found, added_mass_infinite=base.added_mass_infinite), base, 1e-6)
    np.testing.assert_allclose(
        found.froude_krylov, base.froude_krylov, atol=1e-6 * np.abs(base.froude_krylov).max()
    )


def test_frequencies_above_the_limit_are_left_out_before_any_check(tmp_path) -> None:
    base = writers.database()
    spoiled = replace(base, radiation_damping=base.radiation_damping.copy())
    spoiled.radiation_damping[-4:] *= -1.0
    path = programs.aqwa(tmp_path / "hull", spoiled)
    with pytest.raises(HydrodynamicsError, match=r"eigenvalue of -.* --highest-rad-s"):
        importers.load(path, Options(**SIZE))
    found = importers.load(path, Options(**SIZE), highest_rad_s=base.frequencies_rad_s[-5] + 1e-3)
    assert len(found.frequencies_rad_s) == len(base.frequencies_rad_s) - 4
    with pytest.raises(HydrodynamicsError, match="below all 12 frequencies"):
        importers.load(path, Options(**SIZE), highest_rad_s=0.1)


def test_errors_are_repaired_and_the_change_is_reported(tmp_path) -> None:
    base = writers.database()
    spoiled = replace(
        base, added_mass=base.added_mass.copy(), radiation_damping=base.radiation_damping.copy()
    )
    size = np.sqrt(np.abs(base.added_mass[:, 0, 0]).max() * np.abs(base.added_mass[:, 4, 4]).max())
    spoiled.added_mass[5, 0, 4] += 0.1 * size
    # Two in a row: a single one would be left out as a jump.
    spoiled.radiation_damping[2:4, 5, 5] = -0.2 * base.radiation_damping[:, 5, 5].max()
    found = importers.load(programs.aqwa(tmp_path / "hull", spoiled), Options(**SIZE))
    np.testing.assert_allclose(found.added_mass, found.added_mass.transpose(0, 2, 1), rtol=1e-12, atol=1e-6)
    assert np.linalg.eigvalsh(found.radiation_damping).min() > -1e-9 * np.abs(found.radiation_damping).max()
    notes = [note for note in found.provenance.notes if note.startswith("repaired")]
    # Half of the difference of the two halves, over the diagonals about the file's own point.
    about = writers.About(spoiled, programs.ABOVE).matrix(spoiled.added_mass)
    own = np.sqrt(np.abs(about[:, 0, 0]).max() * np.abs(about[:, 4, 4]).max())
    wanted = f"added mass made symmetric, by up to {0.05 * size / own:.2%} of the diagonal: surge and pitch"
    assert any(wanted in note for note in notes), notes
    assert any("negative damping at 2 frequencies" in note for note in notes)


def test_a_lone_jump_is_left_out_and_a_resonance_is_kept() -> None:
    omega = np.linspace(0.2, 3.0, 57)
    smooth = omega**2 * np.exp(-omega)
    lone = smooth.copy()
    lone[30] -= 0.4
    assert np.flatnonzero(repair._jumps(omega, lone)).tolist() == [30]
    # A peak as narrow as two steps either side has flanks.
    peak = smooth + 0.5 / (1.0 + ((omega - omega[30]) / 0.1) ** 2)
    assert not repair._jumps(omega, peak).any()
    assert not repair._jumps(omega, smooth).any()


def test_the_infinite_added_mass_is_found_where_data_end_in_the_middle_of_the_damping() -> None:
    omega = np.linspace(0.05, 1.2, 60)
    s = 1j * omega
    response = 4e4 * s / (s**2 + 0.8 * s + 1.2)
    added_mass, damping = np.zeros((60, 6, 6)), np.zeros((60, 6, 6))
    damping[:, 2, 2] = response.real
    added_mass[:, 2, 2] = 3e5 + response.imag / omega
    assert damping[-1, 2, 2] > 0.9 * damping[:, 2, 2].max()
    found = joint_added_mass_infinite(omega, added_mass, damping)
    # A rational memory of two states is fitted exactly by four or more; its turns with
    # the poles stop at 1e-9.
    assert found[2, 2] == pytest.approx(3e5, rel=1e-6)
    assert np.count_nonzero(found) == 1
    # Ogilvie's relation, with damping guessed beyond the data, is off by far more.
    assert abs(added_mass_infinite(omega, added_mass, damping)[2, 2] - 3e5) > 1e-3 * 3e5


def test_a_roll_moment_of_two_panels_across_names_the_panels_first() -> None:
    """Source: the sum of y^2 over the centres of two equal panels is 3/4 of its integral."""
    base = writers.database()
    coarse = replace(base, froude_krylov=base.froude_krylov.copy())
    square, athwart = base.frequencies_rad_s[:, None] ** 2, np.sin(base.wave_directions_rad)
    coarse.froude_krylov[:, :, 3] -= 1j * 1000.0 * 480.0 / 4 * athwart * square
    check_long_waves(base, "fine.LIS")
    with pytest.raises(HydrodynamicsError, match="misses 25 % of the waterplane's moment, as about 2 panels"):
        check_long_waves(coarse, "coarse.LIS")


def test_a_fit_error_above_a_quarter_is_refused_and_the_proposed_cut_is_accepted(tmp_path) -> None:
    """Source: a hemisphere's data, those above 0.7 of the highest frequency spoiled by noise."""
    base = samples.floating_hemisphere()
    spoiled = replace(base, added_mass=base.added_mass.copy(), radiation=None)
    high = base.frequencies_rad_s > 0.7 * base.frequencies_rad_s[-1]
    spoiled.added_mass[high, 2, 2] *= 1 + 3 * np.random.default_rng(2).standard_normal(high.sum())
    options = argparse.Namespace(highest_rad_s=None, accept_fit=True)
    target = tmp_path / "spoiled.hydro.json"
    with pytest.raises(
        HydrodynamicsError, match=r"fitted to \d+% of its peak, allowed: at most 25%"
    ) as refused:
        command_output.fitted(spoiled, options, target)
    assert not target.exists()
    cut = re.search(r"with --highest-rad-s ([\d.]+) it is ([\d.]+)%", str(refused.value))
    assert cut is not None
    options.highest_rad_s = float(cut[1])
    assert options.highest_rad_s < base.frequencies_rad_s[high].min()
    fitted = command_output.fitted(spoiled, options, target)
    assert fitted.radiation is not None
    assert 100 * fitted.radiation.fit_error == pytest.approx(float(cut[2]), abs=0.01)
    assert target.exists()


def test_a_fit_that_misses_its_limit_is_accepted_on_request_and_names_the_motion() -> None:
    database = samples.floating_hemisphere()
    spoiled = replace(database, added_mass=database.added_mass.copy())
    spoiled.added_mass[-1, 2, 2] *= 2.0
    with pytest.raises(HydrodynamicsError, match="accept_fit"):
        radiation_fit.fit(spoiled, most_states=6)
    radiation = radiation_fit.fit(spoiled, most_states=6, accept=True)
    assert radiation.fit_error > radiation_fit.LIMIT
    missed = [one for one in radiation_fit.misfits(spoiled, radiation) if one.memory > radiation_fit.LIMIT]
    assert [one.motion for one in missed] == ["heave"]
    assert missed[0].memory == pytest.approx(radiation.fit_error)
    assert missed[0].frequency_rad_s == spoiled.frequencies_rad_s[-1]
    # The last added mass, twice as large, is missed by about half of itself.
    assert 0.3 < missed[0].added_mass < 0.6
