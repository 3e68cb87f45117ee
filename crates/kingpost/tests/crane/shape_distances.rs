//! Distances between solids, and of points and curves from them, against other libraries and closed forms.

use kingpost::elements::contact::{ContactSolid, ConvexHull, Curve, Spot};
use kingpost::model::Axis;
use kingpost::scalar::{Dual, Lanes, Scalar};
use kingpost::spatial::{Frame, Vector3, rotation_from_roll_pitch_yaw};
use parry3d_f64::math::{Pose, Rotation, Vector};
use parry3d_f64::query;
use parry3d_f64::shape::{self, ConvexPolyhedron, Shape};
use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};

const TETRAHEDRON: [[f64; 3]; 5] =
    [[1.2, 0.3, -0.5], [-0.8, 0.9, -0.4], [-0.3, -1.1, -0.6], [0.1, 0.2, 1.3], [0.4, -0.2, 0.9]];

fn hull<S: Scalar>(points: &[[f64; 3]]) -> ContactSolid<S> {
    let points: Vec<_> = points.iter().map(|point| Vector3::constant(*point)).collect();
    ContactSolid::Convex(ConvexHull::new(&points).expect("a hull"))
}

/// Returns one solid of each kind that has an inside.
fn solids<S: Scalar>() -> Vec<ContactSolid<S>> {
    let [large, small, long] = [1.1, 0.4, 1.5].map(S::constant);
    vec![
        ContactSolid::Sphere { radius: large },
        ContactSolid::Box { half: [large, small, long] },
        ContactSolid::Cylinder { radius: small, half_length: long, axis: Axis::Y },
        ContactSolid::Capsule { radius: small, half_length: long, axis: Axis::Y },
        ContactSolid::Cone { half_angle: S::constant(0.5).sin_cos(), length: long },
        hull(&TETRAHEDRON),
    ]
}

/// Returns parry's own shapes of the same solids, and their poses: its cones have their middle at the origin, along y.
fn peers() -> Vec<(Box<dyn Shape>, Pose)> {
    let half = 0.75;
    let corners: Vec<Vector> = TETRAHEDRON.into_iter().map(Vector::from_array).collect();
    let to_z = Rotation::from_rotation_x(std::f64::consts::FRAC_PI_2);
    let cone = Pose::from_parts(Vector::new(0.0, 0.0, -half), to_z);
    vec![
        (Box::new(shape::Ball::new(1.1)), Pose::IDENTITY),
        (Box::new(shape::Cuboid::new(Vector::new(1.1, 0.4, 1.5))), Pose::IDENTITY),
        (Box::new(shape::Cylinder::new(1.5, 0.4)), Pose::IDENTITY),
        (Box::new(shape::Capsule::new_y(1.5, 0.4)), Pose::IDENTITY),
        (Box::new(shape::Cone::new(half, 1.5 * 0.5_f64.tan())), cone),
        (Box::new(ConvexPolyhedron::from_convex_hull(&corners).expect("a hull")), Pose::IDENTITY),
    ]
}

fn pose(random: &mut StdRng, reach: f64) -> ([f64; 3], [f64; 3]) {
    let mut draw = |size: f64| std::array::from_fn(|_| random.random_range(-size..size));
    (draw(reach), draw(3.0))
}

fn frame<S: Scalar>((position, angles): ([f64; 3], [f64; 3])) -> Frame<S> {
    let rotation = rotation_from_roll_pitch_yaw(Vector3::constant(angles));
    Frame { rotation, position: Vector3::constant(position) }
}

fn peer(frame: &Frame<f64>) -> Pose {
    let columns = [0, 1, 2].map(|j| Vector::from_array(frame.rotation.column(j).0));
    let rotation = parry3d_f64::math::Matrix::from_cols(columns[0], columns[1], columns[2]);
    Pose::from_parts(Vector::from_array(frame.position.0), Rotation::from_mat3(&rotation))
}

