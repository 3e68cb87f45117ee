"""Several hulls solved together: against Capytaine's own bodies, energy and reciprocity, one hull alone, and
what is refused."""

from dataclasses import replace
from functools import cache

import hydro_samples as samples
import numpy as np
import pytest
from kingpost import cli, hydro
from kingpost.errors import HydrodynamicsError
from kingpost.hydro import checks, overlap, radiation_fit, several_build, several_solve, solve
from kingpost.hydro.database import Water
from kingpost.hydro.hull_options import parse_shape
from kingpost.hydro.meshes import HullMeshes, parametric
from kingpost.hydro.panels import completed, lid
from kingpost.hydro.partial import Partial
from kingpost.hydro.several import Place, SeveralHulls
from kingpost.hydro.several_command import RESPONSE_SHARE, parse_place
from kingpost.hydro.several_mesh import Cluster, Member, rotation
from test_hydro_several_file import sample

capytaine = pytest.importorskip("capytaine")

BARGE = "box:length_m=20,beam_m=10,draught_m=2,depth_m=5"
BESIDE = (Place(0.0, 0.0), Place(0.0, 13.0))
TURNED = (Place(1.0, 2.0, 0.2), Place(3.0, 20.0, 0.2 + np.pi / 6))
DIRECTIONS = 12


@cache
def hull(panels: int = 60) -> HullMeshes:
    return parametric(parse_shape(BARGE), BARGE, panels)


def members(places, panels: int = 60) -> list[Member]:
    return [
        Member(name, place, hull(panels)) for name, place in zip(("weather", "lee"), places, strict=False)
    ]


def solved(places, omega, directions: int = DIRECTIONS, panels: int = 60, water: Water | None = None):
    some = members(places, panels)
    cluster = Cluster.of(some, [True] * len(some))
    return several_solve.solve_several(some, cluster, water or Water(), np.array(omega), directions, False)


def by_capytaine(places, omega: float):
    """A, B and the diffraction forces, by Capytaine's sum of bodies and its own engine, moved to the axes and
    the phase of each hull."""
    bodies, turn = [], np.zeros((12, 12))
    for k, one in enumerate(members(places)):
        at, heading = (one.place.x_m, one.place.y_m, 0.0), one.place.heading_rad
        wet = completed(one.hull.panels, one.hull.reflections)
        cover = completed(lid(one.hull.panels, one.hull.panel_size_m), one.hull.reflections)
        mesh, lid_mesh = (
            capytaine.Mesh(part.vertices, part.corner_lists).rotated_z(heading).translated(at)
            for part in (wet, cover)
        )
        motions = capytaine.rigid_body_dofs(rotation_center=at)
        bodies.append(capytaine.FloatingBody(mesh, motions, lid_mesh=lid_mesh, name=one.name))
        for start in (6 * k, 6 * k + 3):
            turn[start : start + 3, start : start + 3] = rotation(heading)
    both, solver = bodies[0] + bodies[1], capytaine.BEMSolver(method="direct")
    names = list(both.dofs)
    settings = {"body": both, "omega": omega, "rho": 1025.0, "g": 9.80665}
    columns = [
        solver.solve(capytaine.RadiationProblem(radiating_dof=name, **settings), _check_wavelength=False)
        for name in names
    ]
    matrices = [
        turn.T @ np.array([[getattr(one, kind)[name] for one in columns] for name in names]) @ turn
        for kind in ("added_mass", "radiation_damping")
    ]
    forces = np.zeros((2, DIRECTIONS, 6), complex)
    for k, place in enumerate(places):
        for step in range(DIRECTIONS):
            angle = place.heading_rad + 2 * np.pi * step / DIRECTIONS
            problem = capytaine.DiffractionProblem(wave_direction=angle, **settings)
            found = solver.solve(problem, _check_wavelength=False).forces
            ahead = place.x_m * np.cos(angle) + place.y_m * np.sin(angle)
            every = np.array([found[name] for name in names]) @ turn
            forces[k, step] = every[6 * k : 6 * k + 6] * np.exp(-1j * omega**2 / 9.80665 * ahead)
    return *matrices, forces


