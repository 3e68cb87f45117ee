//! Hull meshes whose hydrostatics have closed forms, and one without symmetry.

use kingpost::scalar::{Dual, Scalar};
use kingpost::sea::hull::HullMesh;
use kingpost::spatial::{Frame, Matrix3, Vector3, Wrench, exp};

/// rho g of sea water, N/m^3.
pub const SPECIFIC_WEIGHT: f64 = 1025.0 * 9.80665;

/// The faces of a box with these half-sides about its centre, each as `divisions` x `divisions`
/// squares of two triangles; vertices on its edges are one.
pub fn box_triangles(half_sides: [f64; 3], divisions: usize) -> (Vec<[f64; 3]>, Vec<[usize; 3]>) {
    let (mut vertices, mut triangles) = (Vec::<[i64; 3]>::new(), Vec::new());
    let n = divisions as i64;
    for axis in 0..3 {
        for side in [0, n] {
            // (axis, second, third) is right-handed: the squares run counter-clockwise on the far side.
            let (second, third) = ((axis + 1) % 3, (axis + 2) % 3);
            let mut vertex = |i: i64, j: i64| {
                let mut place = [side; 3];
                (place[second], place[third]) = (i, j);
                vertices.iter().position(|v| *v == place).unwrap_or_else(|| {
                    vertices.push(place);
                    vertices.len() - 1
                })
            };
            for (i, j) in (0..n).flat_map(|i| (0..n).map(move |j| (i, j))) {
                let [a, b, c, d] = [vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)];
                let (b, d) = if side == n { (b, d) } else { (d, b) };
                triangles.extend([[a, b, c], [a, c, d]]);
            }
        }
    }
    let metres = |place: [i64; 3]| core::array::from_fn(|k| half_sides[k] * (2 * place[k] - n) as f64 / n as f64);
    (vertices.into_iter().map(metres).collect(), triangles)
}

/// A box of this length, beam and depth, its origin amidships at this height over the keel, m.
pub fn barge(length: f64, beam: f64, depth: f64, origin_over_keel: f64, divisions: usize) -> HullMesh {
    let (mut vertices, triangles) = box_triangles([length / 2.0, beam / 2.0, depth / 2.0], divisions);
    for r in &mut vertices {
        r[2] += depth / 2.0 - origin_over_keel;
    }
    HullMesh::new(vertices, triangles).expect("a box is a hull")
}

/// A sphere about its centre: a cube's mesh blown up, `divisions` to an edge.
pub fn sphere(radius: f64, divisions: usize) -> HullMesh {
    let (mut vertices, triangles) = box_triangles([1.0; 3], divisions);
    for r in &mut vertices {
        *r = (Vector3(r.map(|x| libm::tan(core::f64::consts::FRAC_PI_4 * x))).direction() * radius).0;
    }
    HullMesh::new(vertices, triangles).expect("a sphere is a hull")
}

/// A hull with no symmetry fore and aft: a box whose bottom rises and narrows forward, its origin
/// amidships on the bottom.
pub fn ship(length: f64, beam: f64, depth: f64, divisions: usize) -> HullMesh {
    let (mut vertices, triangles) = box_triangles([length / 2.0, beam / 2.0, depth / 2.0], divisions);
    for r in &mut vertices {
        let [x, z] = [r[0] / length + 0.5, r[2] / depth + 0.5];
        let fine = x * x * x;
        r[1] *= (1.0 - 0.7 * fine) * (0.6 + 0.4 * z);
        r[2] = depth * (z + (1.0 - z) * 0.5 * fine);
    }
    HullMesh::new(vertices, triangles).expect("a hull")
}

/// Returns the hull in another frame.
pub fn moved(mesh: &HullMesh, mesh_in_frame: &Frame) -> HullMesh {
    let vertices = mesh.vertices().iter().map(|&r| mesh_in_frame.point(r).0).collect();
    let triangles = mesh.triangles().map(|corners| corners.map(|i| i as usize)).collect();
    HullMesh::new(vertices, triangles).expect("a hull that is moved stays one")
}

/// A hull without symmetry fore and aft or from side to side, its origin off its middle.
pub fn skew_ship() -> HullMesh {
    let place = Frame { rotation: exp(Vector3::new(0.1, -0.05, 0.3)), position: Vector3::new(3.0, 0.7, -1.5) };
    moved(&ship(30.0, 9.0, 6.0, 4), &place)
}

/// Somewhere on the sea, turned by this rotation vector.
pub fn place(turn: [f64; 3], height: f64) -> Frame {
    Frame { rotation: exp(Vector3(turn)), position: Vector3::new(11.0, -7.0, height) }
}

/// Returns the pose after a small translation and rotation in its axes, as six variables.
pub fn varied(pose: &Frame) -> Frame<Dual<6>> {
    let variable = |first: usize| Vector3([0, 1, 2].map(|k| Dual::variable(0.0, first + k)));
    let constant = Frame {
        rotation: Matrix3(pose.rotation.0.map(|row| row.map(Dual::constant))),
        position: Vector3::constant(pose.position.0),
    };
    constant.times(&Frame { rotation: exp(variable(3)), position: variable(0) })
}

/// Returns force and moment as one list; the moment is divided by 10 m, so that both have similar size.
pub fn entries(wrench: &Wrench) -> [f64; 6] {
    let ([fx, fy, fz], [mx, my, mz]) = (wrench.force.0, wrench.moment.0);
    [fx, fy, fz, mx / 10.0, my / 10.0, mz / 10.0]
}

pub fn distance(a: &Wrench, b: &Wrench) -> f64 {
    entries(a).iter().zip(entries(b)).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

/// The box of the closed forms: 20 x 10 x 4 m at draught 2 m, origin amidships on the water plane.
pub fn box_barge(divisions: usize) -> HullMesh {
    barge(20.0, 10.0, 4.0, 2.0, divisions)
}

/// Checks a number against another, relative to that one.
pub fn close(found: f64, expected: f64, relative: f64) {
    let allowed = relative * expected.abs().max(1e-300);
    assert!((found - expected).abs() <= allowed, "{found} instead of {expected}");
}

/// Checks a number against another.
pub fn near(found: f64, expected: f64, allowed: f64) {
    assert!((found - expected).abs() <= allowed, "{found} instead of {expected}");
}
