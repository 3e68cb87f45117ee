//! Liquid in a box with any orientation: closed forms, gradient of the energy, derivatives, lanes.

use crate::common::hulls;

use hulls::{barge, near};
use kingpost::scalar::{Dual, Lanes, Scalar};
use kingpost::sea::hull::{BoxTank, FloatingPosition, HullTank, WettedHull};
use kingpost::spatial::{Matrix3, Vector3, exp};
use proptest::prelude::*;

const EDGES: [f64; 3] = [4.0, 6.0, 2.0];

fn tank(filling: f64) -> BoxTank {
    BoxTank { edges: Vector3(EDGES), filling }
}

fn whole() -> f64 {
    EDGES.iter().product()
}

fn all_near(found: Vector3, expected: [f64; 3], allowed: f64) {
    for (found, expected) in found.0.into_iter().zip(expected) {
        near(found, expected, allowed);
    }
}

/// Wall-sided box: the wedge moves sideways by `I tan / V`, and up by half of that times tan (Barrass &
/// Derrett, *Ship Stability for Masters and Mates*, ch. on free surface).
#[test]
fn until_its_surface_meets_top_or_bottom_the_liquid_moves_as_between_upright_walls() {
    let [along, across] = [EDGES[1] * EDGES[0].powi(3) / 12.0, EDGES[0] * EDGES[1].powi(3) / 12.0];
    for (tan_x, tan_y) in [(0.1, 0.2), (-0.3, 0.0), (0.0, -0.3), (1e-8, 0.3), (0.2, -0.19)] {
        let vertical = Vector3::new(tan_x, tan_y, 1.0).direction();
        let rise = 0.5 * (along * tan_x * tan_x + across * tan_y * tan_y);
        all_near(tank(0.5).shift(vertical), [-along * tan_x, -across * tan_y, rise], 1e-13 * whole());
    }
}

/// On its side, the liquid is a box against that side, over the full extent in the other directions.
#[test]
fn on_its_side_and_upside_down_the_liquid_has_the_position_of_a_hand_calculation() {
    for filling in [0.1, 0.5, 0.8] {
        let (volume, air) = (filling * whole(), 1.0 - filling);
        let [length, breadth, height] = EDGES;
        let raised = 0.5 * air * height;
        for sign in [1.0, -1.0] {
            let on_side = tank(filling).shift(Vector3::new(0.0, sign, 0.0));
            all_near(on_side, [0.0, -sign * volume * 0.5 * air * breadth, volume * raised], 1e-13 * whole());
            let on_end = tank(filling).shift(Vector3::new(sign, 0.0, 0.0));
            all_near(on_end, [-sign * volume * 0.5 * air * length, 0.0, volume * raised], 1e-13 * whole());
        }
        let upside_down = tank(filling).shift(Vector3::new(0.0, 0.0, -1.0));
        all_near(upside_down, [0.0, 0.0, volume * 2.0 * raised], 1e-13 * whole());
    }
}

/// In the corner of a cube with its diagonal upright a tetrahedron of volume a^3 / 6, its centre a / 4 from each
/// of three walls; along an edge that lies, a prism of a^2 / 2 with its centre a / 3 from two.
#[test]
fn in_a_corner_and_along_an_edge_the_liquid_is_a_tetrahedron_and_a_prism() {
    let cube = |filling: f64| BoxTank { edges: Vector3::new(1.0, 1.0, 1.0), filling };
    let upright = |filling: f64| 0.5 * (filling - 1.0);
    for a in [1e-4, 0.1, 0.9] {
        let volume = a * a * a / 6.0;
        let [level, raised] = [0.25 * a - 0.5, 0.25 * a - 0.5 - upright(volume)];
        let moved = cube(volume).shift(Vector3::new(1.0, 1.0, 1.0).direction());
        all_near(moved, [volume * level, volume * level, volume * raised], 1e-15);
        // The same of the air, upside down: its first moment is minus that of the liquid.
        let moved = cube(1.0 - volume).shift(Vector3::new(-1.0, -1.0, -1.0).direction());
        let full = (1.0 - volume) * upright(1.0 - volume);
        all_near(moved, [-volume * level, -volume * level, -volume * level - full], 1e-15);
        let prism = 0.5 * a * a;
        let level = a / 3.0 - 0.5;
        let moved = cube(prism).shift(Vector3::new(0.0, 1.0, 1.0).direction());
        all_near(moved, [0.0, prism * level, prism * (level - upright(prism))], 1e-15);
    }
}

