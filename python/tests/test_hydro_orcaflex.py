"""OrcaFlex's vessel types: one database in many conventions, choice by name, and refused files."""

from __future__ import annotations

from dataclasses import replace

import hydro_orcaflex as orcaflex
import numpy as np
import pytest
from hydro_orcaflex import Form
from kingpost.errors import HydrodynamicsError
from kingpost.hydro import importers
from kingpost.hydro.importers import Options

SIZE = {"length_m": 12.0, "beam_m": 10.0, "draught_m": 5.0}
DEEP = {**SIZE, "water_depth_m": np.inf}
EVERY_TURNED = tuple(orcaflex.SIGNS)


def same(found, base) -> None:
    """Equal to rounding: sixteen digits, a few operations, and moments carried over a few metres."""
    for name in ("added_mass", "radiation_damping", "added_mass_infinite", "excitation"):
        wanted, given = getattr(base, name), getattr(found, name)
        for kind in (slice(0, 3), slice(3, 6)):
            largest = np.abs(wanted[..., kind]).max()
            np.testing.assert_allclose(given[..., kind], wanted[..., kind], rtol=0, atol=1e-11 * largest)
    plane, wanted = found.hull.waterplane, base.hull.waterplane
    for name in ("area_m2", "first_moments_m3", "second_moments_m4"):
        np.testing.assert_allclose(getattr(plane, name), getattr(wanted, name), rtol=1e-11, atol=1e-8)
    np.testing.assert_allclose(found.hull.centre_of_buoyancy_m, base.hull.centre_of_buoyancy_m, atol=1e-12)
    np.testing.assert_allclose(found.frequencies_rad_s, base.frequencies_rad_s, rtol=1e-12)
    np.testing.assert_allclose(found.wave_directions_rad, base.wave_directions_rad, atol=1e-12)


FORMS = [
    Form(),
    Form(phases="leads"),
    Form(units="radians", phases="leads", after="zero down-crossing"),
    Form(waves="frequency (rad/s)", after="trough"),
    Form(waves="frequency (Hz)", units="radians", after="zero up-crossing"),
    Form(turned=EVERY_TURNED, phases="leads", after="zero up-crossing"),
    Form(turned=("SwayPositive", "HeavePositive", "PitchPositiveBow"), waves="frequency (rad/s)"),
    Form(phase_origin=(4.0, -2.0, 3.0)),
    Form(phase_origin=(-6.0, 1.0, 0.0), phases="leads", units="radians", turned=EVERY_TURNED),
    Form(symmetry="xz plane", degrees=(0.0, 90.0, 180.0)),
    Form(symmetry="xz plane", degrees=(180.0, -90.0, 0.0), turned=EVERY_TURNED),
]


@pytest.mark.parametrize("form", FORMS)
def test_every_convention_gives_the_same_database(tmp_path, form) -> None:
    base = orcaflex.base()
    found = importers.load(orcaflex.written(tmp_path / "hull.yml", base, form), Options(**DEEP))
    same(found, base)
    assert found.provenance.solver == "OrcaFlex 11.4a"
    # The model's sea is 100 m deep, the coefficients' is not.
    assert found.water == base.water
    assert any("x = 3, y = 0 of the file" in note for note in found.provenance.notes)


@pytest.mark.parametrize(
    ("symmetry", "degrees"),
    [
        ("yz plane", (90.0, 0.0, -90.0)),
        ("xz and yz planes", (0.0, 90.0)),
        ("xz plane", (0.0, 90.0, 180.0)),
        ("None", (0.0, 90.0, 180.0, 270.0)),
    ],
)
def test_every_symmetry_completes_the_circle_of_directions(tmp_path, symmetry, degrees) -> None:
    base = orcaflex.alike_fore_and_aft()
    form = Form(symmetry=symmetry, degrees=degrees)
    same(importers.load(orcaflex.written(tmp_path / "hull.yml", base, form), Options(**DEEP)), base)


def test_a_force_that_lags_the_crest_by_a_quarter_is_the_imaginary_unit(tmp_path) -> None:
    """Surge of a long wave: cos(w t - pi/2) = Re(i exp(-i w t)), by the numbers of the file themselves."""
    path = orcaflex.written(tmp_path / "hull.yml", orcaflex.base(), Form())
    row = path.read_text(encoding="utf-8-sig").split("RAOYawPhase:\n")[1].splitlines()[0]
    surge, lag = (float(cell) for cell in row.strip(" -[]").split(", ")[1:3])
    assert lag == pytest.approx(270.0)
    found = importers.load(path, Options(**DEEP)).excitation[0, 0, 0]
    assert found == pytest.approx(-1j * 1e3 * surge, rel=1e-12)