@pytest.mark.parametrize("places", [BESIDE, TURNED], ids=["beside", "turned"])
def test_coefficients_are_those_of_capytaines_bodies(places) -> None:
    found, omega = solved(places, [1.2]), 1.2
    expected = by_capytaine(places, omega)
    # Beside each other they are mirrored, turned they are not: rounding is left.
    for ours, theirs in zip(
        (found.added_mass[0], found.radiation_damping[0], found.diffraction[0]), expected, strict=True
    ):
        np.testing.assert_allclose(ours, theirs, rtol=0, atol=1e-11 * np.abs(theirs).max())


def test_hulls_in_line_share_their_planes_of_symmetry() -> None:
    beside = Cluster.of(members(BESIDE), [False, False])
    tandem = Cluster.of(members((Place(0, 0), Place(25, 0, np.pi))), [False, False])
    askew = Cluster.of(members(TURNED), [False, False])
    ahead = Place(18 * np.cos(0.3), 18 * np.sin(0.3), 0.3 + np.pi / 2)
    crossed = Cluster.of(members((Place(0, 0, 0.3), ahead)), [False, False])
    assert [one.reflections for one in (beside, tandem, askew, crossed)] == [(0,), (1,), (), (1,)]
    # Surge and sway of boxes beside each other are not coupled, sway and roll of both are.
    assert not beside.couplings[0, 7]
    assert beside.couplings[1, 9]
    assert askew.couplings.all()


def database(found, some) -> SeveralHulls:
    """The results as a database, unchecked."""
    cluster = Cluster.of(some, [True] * len(some))
    directions = found.diffraction.shape[2]
    return several_build._database(some, cluster, Water(), "two boxes", directions, found, ())


def test_energy_and_reciprocity_hold_for_both_hulls_together() -> None:
    omega, some = [0.7, 1.0, 1.3], members(TURNED, 150)
    found = database(solved(TURNED, omega, 48, 150), some)
    damping, scale = found.radiation_damping, np.sqrt(checks.damping_scale(found))
    scaled = damping / np.outer(scale, scale)
    # The limit of computed databases, at a resonance between the hulls at 1.3 rad/s.
    limit = several_build.RESONANT * checks.ASYMMETRY
    assert np.abs(scaled - scaled.transpose(0, 2, 1)).max() < limit
    assert np.linalg.eigvalsh(0.5 * (scaled + scaled.transpose(0, 2, 1))).min() > -0.01
    # Haskind's relation of every motion, with the waves that the other hull scatters.
    difference = checks.haskind_damping(found) - np.diagonal(damping, axis1=1, axis2=2)
    assert np.abs(difference / scale**2).max() < checks.HASKIND


def test_hulls_far_apart_are_as_alone() -> None:
    omega, distance = 1.2, 500.0
    far = solved((Place(0.0, 0.0), Place(300.0, 400.0, 0.3)), [omega])
    alone = solve.solve(hull(), Water(), np.array([omega]), DIRECTIONS, with_lid=True)
    # A ring wave falls as sqrt(2 / (pi k R)); one that comes back has it twice.
    ring = np.sqrt(2 / (np.pi * omega**2 / 9.80665 * distance))
    for name in ("added_mass", "radiation_damping"):
        both, one = getattr(far, name)[0], getattr(alone, name)[0]
        size = np.sqrt(np.outer(np.diag(alone.added_mass[0]), np.diag(alone.added_mass[0])))
        for k in (0, 6):
            assert (np.abs(both[k : k + 6, k : k + 6] - one) / size).max() < ring**2
        assert (np.abs(both[:6, 6:]) / size).max() < 2 * ring
    # Forces over the largest force, moments over that at half the length of the hull.
    largest = np.abs(alone.diffraction[0, :, :3]).max() * np.repeat([1.0, 10.0], 3)
    for k in range(2):
        assert (np.abs(far.diffraction[0, k] - alone.diffraction[0]) / largest).max() < 2 * ring


