"""Other programs' files: round trips through each format, numbers worked by hand, bad files."""

from __future__ import annotations

from dataclasses import replace

import hydro_samples as samples
import hydro_writers as writers
import numpy as np
import pytest
from fuzz.kinds import foreign
from kingpost.cli import main
from kingpost.errors import HydrodynamicsError, flag
from kingpost.hydro import importers, read
from kingpost.hydro.importers import Options, wamit
from kingpost.hydro.importers.convert import about_origin
from kingpost.hydro.memory import added_mass_infinite
from lanes import sampled

SIZE = {"draught_m": 5.0, "length_m": 12.0, "beam_m": 10.0}
HULL = {**SIZE, "volume_m3": 262.0, "centre_of_buoyancy_m": (0.4, 0.0, -1.9)}
WAMIT = {
    **HULL, "density_kg_m3": 1000.0, "gravity_m_s2": 9.81, "water_depth_m": np.inf, "length_scale_m": 1.0,
    "first_column": "period_s", "time_sign": "+", "restoring_includes_weight": False,
    "reference_m": tuple(writers.REFERENCE),
}  # fmt: skip
BEMIO = {**SIZE, "restoring_includes_weight": True}
CAPYTAINE_2 = {
    **HULL, "reference_m": tuple(writers.REFERENCE), "restoring_includes_weight": True,
    "centre_of_gravity_m": tuple(writers.GRAVITY_CENTRE),
}  # fmt: skip
CAPYTAINE_3 = {"length_m": 12.0, "beam_m": 10.0}


def same(found, base, *, apart: bool = True) -> None:
    """Equal but for rounding in the files, 12 digits in text, over matrices of very different entries."""
    for name in ("added_mass", "radiation_damping", "added_mass_infinite", "excitation"):
        wanted = getattr(base, name)
        np.testing.assert_allclose(getattr(found, name), wanted, atol=1e-9 * np.abs(wanted).max(), rtol=1e-9)
    if apart:
        np.testing.assert_allclose(found.froude_krylov, base.froude_krylov, atol=1e-3, rtol=1e-9)
    else:
        assert (found.froude_krylov == 0).all()
        assert any("not apart" in note for note in found.provenance.notes)
    np.testing.assert_allclose(found.frequencies_rad_s, base.frequencies_rad_s, rtol=1e-11)
    np.testing.assert_allclose(found.wave_directions_rad, base.wave_directions_rad, atol=1e-12)
    hull, wanted = found.hull, base.hull
    np.testing.assert_allclose(hull.waterplane.area_m2, wanted.waterplane.area_m2)
    np.testing.assert_allclose(
        hull.waterplane.first_moments_m3, wanted.waterplane.first_moments_m3, atol=1e-6
    )
    np.testing.assert_allclose(
        hull.waterplane.second_moments_m4, wanted.waterplane.second_moments_m4, atol=1e-6
    )
    np.testing.assert_allclose(hull.volume_m3, wanted.volume_m3)
    np.testing.assert_allclose(hull.centre_of_buoyancy_m, wanted.centre_of_buoyancy_m)
    assert found.water == base.water


@pytest.mark.parametrize(("scaled", "apart"), [(False, True), (True, True), (False, False)])
def test_a_bemio_file_is_imported_as_the_original_database(tmp_path, scaled, apart) -> None:
    base, path = writers.database(), tmp_path / "hull.h5"
    writers.write_bemio(path, base, scaled=scaled, apart=apart)
    same(importers.load(path, Options(**BEMIO)), base, apart=apart)


@pytest.mark.parametrize("version", sampled([2, 3], keep=[3]))
def test_a_capytaine_file_is_imported_as_the_original_database(tmp_path, version) -> None:
    base, path = writers.database(), tmp_path / "hull.nc"
    writers.capytaine_dataset(base, version).to_netcdf(path, engine="h5netcdf")
    same(importers.load(path, Options(**(CAPYTAINE_2 if version == 2 else CAPYTAINE_3))), base)


def test_a_capytaine_file_of_the_classic_format_is_imported_as_the_original_database(tmp_path) -> None:
    base, path = writers.database(), tmp_path / "hull.nc"
    writers.capytaine_dataset(base, 2).to_netcdf(path, engine="scipy")
    same(importers.load(path, Options(**CAPYTAINE_2)), base)


