"""Mean drift of each hull from the momentum around it: a cylinder's, and the far field as the sum."""

import numpy as np
import pytest
from kingpost.errors import HydrodynamicsError
from kingpost.hydro import finite_depth
from kingpost.hydro.airy import decay, group_ratio, wave_number
from kingpost.hydro.attitude import rotation
from kingpost.hydro.control_surface import beyond, control_surface, distance, outline, parallel
from kingpost.hydro.database import Water
from kingpost.hydro.drift import mean_drift
from kingpost.hydro.far_field import ring_waves
from kingpost.hydro.flow import Flow, WettedHull, first_order
from kingpost.hydro.hull_options import parse_shape
from kingpost.hydro.meshes import closed, parametric
from kingpost.hydro.near_field import mean_force
from kingpost.hydro.panels import Panels, lid, mirrored, of_patches
from kingpost.hydro.solve import capytaine_mesh
from kingpost.hydro.submerged import submerged_moments
from kingpost.hydro.surface import Surface, particulars
from kingpost.hydro.waterline import waterline
from lanes import sampled

capytaine = pytest.importorskip("capytaine")

BARGE = "box:length_m=20,beam_m=10,draught_m=2,depth_m=5"
DEEP = Water()
ANGLES = 360
CLUSTERS = sampled([(0.0, 0.0, 3.0), (4.0, 0.3, 5.0)], keep=[(0.0, 0.0, 3.0)])
"""Second hull: its shift along x, its heading, its gap to the first, m and rad."""


def whole_hull(text: str, panels: int) -> Panels:
    part = parametric(parse_shape(text), text, panels)
    quads = part.panels.vertices[part.panels.faces]
    for axis in part.reflections:
        quads = np.concatenate([quads, mirrored(quads, axis)])
    points, index = np.unique(quads.reshape(-1, 3).round(9), axis=0, return_inverse=True)
    return Panels(points, index.reshape(-1, 4))


def placed(panels: Panels, x: float, y: float, heading: float = 0.0) -> Panels:
    c, s = np.cos(heading), np.sin(heading)
    turn = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1.0]])
    return Panels(panels.vertices @ turn.T + [x, y, 0], panels.faces)


def solved(hulls, water, frequency, directions, floating):
    """First-order waves around hulls held or floating freely, and their mesh."""
    bodies = [
        capytaine.FloatingBody(
            mesh=capytaine_mesh(capytaine, hull.panels, ()),
            lid_mesh=capytaine_mesh(capytaine, lid(hull.panels, 1.0), ()),
            dofs=capytaine.rigid_body_dofs(rotation_center=hull.reference_m),
            name=f"hull{number}",
        )
        for number, hull in enumerate(hulls)
    ]
    body = bodies[0] if len(bodies) == 1 else capytaine.FloatingBody.join_bodies(*bodies)
    engine = capytaine.DefaultMatrixEngine(green_function=finite_depth.green_function(capytaine))
    solver = capytaine.BEMSolver(engine=engine, method="direct")
    conditions = {
        "body": body, "omega": frequency, "rho": water.density_kg_m3, "g": water.gravity_m_s2,
        "water_depth": np.inf if water.depth_m is None else water.depth_m,
    }  # fmt: skip
    problems = [capytaine.DiffractionProblem(wave_direction=way, **conditions) for way in directions]
    diffracted = [solver.solve(problem, _check_wavelength=False) for problem in problems]
    shell, motions, radiated = body.hull_mask, np.zeros((len(directions), len(hulls), 6), complex), []
    potentials = np.zeros((len(hulls), 6, int(shell.sum())), complex)
    if floating:
        dofs = list(body.dofs)
        radiation = [capytaine.RadiationProblem(radiating_dof=dof, **conditions) for dof in dofs]
        radiated = [solver.solve(problem, _check_wavelength=False) for problem in radiation]
        potentials = np.array([result.potential[shell] for result in radiated]).reshape(potentials.shape)
        wave = [capytaine.bem.airy_waves.froude_krylov_force(problem) for problem in problems]
        excitation = np.array([
            [result.forces[dof] + force[dof] for dof in dofs]
            for result, force in zip(diffracted, wave, strict=True)
        ])  # fmt: skip
        added = np.array([[result.added_masses[dof] for result in radiated] for dof in dofs])
        damping = np.array([[result.radiation_dampings[dof] for result in radiated] for dof in dofs])
        mass, stiffness = (np.kron(np.eye(len(hulls)), part) for part in block(hulls[0], water))
        impedance = -(frequency**2) * (mass + added) - 1j * frequency * damping + stiffness
        motions = np.linalg.solve(impedance[None], excitation[..., None]).reshape(motions.shape)
    scattered = np.array([result.potential[shell] for result in diffracted])
    return first_order(hulls, water, frequency, directions, potentials, scattered, motions), body.mesh


