"""Linear analysis: modes against textbooks and against runs, zero modes."""

from __future__ import annotations

import kingpost
import numpy as np
import pytest
from kingpost.cli import main
from kingpost.reports import modes as modes_report
from kingpost.results import unit_of
from samples import rod

G = 9.80665


def test_each_state_has_its_unit_and_a_mark_for_memory_states():
    """Source: docs/conventions.md: coordinates and their rates in m and rad; Cummins' memory of the water."""
    simulation = kingpost.Simulation("offshore_vessel_on_dp")
    linear = simulation.linearize()
    units = dict(zip(linear.states, linear.units, strict=True))
    assert (units["hull.x"], units["hull.yaw"], units["hull.x.rate"], units["hull.yaw.rate"]) == (
        "m",
        "rad",
        "m/s",
        "rad/s",
    )
    assert [units[name] for name in simulation.coordinates] == simulation.coordinate_units
    memory = {name for name, remembers in zip(linear.states, linear.remembers, strict=True) if remembers}
    assert memory == {name for name in linear.states if ".radiation." in name or ".slow." in name}
    assert 0 < len(memory) < len(linear.states)
    assert {units[name] for name in memory} == {"m", "rad"}
    assert {units[name] for name in linear.states if ".integral." in name} == {"N", "N m"}
    found = kingpost.modes("offshore_vessel_on_dp", waves=False)
    assert unit_of(found["shape"].sel(coordinate="hull.x")[0]) == "m"
    assert unit_of(found["shape"].sel(coordinate="hull.yaw")[0]) == "rad"


def test_a_pendulum_has_its_textbook_frequency(hang):
    """Source: w^2 = m g l / J, for a uniform rod 3 g / (2 L)."""
    mode = kingpost.modes(hang(rod(length=2.0))).sel(mode=1)
    assert mode.kind.item() == "oscillation"
    assert mode.named_after.item() == "swing"
    assert mode.angular_frequency.item() == pytest.approx(np.sqrt(3 * G / 4), rel=1e-14)
    assert mode.frequency.item() == pytest.approx(np.sqrt(3 * G / 4) / (2 * np.pi), rel=1e-14)
    assert mode.damping_ratio.item() == 0
    assert np.isnan(mode.time_constant.item())
    assert mode.sel(coordinate="swing")["shape"].item() == 1


def test_a_damped_pendulum_has_its_textbook_damping_ratio(hang):
    """Source: J x'' + c x' + k x = 0 with k = m g l: zeta = c / (2 sqrt(J k))."""
    inertia, stiffness, damping = 3 * 4 / 3, 3 * G, 1.5
    mode = kingpost.modes(hang(rod(damping=damping))).sel(mode=1)
    ratio = damping / (2 * np.sqrt(inertia * stiffness))
    frequency = np.sqrt(stiffness / inertia)
    assert mode.damping_ratio.item() == pytest.approx(ratio, rel=1e-13)
    assert mode.angular_frequency.item() == pytest.approx(frequency, rel=1e-13)
    assert mode.damped_period.item() == pytest.approx(2 * np.pi / frequency / np.sqrt(1 - ratio**2))
    assert mode.time_constant.item() == pytest.approx(2 * inertia / damping)


def test_an_overdamped_pendulum_has_two_time_constants(hang):
    """Source: the roots of J s^2 + c s + k."""
    inertia, stiffness, damping = 3 * 4 / 3, 3 * G, 60.0
    found = kingpost.modes(hang(rod(damping=damping)))
    assert found.kind.values.tolist() == ["decay", "decay"]
    roots = np.roots([inertia, damping, stiffness])
    assert np.sort(found.time_constant.values) == pytest.approx(np.sort(-1 / roots), rel=1e-12)
    assert np.isnan(found.damping_ratio.values).all()