def test_long_waves_lift_both_hulls_by_their_amplitude() -> None:
    omega, some = np.array([0.25]), members(TURNED)
    found = database(solved(TURNED, omega), some)
    water, plane = Water(), hull().particulars
    mass = water.density_kg_m3 * plane.volume_m3
    inertia = mass * np.diag([1, 1, 1, 12.0, 25.0, 25.0])
    stiffness = water.density_kg_m3 * water.gravity_m_s2 * np.diag([0, 0, 200.0, 1300.0, 6000.0, 0])
    both = np.eye(2)
    impedance = np.kron(both, stiffness) - omega**2 * (np.kron(both, inertia) + found.added_mass[0])
    impedance = impedance - 1j * omega * found.radiation_damping[0]
    for k in range(2):
        # Beam seas of hull k, in which the others' loads have their own directions: waves of 1 km.
        turned = [round((some[k].place.heading_rad - one.place.heading_rad) / (np.pi / 6)) for one in some]
        index = [(3 + shift) % DIRECTIONS for shift in turned]
        loads = np.concatenate([found.hulls[j].excitation[0, at] for j, at in enumerate(index)])
        heave = np.linalg.solve(impedance, loads)[6 * k + 2]
        assert heave == pytest.approx(1.0, abs=0.05)


def test_a_resonance_gets_frequencies_until_its_changes_are_slow() -> None:
    # B = w^2 a / ((w0^2 - w^2)^2 + (2 z w0 w)^2) of one motion, damped by 2 %.
    infinite, natural, damping = np.eye(1), 1.3, 0.02

    def row(w: float):
        k = 1j * w / (natural**2 - w**2 + 2j * damping * natural * w)
        return infinite + k.imag / w, np.array([[k.real]])

    rows = {w: row(w) for w in np.linspace(0.3, 2.5, 23).tolist()}
    added = []
    while (between := several_solve._quickest(rows, infinite)) is not None:
        rows[between] = row(between)
        added.append(between)
    assert 8 <= len(added) <= 30
    assert all(abs(w - natural) < 0.3 for w in added)
    peak = 1 / (2 * damping * natural)
    assert max(one[1][0, 0] for one in rows.values()) > 0.95 * peak


def test_a_resumed_run_gives_the_same_bits(tmp_path, monkeypatch) -> None:
    some, omega, count = members(BESIDE), np.array([0.5, 0.8, 1.1]), []
    cluster = Cluster.of(some, [False, False])
    arguments = (some, cluster, Water(), omega, 4, False)
    whole, at = several_solve.solve_several(*arguments), several_solve.ClusterFlow.at

    def stopping(flow, frequency, *others):
        if len(count) == 2:
            raise KeyboardInterrupt
        count.append(frequency)
        return at(flow, frequency, *others)

    monkeypatch.setattr(several_solve.ClusterFlow, "at", stopping)
    path = tmp_path / "x.partial.npz"
    with pytest.raises(KeyboardInterrupt):
        several_solve.solve_several(*arguments, partial=Partial(path))
    count.clear()
    found = several_solve.solve_several(*arguments, partial=Partial(path))
    assert count == [1.1]
    for name in ("added_mass", "radiation_damping", "added_mass_infinite", "diffraction"):
        np.testing.assert_array_equal(getattr(found, name), getattr(whole, name))


def test_the_memory_of_two_hulls_is_recovered_and_passive_together() -> None:
    omega = np.geomspace(0.05, 60.0, 120)
    turn = np.array([[1.0, 0.4], [-0.3, 1.0]])
    memory = np.kron(turn @ turn.T, np.ones((6, 6))) * np.tile(samples.memory_of_bandpasses(omega), (1, 2, 2))
    infinite = np.kron(np.eye(2), np.diag([3e5, 3e5, 3e5, 1.0, 7e6, 1.0]))
    both = replace(
        sample(120), frequencies_rad_s=omega, radiation=None, hulls=sample(120).hulls[:2],
        added_mass=infinite + memory.imag / omega[:, None, None], radiation_damping=memory.real,
        added_mass_infinite=infinite,
    )  # fmt: skip
    radiation = radiation_fit.fit(both, limit=1e-3)
    assert radiation.fit_error < 1e-3
    # Four poles of surge, heave and pitch; sway alone has two, but every second number is tried from 4 on.
    assert [len(mode.poles_rad_s) > 0 for mode in radiation.modes] == 2 * [1, 1, 1, 0, 1, 0]
    assert max(len(mode.poles_rad_s) for mode in radiation.modes) == 4
    response = radiation_fit.evaluate(radiation, np.append(0.0, np.geomspace(1e-3, 1e3, 2000)))
    np.testing.assert_allclose(response, response.transpose(0, 2, 1), rtol=1e-12)
    peak = np.abs(np.einsum("nii->ni", response)).max(axis=0) + 1.0
    scaled = response / np.sqrt(np.outer(peak, peak))
    assert np.abs(scaled[0]).max() < 1e-12
    assert np.linalg.eigvalsh(scaled.real).min() > -1e-12


