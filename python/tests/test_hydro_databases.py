"""Cases from real databases: listings, files with motions, wrong first frequencies, deep hulls."""

from __future__ import annotations

from dataclasses import replace

import hydro_programs as programs
import hydro_samples as samples
import hydro_writers as writers
import numpy as np
import pytest
from kingpost.errors import HydrodynamicsError
from kingpost.hydro import fit_data, importers, radiation_fit
from kingpost.hydro.database import Hull, Waterplane
from kingpost.hydro.importers import Options, aqwa, aqwa_listing, repair
from kingpost.hydro.importers.long_waves import check_long_waves

SIZE = {"length_m": 12.0, "beam_m": 10.0}
LISTED = {**SIZE, "draught_m": 5.0, "first_column": "period_s"}


def band(omega: np.ndarray, at: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Damping B, three steep bands as a semi-submersible's, and A - A_inf by Ogilvie's relation,
    A - A_inf = (2/pi) P int_0^inf (B(x) - B(w)) / (x^2 - w^2) dx, by trapezoids."""
    damping = omega**4 * (
        np.exp(-(((omega - 0.8) / 0.08) ** 2))
        + 0.6 * np.exp(-(((omega - 1.1) / 0.08) ** 2))
        + 0.5 * np.exp(-(((omega - 1.5) / 0.1) ** 2))
    )
    wanted = np.interp(at, omega, damping)
    found = []
    for w, b in zip(at, wanted, strict=True):
        x = omega[np.abs(omega - w) > 1e-9]
        integrand = (np.interp(x, omega, damping) - b) / (x**2 - w**2)
        beyond = b / (2 * w) * np.log((x[-1] + w) / (x[-1] - w))
        found.append(2 / np.pi * (np.trapezoid(integrand, x) - beyond))
    return wanted, np.array(found)


def platform() -> radiation_fit.Database:
    """Heave of a hull whose damping by waves is nothing where it resonates."""
    omega = np.linspace(0.05, 2.0, 40)
    damping, added_mass = band(np.linspace(0.0, 40.0, 400_001)[1:], omega)
    peak = 1e5 / damping.max()
    matrices = np.zeros((2, 40, 6, 6))
    infinite = np.zeros((6, 6))
    infinite[2, 2] = 3e5
    matrices[0, :, 2, 2], matrices[1, :, 2, 2] = 3e5 + peak * added_mass, peak * damping
    return samples.database(omega, *matrices, infinite)


def test_a_response_far_below_the_peak_of_damping_is_that_of_the_data() -> None:
    database = platform()
    radiation = radiation_fit.fit(database, response_share=0.5)
    omega = database.frequencies_rad_s
    mass = database.water.density_kg_m3 * database.hull.volume_m3
    fitted = radiation_fit.evaluate(radiation, omega)[:, 2, 2]
    added_mass, damping = database.added_mass[:, 2, 2], database.radiation_damping[:, 2, 2]
    infinite = database.added_mass_infinite[2, 2]
    # At each frequency a hull whose stiffness puts its resonance there, with 5 % of critical damping besides.
    low = omega <= omega[damping.argmax()]
    besides = 2 * fit_data.OTHER_DAMPING * omega * (mass + added_mass)
    stiffness = omega**2 * (mass + added_mass)
    exact = 1.0 / (-1j * omega * (damping + besides))
    found = 1.0 / (stiffness - omega**2 * (mass + infinite) - 1j * omega * (np.conj(fitted) + besides))
    off = np.abs(np.abs(found) / np.abs(exact) - 1.0)[low]
    # A fit of as many poles by the peak alone, unweighted, is off by 2.3 %.
    assert off.max() <= 1.05 * 0.5 * radiation_fit.LIMIT


def test_noise_at_high_frequencies_does_not_count_as_the_peak_of_the_memory() -> None:
    clean = platform()
    # One percent of added mass at 20 times the frequency of the largest damping.
    omega = np.append(clean.frequencies_rad_s, 18.0)
    added_mass = np.concatenate([clean.added_mass, 1.01 * clean.added_mass_infinite[None]])
    damping = np.concatenate([clean.radiation_damping, np.zeros((1, 6, 6))])
    noisy = samples.database(omega, added_mass, damping, clean.added_mass_infinite)
    peaks = [fit_data.FitData.of(one, 0.02).peaks[2] for one in (clean, noisy)]
    assert peaks[1] == pytest.approx(peaks[0])


def test_a_fit_that_misses_only_in_a_coupling_names_the_coupling() -> None:
    omega = np.geomspace(0.05, 60.0, 160)
    response = samples.memory_of_bandpasses(omega)
    infinite = np.diag([3e5, 3e5, 3e5, 0.0, 7e6, 0.0])
    added_mass = infinite + response.imag / omega[:, None, None]
    peaks = np.abs(np.diagonal(response, axis1=1, axis2=2)).max(axis=0)
    # A tenth of the peaks, up and down, in the middle of the damping.
    at = np.flatnonzero((omega > 0.6) & (omega < 1.4))
    turned = 0.1 * np.sqrt(peaks[0] * peaks[4]) / omega[at] * (-1.0) ** np.arange(len(at))
    added_mass[at, 0, 4] += turned
    added_mass[at, 4, 0] += turned
    database = samples.database(omega, added_mass, response.real, infinite)
    radiation = radiation_fit.fit(database, most_states=10, accept=True)
    found = {one.motion: one for one in radiation_fit.misfits(database, radiation)}
    assert {name for name, one in found.items() if one.memory > radiation_fit.LIMIT} >= {"surge", "pitch"}
    assert (found["surge"].coupled_with, found["pitch"].coupled_with) == ("pitch", "surge")
    assert found["surge"].memory == pytest.approx(radiation.fit_error)
    assert found["surge"].frequency_rad_s in omega[at]


def test_a_first_or_last_frequency_that_fails_is_left_out_and_a_steep_start_is_kept() -> None:
    omega = np.array([0.105, 0.209, 0.251, 0.314, 0.331, 0.349, 0.370, 0.393, 0.8, 1.2, 2.0, 3.1])
    # Sectional added mass in roll of a supply vessel by strip theory, 1e7 kg m2: the first is not there.
    roll = np.array([5.1, 9.48, 9.56, 9.71, 9.75, 9.80, 9.85, 9.91, 9.63, 7.7, 6.5, 6.45])
    assert np.flatnonzero(repair._jumps(omega, roll)).tolist() == [0]
    # Evenly spaced: a last one beyond a long gap could be anything.
    even = np.linspace(0.2, 2.4, 12)
    assert np.flatnonzero(repair._jumps(even, np.append(roll[1:8], [9.9, 9.8, 9.7, 9.6, 6.0]))).tolist() == [
        11
    ]
    # Added mass of heave in two dimensions grows as the logarithm of the wave length.
    assert not repair._jumps(omega, 5.0 - np.log(omega)).any()
    assert not repair._jumps(omega, np.exp(-omega)).any()


def test_a_listing_of_aqwa_agrees_with_its_ah1_file(tmp_path) -> None:
    base = writers.database()
    base = replace(base, froude_krylov=0.7 * base.excitation, diffraction=0.3 * base.excitation)
    listed = aqwa_listing.read(str(programs.aqwa_listing(tmp_path / "hull", base)), Options())
    exact = aqwa.read(str(programs.aqwa(tmp_path / "hull", base)), Options())
    np.testing.assert_allclose(listed.frequencies_rad_s, exact.frequencies_rad_s, rtol=7e-5)
    for name, digits in (("added_mass", 5e-5), ("radiation_damping", 5e-5), ("added_mass_infinite", 5e-5),
                         ("excitation", 5.5e-3), ("restoring", 5e-5)):  # fmt: skip
        wanted, found = getattr(exact, name), getattr(listed, name)
        np.testing.assert_allclose(found, wanted, rtol=digits, atol=1e-9 * np.abs(wanted).max(), err_msg=name)
    np.testing.assert_allclose(listed.froude_krylov, 0.7 * exact.excitation, rtol=5.5e-3, atol=1.0)
    for name in ("volume_m3", "draught_m", "density_kg_m3", "gravity_m_s2", "water_depth_m", "directions_rad",
                 "centre_of_gravity_m", "centre_of_buoyancy_m", "reference_m"):  # fmt: skip
        np.testing.assert_allclose(getattr(listed, name), getattr(exact, name), rtol=1e-4, atol=1e-4)
    found = importers.load(tmp_path / "hull.LIS", Options(**SIZE))
    assert any("the .AH1 has more" in note for note in found.provenance.notes)


def test_a_listing_that_is_cut_short_or_of_several_structures_is_refused(tmp_path) -> None:
    path = programs.aqwa_listing(tmp_path / "hull", writers.database())
    text = path.read_text()
    path.write_text(text[: text.index("FROUDE KRYLOV + DIFFRACTION") + 900])
    with pytest.raises(HydrodynamicsError, match="rows of froude krylov"):
        importers.load(path, Options(**SIZE))
    path.write_text(text.replace("DENSITY  OF  WATER", "SALINITY"))
    with pytest.raises(HydrodynamicsError, match="nothing after DENSITY OF WATER"):
        importers.load(path, Options(**SIZE))
    path.write_text(text + "\n F O R   S T R U C T U R E   2\n")
    with pytest.raises(HydrodynamicsError, match=r"2 structures.*\.AH1"):
        importers.load(path, Options(**SIZE))


@pytest.mark.parametrize(("heavier", "said"), [(1.0, "they agree"), (1.5, "they differ by")])
def test_motions_of_wamit_are_compared_with_motions_from_the_imported_data(tmp_path, heavier, said) -> None:
    base = writers.database()
    path = programs.wamit_six_digits(tmp_path / "hull", base)
    programs.wamit_listing(tmp_path / "hull", base)
    mass = np.diag([262e3, 262e3, 262e3, 4e6, 5e6, 6e6])
    roll_damping = np.diag([0.0, 0.0, 0.0, 2e5, 0.0, 0.0])
    programs.wamit_motions(tmp_path / "hull", base, mass, roll_damping)
    motions = (tmp_path / "hull.4").read_text()
    programs.wamit_motions(tmp_path / "hull", base, heavier * mass, roll_damping)
    (tmp_path / "hull.4").write_text(motions)
    (tmp_path / "hull.12d").write_text("0.1 0.1 0 0 1 1 1 1 1\n")
    assert importers.recognise("hull.12s") == "wamit"
    notes = importers.load(path.with_suffix(".4"), Options(**LISTED)).provenance.notes
    assert any("motions of hull.4 are not imported" in note and said in note for note in notes), notes
    assert "forces of second order are left out: .12d" in notes
    (tmp_path / "hull.frc").unlink()
    notes = importers.load(path, Options(**LISTED)).provenance.notes
    assert any("no .frc file gives it" in note for note in notes)


@pytest.mark.parametrize(
    ("spoilt", "said"),
    [
        (lambda rows: [row for row in rows if float(row[1]) == 0.0], "other headings"),
        (lambda rows: [row for row in rows if float(row[1]) < 100.0], "other headings"),
        (lambda rows: [[row[0], f"{float(row[1]) + 1.0:.6E}", *row[2:]] for row in rows], "other headings"),
        (lambda rows: [[f"{1.1 * float(row[0]):.6E}", *row[1:]] for row in rows], "other frequencies"),
        (lambda rows: [*rows[:7], [*rows[7][:6], "NaN"], *rows[8:]], "in line 8"),
        (lambda rows: rows[:-1], "other entries"),
        (lambda rows: [[*row[:2], "0", *row[3:]] for row in rows], "motion 0"),
    ],
    ids=["one heading", "some headings", "headings apart", "frequencies", "not a number", "cut", "motion 0"],
)
def test_an_error_in_the_compared_motions_is_reported_and_the_import_succeeds(tmp_path, spoilt, said) -> None:
    base = writers.database()
    path = programs.wamit_six_digits(tmp_path / "hull", base)
    programs.wamit_listing(tmp_path / "hull", base)
    alone = importers.load(path, Options(**LISTED))
    programs.wamit_motions(tmp_path / "hull", base, np.diag([262e3] * 3 + [5e6] * 3), np.zeros((6, 6)))
    motions = tmp_path / "hull.4"
    rows = [line.split() for line in motions.read_text().splitlines()]
    motions.write_text("".join(" ".join(row) + "\n" for row in spoilt(rows)))
    found = importers.load(path, Options(**LISTED))
    (note,) = [note for note in found.provenance.notes if "hull.4" in note]
    assert note.startswith("hull.4 is not compared: ")
    assert said in note
    np.testing.assert_array_equal(found.excitation, alone.excitation)


def test_a_slender_spar_passes_the_check_of_long_waves() -> None:
    """G. I. Taylor's force on a slender body, rho S (1 + c) times the water's acceleration, c = 1 of a
    circle: the moment of a spar of depth T is int 2 rho S z g k exp(k z) dz, and end effects are left out."""
    radius, depth, rho, g = 3.0, 100.0, 1000.0, 9.81
    area, omega = np.pi * radius**2, np.geomspace(0.06, 1.0, 12)
    inertia = np.pi * radius**4 / 4
    spar = Hull(depth, 6.0, 6.0, area * depth, np.array([0.0, 0.0, -depth / 2]),
                Waterplane(area, np.zeros(2), np.array([inertia, 0.0, inertia])))  # fmt: skip
    k = omega**2 / g
    sway = 2 * rho * area * g * (1 - np.exp(-k * depth))
    # int z k exp(k z) from -T to 0.
    moment = 2 * rho * area * g * (np.exp(-k * depth) * (depth + 1 / k) - 1 / k)
    b = 0.5 * np.pi * np.arange(4)
    excitation = np.zeros((12, 4, 6), complex)
    excitation[:, :, 0] = -1j * sway[:, None] * np.cos(b)
    excitation[:, :, 1] = -1j * sway[:, None] * np.sin(b)
    excitation[:, :, 2] = (rho * g * area * np.exp(-k * depth))[:, None]
    excitation[:, :, 3] = 1j * moment[:, None] * np.sin(b)
    excitation[:, :, 4] = -1j * moment[:, None] * np.cos(b)
    own = rho * area * depth
    added_mass = np.diag([own, own, 0.0, own * depth**2 / 3, own * depth**2 / 3, 0.0])
    added_mass[3, 1] = added_mass[1, 3] = own * depth / 2
    added_mass[4, 0] = added_mass[0, 4] = -own * depth / 2
    database = samples.database(omega, np.tile(added_mass, (12, 1, 1)), np.zeros((12, 6, 6)), added_mass,
                                hull=spar, froude_krylov=0 * excitation, diffraction=excitation)  # fmt: skip
    check_long_waves(database, "spar")
    # With the buoyancy's centre 20 m lower the slope's moment would be another.
    wrong = replace(spar, centre_of_buoyancy_m=np.array([0.0, 0.0, -70.0]))
    with pytest.raises(HydrodynamicsError, match="from the excitation by long waves"):
        check_long_waves(replace(database, hull=wrong), "spar")