def test_a_double_pendulum_has_its_textbook_modes(hang):
    """Source: two equal uniform rods, w^2 L / g = 3 -+ 6 / sqrt 7. In the absolute angles a, b the
    equations are 4/3 a'' + 1/2 b'' + 3/2 a = 0 and 1/2 a'' + 1/3 b'' + 1/2 b = 0, times g / L."""
    length = 1.5
    upper = rod("upper", "a", length)
    lower = rod("lower", "b", length, parent="upper", at=f"[0, 0, {-length / 2}]")
    found = kingpost.modes(hang(upper, lower))
    x = np.array([3 - 6 / np.sqrt(7), 3 + 6 / np.sqrt(7)])
    assert found.angular_frequency.values == pytest.approx(np.sqrt(x * G / length), rel=1e-13)
    # b / a from the first equation; the joint's coordinate is b - a.
    relative = (3 - 8 / 3 * x) / x - 1
    shape = found["shape"].values
    assert shape[:, 1] / shape[:, 0] == pytest.approx(relative, rel=1e-11)
    assert np.abs(shape).max(axis=1) == pytest.approx([1, 1])


def test_an_inverted_pendulum_has_an_unstable_mode(hang):
    """Source: x'' = (m g l / J) x."""
    scenario = hang(rod())
    standing = kingpost.Simulation(scenario)
    standing.set_state([np.pi], [0.0])
    found = kingpost.modes(scenario, state=standing.state)
    assert sorted(found.kind.values.tolist()) == ["decay", "unstable"]
    grows = found.isel(mode=found.kind.values.tolist().index("unstable"))
    assert grows.eigenvalue_real.item() == pytest.approx(np.sqrt(3 * G / 4), rel=1e-12)
    assert grows.time_constant.item() == pytest.approx(-1 / np.sqrt(3 * G / 4), rel=1e-12)
    number = grows.mode.item()
    assert f"unstable: mode {number} (swing) grows e-fold in 0.36873 s" in modes_report.text(found)


def test_zero_modes_of_a_free_ship_are_named_after_its_coordinates():
    """Source: without water and gravity nothing answers any motion: six of the ship, two of the crane.
    Each keeps a rate that it is given, so A has each zero eigenvalue twice."""
    found = kingpost.modes("paper", hold_centre=False, motor_1=False)
    names = ["ship.x", "ship.y", "ship.z", "ship.roll", "ship.pitch", "ship.yaw", "slew", "luff"]
    assert found.named_after.values.tolist() == names
    assert set(found.kind.values) == {"zero"}
    assert set(found.multiplicity.values) == {2}
    assert set(found.frequency.values) == {0}
    assert np.array_equal(found["shape"].values, np.eye(8))


def test_a_damped_free_motion_gives_a_zero_mode_and_a_decaying_mode():
    """Source: M* v' = -C v: the rates of decay are the eigenvalues of M*^-1 C."""
    scenario = kingpost.load("paper", hold_centre=False, motor_1=False, damping=True)
    found = kingpost.modes(scenario)
    law = scenario.resolved["forces"]["damping"]["viscous_damping"]
    damping = np.diag([*law["linear_N_s_m"], *law["angular_N_m_s"], 0, 0])
    mass = kingpost.Simulation(scenario).mass_matrix()
    rates = np.linalg.eigvals(np.linalg.solve(mass, damping)).real
    rates = np.sort(rates[rates > 1e-9])
    decays = found.isel(mode=found.kind.values == "decay")
    assert np.sort(1 / decays.time_constant.values) == pytest.approx(rates, rel=1e-10)
    zero = found.isel(mode=found.kind.values == "zero")
    assert zero.sizes["mode"] == 8
    damped = np.diag(damping) > 0
    assert dict(zip(zero.named_after.values, zero.multiplicity.values, strict=True)) == dict(
        zip(found.coordinate.values, np.where(damped, 1, 2), strict=True)
    )


PARALLELOGRAM = """\
version: 1
title: a swing
bodies:
  left:
    mass_kg: 2
    inertia: {tensor: {moments_kg_m2: [0.375, 0.375, 0]}}
    joint: {revolute: {axis: [0, 1, 0], child_position_m: [0, 0, 0.75], initial_angle_rad: 0.4,
                       damping_N_m_s: 1}}
  plank:
    parent: left
    mass_kg: 10
    shape: {box: {length_m: 3, width_m: 0.3, height_m: 0.1}}
    joint: {revolute: {axis: [0, 1, 0], position_m: [0, 0, -0.75], child_position_m: [-1.5, 0, 0],
                       initial_angle_rad: -0.4}}
  right:
    mass_kg: 2
    inertia: {tensor: {moments_kg_m2: [0.375, 0.375, 0]}}
    joint: {revolute: {axis: [0, 1, 0], position_m: [3, 0, 0], child_position_m: [0, 0, 0.75],
                       initial_angle_rad: 0.4}}
loops:
  pin:
    first: {body: plank, position_m: [1.5, 0, 0]}
    second: {body: right, position_m: [0, 0, -0.75]}
    constraints: [x, z]
forces:
  gravity: {gravity: {}}
"""