@pytest.mark.thorough
def test_the_database_of_a_gap_has_its_resonance_and_a_passive_memory() -> None:
    found = several_build.build_several(members(BESIDE, 200), Water(), "two boxes")
    assert any("frequencies added" in note for note in found.provenance.notes)
    omega, heave = found.frequencies_rad_s, found.radiation_damping[:, 2, 2]
    # The piston of the gap: a column of water of the draught and its added mass, w^2 = g / (T + a) with a
    # of about half the gap.
    assert omega[heave.argmax()] == pytest.approx((9.80665 / (2.0 + 1.5)) ** 0.5, rel=0.1)
    radiation = radiation_fit.fit(found, response_share=RESPONSE_SHARE)
    assert radiation.fit_error <= radiation_fit.LIMIT
    everywhere = np.concatenate([np.linspace(0.0, 10.0, 4001), np.geomspace(10.0, 1e3, 500)])
    response = radiation_fit.evaluate(radiation, everywhere)
    peak = np.abs(np.einsum("nii->ni", response)).max(axis=0)
    scaled = response.real / np.sqrt(np.outer(peak, peak))
    assert np.linalg.eigvalsh(scaled).min() > -1e-12


OVERLAPPING = {
    "across": (Place(0, 0), Place(2, 6, 0.3)),
    "along": (Place(0, 0), Place(0, 7)),
    "crossed": (Place(0, 0), Place(0, 0, np.pi / 2)),
    "the same": (Place(0, 0), Place(0, 0)),
    "touching": (Place(0, 0), Place(20, 0)),
}


@pytest.mark.parametrize("places", OVERLAPPING.values(), ids=OVERLAPPING)
def test_hulls_that_overlap_are_refused_by_their_names(places) -> None:
    with pytest.raises(
        HydrodynamicsError, match=r"--at: found weather at x 0 m, .* overlaps or touches lee at"
    ):
        several_build.check_members(members(places), Water())


def test_hulls_whose_boxes_overlap_but_not_their_meshes_are_apart() -> None:
    # A hull across the bow of one turned by 45 degrees: boxes along x and y overlap by 5 m.
    places = (Place(0, 0, np.pi / 4), Place(15, -5, np.pi / 4))
    some = members(places)
    several_build.check_members(some, Water())
    # Beside each other and shifted by 7.07 m: 14.14 m from axis to axis, less the beam.
    assert overlap.gaps_m(some)[0, 1] == pytest.approx(200**0.5 - 10.0, rel=1e-6)


def test_a_hull_inside_another_is_refused() -> None:
    boat = parametric(parse_shape("box:length_m=2,beam_m=1,draught_m=0.5,depth_m=1"), "boat", 60)
    inside = [Member("barge", Place(), hull()), Member("boat", Place(3.3, 1.2), boat)]
    with pytest.raises(HydrodynamicsError, match=r"barge at .* overlaps or touches boat"):
        several_build.check_members(inside, Water())


@pytest.mark.parametrize(("place", "length_m"), [((0, 13), 20), ((23, 0), 10), ((40, 30), 200**0.5)])
def test_hulls_face_each_other_over_the_length_that_both_have_there(place, length_m) -> None:
    # Corner to corner both lie askew to the way between them.
    one, other = members((Place(), Place(*place)))
    assert several_build.facing_m(one, other) == pytest.approx(length_m, abs=1e-9)