def test_a_capytaine_file_by_period_is_read_by_frequency(tmp_path) -> None:
    base, path = writers.database(), tmp_path / "hull.nc"
    found = writers.capytaine_dataset(base, 3).assign_coords(period=lambda d: 2 * np.pi / d.omega)
    found.swap_dims(omega="period").sortby("period").to_netcdf(path, engine="scipy")
    same(importers.load(path, Options(**CAPYTAINE_3)), base)


@pytest.mark.parametrize(
    "form",
    [
        writers.Wamit(),
        writers.Wamit(length=7.5),
        writers.Wamit(by_period=False, header=True),
        writers.Wamit(sign="-", header=True, apart=True),
    ],
    ids=["plain", "scaled by a length", "by frequency with a header", "other sign of time"],
)
def test_wamit_files_are_imported_as_the_original_database(tmp_path, form) -> None:
    base = writers.database()
    path = form.write(tmp_path / "hull", base)
    first = "period_s" if form.by_period else "frequency_rad_s"
    given = {**WAMIT, "length_scale_m": form.length, "first_column": first, "time_sign": form.sign}
    same(importers.load(path, Options(**given)), base, apart=form.apart)


def test_units_and_signs_of_wamit_files_follow_its_manual(tmp_path) -> None:
    # By hand, rho = 1000, g = 10, L = 2, w = 1: A33 = 0.5 * 1000 * 2^3, B33 = 0.1 * that / 0.5 * w,
    # A55 = 0.25 * 1000 * 2^5, A15 = 0.2 * 1000 * 2^4; X1 = i * 1000 * 10 * 2^2 of exp(+i w t),
    # X5 = 2 * 1000 * 10 * 2^3; C33 = 3 * 1000 * 10 * 2^2, C44 = 5 * 1000 * 10 * 2^4.
    period = 2 * np.pi
    (tmp_path / "a.1").write_text(
        f"0.0 3 3 0.6\n0.0 5 5 0.3\n0.0 1 5 0.2\n-1.0 3 3 0.7\n-1.0 5 5 0.3\n-1.0 1 5 0.2\n"
        f"{period:.15f} 3 3 0.5 0.1\n{period:.15f} 5 5 0.25 0.0\n{period:.15f} 1 5 0.2 0.0\n"
    )
    (tmp_path / "a.3").write_text(
        f"{period:.15f} 30.0 1 1.0 90.0 0.0 1.0\n{period:.15f} 30.0 5 2.0 0.0 2.0 0.0\n"
    )
    (tmp_path / "a.hst").write_text("3 3 3.0\n4 4 5.0\n3 4 1.0\n3 5 0.0\n4 5 0.0\n5 5 5.0\n")
    given = {**WAMIT, "gravity_m_s2": 10.0, "length_scale_m": 2.0}
    found = wamit.read(str(tmp_path / "a.1"), Options(**given))
    np.testing.assert_allclose(found.frequencies_rad_s, [1.0])
    np.testing.assert_allclose(found.added_mass[0][[2, 4, 0], [2, 4, 4]], [4000.0, 8000.0, 3200.0])
    np.testing.assert_allclose(found.radiation_damping[0, 2, 2], 800.0)
    np.testing.assert_allclose(found.added_mass_infinite[[2, 4], [2, 4]], [4800.0, 9600.0])
    np.testing.assert_allclose(found.excitation[0, 0, [0, 4]], [-40000j, 160000.0], atol=1e-9)
    np.testing.assert_allclose(found.directions_rad, np.pi / 6)
    np.testing.assert_allclose(found.restoring[[2, 3, 2, 3], [2, 3, 3, 2]], [120e3, 800e3, 80e3, 80e3])


def test_moments_are_carried_to_the_origin() -> None:
    # A mass of 3 kg on water's surge, at 2 m below: a rotation about +y of 1 rad/s moves it by -2 m/s,
    # so A15 = -6 kg m, A55 = 12 kg m2; a force of 1 N there has a moment of -2 N m about +y.
    motion = about_origin(np.array([0.0, 0.0, -2.0]))
    found = motion.T @ np.diag([3.0, 0, 0, 0, 0, 0]) @ motion
    assert (found[0, 4], found[4, 0], found[4, 4]) == (-6.0, -6.0, 12.0)
    assert (np.eye(6)[0] @ motion).tolist() == [1.0, 0.0, 0.0, 0.0, -2.0, 0.0]