def test_a_closed_loop_has_the_modes_of_its_independent_coordinates(tmp_path):
    """Source: a plank on two equal rods stays level, so that with the angle a of the rods the kinetic
    energy is (2 m L^2/3 + M L^2) a'^2 / 2, the potential -(m + M) g L cos a, and heat c a'^2."""
    path = tmp_path / "swing.yaml"
    path.write_text(PARALLELOGRAM, encoding="utf-8")
    rest = kingpost.equilibrium(path)
    assert np.abs(rest.joint_position).max() < 1e-10
    assert rest.position.sel(body="plank").values == pytest.approx([1.5, 0, -1.5], abs=1e-10)
    found = kingpost.modes(path)
    inertia, stiffness = (2 * 2 / 3 + 10) * 1.5**2, (2 + 10) * G * 1.5
    assert found.sizes["mode"] == 1
    assert found.angular_frequency.item() == pytest.approx(np.sqrt(stiffness / inertia), rel=1e-10)
    assert found.damping_ratio.item() == pytest.approx(0.5 / np.sqrt(inertia * stiffness), rel=1e-10)
    assert found["shape"].values[0] == pytest.approx([1, -1, 1], abs=1e-10)


def test_a_lever_gives_a_zero_mode_of_its_cylinders_set_length(tmp_path):
    """Source: J x'' + c r^2 x' + k r^2 x = k r z and z' = 0: a boom of J on a cylinder with the lever r
    about the hinge; x = z / r is free. Without weight the geometry adds nothing."""
    text = """\
version: 1
title: a boom on a cylinder
bodies:
  boom: {mass_kg: 100, shape: {box: {length_m: 4, width_m: 0.5, height_m: 0.5}},
         joint: {revolute: {axis: [0, -1, 0], child_position_m: [-2, 0, 0]}}}
drives:
  luffing:
    cylinder:
      first: {body: world, position_m: [0, 0, -3]}
      second: {body: boom, position_m: [2, 0, 0]}
      shortest_m: 4.5
      longest_m: 5.6
      stiffness_N_per_m: 200000
      damping_N_s_per_m: 800
      push_limit_N: 3000
      pull_limit_N: 3000
      speed_limit_m_s: 0.1
      target: lever
"""
    path = tmp_path / "boom.yaml"
    path.write_text(text, encoding="utf-8")
    found = kingpost.modes(path)
    lever, inertia = 12 / 5, 100 * (16 + 0.25) / 12 + 400
    assert found.kind.values.tolist() == ["zero", "oscillation"]
    assert found.named_after.values.tolist() == ["luffing.wanted_length", "boom"]
    assert found.multiplicity.values.tolist() == [1, 2]
    zero, swing = (found.sel(mode=number) for number in (1, 2))
    assert zero["shape"].values == pytest.approx([1 / lever, 1], rel=1e-10)
    assert swing["shape"].values == pytest.approx([1, 0], abs=1e-10)
    assert swing.angular_frequency.item() == pytest.approx(lever * np.sqrt(2e5 / inertia), rel=1e-10)
    ratio = 800 * lever / (2 * np.sqrt(2e5 * inertia))
    assert swing.damping_ratio.item() == pytest.approx(ratio, rel=1e-10)
    linear = kingpost.Simulation(path).linearize()
    assert linear.coordinates == ["boom"]
    assert linear.B.sel(row="luffing.wanted_length", column="luffing").item() == 0.1


