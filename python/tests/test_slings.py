"""Slings and spreader bars of the gallery's parts at rest, compared with statics."""

from __future__ import annotations

import kingpost
import numpy as np
import pytest
import xarray
from sling_statics import G, leg_tensions

LEGS = ["leg_forward_port", "leg_forward_starboard", "leg_aft_starboard", "leg_aft_port"]
PADEYES = [(4, 3, 2.5), (4, -3, 2.5), (-4, -3, 2.5), (-4, 3, 2.5)]
EA = 3.63e8
SLINGS = ["sling_forward_port", "sling_forward_starboard", "sling_aft_starboard", "sling_aft_port"]
REST = 1e-6
"""Of a tension: what accelerations below the solver's leave of forces, and the two programs' rounding."""


def hung(part: str, block_z: float, top: float, **parameters: float) -> xarray.Dataset:
    """A part of the gallery at rest on a rope from the world."""
    text = f"""
version: 1
title: A part on a rope
simulation: {{step_s: 0.005, duration_s: 1}}
parts:
  rigging:
    part: {part}
    prefix: ""
    parameters: {{bodies.hook_block.joint.floating.initial.position_m.2: {block_z}}}
forces:
  gravity: {{gravity: {{}}}}
  hoist:
    rope:
      path:
        - point: {{body: world, position_m: [0, 0, 40]}}
        - point: {{body: hook_block, position_m: [0, 0, {top}]}}
      axial_stiffness_kN: 1.0e5
"""
    return kingpost.equilibrium(kingpost.Scenario(text, "hung.yaml", tuple(parameters.items())))


def even_tension(
    legs: int, weight: float, unstretched: float, across: float, axial_stiffness: float
) -> tuple[float, float]:
    """Tension, N, and length, m, of n legs that share a weight: n T sqrt(1 - (a / l)^2) = W with
    T = EA (l / L - 1), their padeyes a off the plumb line."""
    low, high = unstretched, 1.1 * unstretched
    for _ in range(60):
        length = (low + high) / 2
        lifts = legs * axial_stiffness * (length / unstretched - 1) * np.sqrt(1 - (across / length) ** 2)
        low, high = (length, high) if lifts < weight else (low, length)
    return axial_stiffness * (low / unstretched - 1), low


def on_four_legs(**parameters: float) -> np.ndarray:
    """Tensions of the four legs, N."""
    return hung("four_leg_sling", 14.68, 1, **parameters).rope_tension.sel(rope=LEGS).values


def test_equal_legs_carry_a_quarter_of_the_weight_over_the_sine_of_their_angle() -> None:
    """Source: n T sin = W, the padeyes 5 m from the plumb line; beside it the angle of the legs without load,
    60 degrees: the strain of 1e-3 changes the sine by a third of that."""
    weight = 120e3 * G
    found = on_four_legs()
    np.testing.assert_allclose(found, even_tension(4, weight, 10, 5, EA)[0], rtol=REST)
    np.testing.assert_allclose(found, weight / 4 / np.sin(np.radians(60)), rtol=5e-4)


@pytest.mark.parametrize("length", [9.98, 10.015, 9.95])
def test_a_leg_of_another_length_shifts_load_from_one_diagonal_to_the_other(length: float) -> None:
    """Source: the stiffness matrix of four springs under a rigid load; 50 mm leave two legs slack."""
    expected = leg_tensions(PADEYES, [length, 10, 10, 10], EA, 120e3, below_m=11.2)
    found = on_four_legs(leg_forward_port_m=length)
    np.testing.assert_allclose(found, expected, rtol=REST, atol=REST * expected.max())
    slack = np.count_nonzero(found < 1e-3 * found.max())
    assert slack == (2 if length == 9.95 else 0)


def test_a_short_leg_costs_a_quarter_of_its_stiffness_times_the_missing_length() -> None:
    """Source: of four springs on a rigid load one self-stress, plus and minus along the diagonals, is left:
    a leg that lacks d stretches all by d / 4. Beyond first order: the strain of 1e-3 and d / L of 1e-3."""
    shift = (on_four_legs(leg_forward_port_m=9.99) - on_four_legs()) * [1, -1, 1, -1]
    np.testing.assert_allclose(shift, EA / 10 * 0.01 / 4, rtol=5e-3)