def test_a_mass_unequal_to_the_displaced_mass_requires_the_options_of_the_weight(tmp_path) -> None:
    base = orcaflex.base()
    path = orcaflex.written(tmp_path / "hull.yml", base, Form(mass=0.0, weight=False))
    with pytest.raises(HydrodynamicsError, match="restoring_includes_weight"):
        importers.load(path, Options(**DEEP))
    found = importers.load(path, Options(**DEEP, restoring_includes_weight=False))
    same(found, base)
    assert any("0 te, is not the displaced one, 262 te" in note for note in found.provenance.notes)
    # And of the displaced mass the file's word is taken back where it is known to be wrong.
    path = orcaflex.written(tmp_path / "hull.yml", base, Form(weight=False))
    with pytest.raises(HydrodynamicsError, match="restoring_includes_weight"):
        importers.load(path, Options(**DEEP))
    same(importers.load(path, Options(**DEEP, restoring_includes_weight=False)), base)


def test_one_error_names_all_values_that_an_orcaflex_file_lacks(tmp_path) -> None:
    path = orcaflex.written(tmp_path / "hull.yml", orcaflex.base(), Form())
    with pytest.raises(HydrodynamicsError, match="no water_depth_m, draught_m, length_m, beam_m in the file"):
        importers.load(path)
    path = orcaflex.written(tmp_path / "hull.yml", orcaflex.base(), Form(phase_origin=(4.0, 0.0, 0.0)))
    with pytest.raises(HydrodynamicsError, match="water_depth_m"):
        importers.load(path, Options(**SIZE))


def test_vessel_types_and_draughts_are_chosen_by_name(tmp_path) -> None:
    base = orcaflex.base()
    other = Form(others={"Name": "Barge, light", "Length": "12"}, phases="leads")
    path = orcaflex.written(tmp_path / "hull.yml", base, Form(), other)
    with pytest.raises(
        HydrodynamicsError, match=r"2 in VesselTypes.*'Type 1', 'Barge, light'.*--vessel-type"
    ):
        importers.load(path, Options(**DEEP))
    with pytest.raises(HydrodynamicsError, match=r"'Barge'.*'Type 1', 'Barge, light'"):
        importers.load(path, Options(**DEEP, vessel_type="Barge"))
    deep = {key: value for key, value in DEEP.items() if key != "length_m"}
    found = importers.load(path, Options(**deep, vessel_type="Barge, light"))
    same(found, base)
    assert found.hull.length_m == 12.0
    with pytest.raises(HydrodynamicsError, match=r"draught_name: found 'Deep', allowed: one of 'Draught1'"):
        importers.load(path, Options(**DEEP, vessel_type="Type 1", draught_name="Deep"))


@pytest.mark.parametrize(
    ("key", "value"),
    [
        ("WavesReferredToBy", "wave length (m)"),
        ("RAOPhaseConvention", "follows"),
        ("RAOPhaseUnitsConvention", "grads"),
        ("RAOPhaseRelativeToConvention", "wind"),
        ("RAOWaveUnit", "max wave slope"),
        ("Symmetry", "xy plane"),
        ("PitchPositiveBow", "port"),
        ("SurgePositive", "~"),
        ("AMDMethod", "Constant"),
        ("ReferenceOriginDatumPosition", "[0, 0, 2]"),
        ("CentreOfBuoyancy", "[0, 0]"),
        ("DisplacedVolume", "much"),
    ],
)
def test_an_unknown_convention_is_refused_with_its_value(tmp_path, key, value) -> None:
    path = orcaflex.written(tmp_path / "hull.yml", orcaflex.base(), Form(others={key: value}))
    with pytest.raises(HydrodynamicsError, match=f"Type 1.*{key}") as found:
        importers.load(path, Options(**DEEP))
    said = {"~": "nothing", "[0, 0, 2]": "trim of 2", "[0, 0]": "0', '0"}.get(value, value)
    assert said in str(found.value)


def test_frequencies_without_forces_are_left_out_with_a_note(tmp_path) -> None:
    base = orcaflex.base()
    path = orcaflex.written(tmp_path / "hull.yml", base, Form())
    lines = path.read_text(encoding="utf-8-sig").splitlines()
    table = next(n for n, line in enumerate(lines) if "RAOYawPhase" in line)
    path.write_text("\n".join(lines[: table + 3] + lines[table + 4 :]), encoding="utf-8-sig")
    found = importers.load(path, Options(**DEEP))
    np.testing.assert_allclose(found.frequencies_rad_s, np.delete(base.frequencies_rad_s, 2))
    assert np.abs(found.excitation - np.delete(base.excitation, 2, axis=0)).max() < 1e-3
    assert any(
        "1 frequencies left out at which there are no load RAOs" in note for note in found.provenance.notes
    )