def test_two_tied_ships_share_their_zero_modes(tmp_path):
    """Source: counting: thirteen coordinates and four constraints leave nine that nothing moves."""
    text = """\
version: 1
title: two ships
bodies:
  one: {mass_kg: 3000, shape: {box: {length_m: 10, width_m: 4, height_m: 2}}, joint: {floating: {}}}
  arm:
    parent: one
    mass_kg: 200
    shape: {cylinder: {radius_m: 0.2, length_m: 4, axis: y}}
    joint: {revolute: {axis: [1, 0, 0], position_m: [1, 2, 1], child_position_m: [0, -2, 0]}}
  two:
    mass_kg: 5000
    shape: {box: {length_m: 12, width_m: 5, height_m: 3}}
    joint: {floating: {initial: {position_m: [0, 8, 0]}}}
loops:
  hook: {first: {body: arm, position_m: [0, 2, 0]}, second: {body: two, position_m: [1, -2, 1]},
         constraints: [x, y, z, yaw]}
"""
    path = tmp_path / "ships.yaml"
    path.write_text(text, encoding="utf-8")
    found = kingpost.modes(path)
    assert found.kind.values.tolist() == ["zero"] * 9
    assert set(found.multiplicity.values) == {2}
    shapes = found["shape"].values
    constraints = kingpost.Simulation(path).constraint_matrix()
    assert constraints.shape == (4, 13)
    assert np.abs(constraints @ shapes.T).max() < 1e-10
    assert np.linalg.matrix_rank(shapes) == 9
    assert len(set(found.named_after.values)) == 9


def test_the_heading_of_a_ship_is_the_only_zero_mode_under_gravity():
    """Source: symmetry about the vertical; the base hangs by its centre with the chain below it."""
    found = kingpost.modes("chain")
    zero = found.isel(mode=found.kind.values == "zero")
    assert zero.named_after.values.tolist() == ["base.yaw"]
    assert found.sizes["mode"] == 13
    assert int(found.multiplicity.sum()) == 26


@pytest.mark.parametrize("number", [1, 2, 5, 8])
def test_a_run_released_along_a_mode_keeps_its_frequency_and_damping(number):
    """Source: the linear motion exp(s t) (shape cos w t - shape_imaginary sin w t); the pendulum's
    forces differ from linear ones by the cube of the angle, here 1e-4 rad."""
    scenario = kingpost.load("chain", {"simulation.duration_s": 6}, hold_rotation=True, damping=40)
    mode = kingpost.modes(scenario).sel(mode=number)
    shape = mode["shape"].values + 1j * mode["shape_imaginary"].values
    eigenvalue = complex(mode.eigenvalue_real.item(), mode.eigenvalue_imaginary.item())
    amplitude = 1e-4
    simulation = kingpost.Simulation(scenario)
    simulation.settle()
    rest = simulation.state
    q, v = rest.q.copy(), rest.v.copy()
    q[-10:] += amplitude * shape.real
    v[-10:] = amplitude * (eigenvalue * shape).real
    simulation.set_state(q, v)
    run = simulation.run()
    angles = run.joint_position.values - rest.q[-10:]
    linear = amplitude * (np.exp(eigenvalue * run.time.values)[:, None] * shape).real
    assert np.abs(angles - linear).max() < 1e-6 * amplitude
    # A decaying oscillation obeys x[k+1] = 2 e^(s h) cos(w h) x[k] - e^(2 s h) x[k-1].
    x = angles[:, np.argmax(np.abs(shape))]
    middle, square = np.linalg.lstsq(np.stack([x[1:-1], x[:-2]], 1), x[2:])[0]
    fitted = np.roots([1, -middle, -square]).astype(complex)
    rate = np.log(fitted[np.argmax(fitted.imag)]) / (run.time.values[1] - run.time.values[0])
    assert rate.imag / (2 * np.pi) == pytest.approx(1 / mode.damped_period.item(), rel=1e-6)
    assert -rate.real / abs(rate) == pytest.approx(mode.damping_ratio.item(), rel=1e-4)


