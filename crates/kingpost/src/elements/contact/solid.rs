//! The distance of a point from a solid.

use super::hull::ConvexHull;
use super::length::{SURFACE_M, choose, length, root};
use crate::model::Axis;
use crate::scalar::Scalar;
use crate::spatial::Vector3;

/// A solid that spots touch, in its own axes about its centre.
#[derive(Clone, Debug)]
pub enum ContactSolid<S = f64> {
    /// The half space below a plane through the origin; the unit normal points out of it.
    Plane {
        /// Unit vector.
        normal: Vector3<S>,
    },
    /// A cuboid.
    Box {
        /// Half of its edge lengths along x, y, z, m.
        half: [S; 3],
    },
    /// A circular cylinder.
    Cylinder {
        /// m.
        radius: S,
        /// Half of its length, m.
        half_length: S,
        /// The axis that it lies along.
        axis: Axis,
    },
    /// A ball.
    Sphere {
        /// m.
        radius: S,
    },
    /// A circular cylinder with round ends.
    Capsule {
        /// m.
        radius: S,
        /// Half of the distance between the centres of its ends, m.
        half_length: S,
        /// The axis that it lies along.
        axis: Axis,
    },
    /// A circular cone below its tip, which is at the origin and points along z.
    Cone {
        /// Sine and cosine of the angle between axis and side.
        half_angle: (S, S),
        /// m.
        length: S,
    },
    /// A convex hull of points.
    Convex(ConvexHull<S>),
}

impl<S: Scalar> ContactSolid<S> {
    /// Returns the distance of a point from the surface, m, negative inside, and its gradient, the outward unit normal
    /// at the nearest point. Inside, the nearest face counts; of two equally near faces, either.
    ///
    /// ```
    /// use kingpost::elements::contact::ContactSolid;
    /// use kingpost::spatial::Vector3;
    /// let deck = ContactSolid::Box { half: [10.0, 5.0, 1.0] };
    /// let (distance, normal) = deck.distance(Vector3::new(13.0, 0.0, 5.0));
    /// assert_eq!((distance, normal.0), (5.0, [0.6, 0.0, 0.8]));
    /// assert_eq!(deck.distance(Vector3::new(1.0, 2.0, 0.9)).1.0, [0.0, 0.0, 1.0]);
    /// ```
    pub fn distance(&self, point: Vector3<S>) -> (S, Vector3<S>) {
        match self {
            Self::Plane { normal } => (normal.dot(point), *normal),
            Self::Sphere { radius } => {
                let away = length(point);
                (away - *radius, point * (S::ONE / away))
            }
            Self::Capsule { radius, half_length, axis } => {
                let mut off = point;
                off[*axis as usize] -= point[*axis as usize].clipped(-*half_length, *half_length);
                let away = length(off);
                (away - *radius, off * (S::ONE / away))
            }
            Self::Cone { half_angle, length: along } => {
                let across = Vector3([point[0], point[1], S::ZERO]);
                let off = length(across);
                let (distance, [radial, axial]) = from_cone(*half_angle, *along, [off, point[2]]);
                let mut normal = across * (radial / off);
                normal[2] = axial;
                (distance, normal)
            }
            Self::Convex(hull) => hull.distance(point),
            Self::Box { half } => {
                let signs = point.0.map(sign);
                let (distance, gradient) =
                    from_corner(core::array::from_fn::<_, 3, _>(|i| point[i] * signs[i] - half[i]));
                (distance, Vector3(core::array::from_fn(|i| gradient[i] * signs[i])))
            }
            Self::Cylinder { radius, half_length, axis } => {
                let along = *axis as usize;
                let side = sign(point[along]);
                let mut across = point;
                across[along] = S::ZERO;
                let off = length(across);
                let (distance, [radial, axial]) = from_corner([off - *radius, point[along] * side - *half_length]);
                let mut normal = across * (radial / off);
                normal[along] = axial * side;
                (distance, normal)
            }
        }
    }
}

/// Returns the distance from the orthant of non-positive coordinates, and its gradient.
fn from_corner<S: Scalar, const N: usize>(beyond: [S; N]) -> (S, [S; N]) {
    let mut nearest = beyond[0];
    let mut faces = [S::ZERO; N];
    faces[0] = S::ONE;
    for i in 1..N {
        let is_nearer = nearest.select_less(beyond[i], || S::ONE, || S::ZERO);
        nearest = nearest.select_less(beyond[i], || beyond[i], || nearest);
        faces[..i].iter_mut().for_each(|face| *face = *face * (S::ONE - is_nearer));
        faces[i] = is_nearer;
    }
    let outside = beyond.map(|x| x.select_below(0.0, || S::ZERO, || x));
    let squared = outside.iter().fold(S::ZERO, |sum, x| sum + *x * *x);
    let away = root(squared);
    let choose = |inside: S, outside: S| squared.select_below(f64::MIN_POSITIVE, || inside, || outside);
    (choose(nearest, away), core::array::from_fn(|i| choose(faces[i], outside[i] / away)))
}

fn sign<S: Scalar>(x: S) -> S {
    x.select_below(0.0, || -S::ONE, || S::ONE)
}

/// Returns the distance from a cone's section, with its gradient: across the axis and along it.
fn from_cone<S: Scalar>((sin, cos): (S, S), length: S, [across, along]: [S; 2]) -> (S, [S; 2]) {
    let (side, base) = (across * cos + along * sin, -along - length);
    let on_side = (across * sin - along * cos).clipped(S::ZERO, length / cos);
    let from_side = [across - on_side * sin, along + on_side * cos];
    let from_base = [across - across.clipped(S::ZERO, length * sin / cos), -base];
    let squares = [from_side, from_base].map(|[x, z]| x * x + z * z);
    let squared = squares[0].select_less(squares[1], || squares[0], || squares[1]);
    let away = root(squared);
    let outward = choose(squares[0], squares[1], from_side, from_base).map(|x| x / away);
    let inside = base.select_less(side, || side, || base);
    let inward = choose(base, side, [cos, sin], [S::ZERO, -S::ONE]);
    let surface = S::constant(SURFACE_M);
    (inside.select_less(surface, || inside, || away), choose(inside, surface, inward, outward))
}