/// Of overlapping round solids both are as far off as EPA's polytope.
#[test]
fn distances_between_solids_are_those_of_parry() {
    let mut random = StdRng::seed_from_u64(11);
    let (own, peers) = (solids::<f64>(), peers());
    let mut compared = 0;
    for (i, (a, (peer_a, offset_a))) in own.iter().zip(&peers).enumerate() {
        for (j, (b, (peer_b, offset_b))) in own.iter().zip(&peers).enumerate() {
            for _ in 0..200 {
                let seen = frame(pose(&mut random, 3.0));
                let (at_a, at_b) = (*offset_a, peer(&seen) * *offset_b);
                let found = a.distance_to(b, &seen);
                let Ok(Some(contact)) = query::contact(&at_a, peer_a.as_ref(), &at_b, peer_b.as_ref(), 100.0) else {
                    continue;
                };
                compared += 1;
                assert!((found - contact.dist).abs() < 1e-5, "{i} {j}: {found} {}", contact.dist);
            }
        }
    }
    assert!(compared > 7000, "{compared}");
}

/// Returns the distance over a scalar type, the pose shifted by `shift` along six directions.
fn shifted<S: Scalar>(i: usize, j: usize, at: ([f64; 3], [f64; 3]), shift: [S; 6]) -> S {
    let own = solids::<S>();
    let moved = |start: [f64; 3], by: &[S]| Vector3(std::array::from_fn(|k| S::constant(start[k]) + by[k]));
    let seen =
        Frame { rotation: rotation_from_roll_pitch_yaw(moved(at.1, &shift[3..])), position: moved(at.0, &shift[..3]) };
    own[i].distance_to(&own[j], &seen)
}

/// Central differences with the step h have an error of h^2. EPA's polytope of a round solid is some 1e-3 off in its normal:
/// that is the error of a derivative, and its square, over h, that of a difference.
#[test]
fn derivatives_of_distances_between_solids_are_those_of_differences() {
    let mut random = StdRng::seed_from_u64(12);
    for i in 0..6 {
        for j in 0..6 {
            let at = pose(&mut random, 3.0);
            let exact = shifted::<Dual<6>>(i, j, at, std::array::from_fn(|k| Dual::variable(0.0, k)));
            for k in 0..6 {
                let step = |h: f64| shifted::<f64>(i, j, at, std::array::from_fn(|l| if l == k { h } else { 0.0 }));
                let difference = (step(1e-3) - step(-1e-3)) / 2e-3;
                assert!(
                    (exact.derivative[k] - difference).abs() < 5e-3,
                    "{i} {j} {k}: {} {difference}",
                    exact.derivative[k]
                );
            }
        }
    }
}

#[test]
fn every_lane_of_a_distance_is_that_of_a_single_run() {
    let mut random = StdRng::seed_from_u64(13);
    for i in 0..6 {
        for j in 0..6 {
            let at = pose(&mut random, 2.0);
            let shifts: [[f64; 6]; 4] =
                std::array::from_fn(|_| std::array::from_fn(|_| random.random_range(-1.0..1.0)));
            let together = std::array::from_fn(|k| Lanes::new(std::array::from_fn(|lane| shifts[lane][k])));
            let found = shifted::<Lanes>(i, j, at, together).to_array();
            for lane in 0..4 {
                assert_eq!(found[lane].to_bits(), shifted::<f64>(i, j, at, shifts[lane]).to_bits(), "{i} {j}");
            }
        }
    }
}

/// A box as a hull: the distance of a point is that of the box's own closed form, outside and inside.
#[test]
fn the_distance_from_a_hull_of_eight_corners_is_that_from_a_box() {
    let half = [1.1, 0.4, 1.5];
    let corners: Vec<[f64; 3]> =
        (0..8).map(|k| std::array::from_fn(|i| if k >> i & 1 == 0 { -half[i] } else { half[i] })).collect();
    let (of_hull, of_box) = (hull::<f64>(&corners), ContactSolid::Box { half });
    if let ContactSolid::Convex(hull) = &of_hull {
        assert_eq!((hull.corners.len(), hull.edges.len()), (8, 12));
    }
    let mut random = StdRng::seed_from_u64(14);
    for _ in 0..2000 {
        let point = Vector3(pose(&mut random, 2.5).0);
        let [(a, of_a), (b, of_b)] = [of_hull.distance(point), of_box.distance(point)];
        assert!((a - b).abs() < 1e-14 && (of_a - of_b).norm() < 1e-12, "{point:?}: {a} {b}");
    }
}

