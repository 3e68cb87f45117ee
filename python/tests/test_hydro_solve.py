"""The panel method: against closed forms and tables, its symmetries, and the results that are refused."""

import sys
from dataclasses import replace

import hydro_samples as samples
import numpy as np
import pytest
from kingpost import cli, gallery
from kingpost.errors import HydrodynamicsError
from kingpost.hydro import build, checks, database_file, radiation_fit, symmetry
from kingpost.hydro.airy import wave_number
from kingpost.hydro.database import Database, Water
from kingpost.hydro.hull_options import parse_shape
from kingpost.hydro.meshes import HullMeshes, parametric, whole
from kingpost.hydro.panels import of_triangles
from kingpost.hydro.solve import froude_krylov, solve
from lanes import THOROUGH

pytest.importorskip("capytaine")

BARGE = "box:length_m=20,beam_m=10,draught_m=2,depth_m=5"
VESSEL = "offshore_vessel:length_m=80,beam_m=18,draught_m=5.5,depth_m=8,block_coefficient=0.68"


def hull(description: str, panels: int) -> HullMeshes:
    return parametric(parse_shape(description), description, panels)


@pytest.fixture(scope="module")
def barge() -> Database:
    """Solved here, or by default as the gallery has it stored."""
    if not THOROUGH:
        return database_file.read(gallery.folder() / "hydro" / "barge.hydro.json")
    frequencies = np.array([0.3, 0.6, 0.9, 1.2, 1.6, 2.0, 2.5, 3.0])
    return build.build(hull(BARGE, 400), Water(), "barge", frequencies, directions=24)


def test_a_heaving_hemisphere_has_the_coefficients_of_hulmes_table():
    water, radius = Water(density_kg_m3=1000.0), 5.0
    frequencies = np.sqrt(water.gravity_m_s2 * samples.HULME[:, 0] / radius)
    found = solve(hull("sphere:radius_m=5", 500), water, frequencies, 4, with_lid=True)
    mass = 2 / 3 * np.pi * 1000 * radius**3
    np.testing.assert_allclose(found.added_mass[:, 2, 2] / mass, samples.HULME[:, 1], rtol=0.02)
    allowed = np.maximum(0.02 * samples.HULME[:, 2], 0.005)
    damping = found.radiation_damping[:, 2, 2] / mass / frequencies
    assert (np.abs(damping - samples.HULME[:, 2]) <= allowed).all()
    assert found.added_mass_infinite[2, 2] / mass == pytest.approx(samples.HULME_INFINITE, rel=0.02)
    # A sphere that rolls, pitches or yaws about its centre moves no water: 1e-3 of what its mass would
    # have, from panels that are not quite round.
    assert np.abs(found.added_mass[:, 3:, 3:]).max() < 1e-3 * mass * radius**2


@pytest.mark.parametrize("water", [Water(), Water(depth_m=12.0)])
def test_froude_krylov_heave_in_head_seas_is_the_closed_form_of_a_box(water):
    length, beam, draught = 20, 10, 2
    for frequency in (0.2, 0.6, 1.0, 1.5):
        k = wave_number(frequency, water)
        force = froude_krylov(hull(BARGE, 900), water, frequency, np.array([np.pi]))[0]
        depth = 0.0 if water.depth_m is None else water.depth_m
        decay = np.cosh(k * (depth - draught)) / np.cosh(k * depth) if depth else np.exp(-k * draught)
        sinc = np.sin(k * length / 2) / (k * length / 2)
        waterplane = water.density_kg_m3 * water.gravity_m_s2 * length * beam
        assert force[2] == pytest.approx(waterplane * decay * sinc, rel=0.01)
        # Long waves lift the whole waterplane.
        if frequency == 0.2:
            assert force[2].real == pytest.approx(waterplane, rel=0.02)


