"""A simulation stepped by hand: states, snapshots, matrices and their identities."""

from __future__ import annotations

import kingpost
import numpy as np
import pytest
from kingpost import Simulation, load


@pytest.fixture
def moving() -> Simulation:
    """The paper's crane ship, centre free, load on, both motors on, in the middle of its motion."""
    scenario = load("paper", motor_1=True, motor_2=True, load=True, hold_centre=False, damping=True)
    simulation = Simulation(scenario)
    simulation.step(700)
    return simulation


def test_free_coordinates_are_those_of_the_paper():
    """Source: the paper's list of generalized velocities, 8 entries; 5 with the centre held."""
    free = Simulation(load("paper", hold_centre=False)).coordinates
    assert free == ["ship.x", "ship.y", "ship.z", "ship.roll", "ship.pitch", "ship.yaw", "slew", "luff"]
    assert Simulation("paper").coordinates == free[3:]


def test_kinetic_energy_is_half_v_m_v(moving):
    """Source: K = 1/2 q'^T M* q' (paper eqs. 45, 49, 60a)."""
    v = moving.state.v
    channel = next(c for c in moving.channels if c["variable"] == "kinetic_energy")
    assert 0.5 * v @ moving.mass_matrix() @ v == pytest.approx(moving.row()[channel["offset"]], rel=1e-13)


def test_mass_matrix_is_symmetric_and_positive(moving):
    """Source: M* = B^T M B with M positive (paper eq. 60a)."""
    matrix = moving.mass_matrix()
    assert np.allclose(matrix, matrix.T, rtol=1e-13, atol=1e-9)
    assert np.linalg.eigvalsh(matrix).min() > 0


def test_the_equation_of_motion_holds(moving):
    """Source: M* q'' + N* q' = F* (paper eq. 61), matrices of one form, q'' of the other."""
    matrices = moving.moving_frame()
    velocity = matrices["q_dot"].values.ravel()
    left = matrices["M_star"].values @ moving.acceleration() + matrices["N_star"].values @ velocity
    right = matrices["F_star"].values.ravel()
    assert left == pytest.approx(right, abs=1e-9 * np.abs(matrices["M_star"]).max().item())


def test_both_forms_give_one_mass_matrix_and_bias_force(moving):
    """Source: the recursive form against the paper's blocks."""
    matrices = moving.moving_frame()
    mass = matrices["M_star"].values
    assert moving.mass_matrix() == pytest.approx(mass, abs=1e-10 * np.abs(mass).max())
    bias = matrices["N_star"].values @ matrices["q_dot"].values.ravel()
    assert moving.bias_force() == pytest.approx(bias, abs=1e-10 * np.abs(bias).max())


def test_cartesian_rates_are_b_times_the_generalized_velocity(moving):
    """Source: X' = B q' (paper eq. 45); matrices carry labels of bodies and coordinates."""
    matrices = moving.moving_frame()
    b, rates = matrices["B"], matrices["X_dot"]
    assert b.values @ moving.state.v == pytest.approx(rates.values.ravel(), abs=1e-10)
    assert list(b["column"].values) == moving.coordinates
    assert b.sel(row="arm.omega_y", column="luff").item() == pytest.approx(1)


def test_frame_connection_matrices_chain(moving):
    """Source: E(arm) = E(tower) E(arm/tower) (paper eq. 26), and R of E is R."""
    matrices = {name: matrix.values for name, matrix in moving.moving_frame().items()}
    assert matrices["E_arm"] == pytest.approx(matrices["E_tower"] @ matrices["E_arm/tower"], abs=1e-12)
    assert np.array_equal(matrices["E_arm"][:3, :3], matrices["R_arm"])


def test_every_matrix_has_a_unit_and_labels(moving):
    """Source: the public contract."""
    names = set(moving.moving_frame())
    assert names >= {"B", "B_dot", "X_dot", "M", "D", "F", "M_star", "N_star", "F_star", "Omega_arm"}
    for name, matrix in moving.moving_frame().items():
        assert matrix.attrs["units"], name
        assert matrix.shape == (matrix.sizes["row"], matrix.sizes["column"])


def test_a_force_per_coordinate_adds_to_the_loads(moving):
    """Source: M* (q''(tau) - q''(0)) = tau, linear in the applied force."""
    tau = np.arange(1.0, 9.0) * 1000
    difference = moving.acceleration(tau) - moving.acceleration()
    assert moving.mass_matrix() @ difference == pytest.approx(tau, rel=1e-8)
    with pytest.raises(kingpost.KingpostError, match="8"):
        moving.acceleration([1.0, 2.0])


def test_a_snapshot_resumes_to_the_same_bits(moving):
    """Source: bitwise equality, also in another simulation of the same scenario."""
    snapshot = moving.snapshot()
    moving.step(137)
    expected = moving.row()
    moving.restore(snapshot)
    moving.step(137)
    assert np.array_equal(moving.row(), expected)
    other = Simulation(moving.scenario)
    other.restore(snapshot)
    other.step(137)
    assert np.array_equal(other.row(), expected)