def test_a_sphere_with_its_weight_in_roll_becomes_buoyancy_alone(tmp_path) -> None:
    # Radius 5 m, centre of gravity 2 m below the water: pi a^4 / 4 + V z_B = 0, so C44 = rho g V 2 m in all,
    # and buoyancy alone has no stiffness about the water plane.
    base = samples.floating_hemisphere()
    omega, mass = base.frequencies_rad_s, 1000.0 * base.hull.volume_m3
    waves = np.zeros((len(omega), 4, 6), complex)
    waves[:, :, 2] = (9810.0 * 25 * np.pi - omega**2 * (mass + base.added_mass[:, 2, 2]))[:, None]
    waves[:, :, 0] = -1j * (omega**2)[:, None] * mass * np.cos(0.5 * np.pi * np.arange(4))
    base = replace(
        base, wave_directions_rad=0.5 * np.pi * np.arange(4), diffraction=waves, froude_krylov=0 * waves
    )
    gravity_centre = np.array([0.0, 0.0, -2.0])
    stiffness = writers.About(base, gravity_centre).restoring(gravity_centre)
    np.testing.assert_allclose(stiffness[3, 3], 9810.0 * base.hull.volume_m3 * 2.0)
    found = writers.capytaine_dataset(base, 3)
    moved = writers.About(base, gravity_centre)
    found["added_mass"][:-1] = moved.matrix(base.added_mass)
    found["added_mass"][-1] = moved.matrix(base.added_mass_infinite)
    found["radiation_damping"][:-1] = moved.matrix(base.radiation_damping)
    waves = moved.force(waves)
    found["diffraction_force"][:, :-1] = np.stack([waves.real, waves.imag])
    found["hydrostatic_stiffness"][:] = stiffness
    found = found.assign_coords(
        rotation_center=("space_coordinate", gravity_centre),
        center_of_mass=("space_coordinate", gravity_centre),
    )
    found.to_netcdf(tmp_path / "sphere.nc", engine="scipy")
    hull = importers.load(tmp_path / "sphere.nc", Options(length_m=10.0, beam_m=10.0)).hull
    np.testing.assert_allclose(hull.waterplane.second_moments_m4[[0, 2]], np.pi * 5**4 / 4)
    roll = hull.waterplane.second_moments_m4[2] + hull.volume_m3 * hull.centre_of_buoyancy_m[2]
    assert abs(roll) < 1e-9 * hull.waterplane.second_moments_m4[2]


@pytest.mark.parametrize("option", [name for name in WAMIT if name != "volume_m3"])
def test_the_error_names_a_value_that_a_file_lacks(tmp_path, option) -> None:
    path = writers.Wamit().write(tmp_path / "hull", writers.database())
    given = {name: value for name, value in WAMIT.items() if name != option}
    with pytest.raises(HydrodynamicsError, match=f"{option}: found nothing in the file.*{flag(option)}"):
        importers.load(path, Options(**given))


def test_one_error_names_all_values_that_a_file_lacks(tmp_path) -> None:
    path = writers.Wamit().write(tmp_path / "hull", writers.database())
    with pytest.raises(HydrodynamicsError) as caught:
        importers.load(path, Options(density_kg_m3=1000.0))
    for option in ("gravity_m_s2", "reference_m", "length_scale_m", "time_sign", "beam_m", "volume_m3"):
        assert option in str(caught.value)
    writers.write_bemio(tmp_path / "hull.h5", writers.database())
    with pytest.raises(HydrodynamicsError, match=r"no draught_m, length_m, .*each as an option"):
        importers.load(tmp_path / "hull.h5")


