//! The distance between two solids.

use parry3d_f64::math::{Matrix, Pose, Rotation, Vector};
use parry3d_f64::query::details::contact_support_map_support_map_with_params;
use parry3d_f64::query::gjk::{GJKResult, VoronoiSimplex};
use parry3d_f64::shape::SupportMap;

use super::length::length;
use super::solid::ContactSolid;
use crate::scalar::Scalar;
use crate::spatial::{Frame, Matrix3, Vector3};

/// Numbers of a solid's core, but for hulls.
const FEW: usize = 3;

/// Numbers of a hull's core: 32 corners.
const MANY: usize = 96;

/// Largest distance of a corner from the supporting plane that it is on, as a share of the size: GJK's own error.
const ON_PLANE: f64 = 1e-6;

impl<S: Scalar> ContactSolid<S> {
    /// Returns the distance of another solid from this one, m; if they overlap, the negative of the shortest displacement
    /// that parts them. `seen` is the other's frame in this one's axes.
    ///
    /// The distance is the largest gap `-h_1(n) - h_2(-n)` between the supporting planes of both over all unit normals
    /// n. The best n, and the point of the other solid that is nearest, come from GJK and EPA on plain numbers. The gap at
    /// its maximum has the derivatives of the distance with n and that point held fixed, each in its solid.
    ///
    /// ```
    /// use kingpost::elements::contact::ContactSolid;
    /// use kingpost::spatial::{Frame, Vector3};
    /// let deck = ContactSolid::Box { half: [10.0, 5.0, 1.0] };
    /// let ball = ContactSolid::Sphere { radius: 0.5 };
    /// let distance = deck.distance_to(&ball, &Frame::translation(Vector3::new(13.0, 0.0, 5.0)));
    /// assert!((distance - 4.5).abs() < 1e-15);
    /// ```
    pub fn distance_to(&self, other: &Self, seen: &Frame<S>) -> S {
        let Nearest { normal, point, shares } = match (self, other) {
            (Self::Plane { normal }, _) => {
                return normal.dot(seen.position) - other.reach(seen.rotation.transpose_times(-*normal));
            }
            (_, Self::Plane { normal }) => {
                let out = seen.rotation * *normal;
                return -out.dot(seen.position) - self.reach(-out);
            }
            _ => self.separating(other, seen),
        };
        let plain = Matrix3::from_fn(|i, j| seen.rotation.row(i)[j].plain());
        let turning = normal.dot(seen.rotation * point - plain * point);
        let theirs = plain.transpose_times(-normal);
        let reaches = self.reach_at(normal, &shares[0]) + other.reach_at(theirs, &shares[1]);
        normal.dot(seen.position) - reaches + turning
    }

    /// Returns the support function along a vector without derivatives. That of a hull has the derivatives of the nearest
    /// point: of each corner by its share in it, also where that point is within an edge or a face.
    fn reach_at(&self, along: Vector3<S>, shares: &[S]) -> S {
        let Self::Convex(hull) = self else { return self.reach(along) };
        hull.corners.iter().zip(shares).fold(self.reach(along).plain(), |sum, (corner, share)| {
            let reach = along.dot(*corner);
            sum + *share * (reach - reach.plain())
        })
    }

    /// Returns the support function: the largest component of the solid's points along a unit vector, m.
    fn reach(&self, along: Vector3<S>) -> S {
        let size = |x: S| x.select_below(0.0, || -x, || x);
        let across = |axis: usize| {
            let mut across = along;
            across[axis] = S::ZERO;
            length(across)
        };
        match self {
            Self::Plane { .. } => S::ZERO,
            Self::Sphere { radius } => *radius,
            Self::Box { half } => size(along[0]) * half[0] + size(along[1]) * half[1] + size(along[2]) * half[2],
            Self::Capsule { radius, half_length, axis } => size(along[*axis as usize]) * *half_length + *radius,
            Self::Cylinder { radius, half_length, axis } => {
                size(along[*axis as usize]) * *half_length + across(*axis as usize) * *radius
            }
            Self::Cone { half_angle: (sin, cos), length } => {
                let base = *length * (across(2) * *sin / *cos - along[2]);
                base.select_below(0.0, || S::ZERO, || base)
            }
            Self::Convex(hull) => hull.corners.iter().fold(S::constant(f64::MIN), |most, corner| {
                let reach = along.dot(*corner);
                most.select_less(reach, || reach, || most)
            }),
        }
    }