/// Points against parry's own projections; the gradient is a unit vector.
#[test]
fn distances_of_points_from_solids_are_those_of_parry() {
    let mut random = StdRng::seed_from_u64(15);
    for (solid, (peer, offset)) in solids::<f64>().iter().zip(&peers()) {
        for _ in 0..2000 {
            let point = Vector3(pose(&mut random, 2.5).0);
            let (found, gradient) = solid.distance(point);
            let theirs = peer.distance_to_point(offset, Vector::from_array(point.0), false);
            assert!((found - theirs).abs() < 1e-6, "{solid:?} {point:?}: {found} {theirs}");
            assert!((gradient.norm() - 1.0).abs() < 1e-9);
        }
    }
}

/// The smallest distance of 20001 points of a curve is above the minimum by at most a second difference.
#[test]
fn the_nearest_point_of_a_curve_is_the_best_of_many() {
    let mut random = StdRng::seed_from_u64(16);
    for solid in solids::<f64>() {
        for k in 0..20 {
            let at = frame::<f64>(pose(&mut random, 2.0));
            let (across, along) = (at.rotation.column(0), at.rotation.column(1));
            let curve = if k % 2 == 0 {
                Curve::Line { middle: at.position, half: across * 1.5 }
            } else {
                Curve::Line { middle: at.position * 0.3, half: along * 2.0 }
            };
            let found = curve.nearest(&solid, 1e-3);
            let best = (-10_000..=10_000)
                .map(|i| f64::from(i) * 1e-4)
                .fold(f64::MAX, |best, t| best.min(solid.distance(curve.at(t).0).0 + 1e-3 * t * t));
            let above = best - found.distance;
            assert!((-1e-12..3e-4).contains(&above), "{solid:?} {curve:?}: {above}");
        }
    }
}

/// Two bars of radius r whose axes cross at any angle, a distance h apart: |h| - 2 r, along their common normal; in parallel, and
/// where an end is nearest, the distance of points.
#[test]
fn the_distance_of_bars_is_that_of_their_axes() {
    let [radius, half_length] = [0.1, 1.0];
    let solid = ContactSolid::Capsule { radius, half_length, axis: Axis::X };
    let bar = |middle: [f64; 3], half: [f64; 3]| Spot::Tube {
        curve: Curve::Line { middle: Vector3(middle), half: Vector3(half) },
        radius,
        crown: 0.0,
    };
    let (sin, cos) = 0.7_f64.sin_cos();
    let cases = [
        (bar([0.3, 0.0, 0.5], [0.0, 1.0, 0.0]), 0.3, [0.3, 0.0, 0.4]),
        (bar([0.3, 0.0, 0.19], [cos, sin, 0.0]), -0.01, [0.3, 0.0, 0.09]),
        (bar([0.0, 1.5, 0.0], [0.0, 1.0, 0.0]), 0.3, [0.0, 0.4, 0.0]),
        (bar([3.0, 0.0, 0.4], [1.0, 0.0, 0.0]), (1.0_f64 + 0.16).sqrt() - 0.2, [1.9071523, 0.0, 0.3628609]),
    ];
    for (spot, distance, touches) in cases {
        let near = spot.nearness(&solid, &Frame::identity());
        assert!((near.depth + distance).abs() < 1e-12, "{} m, not {distance} m", -near.depth);
        assert!((near.point - Vector3(touches)).norm() < 1e-6, "{:?}", near.point);
        assert!((near.gain - 1.0).abs() < 1e-12);
    }
    let parallel = bar([0.4, 0.0, 0.3], [1.0, 0.0, 0.0]).nearness(&solid, &Frame::identity());
    assert!((parallel.depth + 0.1).abs() < 1e-12, "{}", parallel.depth);
}