def test_an_option_that_contradicts_the_file_is_an_error(tmp_path) -> None:
    writers.write_bemio(tmp_path / "hull.h5", writers.database())
    with pytest.raises(HydrodynamicsError, match=r"density_kg_m3: found 1025.0, while the file says 1000.0"):
        importers.load(tmp_path / "hull.h5", Options(**BEMIO, density_kg_m3=1025.0))


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        ({"time_sign": "-"}, "the sign of time"),
        ({"length_scale_m": 2.0}, "restoring|excitation"),
        ({"density_kg_m3": -1.0}, "density_kg_m3: found -1.0"),
        ({"time_sign": "x"}, "time_sign: found 'x'"),
        ({"reference_m": (1.0, 2.0)}, "reference_m"),
        (
            {"restoring_includes_weight": True, "centre_of_gravity_m": (0.4, 0.0, -1.2)},
            "restoring: found .* in roll, from .* long waves.* check restoring_includes_weight",
        ),
    ],
)
def test_a_wrong_option_is_detected_in_long_waves(tmp_path, wrong, message) -> None:
    path = writers.Wamit().write(tmp_path / "hull", writers.database())
    with pytest.raises(HydrodynamicsError, match=message):
        importers.load(path, Options(**{**WAMIT, **wrong}))


def some_directions(base, kept):
    return replace(
        base,
        wave_directions_rad=base.wave_directions_rad[kept],
        froude_krylov=base.froude_krylov[:, kept],
        diffraction=base.diffraction[:, kept],
    )


def test_the_circle_is_filled_by_mirror_images(tmp_path) -> None:
    # Sway, roll and yaw go with sin b in the sample and the rest with cos b: its two sides are equal.
    base = writers.database()
    path = writers.Wamit().write(tmp_path / "hull", some_directions(base, [0, 1, 2]))
    with pytest.raises(HydrodynamicsError, match="hull_symmetry"):
        importers.load(path, Options(**WAMIT))
    given = {**WAMIT, "hull_symmetry": "port_starboard"}
    # The reference is off the plane of symmetry, which is no matter: moments are carried over first.
    same(importers.load(path, Options(**given)), base, apart=False)
    path = writers.Wamit().write(tmp_path / "hull", some_directions(base, [0, 2]))
    with pytest.raises(HydrodynamicsError, match=r"0, 180 deg with hull_symmetry port_starboard"):
        importers.load(path, Options(**given))


def test_a_body_of_revolution_turns_its_forces_with_the_wave(tmp_path) -> None:
    base = writers.database()
    path = writers.Wamit().write(tmp_path / "hull", some_directions(base, [0]))
    directions, values = importers.directions.whole_circle(
        np.zeros(1), base.excitation[:, :1], Options(hull_symmetry="revolution"), str(path)
    )
    assert len(directions) == 24
    east, north = base.excitation[:, 0], values[:, 6]
    np.testing.assert_allclose(north[:, [1, 2, 3]], np.stack([east[:, 0], east[:, 2], -east[:, 4]], axis=1))


def test_added_mass_at_infinite_frequency_follows_from_the_damping() -> None:
    # Hulme's table: 0.5 of the displaced mass; fifteen frequencies give it to a thousandth.
    base = samples.floating_hemisphere()
    found = added_mass_infinite(base.frequencies_rad_s, base.added_mass, base.radiation_damping)
    assert abs(found[2, 2] / base.added_mass_infinite[2, 2] - 1.0) < 1e-3


def test_a_truncated_or_foreign_file_gives_one_clear_error(tmp_path) -> None:
    base = writers.database()
    writers.write_bemio(tmp_path / "a.h5", base)
    writers.capytaine_dataset(base, 3).to_netcdf(tmp_path / "a.nc", engine="h5netcdf")
    writers.Wamit().write(tmp_path / "a", base)
    given = {".h5": BEMIO, ".nc": CAPYTAINE_3, ".1": WAMIT, ".3": WAMIT, ".hst": WAMIT}
    for ending, options in given.items():
        path = tmp_path / f"a{ending}"
        whole = path.read_bytes()
        for share in (0.0, 0.001, 0.3, 0.7, 0.98):
            path.write_bytes(whole[: int(share * len(whole))])
            with pytest.raises(HydrodynamicsError, match="allowed"):
                importers.load(path, Options(**options))
        path.write_bytes(b"solid hull\n  facet normal 0 0 1\n" * 40)
        with pytest.raises(HydrodynamicsError, match="allowed"):
            importers.load(path, Options(**options))
        path.write_bytes(whole)


