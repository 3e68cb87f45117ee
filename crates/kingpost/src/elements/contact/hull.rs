//! Convex hulls of points, and their distance from a point.

use parry3d_f64::math::Vector;
use parry3d_f64::transformation::try_convex_hull;

use super::length::{SURFACE_M, choose, length};
use crate::scalar::Scalar;
use crate::spatial::Vector3;

/// Smallest thickness of a hull, as a share of its size: far above the rounding with which faces are found.
const LEAST_THICKNESS: f64 = 1e-6;

/// Largest distance of a point outside a face, as a share of the hull's size: rounding of the face's normal.
const FLATNESS: f64 = 1e-9;

/// Cosine of the angle between two triangles, 0.03 degrees, up to which the line between them is no edge: the corners of one
/// face, in numbers of four digits.
const FLAT: f64 = 1.0 - 1.5e-7;

/// A convex hull of points.
#[derive(Clone, Debug)]
pub struct Hull<S = f64> {
    /// Its corners, m.
    pub corners: Vec<Vector3<S>>,
    /// The corners at both ends of each edge.
    pub edges: Vec<[usize; 2]>,
    /// The sides of all triangles: edges, and lines across faces of more than three corners.
    sides: Vec<[usize; 2]>,
    faces: Vec<Triangle<S>>,
}

/// A triangle of the surface: the points p of its plane have `normal . p = offset`.
#[derive(Clone, Debug)]
struct Triangle<S> {
    normal: Vector3<S>,
    offset: S,
    /// In the order of their angle about the normal.
    corners: [usize; 3],
}

impl<S: Scalar> Hull<S> {
    /// Returns the hull of points; `None` for points near one plane, and if the lanes' hulls have different faces.
    pub fn new(points: &[Vector3<S>]) -> Option<Self> {
        let plain: Vec<Vector> = points.iter().map(|p| Vector::from_array(p.0.map(S::value))).collect();
        let size = thickness(&plain).filter(|[size, thickness]| *thickness > size * LEAST_THICKNESS)?[0];
        let (corners, triangles) = try_convex_hull(&plain).ok()?;
        let given = |corner: &Vector| plain.iter().position(|point| point == corner).map(|i| points[i]);
        let corners = corners.iter().map(given).collect::<Option<Vec<_>>>()?;
        let faces: Vec<_> = triangles.iter().map(|t| Triangle::new(&corners, t.map(|i| i as usize))).collect();
        let is_outside = |face: &Triangle<S>, point: &Vector3<S>| !face.height(*point).all(|x| x <= size * FLATNESS);
        if faces.iter().any(|face| points.iter().any(|point| is_outside(face, point))) {
            return None;
        }
        let on = |[a, b]: [usize; 2]| {
            faces.iter().filter(move |face| face.corners.contains(&a) && face.corners.contains(&b))
        };
        let all = faces.iter().flat_map(|face| face.sides()).filter(|[a, b]| a < b);
        let sides: Vec<_> = all.collect();
        let is_sharp = |side: &[usize; 2]| {
            let normals: Vec<_> = on(*side).map(|face| face.normal).collect();
            !normals.windows(2).all(|pair| pair[0].dot(pair[1]).value() > FLAT)
        };
        let edges = sides.iter().copied().filter(is_sharp).collect();
        Some(Self { corners, edges, sides, faces })
    }

    /// Returns the distance of a point from the surface, m, negative inside, and its gradient.
    pub(super) fn distance(&self, point: Vector3<S>) -> (S, Vector3<S>) {
        let mut inside = S::constant(f64::MIN);
        let mut normal = Vector3::zero();
        for face in &self.faces {
            let height = face.height(point);
            normal = Vector3(choose(inside, height, face.normal.0, normal.0));
            inside = inside.select_less(height, || height, || inside);
        }
        if inside.all(|inside| inside < SURFACE_M) {
            return (inside, normal);
        }
        let off = self.off(point);
        let away = length(off);
        let (surface, outward) = (S::constant(SURFACE_M), off * (S::ONE / away));
        let distance = inside.select_less(surface, || inside, || away);
        (distance, Vector3(choose(inside, surface, normal.0, outward.0)))
    }

    /// Returns the vector to a point outside from the nearest point of the surface.
    fn off(&self, point: Vector3<S>) -> Vector3<S> {
        let mut nearest = point - self.corners[0];
        let mut least = nearest.norm_squared();
        let mut compare = |off: Vector3<S>, squared: S| {
            nearest = Vector3(choose(squared, least, off.0, nearest.0));
            least = squared.select_less(least, || squared, || least);
        };
        for [a, b] in &self.sides {
            let (from, along) = (point - self.corners[*a], self.corners[*b] - self.corners[*a]);
            let share = (from.dot(along) / along.norm_squared()).clipped(S::ZERO, S::ONE);
            let off = from - along * share;
            compare(off, off.norm_squared());
        }
        for face in &self.faces {
            let height = face.height(point);
            let beside = face.beside(&self.corners, point);
            let far = S::constant(f64::MAX);
            let squared = beside.select_below(0.0, || far, || height.select_below(0.0, || far, || height * height));
            compare(face.normal * height, squared);
        }
        nearest
    }
}

impl<S: Scalar> Triangle<S> {
    fn new(points: &[Vector3<S>], corners: [usize; 3]) -> Self {
        let [a, b, c] = corners.map(|i| points[i]);
        let area = (b - a).cross(c - a);
        let normal = area * (S::ONE / length(area));
        Self { normal, offset: normal.dot(a), corners }
    }

    /// Returns the two corners of each side, in order.
    fn sides(&self) -> [[usize; 2]; 3] {
        let [a, b, c] = self.corners;
        [[a, b], [b, c], [c, a]]
    }

    fn height(&self, point: Vector3<S>) -> S {
        self.normal.dot(point) - self.offset
    }

    /// Returns a number that is negative if the point is beside the face.
    fn beside(&self, points: &[Vector3<S>], point: Vector3<S>) -> S {
        self.sides().iter().fold(S::constant(f64::MAX), |least, [a, b]| {
            let inward = self.normal.cross(points[*b] - points[*a]).dot(point - points[*a]);
            inward.select_less(least, || inward, || least)
        })
    }
}

/// Returns the largest distance between a point and the first, and the distance of a point from the plane through three that
/// are far apart.
fn thickness(points: &[Vector]) -> Option<[f64; 2]> {
    let first = *points.first()?;
    let farthest = |measure: &dyn Fn(Vector) -> f64| {
        points.iter().map(|p| *p - first).fold((Vector::ZERO, 0.0), |(best, most), off| {
            if measure(off) > most { (off, measure(off)) } else { (best, most) }
        })
    };
    let (along, size) = farthest(&|off| off.length());
    let (across, area) = farthest(&|off| along.cross(off).length());
    let normal = along.cross(across);
    let (_, volume) = farthest(&|off| normal.dot(off).abs());
    let thickness = [area / size, volume / area].into_iter().fold(f64::MAX, f64::min);
    Some([size, if size > 0.0 && area > 0.0 { thickness } else { 0.0 }])
}