    /// Returns the two parallel planes between which the gap is largest.
    fn separating(&self, other: &Self, seen: &Frame<S>) -> Nearest<S> {
        let few = !matches!((self, other), (Self::Convex(_), _) | (_, Self::Convex(_)));
        let room = if few { FEW } else { MANY };
        let mut numbers: Vec<S> = (0..3).flat_map(|j| seen.rotation.column(j).0).chain(seen.position.0).collect();
        let kinds = [self, other].map(|solid| {
            let (kind, mut core) = solid.core();
            core.resize(room, S::ZERO);
            numbers.append(&mut core);
            kind
        });
        let found: Vec<S> = if few {
            S::from_values::<{ 12 + 2 * FEW }, 6>(core::array::from_fn(|i| numbers[i]), &|given| nearest(kinds, &given))
                .to_vec()
        } else {
            let numbers = core::array::from_fn(|i| numbers[i]);
            S::from_values::<{ 12 + 2 * MANY }, { 6 + 2 * MANY / 3 }>(numbers, &|given| nearest(kinds, &given)).to_vec()
        };
        let shares = [0, 1].map(|k| found[6..].chunks(MANY / 3).nth(k).map(<[S]>::to_vec).unwrap_or_default());
        Nearest { normal: Vector3::from_slice(&found), point: Vector3::from_slice(&found[3..]), shares }
    }

    /// Returns the solid without the ball that is added all around it.
    fn core(&self) -> (CoreKind, Vec<S>) {
        match self {
            Self::Plane { .. } | Self::Sphere { .. } => (CoreKind::Point, Vec::new()),
            Self::Box { half } => (CoreKind::Cuboid, half.to_vec()),
            Self::Capsule { half_length, axis, .. } => (CoreKind::Round(*axis as usize), vec![S::ZERO, *half_length]),
            Self::Cylinder { radius, half_length, axis } => {
                (CoreKind::Round(*axis as usize), vec![*radius, *half_length])
            }
            Self::Cone { half_angle: (sin, cos), length } => (CoreKind::Cone, vec![*length * *sin / *cos, *length]),
            Self::Convex(hull) => {
                (CoreKind::Corners(hull.corners.len()), hull.corners.iter().flat_map(|corner| corner.0).collect())
            }
        }
    }
}

/// Two parallel planes that touch two solids, without derivatives.
struct Nearest<S> {
    /// Unit normal, out of the first.
    normal: Vector3<S>,
    /// The second's point on its plane, in its axes, m.
    point: Vector3<S>,
    /// Shares of the corners of each hull in its point on its plane.
    shares: [Vec<S>; 2],
}

/// The kind of a core, and how many corners or which axis it has.
#[derive(Clone, Copy)]
enum CoreKind {
    Point,
    Cuboid,
    Round(usize),
    Cone,
    Corners(usize),
}

/// A convex core in plain numbers.
struct Core<'a> {
    kind: CoreKind,
    numbers: &'a [f64],
}

impl SupportMap for Core<'_> {
    fn local_support_point(&self, dir: Vector) -> Vector {
        let signed = |size: f64, by: f64| if by < 0.0 { -size } else { size };
        let on_rim = |axis: usize, radius: f64| {
            let mut across = dir;
            across[axis] = 0.0;
            across.try_normalize().map_or(Vector::ZERO, |unit| unit * radius)
        };
        match (self.kind, self.numbers) {
            (CoreKind::Cuboid, &[x, y, z, ..]) => Vector::new(signed(x, dir.x), signed(y, dir.y), signed(z, dir.z)),
            (CoreKind::Round(axis), &[radius, half_length, ..]) => {
                let mut point = on_rim(axis, radius);
                point[axis] = signed(half_length, dir[axis]);
                point
            }
            (CoreKind::Cone, &[radius, length, ..]) => {
                let rim = on_rim(2, radius) - Vector::Z * length;
                if rim.dot(dir) > 0.0 { rim } else { Vector::ZERO }
            }
            (CoreKind::Corners(count), numbers) => {
                let corners = numbers.chunks_exact(3).take(count).map(Vector::from_slice);
                corners.reduce(|best, next| if next.dot(dir) > best.dot(dir) { next } else { best }).unwrap_or_default()
            }
            _ => Vector::ZERO,
        }
    }
}