@pytest.mark.parametrize(("x", "y", "block_z"), [(1.0, 0.0, 14.17), (0.0, 0.8, 13.95), (-0.9, 0.6, 14.0)])
def test_a_centre_of_gravity_off_the_middle_tilts_the_load_until_it_is_under_the_hook(x, y, block_z) -> None:
    """Source: the stiffness matrix, from the load level; the engine's load hangs under its hook. It begins
    where the legs nearest to the hook come taut: on two legs alone it has another rest."""
    rest = hung("four_leg_sling", block_z, 1, centre_of_gravity_x_m=x, centre_of_gravity_y_m=y)
    expected = leg_tensions(PADEYES, [10] * 4, EA, 120e3, (x, y, 0), below_m=11.2)
    np.testing.assert_allclose(rest.rope_tension.sel(rope=LEGS), expected, rtol=REST)
    apart = rest.position.sel(body="module") - rest.position.sel(body="hook_block")
    np.testing.assert_allclose(apart.sel(axis=["x", "y"]), 0, atol=1e-6)


def test_the_factor_of_a_leg_at_rest_is_its_tension_over_an_even_share() -> None:
    """Source: the weight over four times the sine of 60 degrees; the share in the file has six digits."""
    rest = hung("four_leg_sling", 14.68, 1, leg_forward_port_m=9.98)
    even = 120e3 * G / 4 / np.sin(np.radians(60))
    factor = rest.rope_daf.sel(rope_with_rope_daf=LEGS).values
    np.testing.assert_allclose(factor, rest.rope_tension.sel(rope=LEGS) / even, rtol=1e-5)


def two_legs(first_m: float, second_m: float, centre_x: float, hook: np.ndarray) -> np.ndarray:
    """Tensions of two legs that do not stretch, from one point to a beam with padeyes 2 m to both sides.

    It is put level, the point where `hook` says in its x and z.
    """
    text = f"""
version: 1
title: A beam on two legs
simulation: {{step_s: 0.005, duration_s: 1}}
bodies:
  beam:
    mass_t: 5
    centre_of_mass_m: [{centre_x}, 0, -0.5]
    shape: {{box: {{length_m: 6, width_m: 1, height_m: 1}}}}
    joint: {{floating: {{initial: {{position_m: [{centre_x - hook[0]}, 0, {-0.5 - hook[1]}]}}}}}}
forces:
  gravity: {{gravity: {{}}}}
  first:
    rope:
      path: [{{point: {{body: world}}}}, {{point: {{body: beam, position_m: [-2, 0, 0]}}}}]
      unstretched_length_m: {first_m}
  second:
    rope:
      path: [{{point: {{body: world}}}}, {{point: {{body: beam, position_m: [2, 0, 0]}}}}]
      unstretched_length_m: {second_m}
"""
    return kingpost.equilibrium(kingpost.Scenario(text, "beam.yaml")).rope_tension.values


@pytest.mark.parametrize(("first", "second", "centre"), [(2.5, 2.5, 0.0), (2.5, 3.0, 0.0), (2.6, 2.4, 0.5)])
def test_two_legs_share_the_weight_by_lamis_theorem(first, second, centre) -> None:
    """Source: the triangle of legs and beam, the centre of gravity under the hook, T1 / sin b2 = T2 / sin b1
    = W / sin (b1 + b2)."""
    along = (first**2 - second**2) / 8
    hook = np.array([along, np.sqrt(first**2 - (2 + along) ** 2)])
    down = np.array([centre, -0.5]) - hook
    angles = []
    for end in (-2, 2):
        leg = np.array([end, 0]) - hook
        angles.append(np.arccos(leg @ down / np.linalg.norm(leg) / np.linalg.norm(down)))
    weight = 5e3 * G / np.sin(sum(angles))
    expected = [weight * np.sin(angles[1]), weight * np.sin(angles[0])]
    np.testing.assert_allclose(two_legs(first, second, centre, hook), expected, rtol=REST)