def block(hull: WettedHull, water: Water) -> tuple[np.ndarray, np.ndarray]:
    """Mass and stiffness of a hull with two planes of symmetry, its centre of gravity on the water plane."""
    found, unit = particulars(hull.panels.surface), water.density_kg_m3 * water.gravity_m_s2
    mass = water.density_kg_m3 * found.volume_m3
    xx, _, yy = found.waterplane.second_moments_m4
    below = found.volume_m3 * found.centre_of_buoyancy_m[2]
    return (
        mass * np.diag([1, 1, 1, 3.2**2, 5.9**2, 6.4**2]),
        unit * np.diag([0, 0, found.waterplane.area_m2, yy + below, xx + below, 0]),
    )


def far(waves, mesh) -> np.ndarray:
    """Surge and sway force and yaw moment on all hulls together, from the far field."""
    frequency, water = waves.frequency_rad_s, waves.water
    k, ratio = wave_number(frequency, water), group_ratio(frequency, water)
    rings = ring_waves(mesh, waves.potential, waves.normal_velocity, frequency, water, ANGLES)
    at = np.rint(waves.directions_rad / (2 * np.pi) * ANGLES).astype(int)
    return np.array([mean_drift(ring, n, k, ratio, water) for ring, n in zip(rings, at, strict=True)])


def test_the_force_on_a_held_cylinder_on_the_sea_bed_is_exact():
    # R. C. MacCamy & R. A. Fuchs, Wave forces on piles, Beach Erosion Board Tech. Memo 69, 1954:
    # the scattered potential -sum e_m i^m J_m'(ka) / H_m'(ka) H_m(kr) cos m t, here given to the panels.
    from scipy.special import h1vp, hankel1, jvp

    radius, count, frequency, water = 5.0, 32, 1.3, Water(depth_m=10.0)
    k, orders = wave_number(frequency, water), np.arange(24)
    turn = 2 * np.pi * np.arange(count + 1) / count
    depths = np.linspace(0, -10.0, 9)
    # The polygon has the circle's area.
    corner = radius * np.sqrt(2 * np.pi / count / np.sin(2 * np.pi / count))
    plan = corner * np.stack([np.cos(turn), np.sin(turn)], axis=1)
    grid = np.concatenate(
        [np.repeat(plan[:, None], 9, axis=1), np.tile(depths[None, :, None], (count + 1, 1, 1))], axis=2
    )
    panels = of_patches([grid], np.array([0.0, 0.0, -5.0]))
    centres = capytaine_mesh(capytaine, panels, ()).faces_centers
    angle = np.arctan2(centres[:, 1], centres[:, 0])[:, None]
    share = np.where(orders == 0, 1, 2) * jvp(orders, k * radius) / h1vp(orders, k * radius)
    around = (-share * 1j**orders * hankel1(orders, k * radius) * np.cos(orders * angle)).sum(axis=1)
    potential = -1j * water.gravity_m_s2 / frequency * decay(k, centres[:, 2], water)[0] * around
    hull = WettedHull(panels, np.zeros(3))
    waves = first_order(
        [hull], water, frequency, np.zeros(1), np.zeros((1, 6, len(potential))), potential[None],
        np.zeros((1, 1, 6)),
    )  # fmt: skip
    # Its ring wave: H_m(kr) -> sqrt(2 / pi k r) exp(i (k r - m pi / 2 - pi / 4)).
    turn = 2 * np.pi * np.arange(ANGLES) / ANGLES
    ring = -np.sqrt(2 / (np.pi * k)) * np.exp(-0.25j * np.pi) * np.cos(np.outer(turn, orders)) @ share
    wanted = mean_drift(ring, 0, k, group_ratio(frequency, water), water)
    found = mean_force(waves, 0)[0]
    # 32 flat panels around: 1.3 %, 48: 0.6 %.
    assert found[0] == pytest.approx(wanted[0], rel=0.02)
    assert abs(found[1]) < 1e-3 * wanted[0]
    assert abs(found[5]) < 1e-3 * wanted[0] * radius


def test_the_flow_beside_a_hull_has_the_slopes_of_its_potential_and_meets_the_surface():
    hull = WettedHull(whole_hull(BARGE, 150), np.zeros(3))
    waves, _ = solved([hull], DEEP, 1.2, np.zeros(1), floating=False)
    flow = Flow(waves)
    points = np.array([[12.5, 3.0, -1.0], [4.0, 7.0, -0.6], [1.0, 2.0, -5.0], [13.0, 0.0, 0.0]])
    potential, velocity = (part[0] for part in flow.at(points))
    step = 0.2
    for axis in range(2):
        shift = step * np.eye(3)[axis]
        slope = (flow.at(points + shift)[0] - flow.at(points - shift)[0])[0] / (2 * step)
        # The steps of Capytaine's tables over the step, on a wave with velocities of 1.2 m/s.
        np.testing.assert_allclose(slope, velocity[:, axis], atol=0.04)
    assert abs(velocity[3, 2] - 1.2**2 / 9.80665 * potential[3]) < 0.01


