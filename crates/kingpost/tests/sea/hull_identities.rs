//! Identities that hold for any hull in any position: energy and its gradient, two ways to integrate, lanes.

use crate::common::hulls;

use hulls::{SPECIFIC_WEIGHT, box_barge, distance, moved, near, place, skew_ship, varied};
use kingpost::scalar::{Dual, LANES, Lanes, Scalar};
use kingpost::sea::hull::{FloatingPosition, HullMesh, LocalWater, WettedHull};
use kingpost::spatial::{Frame, Matrix3, Vector3, Wrench, exp, rotation_from_roll_pitch_yaw};
use proptest::prelude::*;

/// Rotation vector and height that cut [`skew_ship`] anywhere, or leave it dry or under water.
fn any_pose() -> impl Strategy<Value = ([f64; 3], f64)> {
    (prop::array::uniform3(-1.5..1.5_f64), -6.0..6.0_f64)
}

/// The weight of all the water that the skew ship can displace.
fn scale() -> f64 {
    SPECIFIC_WEIGHT * skew_ship().volume()
}

proptest! {
    /// By the chain rule exactly, so to rounding.
    #[test]
    fn the_wrench_is_minus_the_gradient_of_the_energy((turn, height) in any_pose()) {
        let mesh = skew_ship();
        let pose = place(turn, height);
        let wrench = WettedHull::new(&mesh).buoyancy(&mesh, &FloatingPosition::of(&pose)).wrench(SPECIFIC_WEIGHT);
        let varied = FloatingPosition::of(&varied(&pose));
        let energy = WettedHull::new(&mesh).buoyancy(&mesh, &varied).potential_energy(Dual::constant(SPECIFIC_WEIGHT));
        let [fx, fy, fz, mx, my, mz] = energy.derivative.map(|slope| -slope);
        let gradient = Wrench { force: Vector3([fx, fy, fz]), moment: Vector3([mx, my, mz]) };
        prop_assert!(distance(&wrench, &gradient) < 1e-12 * scale(), "{wrench:?} {gradient:?}");
        prop_assert!(energy.value > -1e-12 * scale());
    }

    /// Differences over h = 1e-4 m or rad err by h^2 times the third derivative.
    #[test]
    fn the_wrench_is_minus_the_differences_of_the_energy((turn, height) in any_pose()) {
        let mesh = skew_ship();
        let (pose, mut wetted, h) = (place(turn, height), WettedHull::new(&mesh), 1e-4);
        let wrench = wetted.buoyancy(&mesh, &FloatingPosition::of(&pose)).wrench(SPECIFIC_WEIGHT);
        let mut energy = |step: [f64; 6]| {
            let [x, y, z, a, b, c] = step;
            let moved = pose.times(&Frame { rotation: exp(Vector3::new(a, b, c)), position: Vector3::new(x, y, z) });
            wetted.buoyancy(&mesh, &FloatingPosition::of(&moved)).potential_energy(SPECIFIC_WEIGHT)
        };
        let slope: [f64; 6] = core::array::from_fn(|k| {
            let mut step = [0.0; 6];
            step[k] = h;
            (energy(step) - energy(step.map(|x| -x))) / (2.0 * h)
        });
        let differences = Wrench {
            force: Vector3([-slope[0], -slope[1], -slope[2]]),
            moment: Vector3([-slope[3], -slope[4], -slope[5]]),
        };
        prop_assert!(distance(&wrench, &differences) < 1e-6 * scale());
    }

    /// The pressure integrated over the wetted surface, component by component, is compared with the
    /// divergence theorem.
    #[test]
    fn the_pressure_of_still_water_gives_the_same_wrench((turn, height) in any_pose()) {
        let (mesh, pose) = (skew_ship(), place(turn, height));
        let mut wetted = WettedHull::new(&mesh);
        let still = |_| LocalWater { elevation: 0.0, dynamic_pressure: 0.0 };
        let pressure = wetted.pressure_wrench(&mesh, &pose, SPECIFIC_WEIGHT, still);
        let buoyancy = wetted.buoyancy(&mesh, &FloatingPosition::of(&pose)).wrench(SPECIFIC_WEIGHT);
        prop_assert!(distance(&pressure, &buoyancy) < 1e-13 * scale());
    }

    /// A sloping sea, with the pressure of its depth, is still water under a tilted vertical and a greater
    /// gravity.
    #[test]
    fn the_pressure_below_a_slope_is_that_of_water_at_rest_under_tilted_gravity(
        (turn, height) in any_pose(), slope in -0.8..0.8_f64
    ) {
        let (mesh, pose) = (skew_ship(), place(turn, height));
        let mut wetted = WettedHull::new(&mesh);
        let sloping = |point: Vector3| {
            let elevation = slope * (point[0] - 10.0);
            LocalWater { elevation, dynamic_pressure: SPECIFIC_WEIGHT * elevation }
        };
        let pressure = wetted.pressure_wrench(&mesh, &pose, SPECIFIC_WEIGHT, sloping);
        let steeper = libm::hypot(1.0, slope);
        let up = Vector3::new(-slope, 0.0, 1.0) * (1.0 / steeper);
        let tilted = FloatingPosition {
            height: (pose.position - Vector3::new(10.0, 0.0, 0.0)).dot(up),
            vertical: pose.rotation.transpose_times(up),
        };
        let at_rest = wetted.buoyancy(&mesh, &tilted).wrench(SPECIFIC_WEIGHT * steeper);
        prop_assert!(distance(&pressure, &at_rest) < 1e-12 * scale());
    }

    /// Differences over h = 1e-7 err by h and by rounding over h. The pressure need not be 0 at the
    /// surface for the wrench to change without jumps where a vertex goes under.
    #[test]
    fn the_wrench_of_a_wave_has_the_derivatives_of_dual_numbers((turn, height) in any_pose(), k in 0..6_usize) {
        let (mesh, pose, h) = (skew_ship(), place(turn, height), 1e-7);
        let mut wetted = WettedHull::new(&mesh);
        let mut beside = |h: f64| {
            let step: [f64; 6] = core::array::from_fn(|j| if j == k { h } else { 0.0 });
            let small = Frame { rotation: exp(Vector3::from_slice(&step[3..])), position: Vector3::from_slice(&step) };
            wetted.pressure_wrench(&mesh, &pose.times(&small), SPECIFIC_WEIGHT, swell)
        };
        let (ahead, behind) = (beside(h), beside(-h));
        let weight = Dual::constant(SPECIFIC_WEIGHT);
        let exact = WettedHull::new(&mesh).pressure_wrench(&mesh, &varied(&pose), weight, swell);
        let slope = |of: Vector3<Dual<6>>| Vector3(of.0.map(|x| x.derivative[k] * 2.0 * h));
        let expected = Wrench { moment: slope(exact.moment), force: slope(exact.force) };
        let differences = ahead + behind * -1.0;
        prop_assert!(distance(&differences, &expected) < 2.0 * h * 1e-5 * scale(), "{differences:?} {expected:?}");
    }

    /// The swell is at most 1 m high: vertices above need no evaluation, unless a neighbour can be wet.
    #[test]
    fn a_vertex_among_dry_ones_is_not_evaluated_and_the_sum_is_unchanged((turn, height) in any_pose()) {
        let (mesh, pose) = (skew_ship(), place(turn, height));
        let plain = WettedHull::new(&mesh).pressure_wrench(&mesh, &pose, SPECIFIC_WEIGHT, swell);
        let (mut wetted, mut asked) = (WettedHull::new(&mesh), Vec::new());
        let counted = |point: Vector3| {
            asked.push(point);
            swell(point)
        };
        let bounded = wetted.pressure_wrench_below(&mesh, &pose, SPECIFIC_WEIGHT, 1.0, counted);
        prop_assert_eq!(plain, bounded);

        let in_world: Vec<Vector3> = mesh.vertices().iter().map(|r| pose.point(*r)).collect();
        let low = |vertex: u32| in_world[vertex as usize][2] <= 1.0;
        let counts = |vertex: usize| {
            let of_vertex = |corners: &[u32; 3]| corners.contains(&(vertex as u32));
            low(vertex as u32) || mesh.triangles().filter(of_vertex).any(|corners| corners.into_iter().any(low))
        };
        let most: Vec<Vector3> = (0..in_world.len()).filter(|vertex| counts(*vertex)).map(|i| in_world[i]).collect();
        prop_assert!(asked.len() <= most.len(), "{} {}", asked.len(), most.len());
        prop_assert!(asked.iter().all(|point| most.contains(point)));
    }

    #[test]
    fn every_lane_is_bitwise_identical_to_a_single_run(poses in prop::array::uniform4(any_pose()), alike: bool) {
        let mesh = skew_ship();
        // Either anywhere, or so near each other that most triangles are cut alike.
        let poses: [Frame; LANES] = core::array::from_fn(|k| {
            let (turn, height) = poses[if alike { 0 } else { k }];
            place(turn, height + 0.01 * k as f64)
        });
        let lanes = |of: &dyn Fn(&Frame) -> f64| Lanes::new(core::array::from_fn(|k| of(&poses[k])));
        let together = Frame {
            rotation: Matrix3::from_fn(|i, j| lanes(&|pose| pose.rotation.0[i][j])),
            position: Vector3([0, 1, 2].map(|i| lanes(&|pose| pose.position[i]))),
        };
        let mut of_lanes = WettedHull::new(&mesh);
        let weight = Lanes::constant(SPECIFIC_WEIGHT);
        let wave = of_lanes.pressure_wrench_below(&mesh, &together, weight, Lanes::ONE, swell);
        let buoyancy = of_lanes.buoyancy(&mesh, &FloatingPosition::of(&together));
        for (k, pose) in poses.iter().enumerate() {
            let mut alone = WettedHull::new(&mesh);
            let expected = alone.pressure_wrench(&mesh, pose, SPECIFIC_WEIGHT, swell);
            let expected_buoyancy = alone.buoyancy(&mesh, &FloatingPosition::of(pose));
            for axis in 0..3 {
                prop_assert_eq!(wave.force[axis].to_array()[k], expected.force[axis]);
                prop_assert_eq!(wave.moment[axis].to_array()[k], expected.moment[axis]);
                prop_assert_eq!(buoyancy.first_moment[axis].to_array()[k], expected_buoyancy.first_moment[axis]);
            }
            prop_assert_eq!(buoyancy.volume.to_array()[k], expected_buoyancy.volume);
        }
    }

    /// Rates of V and G along the height and along tangents of n, the first exactly.
    #[test]
    fn the_waterplane_is_the_rate_of_buoyancy((turn, height) in any_pose()) {
        let mesh = skew_ship();
        let position = FloatingPosition::of(&place(turn, height));
        let waterplane = WettedHull::new(&mesh).waterplane(&mesh, &position);
        let varied = FloatingPosition::of(&varied(&place(turn, height)));
        let buoyancy = WettedHull::new(&mesh).buoyancy(&mesh, &varied);
        let n = position.vertical;
        for (k, turn) in [(3, [1.0, 0.0, 0.0]), (4, [0.0, 1.0, 0.0]), (5, [0.0, 0.0, 1.0])] {
            // A turn a of the hull changes n by n x a, and its translation along axis k z0 by n_k.
            let tangent = n.cross(Vector3(turn));
            let size = scale() / SPECIFIC_WEIGHT;
            near(buoyancy.volume.derivative[k - 3], -n[k - 3] * waterplane.area, 1e-12 * size);
            near(buoyancy.volume.derivative[k], -tangent.dot(waterplane.first_moments), 1e-12 * size);
            let rates = waterplane.second_moments * tangent;
            for axis in 0..3 {
                near(buoyancy.first_moment[axis].derivative[k], -rates[axis], 1e-11 * size);
                let first = n[k - 3] * waterplane.first_moments[axis];
                near(buoyancy.first_moment[axis].derivative[k - 3], -first, 1e-11 * size);
            }
        }
    }
}

