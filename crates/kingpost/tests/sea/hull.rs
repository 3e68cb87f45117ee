//! Hulls in still water: closed forms, the linear form, and invalid hulls.

use crate::common::hulls;

use core::f64::consts::PI;
use hulls::{
    SPECIFIC_WEIGHT, barge, box_barge, box_triangles, close, distance, moved, near, place, ship, sphere, varied,
};
use kingpost::scalar::{Dual, Scalar};
use kingpost::sea::hull::{
    FloatingPosition, HullMesh, LinearHydrostatics, LocalWater, MeshError, StabilityError, WettedHull,
};
use kingpost::spatial::{Frame, Vector3, exp};

#[test]
fn a_box_displaces_its_length_by_its_beam_by_its_draught() {
    for divisions in [1, 3, 9] {
        let mesh = box_barge(divisions);
        let mut wetted = WettedHull::new(&mesh);
        for height in [-1.9, -0.3, 0.0, 0.7, 1.99] {
            let draught = 2.0 - height;
            let position = FloatingPosition::upright(height);
            let (buoyancy, waterplane) = (wetted.buoyancy(&mesh, &position), wetted.waterplane(&mesh, &position));
            close(buoyancy.volume, 200.0 * draught, 1e-14);
            close(buoyancy.height_moment, -100.0 * draught * draught, 1e-13);
            near((buoyancy.centre() - Vector3::new(0.0, 0.0, -2.0 + 0.5 * draught)).norm(), 0.0, 1e-13);
            close(waterplane.area, 200.0, 1e-14);
            close(waterplane.second_moments.xx, 20.0 * 20.0 * 20.0 * 10.0 / 12.0, 1e-13);
            close(waterplane.second_moments.yy, 20.0 * 10.0 * 10.0 * 10.0 / 12.0, 1e-13);
            near(waterplane.second_moments.xy, 0.0, 1e-11);
            near(waterplane.first_moments[0].abs() + waterplane.first_moments[1].abs(), 0.0, 1e-12);
            close(waterplane.first_moments[2], -height * 200.0, 1e-13);
        }
        close(mesh.volume(), 800.0, 1e-14);
    }
}

#[test]
fn a_sphere_of_triangles_displaces_a_cap_with_an_error_of_second_order() {
    let (radius, depth) = (5.0, 3.7);
    let cap = PI * depth * depth * (3.0 * radius - depth) / 3.0;
    let section = PI * depth * (2.0 * radius - depth);
    let errors = [8, 16, 32].map(|divisions| {
        let mesh = sphere(radius, divisions);
        let (mut wetted, position) = (WettedHull::new(&mesh), FloatingPosition::heeled(radius - depth, 0.4, -0.2));
        let (volume, area) = (wetted.buoyancy(&mesh, &position).volume, wetted.waterplane(&mesh, &position).area);
        [cap - volume, section - area, 4.0 / 3.0 * PI * radius.powi(3) - mesh.volume()]
    });
    for quantity in 0..3 {
        for (coarse, fine) in errors.iter().zip(&errors[1..]) {
            let ratio = coarse[quantity] / fine[quantity];
            assert!((3.6..4.4).contains(&ratio), "{quantity}: {ratio}");
        }
    }
    assert!(errors[2][0] / cap < 3e-3);
}

/// On a box in a long-crested sea along it, `F = rho g a e^(-k T) B 2/k sin(k L/2)` at the instant
/// of a crest amidships (Faltinsen, *Sea Loads*, 1990, ch. 3), of the pressure `rho g a e^(kz) cos(kx)`;
/// the sides push across only.
#[test]
fn the_wave_pressure_heaves_a_box_by_the_closed_form_with_an_error_of_second_order() {
    let (amplitude, number) = (0.01, 2.0 * PI / 35.0);
    let wave = |point: Vector3| {
        let crest = amplitude * libm::cos(number * point[0]);
        LocalWater { elevation: crest, dynamic_pressure: SPECIFIC_WEIGHT * crest * libm::exp(number * point[2]) }
    };
    let exact = SPECIFIC_WEIGHT * amplitude * libm::exp(-number * 2.0) * 10.0 * 2.0 / number * libm::sin(number * 10.0);
    let errors = [4, 8, 16].map(|divisions| {
        let mesh = box_barge(divisions);
        let wrench = WettedHull::new(&mesh).pressure_wrench(&mesh, &Frame::identity(), SPECIFIC_WEIGHT, wave);
        (exact - (wrench.force[2] - SPECIFIC_WEIGHT * 400.0)) / exact
    });
    // A chord lies below an arc of the cosine by (k dx)^2 / 12 of it on the average.
    for (divisions, error) in [4.0, 8.0, 16.0].into_iter().zip(errors) {
        let chord = (number * 20.0 / divisions) * (number * 20.0 / divisions) / 12.0;
        assert!((0.95..1.05).contains(&(error / chord)), "{errors:?}");
    }
}