/// Returns the unit normal between two cores and the nearest point of the other in its axes, by GJK, or by EPA if they overlap;
/// then, if there is room, the shares of the corners of both.
fn nearest<const N: usize>(kinds: [CoreKind; 2], given: &[f64]) -> [f64; N] {
    let (pose, cores) = given.split_at(12);
    let (own, others) = cores.split_at(cores.len() / 2);
    let [own, other] = [&Core { kind: kinds[0], numbers: own }, &Core { kind: kinds[1], numbers: others }];
    let [x, y, z, position] = [0, 3, 6, 9].map(|i| Vector::from_slice(&pose[i..i + 3]));
    let pose = Pose::from_parts(position, Rotation::from_mat3(&Matrix::from_cols(x, y, z)));
    let apart = [position.try_normalize().unwrap_or(Vector::Z), Vector::ZERO, Vector::ZERO];
    let [normal, point, of_own] = match (own.kind, other.kind) {
        (CoreKind::Point, CoreKind::Point) => apart,
        _ => {
            let mut simplex = VoronoiSimplex::new();
            match contact_support_map_support_map_with_params(&pose, own, other, f64::MAX, &mut simplex, None) {
                GJKResult::ClosestPoints(of_own, point, normal) if normal.is_finite() && point.is_finite() => {
                    [normal, pose.inverse_transform_point(point), of_own]
                }
                _ => apart,
            }
        }
    };
    let mut found = [0.0; N];
    found[..3].copy_from_slice(&normal.to_array());
    found[3..6].copy_from_slice(&point.to_array());
    let shares = [(own, normal, of_own), (other, pose.rotation.inverse() * -normal, point)];
    for (room, (core, normal, point)) in found[6..].chunks_mut(MANY / 3).zip(shares) {
        core.write_shares(normal, point, room);
    }
    found
}

impl Core<'_> {
    /// Writes the shares of the corners in the point of a supporting plane: of the three corners on that plane around the
    /// point, or two, or the one. Others have none.
    fn write_shares(&self, normal: Vector, point: Vector, room: &mut [f64]) {
        let CoreKind::Corners(count) = self.kind else { return };
        let corners: Vec<Vector> = self.numbers.chunks_exact(3).take(count).map(Vector::from_slice).collect();
        let heights: Vec<f64> = corners.iter().map(|corner| normal.dot(*corner)).collect();
        let top = heights.iter().copied().fold(f64::MIN, f64::max);
        let size = corners.iter().map(|corner| (*corner - point).length()).fold(0.0, f64::max);
        let on: Vec<usize> = (0..count).filter(|&i| top - heights[i] <= size * ON_PLANE).collect();
        let mut best = (f64::MIN, [(0, 0.0); 3]);
        for (k, &a) in on.iter().enumerate() {
            for (l, &b) in on.iter().enumerate().skip(k) {
                for &c in &on[l..] {
                    let shares = barycentric([corners[a], corners[b], corners[c]], point);
                    let there = corners[a] * shares[0] + corners[b] * shares[1] + corners[c] * shares[2];
                    // The triangle around the point, or the one that is nearest to be.
                    let least = shares.iter().copied().fold(0.0, f64::min) - (there - point).length() / size;
                    if least > best.0 {
                        best = (least, [(a, shares[0]), (b, shares[1]), (c, shares[2])]);
                    }
                }
            }
        }
        for (i, share) in best.1 {
            room[i] += share;
        }
    }
}

/// Returns the barycentric coordinates of the point of a triangle, or of a line or point, nearest to a point.
fn barycentric([a, b, c]: [Vector; 3], point: Vector) -> [f64; 3] {
    let (u, v, w) = (b - a, c - a, point - a);
    let area = u.cross(v);
    if let Some(scale) = Some(area.length_squared()).filter(|area| *area > 0.0) {
        let [of_b, of_c] = [w.cross(v), u.cross(w)].map(|part| part.dot(area) / scale);
        return [1.0 - of_b - of_c, of_b, of_c];
    }
    let along = if v.length_squared() > u.length_squared() { v } else { u };
    let share = if along.length_squared() > 0.0 { w.dot(along) / along.length_squared() } else { 0.0 };
    if along == v { [1.0 - share, 0.0, share] } else { [1.0 - share, share, 0.0] }
}