def test_a_spreader_bar_takes_the_thrust_of_its_legs() -> None:
    """Source: 2 T sin = weight of load and bar, the lugs 6 m from the plumb line: the bar takes T cos. Its
    middle is bent by the weight of a half, 3 m out, and the thrust, 0.3 m above the axis."""
    rest = hung("spreader_bar", 17.64, 0.8)
    half = 2e3 * G
    tension, length = even_tension(2, 34e3 * G, 12, 6, 1.22e8)
    thrust = tension * 6 / length
    np.testing.assert_allclose(rest.rope_tension.sel(rope=["leg_forward", "leg_aft"]), tension, rtol=REST)
    reaction = rest.joint_reaction.sel(joint="bar_middle")
    # On the aft half, whose x points to the middle: the forward half pushes it aft.
    np.testing.assert_allclose(reaction.sel(component="force_x"), -thrust, rtol=REST)
    np.testing.assert_allclose(reaction.sel(component="force_y"), 0, atol=REST * thrust)
    np.testing.assert_allclose(reaction.sel(component="force_z"), 0, atol=REST * thrust)
    bends = float(reaction.sel(component="moment_y"))
    np.testing.assert_allclose(abs(bends), 3 * half + 0.3 * thrust, rtol=REST)


def test_slings_under_a_spreader_bar_carry_a_quarter_over_the_sine() -> None:
    """Source: 4 T sin = W, the padeyes 2.4 m beside the bar."""
    found = hung("spreader_bar", 17.64, 0.8).rope_tension.sel(rope=SLINGS).values
    np.testing.assert_allclose(found, even_tension(4, 30e3 * G, 4, 2.4, 6.4e7)[0], rtol=REST)


def test_a_short_sling_under_a_spreader_bar_tilts_the_load_and_a_short_leg_of_four_takes_more_load() -> None:
    """Source: six slings and a bar are statically determinate: their tensions follow from places alone,
    whatever gives way. 20 mm turn them by some 20 mm in 2.4 m. Four legs from one point are not."""
    under_a_bar = hung("spreader_bar", 17.64, 0.8, sling_forward_port_m=3.98).rope_tension
    even = hung("spreader_bar", 17.64, 0.8).rope_tension
    np.testing.assert_allclose(under_a_bar.sel(rope=SLINGS), even.sel(rope=SLINGS), rtol=0.01)
    legs = on_four_legs(leg_forward_port_m=9.98) / on_four_legs()
    assert legs[0] > 1.4
    assert legs[1] < 0.6


def test_a_sling_part_with_a_free_load_must_be_mounted_on_the_world() -> None:
    """Source: what moves freely hangs on no ship; the answer names the place of the mounting."""
    text = """
version: 1
title: A sling on a ship
simulation: {step_s: 0.01, duration_s: 1}
bodies:
  ship: {mass_t: 500, shape: {box: {length_m: 30, width_m: 10, height_m: 4}}, joint: {floating: {}}}
parts: {rigging: {part: four_leg_sling, on: ship}}
"""
    with pytest.raises(kingpost.ScenarioError, match=r"parts\.rigging\.on: found ship"):
        kingpost.Scenario(text, "ship.yaml")


def test_the_leg_tensions_of_the_gallerys_lift_agree_with_statics() -> None:
    """Source: the stiffness matrix. In still water, while the winch hoists evenly from 40 to 54 s, what is
    left of the lift-off moves the mean by some 1e-4 of a leg's tension."""
    calm = {"simulation.duration_s": 54, "waves": False}
    legs = kingpost.run("four_leg_lift", calm).rope_tension.sel(rope=LEGS, time=slice(40, 54))
    expected = leg_tensions(PADEYES, [9.98, 10, 10, 10], EA, 120e3, below_m=11.2)
    np.testing.assert_allclose(legs.mean("time"), expected, rtol=2e-3)