@pytest.mark.parametrize("floating", [pytest.param(False, marks=pytest.mark.thorough), True])
def test_the_force_on_one_hull_is_that_of_the_far_field(floating):
    hull = WettedHull(whole_hull(BARGE, 320), np.zeros(3))
    waves, mesh = solved([hull], DEEP, 1.2, np.radians([0.0, 30.0]), floating)
    wanted, found = far(waves, mesh), mean_force(waves, 0)[:, [0, 1, 5]]
    scale = np.abs(wanted).max(axis=0)
    # Two integrals over the same panels: the difference is less than the error of either.
    np.testing.assert_allclose(found / scale, wanted / scale, atol=0.02)


@pytest.mark.parametrize(("shift", "heading", "gap"), CLUSTERS)
def test_the_forces_on_two_hulls_add_up_to_the_far_field_of_both(shift, heading, gap):
    panels = whole_hull(BARGE, 120)
    at = np.array([shift, 10.0 + gap, 0.0])
    hulls = [WettedHull(panels, np.zeros(3)), WettedHull(placed(panels, *at[:2], heading), at)]
    waves, mesh = solved(hulls, DEEP, 1.6, np.radians([0.0, 90.0]), floating=heading == 0)
    each = np.array([mean_force(waves, number) for number in (0, 1)])
    found, wanted = each.sum(axis=0)[:, [0, 1, 5]], far(waves, mesh)
    found[:, 2] += at[0] * each[1, :, 1] - at[1] * each[1, :, 0]
    scale = np.abs(wanted).max(axis=0)
    np.testing.assert_allclose(found / scale, wanted / scale, atol=0.02)
    # The hulls in beam waves: the one in front takes nearly everything.
    assert each[0, 1, 1] > 2 * abs(each[1, 1, 1])


@pytest.mark.thorough
def test_the_control_surface_may_be_near_or_far():
    hull = WettedHull(whole_hull(BARGE, 320), np.zeros(3))
    waves, _ = solved([hull], DEEP, 1.2, np.radians([30.0]), floating=True)
    near, wide = mean_force(waves, 0, 1.2, 0.9)[0], mean_force(waves, 0, 3.5, 1.5)[0]
    # Of the water's own scale, rho g L / 2 for forces and rho g L^2 / 2 for moments.
    scale = 0.5 * 1025 * 9.80665 * np.array([20, 20, 20, 400, 400, 400])
    np.testing.assert_allclose(near / scale, wide / scale, atol=0.005)


@pytest.mark.parametrize("floating", [False, True])
def test_the_pressure_on_a_hemisphere_points_to_its_centre(floating):
    # Held, it has no moment about its centre. Floating with its centre of gravity there it has no mean moment
    # about the centre at rest either, because displacement and force of the first order are in phase.
    hull = WettedHull(whole_hull("hemisphere:radius_m=5,depth_m=7", 320), np.zeros(3))
    waves, _ = solved([hull], DEEP, 1.2, np.zeros(1), floating)
    found = mean_force(waves, 0)[0]
    # 0.2 % of the water's scale, rho g R^3 / 2; 0.05 % with 900 panels.
    assert abs(found[4]) < 0.005 * 0.5 * 1025 * 9.80665 * 5**3
    assert abs(found[5]) < 1e-6 * found[0] * 5


def test_the_flare_of_a_sphere_vanishes_at_the_water_line():
    panels = whole_hull("hemisphere:radius_m=5,depth_m=7", 320)
    # A panel is 0.65 m high: its own flare is 0.065. The next term of the series of tan(z / R) remains.
    assert np.abs(waterline(panels).flare).max() < 0.005
    # A cone with its point down has the flare r / h all the way.
    radius = np.linspace(0.2, 1.0, 6)
    turn = 2 * np.pi * np.arange(13) / 12
    cone = np.stack(
        [np.outer(np.cos(turn), radius), np.outer(np.sin(turn), radius), np.tile(radius - 1, (13, 1))], 2
    )
    flare = waterline(of_patches([5 * cone], np.array([0.0, 0.0, -1.0]))).flare
    # The sides of the polygon are nearer to the axis than its corners.
    np.testing.assert_allclose(flare, np.cos(np.pi / 12), rtol=1e-6)