#[test]
fn an_empty_and_a_full_tank_have_no_free_surface() {
    for filling in [0.0, 1.0] {
        for vertical in [Vector3::new(0.0, 0.0, 1.0), Vector3::new(0.3, -0.4, 0.2), Vector3::new(-1.0, 1.0, -1.0)] {
            let vertical = vertical.direction();
            assert_eq!(tank(filling).shift(vertical), Vector3::zero());
            assert_eq!(tank(filling).second_moment(vertical, vertical, vertical), 0.0);
        }
    }
}

#[test]
fn nan_stays_nan_and_the_search_ends() {
    assert!(tank(0.5).shift(Vector3::new(f64::NAN, 0.0, 1.0)).norm().is_nan());
}

/// `i = l (b / cos)^3 / 12` if the heeled surface is between walls; along the ship `b / cos l^3 / 12`.
#[test]
fn the_second_moments_of_a_heeled_surface_are_those_of_its_rectangle() {
    let heel = 0.3_f64;
    let vertical = FloatingPosition::heeled(0.0, heel, 0.0).vertical;
    let (across, along) = (Vector3::new(0.0, libm::cos(heel), -libm::sin(heel)), Vector3::new(1.0, 0.0, 0.0));
    let (l, b) = (EDGES[0], EDGES[1] / libm::cos(heel));
    near(tank(0.5).second_moment(vertical, across, across), l * b.powi(3) / 12.0, 1e-12 * whole());
    near(tank(0.5).second_moment(vertical, along, along), b * l.powi(3) / 12.0, 1e-12 * whole());
    near(tank(0.5).second_moment(vertical, along, across), 0.0, 1e-12 * whole());
    // Athwart on a hull: its length is across the ship.
    let turned = Matrix3([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]);
    let tank = HullTank { tank: tank(0.5), rotation: turned, density: 850.0 };
    let (upright, y) = (Vector3::new(0.0, 0.0, 1.0), Vector3::new(0.0, 1.0, 0.0));
    let expected = 850.0 * EDGES[1] * EDGES[0].powi(3) / 12.0;
    near(tank.second_moment(upright, y, y), expected, 1e-12 * expected);
    near(tank.shift(Vector3::new(0.0, 0.28, 0.96))[1], -expected * 0.28 / 0.96, 1e-12 * expected);
}

fn any_tank() -> impl Strategy<Value = (BoxTank, Vector3)> {
    let turn = prop::array::uniform3(-3.0..3.0_f64);
    (prop::array::uniform3(0.5..4.0_f64), 0.02..0.98_f64, turn)
        .prop_map(|(edges, filling, turn)| (BoxTank { edges: Vector3(edges), filling }, exp(Vector3(turn)).row(2)))
}