def test_damping_other_than_radiation_damping_is_left_out_with_a_note(tmp_path) -> None:
    form = Form(others={"OtherLinearDamping": "[0, 0, 0, 5, 0, 0]"})
    path = orcaflex.written(tmp_path / "hull.yml", orcaflex.base(), form)
    notes = importers.load(path, Options(**DEEP)).provenance.notes
    assert any("other damping of the file" in note for note in notes)


DEEPLY_NESTED = "VesselTypes: " + "[" * 100_000 + "]" * 100_000
# Ten lists of ten lists of ten...: 10^9 numbers if they were all gone through.
BOMB = "\n".join(
    ["a0: &a0 [1, 1]"] + [f"a{n}: &a{n} [{', '.join([f'*a{n - 1}'] * 10)}]" for n in range(1, 10)]
)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "empty"),
        ("just words", "no entries"),
        ("a: [1, 2", "cannot be read"),
        ("a: 1\n---\nb: 2", "cannot be read"),
        ("version: 1\ntitle: a scenario", "UnitsSystem"),
        ("General: {UnitsSystem: US}", "US"),
        ("General: {UnitsSystem: SI}", "VesselTypes"),
        ("General: {UnitsSystem: SI}\nVesselTypes: [{Name: a}]", "Draughts"),
        (DEEPLY_NESTED, "more than 50 lists"),
        (BOMB.replace("a9:", "DisplacedVolume:"), "UnitsSystem"),
        ("a: !!python/object/apply:os.getcwd []", "UnitsSystem"),
    ],
)
def test_a_file_of_another_kind_is_refused(tmp_path, text, said) -> None:
    path = tmp_path / "hull.yml"
    path.write_text(text)
    with pytest.raises(HydrodynamicsError, match=said):
        importers.load(path, Options(**DEEP))


def test_a_file_cut_short_anywhere_is_refused(tmp_path) -> None:
    """Matrices stand before forces, of which the last row of the last direction may not be missed."""
    text = orcaflex.written(tmp_path / "whole.yml", orcaflex.base(), Form()).read_text(encoding="utf-8-sig")
    path = tmp_path / "cut.yml"
    for part in np.linspace(0.01, 0.93, 24):
        path.write_text(text[: int(part * len(text))])
        with pytest.raises(HydrodynamicsError):
            importers.load(path, Options(**DEEP))


def test_rows_that_are_repeated_lists_are_refused_at_once(tmp_path) -> None:
    path = orcaflex.written(tmp_path / "hull.yml", orcaflex.base(), Form())
    lines = path.read_text(encoding="utf-8-sig").split("\n")
    row = next(n for n, line in enumerate(lines) if "HydrostaticStiffnessz" in line) + 1
    lines[row] = "          - *a9"
    head = lines.index("---") + 1
    path.write_text("\n".join([*lines[:head], BOMB, *lines[head:]]))
    with pytest.raises(HydrodynamicsError, match="HydrostaticStiffness"):
        importers.load(path, Options(**DEEP))


def test_orcawaves_binary_results_are_refused_with_advice(tmp_path) -> None:
    path = tmp_path / "hull.owr"
    path.write_bytes(b"\x00OrcaWave")
    with pytest.raises(HydrodynamicsError, match=r"binary.*save the model as \.yml"):
        importers.load(path, Options(**DEEP))


def test_a_wrong_density_is_a_contradiction(tmp_path) -> None:
    path = orcaflex.written(tmp_path / "hull.yml", orcaflex.base(), Form())
    with pytest.raises(HydrodynamicsError, match="while the file says 1000"):
        importers.load(path, Options(**DEEP, density_kg_m3=1025.0))


def test_the_file_is_an_input_of_the_command(tmp_path, capsys) -> None:
    from kingpost.cli import main
    from kingpost.hydro import read

    base = replace(orcaflex.base(), title="hull")
    path = orcaflex.written(tmp_path / "hull.yml", base, Form(), Form(phases="leads"))
    target = tmp_path / "hull.hydro.json"
    given = ["--vessel-type", "Type 2", "--water-depth-m", "inf", "--length-m", "12", "--beam-m", "10",
             "--draught-m", "5", "--accept-fit"]  # fmt: skip
    assert main(["hydro", str(path), "-o", str(target), *given]) == 0
    assert "vessel type 'Type 2', draught 'Draught1'" in capsys.readouterr().out
    # Seven digits are written.
    np.testing.assert_allclose(read(target).added_mass, base.added_mass, rtol=1e-6, atol=1.0)