def test_the_longest_waves_lift_the_barge_by_its_waterplane(barge):
    stiffness = 1025 * 9.80665 * 200
    assert abs(barge.excitation[0, barge.excitation.shape[1] // 2, 2]) == pytest.approx(stiffness, rel=0.1)


def test_the_coefficients_of_the_barge_pass_every_check_and_its_file_keeps_them(barge, tmp_path):
    checks.check(database_file.read(database_file.write(barge, tmp_path / "barge.hydro.json")))
    assert barge.provenance.lid_panels > 0


@pytest.mark.thorough
def test_a_mirrored_half_gives_the_coefficients_of_the_whole_hull():
    water, frequencies = Water(), np.array([0.5, 1.0])
    half = hull(VESSEL, 220)
    full = replace(half, reflections=(), panels=of_triangles(whole(half.panels.surface, (1,))))
    # The same triangles on both sides, so that only the mirroring differs.
    half = replace(half, panels=of_triangles(half.panels.surface))
    one, other = (solve(part, water, frequencies, 8, with_lid=False) for part in (half, full))
    for name in ("added_mass", "radiation_damping", "froude_krylov", "diffraction"):
        first, second = getattr(one, name), getattr(other, name)
        size = np.sqrt(np.diagonal(other.added_mass, axis1=1, axis2=2).max(axis=0))
        # Capytaine's integral over a panel changes in the fourth digit with the order of its corners,
        # and mirroring turns that round.
        first, second = (part / size for part in (first, second))
        np.testing.assert_allclose(first, second, atol=1e-3 * np.abs(second).max(), err_msg=name)


def test_mirror_images_of_wave_directions_have_the_signs_of_the_symmetry():
    water, count = Water(), 12
    box = hull(BARGE, 100)
    angles = 2 * np.pi * np.arange(count) / count
    direct = np.array([froude_krylov(box, water, 1.0, angles)])
    chosen = symmetry.independent_directions(count, box.reflections)
    mirrored = symmetry.whole_circle(direct[:, chosen], chosen, count, box.reflections)
    np.testing.assert_allclose(mirrored, direct, atol=1e-9 * np.abs(direct).max())
    assert len(chosen) == 4
    assert symmetry.independent_directions(5, (0, 1)) == [0, 1, 2]


@pytest.mark.thorough
def test_the_lid_removes_the_spikes_at_irregular_frequencies():
    # The inner water of a box of 20 x 10 x 2 m sloshes at wave numbers pi sqrt((m/20)^2 + (n/10)^2);
    # heave is symmetric: m = n = 0 excluded, the first is m = 2, n = 0 with w^2 = g k coth(k T).
    k = 2 * np.pi / 20
    irregular = np.sqrt(9.80665 * k / np.tanh(2 * k))
    frequencies = irregular * np.linspace(0.9, 1.1, 11)
    box = hull(BARGE, 250)
    roughness = []
    for with_lid in (True, False):
        heave = solve(box, Water(), frequencies, 4, with_lid).added_mass[:, 2, 2]
        roughness.append(np.abs(np.diff(heave, 3)).max() / heave.mean())
    assert roughness[0] < 0.02
    assert roughness[1] > 5 * roughness[0]


def spoilt(found: Database, name: str, change: np.ndarray) -> Database:
    return replace(found, **{name: getattr(found, name) + change})


def test_an_added_mass_that_is_not_symmetric_is_refused(barge):
    change = np.zeros((6, 6))
    change[0, 4] = 2e6
    with pytest.raises(
        HydrodynamicsError, match=r"added_mass: found .* from pitch to surge but .* back at \S+ rad/s"
    ):
        checks.check(spoilt(barge, "added_mass", change))


def test_damping_that_generates_energy_is_refused(barge):
    change = np.zeros((6, 6))
    change[2, 2] = -0.5 * barge.radiation_damping[:, 2, 2].max()
    with pytest.raises(HydrodynamicsError, match=r"radiation_damping: found an eigenvalue of -0\.\d+ of"):
        checks.check(spoilt(barge, "radiation_damping", change))


def test_damping_that_disagrees_with_the_excitation_is_refused(barge):
    with pytest.raises(HydrodynamicsError, match=r"Haskind's relation in .*allowed: at most 10%"):
        checks.check(replace(barge, diffraction=0 * barge.diffraction))


def test_a_negative_added_mass_at_infinite_frequency_is_refused(barge):
    with pytest.raises(HydrodynamicsError, match=r"added_mass_infinite: found -1e\+06 in heave"):
        checks.check(replace(barge, added_mass_infinite=np.diag([0, 0, -1e6, 0, 0, 0])))


def test_frequencies_that_the_panels_do_not_resolve_are_refused():
    with pytest.raises(HydrodynamicsError, match=r"frequencies: found 9 rad/s, a wave of .* on panels of"):
        build.build(hull(BARGE, 100), Water(), "barge", np.array([1.0, 9.0]))


def test_a_keel_in_the_sea_bed_is_refused():
    with pytest.raises(
        HydrodynamicsError, match=r"water_depth_m: found 1.5, allowed: more than the draught of 2 m"
    ):
        build.build(hull(BARGE, 100), Water(depth_m=1.5), "barge")


def test_a_shallow_hull_gets_no_lid_and_a_note():
    shallow = hull("box:length_m=20,beam_m=10,draught_m=0.2,depth_m=3", 300)
    with pytest.raises(HydrodynamicsError, match=r"lid: found a draught of 0.2 m"):
        build.build(shallow, Water(), "barge", np.array([1.0]), with_lid=True)
    found = build.build(shallow, Water(), "barge", np.array([0.5, 1.0]), directions=8)
    assert found.provenance.lid_panels == 0
    assert any("no lid" in note for note in found.provenance.notes)


def command(capsys: pytest.CaptureFixture[str], *words: str) -> tuple[int, str, str]:
    try:
        status = cli.main(["hydro", *words])
    except SystemExit as left:
        status = left.code
    captured = capsys.readouterr()
    return status, captured.out, captured.err


def test_the_command_writes_a_database_that_can_be_read(tmp_path, capsys):
    target = tmp_path / "sphere.hydro.json"
    words = ("--panels", "400", "--directions", "4", "--title", "a sphere")
    status, out, err = command(capsys, "sphere:radius_m=5", "-o", str(target), *words)
    assert (status, err) == (0, "")
    assert "volume              261.7" in out
    found = database_file.read(target)
    assert found.provenance.source == "sphere:radius_m=5"
    assert found.added_mass.shape == (build.FREQUENCIES, 6, 6)
    assert found.radiation.fit_error <= radiation_fit.LIMIT


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (
            ["nothing.stl"],
            "nothing.stl: hull: found no such file, allowed: a mesh file, or a parametric hull",
        ),
        (["box"], "hull: found no length_m, allowed: box:length_m=..."),
        ([BARGE, "--directions", "1"], "--directions: found 1, allowed: a whole number from 4 to 360"),
        ([BARGE, "--panels", "2"], "--panels: found 2"),
        ([BARGE, "--panels", "1000000000"], "--panels: found 1000000000, allowed: a whole number from 50"),
        ([VESSEL, "--panels", "20000"], "hull: found "),
        ([BARGE, "--density-kg-m3", "0"], "--density-kg-m3: found 0, allowed: a number greater than 0"),
        ([BARGE, "--water-depth-m", "nan"], "--water-depth-m: found nan"),
        ([BARGE, "--frequencies-rad-s", "1:2"], "--frequencies-rad-s: found '1:2'"),
        ([BARGE, "--draught-m", "3"], "--draught-m: found a parametric hull"),
    ],
)
def test_a_wrong_command_line_gives_one_error_line_and_no_file(tmp_path, capsys, monkeypatch, words, message):
    monkeypatch.chdir(tmp_path)
    status, _, err = command(capsys, *words, "-o", "hull.hydro.json")
    assert status == cli.WRONG_INPUT
    assert err.startswith(f"error: {message}")
    assert err.count("\n") == 1
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("output", ["hull.json", "none/hull.hydro.json"])
def test_a_wrong_output_path_is_refused_before_the_computation(tmp_path, capsys, monkeypatch, output):
    monkeypatch.chdir(tmp_path)
    status, out, err = command(capsys, BARGE, "-o", output)
    assert (status, out) == (cli.WRONG_INPUT, "")
    assert err.count("\n") == 1


def test_missing_capytaine_gives_one_error_with_the_install_command(tmp_path, capsys, monkeypatch):
    monkeypatch.setitem(sys.modules, "capytaine", None)
    status, _, err = command(capsys, BARGE, "-o", str(tmp_path / "a.hydro.json"))
    assert status == cli.WRONG_INPUT
    assert err == (
        'error: capytaine: found no such package, allowed: `pip install "capytaine>=3"`, which installs it\n'
    )


def test_an_interrupted_command_leaves_no_file(tmp_path, capsys, monkeypatch):
    def interrupted(*_arguments: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("kingpost.hydro.build.solve", interrupted)
    status, _, _ = command(capsys, BARGE, "-o", str(tmp_path / "a.hydro.json"))
    assert status == cli.INTERRUPTED
    assert list(tmp_path.iterdir()) == []