proptest! {
    /// The surface moves liquid only along itself, so the derivative of `n . V (c - c0)` with respect to n is
    /// `V (c - c0)` at constant volume: exact, so the error is rounding. It is divided by the smallest
    /// thickness of the surface.
    #[test]
    fn the_moment_is_the_gradient_of_the_energy((tank, vertical) in any_tank()) {
        let dual = BoxTank {
            edges: Vector3::<Dual<3>>::constant(tank.edges.0),
            filling: Dual::constant(tank.filling),
        };
        let varied = Vector3(core::array::from_fn(|k| Dual::variable(vertical[k], k)));
        let gradient = Vector3(varied.dot(dual.shift(varied)).derivative);
        // Along the vertical itself n is no longer a unit vector.
        let moment = vertical.cross(tank.shift(vertical));
        let size = tank.edges.norm() * tank.edges[0] * tank.edges[1] * tank.edges[2];
        prop_assert!((vertical.cross(gradient) - moment).norm() < 1e-12 * size, "{gradient:?} {moment:?}");
    }

    /// The error of differences over h is h^2 times the third derivative, or times its jump where the surface
    /// passes a corner.
    #[test]
    fn derivatives_along_everything_are_central_differences((tank, vertical) in any_tank()) {
        let h = 1e-5;
        let [x, y, z] = tank.edges.0;
        let numbers = [x, y, z, tank.filling, vertical[0], vertical[1], vertical[2]];
        fn shift<S: Scalar>([x, y, z, filling, a, b, c]: [S; 7]) -> Vector3<S> {
            BoxTank { edges: Vector3::new(x, y, z), filling }.shift(Vector3::new(a, b, c).direction())
        }
        let exact = shift::<Dual<7>>(core::array::from_fn(|k| Dual::variable(numbers[k], k)));
        for k in 0..7 {
            let at = |by: f64| shift::<f64>(core::array::from_fn(|i| numbers[i] + if i == k { by } else { 0.0 }));
            let difference = (at(h) - at(-h)) * (0.5 / h);
            for axis in 0..3 {
                let apart = exact[axis].derivative[k] - difference[axis];
                prop_assert!(apart.abs() < 1e-4 * (1.0 + difference.norm()), "{k} {axis}: {apart}");
            }
        }
    }

    /// With half filling, the surface passes through the middle of the box: its moments are those of a hull
    /// mesh cut there.
    #[test]
    fn a_tank_half_full_is_a_hull_in_water_to_its_middle((tank, vertical) in any_tank(), turn in 0.0..6.3_f64) {
        let tank = BoxTank { filling: 0.5, ..tank };
        let [length, breadth, height] = tank.edges.0;
        let (mesh, position) = (barge(length, breadth, height, 0.5 * height, 3), FloatingPosition { height: 0.0, vertical });
        let mut wetted = WettedHull::new(&mesh);
        let first_moment = wetted.buoyancy(&mesh, &position).first_moment;
        let upright = Vector3::new(0.0, 0.0, -0.25 * height * tank.volume());
        let size = tank.edges.norm() * tank.volume();
        prop_assert!((first_moment - upright - tank.shift(vertical)).norm() < 1e-13 * size);
        let across = vertical.cross(Vector3::new(libm::cos(turn), libm::sin(turn), 0.3)).direction();
        let (along, plane) = (across.cross(vertical), wetted.waterplane(&mesh, &position));
        for (t, u) in [(across, across), (across, along), (along, along)] {
            let apart = plane.second_moment(t, u) - tank.second_moment(vertical, t, u);
            prop_assert!(apart.abs() < 1e-11 * (1.0 + plane.second_moment(t, t)), "{apart:e}");
        }
    }

    #[test]
    fn a_lane_is_bitwise_identical_to_a_single_tank(all in prop::array::uniform4(any_tank())) {
        let lanes = |of: &dyn Fn(&(BoxTank, Vector3)) -> f64| Lanes::new([0, 1, 2, 3].map(|k| of(&all[k])));
        let together = BoxTank {
            edges: Vector3([0, 1, 2].map(|axis| lanes(&|(tank, _)| tank.edges[axis]))),
            filling: lanes(&|(tank, _)| tank.filling),
        };
        let shift = together.shift(Vector3([0, 1, 2].map(|axis| lanes(&|(_, vertical)| vertical[axis]))));
        for (lane, (tank, vertical)) in all.iter().enumerate() {
            let alone = tank.shift(*vertical);
            for axis in 0..3 {
                prop_assert_eq!(shift[axis].to_array()[lane].to_bits(), alone[axis].to_bits());
            }
        }
    }
}