def test_water_that_sloshes_across_a_gap_limits_the_frequencies() -> None:
    water, near, wide = Water(), members(BESIDE), members((Place(0, 0), Place(0, 40)))
    limit = several_build.sloshing_rad_s(near, water)
    assert limit == pytest.approx((0.9 * np.pi / 3 * 9.80665) ** 0.5)
    assert several_build.sloshing_rad_s(wide, water) == np.inf
    assert several_build.gap_warnings(near, 0.5 * limit, water) == []
    assert "end at 3.04 rad/s" in several_build.gap_warnings(near, limit, water)[0]
    assert "sloshes" in several_build.gap_warnings(near, 4.0, water)[0]
    assert "narrower" in several_build.gap_warnings(members((Place(), Place(0, 10.5))), 1.0, water)[0]


def command(capsys: pytest.CaptureFixture[str], *words: str) -> tuple[int, str, str]:
    try:
        status = cli.main(["hydro", *words])
    except SystemExit as left:
        status = left.code
    captured = capsys.readouterr()
    return status, captured.out, captured.err


def test_the_command_writes_a_database_of_both_hulls(tmp_path, capsys) -> None:
    target = tmp_path / "two.hydro.json"
    words = ("--at", "0,0,0", "--at", "0,18,30", "--panels", "60", "--directions", "12",
             "--frequencies-rad-s", "0.4:1.1:8", "--accept-fit")  # fmt: skip
    status, out, err = command(capsys, BARGE, BARGE, *words, "-o", str(target))
    assert (status, err) == (0, "")
    assert "place               x 0 m, y 18 m, heading 30 deg" in out
    assert "GB at most" in out
    assert " min for 8 frequencies" in out
    found = hydro.read_several(target)
    assert found.names == ("box", "box_2")
    np.testing.assert_array_equal(found.added_mass, found.added_mass.transpose(0, 2, 1))
    assert len(found.radiation.modes) == 12
    assert hydro.read(hydro.write(found.of("box_2"), tmp_path / "one.hydro.json")).motions[0] == "surge"


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ([BARGE, BARGE], "--at: found 0 places, allowed: 2, one for each hull"),
        ([BARGE, BARGE, "--at", "0,0,0", "--at", "1,2"], "--at: found '1,2', allowed: X_M,Y_M,HEADING_DEG"),
        ([BARGE, BARGE, "--at", "0,0,0", "--at", "0,5,0"], "--at: found box at x 0 m, y 0 m, heading 0 deg, "
         "which overlaps or touches box_2 at x 0 m, y 5 m"),
        ([BARGE, BARGE, "--at", "0,0,0", "--at", "0,15,0", "--name", "a", "--name", "a"],
         "--name: found 'a' for 2 hulls, allowed: a name for each hull"),
        ([BARGE, BARGE, "--at", "0,0,0", "--at", "0,15,0", "--name", "a"], "--name: found 1 names"),
        ([BARGE, BARGE, "--at", "0,0,0", "--at", "0,15,0", "--heel-deg", "3"], "--heel-deg: found several"),
        ([BARGE, "--at", "0,0,0"], "--at: found one hull, allowed: several hulls"),
        ([BARGE, BARGE, "--at", "0,0,0", "--at", "0,15,0", "--water-depth-m", "1.5"], "water_depth_m: found"),
    ],
)  # fmt: skip
def test_a_wrong_command_line_gives_one_error_line_and_no_file(tmp_path, capsys, monkeypatch, words, message):
    monkeypatch.chdir(tmp_path)
    status, _, err = command(capsys, *words, "-o", "hulls.hydro.json")
    assert status == cli.WRONG_INPUT
    assert err.startswith(f"error: {message}")
    assert err.count("\n") == 1
    assert list(tmp_path.iterdir()) == []


def test_a_place_is_read_in_degrees() -> None:
    assert parse_place("-1.5,2,90") == Place(-1.5, 2.0, np.pi / 2)