/// Depth, normal and point of a spot with their derivatives by the pose, against central differences with the step h: their
/// error is h^2 over the distance of a centre of curvature, squared.
#[test]
fn derivatives_of_spots_are_those_of_differences() {
    fn near<S: Scalar>(spot: usize, solid: usize, at: ([f64; 3], [f64; 3]), shift: [S; 6]) -> [S; 7] {
        let moved = |start: [f64; 3], by: &[S]| Vector3(std::array::from_fn(|k| S::constant(start[k]) + by[k]));
        let rotation = rotation_from_roll_pitch_yaw(moved(at.1, &shift[3..]));
        let seen = Frame { rotation, position: moved(at.0, &shift[..3]) };
        let [zero, one, fifth] = [0.0, 1.0, 0.2].map(S::constant);
        let spots = [
            Spot::Tube {
                curve: Curve::Line { middle: Vector3::zero(), half: Vector3([zero, zero, one]) },
                radius: fifth,
                crown: S::constant(2e-4),
            },
            Spot::Tube {
                curve: Curve::Arc {
                    centre: Vector3::zero(),
                    across: Vector3([one, zero, zero]),
                    along: Vector3([zero, one, zero]),
                    half_angle: S::constant(0.4),
                },
                radius: fifth,
                crown: S::constant(2e-4),
            },
        ];
        let found = spots[spot].nearness(&solids::<S>()[solid], &seen);
        let [a, b, c] = found.normal.0;
        let [x, y, z] = found.point.0;
        [found.depth * found.gain, a, b, c, x, y, z]
    }
    let mut random = StdRng::seed_from_u64(17);
    for spot in 0..2 {
        for solid in 0..6 {
            for _ in 0..5 {
                let at = pose(&mut random, 2.0);
                let exact = near::<Dual<6>>(spot, solid, at, std::array::from_fn(|k| Dual::variable(0.0, k)));
                let alone = near::<f64>(spot, solid, at, [0.0; 6]);
                assert_eq!(exact.map(|x| x.value.to_bits()), alone.map(f64::to_bits), "{spot} {solid}");
                for k in 0..6 {
                    let step =
                        |h: f64| near::<f64>(spot, solid, at, std::array::from_fn(|l| if l == k { h } else { 0.0 }));
                    let (up, down) = (step(1e-5), step(-1e-5));
                    for (m, exact) in exact.iter().enumerate() {
                        let (difference, found) = ((up[m] - down[m]) / 2e-5, exact.derivative[k]);
                        let off = (found - difference).abs() / (1.0 + found.abs());
                        assert!(off < 1e-4, "{spot} {solid} {k} {m}: {found} {difference}");
                    }
                }
            }
        }
    }
}

/// Random points, some of them repeated, in one plane or on one line: a hull or none, never a panic.
#[test]
fn every_set_of_points_has_a_hull_or_none() {
    let mut random = StdRng::seed_from_u64(18);
    let mut refused = 0;
    for case in 0..20_000 {
        let count = random.random_range(1..12);
        let grid = [1.0, 4.0, 1e6][case % 3];
        let mut points: Vec<Vector3<f64>> = (0..count)
            .map(|_| Vector3(std::array::from_fn(|_| (random.random_range(-1.0..1.0_f64) * grid).round() / grid)))
            .collect();
        match case % 5 {
            0 => points.iter_mut().for_each(|point| point[2] = 0.3 * point[0] - 0.2),
            1 => points.iter_mut().for_each(|point| *point = Vector3([point[0], 2.0 * point[0], 0.0])),
            2 => points.iter_mut().for_each(|point| point[2] *= 1e-5),
            3 => points.push(points[0]),
            _ => {}
        }
        if let Some(hull) = ConvexHull::new(&points) {
            assert!(hull.corners.len() >= 4 && hull.edges.len() >= 6);
            // A corner is on the surface, the middle inside it.
            let solid = ContactSolid::Convex(hull.clone());
            assert!(hull.corners.iter().all(|corner| solid.distance(*corner).0.abs() < 1e-8));
            let sum = hull.corners.iter().fold(Vector3::zero(), |sum, corner| sum + *corner);
            let middle = solid.distance(sum * (1.0 / hull.corners.len() as f64)).0;
            assert!(middle < 0.0, "{middle} {case} {hull:?} {points:?}");
        } else if case % 5 >= 3 && case % 3 > 0 {
            // Few points may be near one plane by chance.
            refused += usize::from(count > 6);
        }
    }
    assert!(refused < 5, "{refused}");
}
