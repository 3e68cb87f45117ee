//! Convex hulls of points, and their distance from a point.

use parry3d_f64::math::Vector;
use parry3d_f64::transformation::try_convex_hull;

use super::length::{SURFACE_M, choose, length};
use crate::scalar::Scalar;
use crate::spatial::Vector3;

/// Smallest thickness of a hull, as a share of its size: a plate of 10 m by 10 mm, far above `FLATNESS`.
const LEAST_THICKNESS: f64 = 1e-3;

/// Largest distance of a face's corners from its plane, as a share of the hull's size: corners in numbers of four digits.
const FLATNESS: f64 = 1e-4;

/// A convex hull of points.
#[derive(Clone, Debug)]
pub struct ConvexHull<S = f64> {
    /// Its corners, m.
    pub corners: Vec<Vector3<S>>,
    /// The corners at both ends of each edge.
    pub edges: Vec<[usize; 2]>,
    faces: Vec<HullFace<S>>,
}

/// A face: the points p of its plane have `normal . p = offset`.
#[derive(Clone, Debug)]
struct HullFace<S> {
    normal: Vector3<S>,
    offset: S,
    /// In the order of their angle about the normal.
    corners: Vec<usize>,
}

impl<S: Scalar> ConvexHull<S> {
    /// Returns the hull of points; `None` for points near one plane, and if the lanes' hulls have different faces.
    pub fn new(points: &[Vector3<S>]) -> Option<Self> {
        let plain: Vec<Vector> = points.iter().map(|p| Vector::from_array(p.0.map(S::value))).collect();
        let [size, thickness] = extent(&plain)?;
        if thickness < size * LEAST_THICKNESS {
            return None;
        }
        // Of points that are one but for `FLATNESS`, the first.
        let is_new = |&i: &usize| plain[..i].iter().all(|other| (plain[i] - other).length() > size * FLATNESS);
        let kept: Vec<usize> = (0..plain.len()).filter(is_new).collect();
        let plain: Vec<Vector> = kept.iter().map(|&i| plain[i]).collect();
        let polygons = polygons(&plain, size)?;
        let mut used: Vec<usize> = polygons.iter().flatten().copied().collect();
        used.sort_unstable();
        used.dedup();
        let corners: Vec<_> = used.iter().map(|&i| points[kept[i]]).collect();
        let place = |i: usize| used.binary_search(&i).ok();
        let faces = polygons.iter().map(|polygon| {
            Some(HullFace::new(&corners, polygon.iter().map(|&i| place(i)).collect::<Option<Vec<_>>>()?))
        });
        let faces = faces.collect::<Option<Vec<_>>>()?;
        let sides: Vec<_> = faces.iter().flat_map(HullFace::sides).collect();
        let edges: Vec<_> = sides.iter().copied().filter(|[a, b]| a < b).collect();
        // Each edge is a side of two faces, once in each direction, and Euler's formula holds.
        let is_closed = edges.iter().all(|[a, b]| sides.iter().filter(|side| **side == [*b, *a]).count() == 1)
            && sides.len() == 2 * edges.len()
            && corners.len() + faces.len() == edges.len() + 2;
        let is_inside = |face: &HullFace<S>| points.iter().all(|p| face.height(*p).all(|x| x <= size * FLATNESS));
        (is_closed && faces.iter().all(is_inside)).then_some(Self { corners, edges, faces })
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
        for [a, b] in &self.edges {
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

impl<S: Scalar> HullFace<S> {
    fn new(points: &[Vector3<S>], corners: Vec<usize>) -> Self {
        let first = points[corners[0]];
        let area = corners[1..]
            .windows(2)
            .fold(Vector3::zero(), |sum, pair| sum + (points[pair[0]] - first).cross(points[pair[1]] - first));
        let normal = area * (S::ONE / length(area));
        let sum = corners.iter().fold(S::ZERO, |sum, &i| sum + normal.dot(points[i]));
        Self { normal, offset: sum / S::constant(corners.len() as f64), corners }
    }

    fn height(&self, point: Vector3<S>) -> S {
        self.normal.dot(point) - self.offset
    }

    /// Returns the two corners of each side, in order.
    fn sides(&self) -> Vec<[usize; 2]> {
        let next = self.corners.iter().cycle().skip(1);
        self.corners.iter().zip(next).map(|(a, b)| [*a, *b]).collect()
    }

    /// Returns a number that is negative if the point is beside the face.
    fn beside(&self, points: &[Vector3<S>], point: Vector3<S>) -> S {
        let next = self.corners.iter().cycle().skip(1);
        self.corners.iter().zip(next).fold(S::constant(f64::MAX), |least, (a, b)| {
            let inward = self.normal.cross(points[*b] - points[*a]).dot(point - points[*a]);
            inward.select_less(least, || inward, || least)
        })
    }
}

/// Returns the corners of each face, counterclockwise from outside: triangles in one plane are one face.
fn polygons(points: &[Vector], size: f64) -> Option<Vec<Vec<usize>>> {
    let (corners, triangles) = try_convex_hull(points).ok()?;
    let flat = size * FLATNESS;
    let mut planes: Vec<(Vector, f64)> = Vec::new();
    let mut areas: Vec<_> = triangles.iter().map(|t| t.map(|i| corners[i as usize])).collect();
    // The largest triangle of a face has the best normal.
    let area = |t: &[Vector; 3]| (t[1] - t[0]).cross(t[2] - t[0]);
    areas.sort_by(|a, b| area(b).length().total_cmp(&area(a).length()));
    for triangle in areas {
        let Some(normal) = area(&triangle).try_normalize() else { continue };
        let is_in = |(normal, offset): &(Vector, f64)| triangle.iter().all(|p| (normal.dot(*p) - offset).abs() <= flat);
        if !planes.iter().any(is_in) {
            planes.push((normal, normal.dot(triangle[0])));
        }
    }
    planes.iter().map(|(normal, offset)| polygon(points, (*normal, *offset), flat)).collect()
}

/// Returns the corners of the convex polygon of all points in a plane: each next one has all the others on its left.
fn polygon(points: &[Vector], (normal, offset): (Vector, f64), flat: f64) -> Option<Vec<usize>> {
    let on: Vec<usize> = (0..points.len()).filter(|&i| (normal.dot(points[i]) - offset).abs() <= flat).collect();
    let start = *on.iter().max_by(|a, b| {
        let [a, b] = [points[**a].to_array(), points[**b].to_array()];
        a.partial_cmp(&b).unwrap_or(core::cmp::Ordering::Equal)
    })?;
    let mut found = vec![start];
    loop {
        let from = *found.last()?;
        let off = |i: usize| points[i] - points[from];
        let mut ahead = on.iter().copied().filter(|&i| off(i).length() > flat);
        let first = ahead.next()?;
        let next = ahead.fold(first, |best, i| {
            let turn = normal.dot(off(best).cross(off(i)));
            let along = flat * off(best).length().max(off(i).length());
            // Of points in one line, the farthest.
            if turn < -along || (turn <= along && off(i).length() > off(best).length()) { i } else { best }
        });
        if (points[next] - points[start]).length() <= flat {
            return (found.len() > 2).then_some(found);
        }
        if found.len() == on.len() {
            return None;
        }
        found.push(next);
    }
}

/// Returns the largest distance between a point and the first, and the smallest of the distances of a point from a line
/// through two and from the plane through three that are far apart.
fn extent(points: &[Vector]) -> Option<[f64; 2]> {
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
    (size > 0.0 && area > 0.0 && volume.is_finite()).then(|| [size, (area / size).min(volume / area)])
}