def test_the_error_for_another_hdf5_file_names_the_missing_field(tmp_path) -> None:
    import h5py

    for ending in (".h5", ".nc"):
        with h5py.File(tmp_path / f"a{ending}", "w") as file:
            file["something"] = 1.0
        with pytest.raises(HydrodynamicsError, match="allowed"):
            importers.load(tmp_path / f"a{ending}", Options(**BEMIO))


def test_the_error_for_an_unknown_file_lists_the_known_kinds(tmp_path) -> None:
    with pytest.raises(HydrodynamicsError, match=r"unknown format, allowed: Capytaine's .nc"):
        importers.load(tmp_path / "hull.stl")
    with pytest.raises(HydrodynamicsError, match="No such file"):
        importers.load(tmp_path / "hull.h5")


def test_the_command_writes_a_whole_database_or_none(tmp_path, capsys) -> None:
    base, source, target = writers.database(30.0, 40), tmp_path / "hull.h5", tmp_path / "hull.hydro.json"
    writers.write_bemio(source, base)
    given = ["hydro", str(source), "-o", str(target), "--draught-m", "5", "--length-m=12", "--beam-m", "10"]
    assert main(given) != 0
    assert "--restoring-includes-weight" in capsys.readouterr().err
    assert not list(tmp_path.glob("*.json"))
    assert main([*given, "--restoring-includes-weight", "yes"]) == 0
    radiation = read(target).radiation
    assert radiation is not None
    assert radiation.fit_error <= 0.02
    assert [len(mode.poles_rad_s) > 0 for mode in radiation.modes[:3]] == [True, True, True]


def test_an_option_of_a_file_is_refused_for_a_hull(tmp_path, capsys) -> None:
    hull = "box:length_m=20,beam_m=10,draught_m=2,depth_m=5"
    assert main(["hydro", hull, "-o", str(tmp_path / "a.hydro.json"), "--time-sign=+"]) != 0
    assert "--time-sign: found a hull" in capsys.readouterr().err


@pytest.mark.parametrize(
    "option", [["--loading", "kg_m=2"], ["--panels", "900"], ["--no-lid"], ["--flip-normals"]]
)
def test_an_option_of_a_hull_is_refused_for_a_file(tmp_path, capsys, option) -> None:
    source = tmp_path / "hull.h5"
    writers.write_bemio(source, writers.database())
    assert main(["hydro", str(source), "-o", str(tmp_path / "a.hydro.json"), *option]) != 0
    name = option[0].removeprefix("--").removeprefix("no-")
    assert f"{flag(name)}: found {source}, allowed: a hull that is computed" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("kind", "file", "old", "new"),
    [
        ("aqwa_listing", "hull.LIS", "E+", "Ex+"),
        ("shipx", "hull.hyd", "*", "x*"),
        ("nemoh", "Mesh/KH.dat", "0.00000000E+00\n", "\n"),
        ("orcaflex", "hull.yml", "AddedMassMatrix", "AddedMass"),
        ("wamit", "hull.hst", "3 3 ", "3 x "),
    ],
)
def test_a_word_in_place_of_a_number_is_refused_in_one_line(tmp_path, kind, file, old, new) -> None:
    """Source: found by damaging the files; each ended in a traceback of the library that reads it."""
    sample = foreign.samples()[kind]
    for name, content in sample.files.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_bytes(content)
    text = (tmp_path / file).read_text(encoding="latin-1")
    assert old in text
    (tmp_path / file).write_text(text.replace(old, new, 1), encoding="latin-1")
    with pytest.raises(HydrodynamicsError) as refused:
        importers.load(tmp_path / sample.named, Options(**foreign.GIVEN[kind]))
    assert len(str(refused.value)) < 500


@pytest.mark.parametrize(("kind", "name"), [("bemio", "hull.h5"), ("capytaine", "hull.nc")])
def test_a_truncated_file_is_refused_without_other_output(tmp_path, capfd, kind, name) -> None:
    """Source: found by damaging the files; the library's own complaints reached the terminal."""
    content = foreign.samples()[kind].files[name]
    path = tmp_path / name
    path.write_bytes(content[: len(content) // 2])
    with pytest.raises(HydrodynamicsError, match="found a file that is damaged"):
        importers.load(path, Options(**foreign.GIVEN[kind]))
    assert capfd.readouterr().err == ""