#[test]
fn linear_hydrostatics_of_a_box_are_the_closed_forms() {
    let linear = LinearHydrostatics::of_mesh(&box_barge(3)).unwrap();
    let restoring = linear.restoring(SPECIFIC_WEIGHT);
    close(restoring.heave, SPECIFIC_WEIGHT * 200.0, 1e-13);
    close(restoring.roll, SPECIFIC_WEIGHT * (20.0 * 1000.0 / 12.0 - 400.0), 1e-13);
    close(restoring.pitch, SPECIFIC_WEIGHT * (10.0 * 8000.0 / 12.0 - 400.0), 1e-13);
    near(restoring.heave_roll.abs() + restoring.heave_pitch.abs() + restoring.roll_pitch.abs(), 0.0, 1e-6);
    // With the weight half a metre over the keel's 2.5 m, W GM is left: KB + BM - KG.
    let weight = SPECIFIC_WEIGHT * 400.0;
    let whole = restoring.with_weight(weight, 0.5);
    close(whole.roll, weight * (1.0 + 25.0 / 6.0 - 2.5), 1e-13);
    close(whole.pitch, weight * (1.0 + 50.0 / 3.0 - 2.5), 1e-13);
}

/// The skew ship upright in its own axes with its origin on the water.
fn afloat() -> HullMesh {
    let place = Frame { rotation: exp(Vector3::new(0.0, 0.0, 0.4)), position: Vector3::new(2.0, 0.8, -3.1) };
    moved(&ship(30.0, 9.0, 6.0, 5), &place)
}

#[test]
fn the_linear_wrench_is_minus_the_gradient_of_its_energy_and_restoring_its_rate() {
    let linear = LinearHydrostatics::of_mesh(&afloat()).unwrap();
    let size = SPECIFIC_WEIGHT * linear.volume;
    for (turn, height) in [([0.0; 3], 0.0), ([0.3, -0.2, 1.0], 0.4), ([-0.1, 0.5, -2.0], -1.0)] {
        let pose = place(turn, height);
        let position = FloatingPosition::of(&varied(&pose));
        let energy = linear.potential_energy(&position, Dual::constant(SPECIFIC_WEIGHT));
        let wrench = linear.wrench(&FloatingPosition::of(&pose), SPECIFIC_WEIGHT);
        for axis in 0..3 {
            near(wrench.force[axis], -energy.derivative[axis], 1e-13 * size);
            near(wrench.moment[axis], -energy.derivative[axis + 3], 1e-12 * size);
        }
    }
    let position = FloatingPosition::of(&varied(&Frame::identity()));
    let (wrench, restoring) =
        (linear.wrench(&position, Dual::constant(SPECIFIC_WEIGHT)), linear.restoring(SPECIFIC_WEIGHT));
    let size = 1e-13 * size * 100.0;
    for (force, motion, stiffness) in [
        (wrench.force[2], 2, restoring.heave),
        (wrench.force[2], 3, restoring.heave_roll),
        (wrench.force[2], 4, restoring.heave_pitch),
        (wrench.moment[0], 2, restoring.heave_roll),
        (wrench.moment[0], 3, restoring.roll),
        (wrench.moment[0], 4, restoring.roll_pitch),
        (wrench.moment[1], 2, restoring.heave_pitch),
        (wrench.moment[1], 3, restoring.roll_pitch),
        (wrench.moment[1], 4, restoring.pitch),
    ] {
        near(-force.derivative[motion], stiffness, size);
    }
}