def turned(roll: float, pitch: float, yaw: float) -> np.ndarray:
    c, s = np.cos(yaw), np.sin(yaw)
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1.0]]) @ rotation(roll, pitch)


def test_the_submerged_moments_are_those_of_the_hull_cut_at_the_water():
    hull = closed(parse_shape("box:length_m=20,beam_m=10,draught_m=4,depth_m=8"), 2.0)
    hull = Surface(hull.vertices @ turned(0.1, 0.05, 0.5).T + [1.0, 2.0, 0.5], hull.triangles)
    reference = np.array([3.0, -1.0, 0.7])
    wet = hull.below()
    motion = np.array([0.4, -0.7, 0.5, 0.2, -0.1, 0.15])

    def cut(part: float) -> np.ndarray:
        turn = turned(*(part * motion[3:]))
        moved = (hull.vertices - reference) @ turn.T + reference + part * motion[:3]
        found = particulars(Surface(moved, hull.triangles).below())
        x, y, _ = found.centre_of_buoyancy_m - reference
        return found.volume_m3 * np.array([1.0, y, -x])

    floating = WettedHull(Panels(wet.vertices, wet.triangles[:, [0, 1, 2, 2]]), reference)
    step = 0.01
    # The mean of cos^2 is 1/2.
    wanted = (cut(step) + cut(-step) - 2 * cut(0)) / (4 * step**2)
    found = submerged_moments(floating, motion[None] + 0j)[0]
    # Terms of the fourth order: step^2 of the largest.
    np.testing.assert_allclose(found, wanted, atol=1e-3 * np.abs(wanted).max())


def test_the_control_surface_is_closed():
    panels = placed(whole_hull(BARGE, 150), 3.0, -2.0, 0.4)
    surface = control_surface(panels, 1.5, 1.0)
    shell, rim, plane = surface.shell, surface.rim, surface.water_plane
    np.testing.assert_allclose(shell.weights @ shell.normals, [0, 0, -23 * 13], atol=1e-3)
    np.testing.assert_allclose(rim.weights @ rim.normals, 0, atol=1e-9)
    assert rim.weights.sum() == pytest.approx(2 * (23 + 13), rel=1e-5)
    assert plane.weights.sum() == pytest.approx(23 * 13 - 200, rel=1e-5)
    # Int z n_z dS over the bottom, the volume inside.
    flux = (shell.at_m * shell.normals).sum(axis=1) @ shell.weights
    assert flux == pytest.approx(3 * 23 * 13 * 3.5, rel=1e-4)


def test_the_water_plane_around_a_moonpool_is_left_out():
    panels = whole_hull(BARGE, 150)
    pool = whole_hull("box:length_m=4,beam_m=3,draught_m=2,depth_m=5", 40)
    # The pool's sides, with the water inside.
    sides = pool.faces[pool.vertices[pool.faces][:, :, 2].max(axis=1) > -2 + 1e-6][:, ::-1]
    faces = np.concatenate([panels.faces, sides + len(panels.vertices)])
    hull = Panels(np.concatenate([panels.vertices, pool.vertices]), faces)
    points, _ = waterline(hull).points()
    assert (points.at_m * points.normals).sum(axis=1) @ points.weights == pytest.approx(2 * (200 - 12))
    assert control_surface(hull, 1.5, 1.0).water_plane is None


def test_outlines_and_their_distance():
    square = np.array([[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]])
    np.testing.assert_allclose(parallel(square, 1.0), square * 2 - 1)
    assert distance(square, square + np.array([5.0, 0.5])) == pytest.approx(3.0)
    assert distance(square, square + np.array([1.0, 1.0])) == 0.0
    np.testing.assert_allclose(np.ptp(outline(whole_hull(BARGE, 150)), axis=0), [20, 10], rtol=1e-4)
    points, _ = waterline(whole_hull(BARGE, 150)).points()
    assert (points.at_m * points.normals).sum(axis=1) @ points.weights == pytest.approx(2 * 200)
    at, weights = beyond(0.3)
    assert weights @ at**2 == pytest.approx(1 / 3)


def test_hulls_that_meet_are_refused():
    panels = whole_hull(BARGE, 150)
    hulls = [WettedHull(panels, np.zeros(3)), WettedHull(placed(panels, 0.0, 9.0), np.zeros(3))]
    count = 2 * len(panels.faces)
    waves = first_order(
        hulls, DEEP, 1.2, np.zeros(1), np.zeros((2, 6, count)), np.zeros((1, count)), np.zeros((1, 2, 6))
    )
    with pytest.raises(HydrodynamicsError, match="outlines meet in plan"):
        mean_force(waves, 0)