/// Some regular wave, as any scalar; its pressure does not vanish at its surface.
fn swell<S: Scalar>(point: Vector3<S>) -> LocalWater<S> {
    let (sin, cos) = (point[0] * S::constant(0.2) + point[1] * S::constant(0.1)).sin_cos();
    LocalWater { elevation: cos, dynamic_pressure: S::constant(SPECIFIC_WEIGHT) * (cos + sin * S::constant(0.3)) }
}

#[test]
fn a_pose_that_is_not_finite_gives_no_finite_wrench() {
    let mesh = box_barge(2);
    for height in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let mut wetted = WettedHull::new(&mesh);
        let wrench = wetted.buoyancy(&mesh, &FloatingPosition::upright(height)).wrench(SPECIFIC_WEIGHT);
        assert!(wrench.force.0.iter().any(|f| f.is_nan()));
        let still = |_| LocalWater { elevation: 0.0, dynamic_pressure: 0.0 };
        let pose = Frame::translation(Vector3::new(0.0, 0.0, height));
        assert!(wetted.pressure_wrench(&mesh, &pose, SPECIFIC_WEIGHT, still).force[0].is_nan());
    }
}

#[test]
fn no_vertex_of_a_hull_above_all_waves_is_evaluated() {
    let (mesh, pose) = (skew_ship(), place([0.0; 3], 60.0));
    let nowhere = |_| -> LocalWater { panic!("the hull is dry") };
    let wrench = WettedHull::new(&mesh).pressure_wrench_below(&mesh, &pose, SPECIFIC_WEIGHT, 1.0, nowhere);
    assert_eq!(wrench, Wrench::zero());
}

/// The heading, the position on the sea, and the frame in which a hull is drawn have no effect.
#[test]
fn buoyancy_does_not_depend_on_heading_and_frame() {
    let (mesh, pose) = (skew_ship(), place([0.3, -0.4, 0.2], 0.6));
    let wrench_of = |mesh: &HullMesh, pose: &Frame| {
        WettedHull::new(mesh).buoyancy(mesh, &FloatingPosition::of(pose)).wrench(SPECIFIC_WEIGHT)
    };
    let wrench = wrench_of(&mesh, &pose);
    let heading = Frame {
        rotation: rotation_from_roll_pitch_yaw(Vector3::new(0.0, 0.0, 2.2)),
        position: Vector3::new(40.0, 5.0, 0.0),
    };
    assert!(distance(&wrench, &wrench_of(&mesh, &heading.times(&pose))) < 1e-13 * scale());
    let frame = Frame { rotation: exp(Vector3::new(0.4, 1.0, -0.3)), position: Vector3::new(-2.0, 1.0, 3.0) };
    let seen_elsewhere = wrench_of(&moved(&mesh, &frame), &pose.times(&frame.inverse()));
    assert!(distance(&frame.wrench_to_parent(&wrench), &seen_elsewhere) < 1e-13 * scale());
}