/// Their difference is of second order in the motion, that of their energies of third.
#[test]
fn mesh_and_linear_hydrostatics_agree_for_small_motions() {
    let mesh = afloat();
    let (linear, mut wetted) = (LinearHydrostatics::of_mesh(&mesh).unwrap(), WettedHull::new(&mesh));
    let reference = wetted.buoyancy(&mesh, &FloatingPosition::upright(0.0)).potential_energy(SPECIFIC_WEIGHT)
        - linear.potential_energy(&FloatingPosition::upright(0.0), SPECIFIC_WEIGHT);
    let mut differences = |size: f64| {
        let pose = Frame { rotation: exp(Vector3::new(0.6, -0.3, 2.0) * size), position: Vector3::new(0.0, 0.0, size) };
        let position = FloatingPosition::of(&pose);
        let buoyancy = wetted.buoyancy(&mesh, &position);
        let wrench = distance(&buoyancy.wrench(SPECIFIC_WEIGHT), &linear.wrench(&position, SPECIFIC_WEIGHT));
        let energy = buoyancy.potential_energy(SPECIFIC_WEIGHT) - linear.potential_energy(&position, SPECIFIC_WEIGHT);
        [wrench, (energy - reference).abs()]
    };
    let (coarse, fine) = (differences(2e-3), differences(1e-3));
    assert!(fine[0] < 1e-5 * SPECIFIC_WEIGHT * linear.volume);
    for (order, (coarse, fine)) in [2, 3].into_iter().zip(coarse.into_iter().zip(fine)) {
        let ratio = coarse / fine / 2.0_f64.powi(order);
        assert!((0.95..1.05).contains(&ratio), "order {order}: {ratio}");
    }
}

fn unit_box() -> (Vec<[f64; 3]>, Vec<[usize; 3]>) {
    box_triangles([1.0, 2.0, 3.0], 2)
}

#[test]
fn the_error_of_every_invalid_mesh_contains_the_defect_and_its_position() {
    let (vertices, triangles) = unit_box();
    assert_eq!(HullMesh::new(vec![], vec![]), Err(MeshError::TooFew { triangles: 0 }));

    let mut bad = vertices.clone();
    bad[3][2] = f64::INFINITY;
    let expected = MeshError::NotFinite { vertex: 3, axis: 'z', found: f64::INFINITY };
    assert_eq!(HullMesh::new(bad, triangles.clone()), Err(expected));

    let mut bad = triangles.clone();
    bad[5][1] = 26;
    let error = HullMesh::new(vertices.clone(), bad).unwrap_err();
    assert_eq!(error, MeshError::NoSuchVertex { triangle: 5, found: 26, vertices: 26 });
    assert_eq!(error.to_string(), "triangle 5 of the hull: corner 26, allowed: 0 to 25");

    let mut bad = triangles.clone();
    let gone = bad.remove(7).map(|i| vertices[i]);
    let Err(MeshError::Open { edges, from_m, to_m }) = HullMesh::new(vertices.clone(), bad) else {
        panic!("a hole is found");
    };
    assert!(edges == 3 && gone.contains(&from_m) && gone.contains(&to_m));

    let mut bad = triangles.clone();
    bad[7].swap(0, 1);
    let Err(MeshError::Inconsistent { edges, from_m, to_m }) = HullMesh::new(vertices.clone(), bad) else {
        panic!("a triangle that looks in is found");
    };
    assert!(edges == 3 && gone.contains(&from_m) && gone.contains(&to_m));

    let inward: Vec<[usize; 3]> = triangles.iter().map(|&[a, b, c]| [a, c, b]).collect();
    let Err(MeshError::Inward { volume_m3, .. }) = HullMesh::new(vertices.clone(), inward.clone()) else {
        panic!("inward normals are found");
    };
    close(volume_m3, -48.0, 1e-14);

    let flat = vertices.iter().map(|r| [r[0], r[1], 0.5]).collect();
    assert!(matches!(HullMesh::new(flat, triangles.clone()), Err(MeshError::NoVolume { .. })));

    // A catamaran of which one hull is inside out.
    let second = |r: &[f64; 3]| [r[0], r[1] + 10.0, r[2]];
    let both: Vec<[f64; 3]> = vertices.iter().copied().chain(vertices.iter().map(second)).collect();
    let beside = |triangles: &[[usize; 3]]| -> Vec<[usize; 3]> {
        triangles.iter().map(|corners| corners.map(|i| i + vertices.len())).collect()
    };
    let catamaran = HullMesh::new(both.clone(), [triangles.clone(), beside(&triangles)].concat()).unwrap();
    close(catamaran.volume(), 96.0, 1e-14);
    let error = HullMesh::new(both, [triangles, beside(&inward)].concat()).unwrap_err();
    assert!(matches!(error, MeshError::Inward { at_m, .. } if at_m[1] > 5.0), "{error}");
}

#[test]
fn a_hull_above_the_water_has_no_hydrostatics() {
    let high = barge(20.0, 10.0, 4.0, -0.5, 1);
    let error = LinearHydrostatics::of_mesh(&high).unwrap_err();
    assert_eq!(error, StabilityError::AboveWater { lowest_m: 0.5 });
}