def test_a_broken_snapshot_is_refused_and_changes_nothing(moving):
    """Source: the public contract: one base exception."""
    before = moving.row()
    for broken in (b"", b"not a snapshot", moving.snapshot()[:-3]):
        with pytest.raises(kingpost.KingpostError):
            moving.restore(broken)
    assert np.array_equal(moving.row(), before)


def test_a_set_state_reads_back_equal(moving):
    """Source: the round trip; accelerations depend on q and v alone."""
    state, acceleration = moving.state, moving.acceleration()
    other = Simulation(moving.scenario)
    other.step(700)  # the same instant, so that drives and their torques are the same
    other.set_state(state.q, state.v)
    assert other.state.q == pytest.approx(state.q, abs=1e-15)
    assert np.array_equal(other.state.v, state.v)
    assert other.acceleration() == pytest.approx(acceleration, rel=1e-12)


@pytest.mark.parametrize("size", [0, 3, 100])
def test_a_state_of_the_wrong_size_is_refused(moving, size):
    """Source: the public contract: one base exception, sizes in the message."""
    with pytest.raises(kingpost.KingpostError):
        moving.set_state(np.zeros(size), moving.state.v)


def test_a_state_that_is_not_finite_is_refused(moving):
    """Source: the public contract: one base exception."""
    with pytest.raises(kingpost.KingpostError):
        moving.set_state(moving.state.q, moving.state.v * np.nan)


def test_reset_goes_back_to_the_start(moving):
    """Source: bitwise equality with a simulation that never moved."""
    moving.reset()
    assert moving.time_s == 0
    assert np.array_equal(moving.row(), Simulation(moving.scenario).row())


def test_reset_takes_a_seed():
    """Source: the seed stands in the resolved scenario and so in the results."""
    simulation = Simulation(load("paper", {"simulation.duration_s": 0.01}))
    simulation.reset(seed=7)
    assert simulation.run().attrs["seed"] == 7


def test_poses_are_the_recorded_positions_and_orientations(moving):
    """Source: two ways to one number."""
    poses, row = moving.poses(), moving.row()
    channel = next(c for c in moving.channels if c["variable"] == "position")
    positions = row[channel["offset"] :][: channel["len"]].reshape(-1, 3)
    assert np.array_equal(poses[:, :3], positions)
    assert np.linalg.norm(poses[:, 3:], axis=1) == pytest.approx(1.0)


def test_a_parameter_that_is_not_live_is_refused_during_a_run():
    """Source: the contract; crates/kingpost/tests/schemes/live_parameters.rs has what live ones do."""
    simulation = Simulation("paper")
    simulation.step(5)
    with pytest.raises(
        kingpost.KingpostError,
        match=r"crane_x_m: takes effect at the start.*: motor_1, .*, simulation.integrator",
    ):
        simulation.set_parameter("crane_x_m", 0)
    assert simulation.time_s == pytest.approx(0.005)
    assert simulation.scenario.model["parameters"][6]["value"] == -10


def test_a_lever_is_an_input_that_drives_its_motor(small):
    """Source: half the lever is half the torque, so half the acceleration from rest."""
    scenario = load(small, {"drives.motor.motor.history": "lever"})
    simulation = Simulation(scenario)
    (lever,) = simulation.inputs.values()
    assert (lever.name, lever.lower, lever.upper, lever.value) == ("motor", -1, 1, 0)
    simulation.set_input("motor", 1)
    full = simulation.acceleration()
    simulation.set_input("motor", 0.5)
    assert simulation.acceleration() == pytest.approx(0.5 * full, rel=1e-12)
    assert simulation.inputs["motor"].value == 0.5
    with pytest.raises(kingpost.KingpostError, match="no_such"):
        simulation.set_input("no_such", 0)


def test_an_input_that_a_controller_sets_names_its_signal() -> None:
    simulation = kingpost.Simulation("slew_without_swing")
    free = [name for name, one in simulation.inputs.items() if one.signal is None]
    assert free == ["swing_feedback.luffing.target_offset"]
    for name, one in simulation.inputs.items():
        if one.signal is not None:
            with pytest.raises(kingpost.KingpostError, match=f"because it is connected to {one.signal}"):
                simulation.set_input(name, 0.0)


def test_a_run_continues_from_the_present_state():
    """Source: the public contract of `Simulation.run`: records from now to the end."""
    simulation = Simulation(load("paper", {"simulation.duration_s": 0.1}))
    simulation.step(50)
    times = simulation.run()["time"].values
    assert times[0] == pytest.approx(0.05)
    assert times[-1] == pytest.approx(0.1)


def test_a_run_reports_its_progress_and_an_exception_there_ends_it():
    """Source: the public contract of `Simulation.run`."""
    seen: list[float] = []
    Simulation(load("paper", {"simulation.duration_s": 0.1})).run(seen.append)
    assert seen == sorted(seen)
    assert 0 < seen[-1] <= 0.1 + 1e-9

    def stop(_time_s: float) -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        Simulation("paper").run(stop)