HELD = """\
version: 1
title: A barge on a soft hold
simulation: {step_s: 0.05, duration_s: 1, begin_at_equilibrium: true}
sea: {}
parts:
  vessel: {part: crane_barge_hull, prefix: "", parameters: {bodies.hull.mass_t: 7380}}
forces:
  gravity: {gravity: {}}
  hold: {soft_hold: {body: hull, target: {x_m: 5, y_m: 0, heading_deg: 0}}}
"""
WITH_A_LOAD = """\
  tie:
    rope:
      path: [{point: {body: hull, position_m: [1.3, 0, 30]}}, {point: {body: lift}}]
      unstretched_length_m: 12.4
      axial_stiffness_kN: 100
      damping_time_s: 0.01
bodies:
  lift:
    mass_kg: 1
    joint: {floating: {initial: {position_m: [0, 0, 20]}}}
    inertia: {radii_of_gyration: {radii_m: [1, 1, 1]}}
"""


def test_a_light_load_on_a_rope_changes_no_mode_of_the_barge_that_carries_it(tmp_path):
    """A soft hold has a damping of a fifth; 1 kg in 7,380 t changes a mode by its share, 1e-7, and by more
    where the swing of 7 s is near."""
    found = []
    for text in (HELD, HELD + WITH_A_LOAD):
        path = tmp_path / "held.yaml"
        path.write_text(text, encoding="utf-8")
        modes = kingpost.modes(path)
        named = np.char.startswith(modes.named_after.values.astype(str), "hull.")
        modes = modes.isel(mode=named & (modes.memory_share.values < 0.5))
        found.append(modes.eigenvalue_real.values + 1j * modes.eigenvalue_imaginary.values)
    bare, loaded = found
    assert len(bare) == len(loaded) == 6
    np.testing.assert_allclose(loaded, bare, rtol=1e-5)
    np.testing.assert_allclose(-bare[:3].real / np.abs(bare[:3]), 0.2, rtol=0.01)


def test_linearize_names_its_states_and_inputs(hang):
    """Source: A = [0 1; -k/J -c/J]; B = 1/J for the lever of a motor of 1 N m."""
    scenario = hang(rod(damping=0.4))
    simulation = kingpost.Simulation(scenario)
    simulation.settle()
    linear = simulation.linearize()
    assert linear.states == ["swing", "swing.rate"]
    assert linear.coordinates == ["swing"]
    assert linear.inputs == []
    assert linear.A.values == pytest.approx(np.array([[0, 1], [-3 * G / 4, -0.1]]), abs=1e-14)
    assert linear.B.shape == (2, 0)
    assert np.abs(linear.rates).max() < 1e-9
    assert linear.A.sel(row="swing.rate", column="swing").item() == pytest.approx(-3 * G / 4)


def test_an_equilibrium_is_a_row_of_results(hang):
    """Source: statics: the hinge carries the weight."""
    rest = kingpost.equilibrium(hang(rod(mass=3)))
    assert rest.joint_position.sel(coordinate="swing").item() == pytest.approx(0, abs=1e-12)
    reaction = rest.joint_reaction.sel(joint="swing").values
    assert np.abs(reaction).max() == pytest.approx(3 * G)
    assert rest.attrs["status"].startswith("at rest after")
    assert "time" not in rest.dims


def test_a_falling_body_has_no_modes(capsys):
    """Source: a body without support; the message says what accelerates."""
    with pytest.raises(kingpost.KingpostError, match=r"no equilibrium .*ship\.z still accelerates"):
        kingpost.modes("paper", gravity=True, hold_centre=False, motor_1=False)
    command = ["modes", "paper", "--set=gravity=on", "--set=hold_centre=off"]
    assert main(command) == 2
    assert capsys.readouterr().err.count("\n") == 1


def test_modes_warn_where_a_prescribed_coordinate_accelerates_and_nowhere_else():
    """Source: flexible_boom's post slews from the start by a ramp; the chain has no prescribed joint."""
    found = kingpost.modes("flexible_boom")
    assert found.attrs["warning"].startswith("slew moves or accelerates as prescribed at 0 s")
    assert modes_report.text(found).endswith(f"warning: {found.attrs['warning']}")
    simulation = kingpost.Simulation("flexible_boom")
    assert simulation.linearize().warning == found.attrs["warning"]
    assert kingpost.Simulation(kingpost.load("flexible_boom", slew_rate_rad_s=0)).linearize().warning is None
    assert "warning" not in kingpost.modes("chain").attrs
    swept = kingpost.modes("flexible_boom", sweep={"slew_rate_rad_s": [0.0, 0.1]})
    assert swept.attrs["warning"] == found.attrs["warning"]
