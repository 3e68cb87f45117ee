//! Lines and arcs, and their points nearest to a solid.

use super::solid::ContactSolid;
use crate::scalar::Scalar;
use crate::spatial::{Frame, Vector3};

/// A curve, with the parameter t from -1 to 1.
#[derive(Clone, Copy, Debug)]
pub enum Curve<S = f64> {
    /// A straight line.
    Line {
        /// m.
        middle: Vector3<S>,
        /// From the middle to the end at t = 1, m.
        half: Vector3<S>,
    },
    /// An arc of a circle.
    Arc {
        /// Centre of the circle, m.
        centre: Vector3<S>,
        /// From the centre to the middle of the arc, m.
        across: Vector3<S>,
        /// From the centre, a quarter turn after the middle, m.
        along: Vector3<S>,
        /// Angle from the middle to an end, rad.
        half_angle: S,
    },
}

/// Halvings of the interval of t: to 5e-7, from which the tangents at both ends give the minimum to 1e-13.
const HALVINGS: usize = 22;

/// The point of a curve nearest to a solid.
#[derive(Clone, Copy, Debug)]
pub struct Approach<S> {
    /// m.
    pub point: Vector3<S>,
    /// Distance with the crown, m.
    pub distance: S,
    /// Gradient of that distance by the curve's position. A unit vector, but for a line that crosses an edge inside the
    /// solid: there it is the mean of the normals of two faces that is perpendicular to the line.
    pub gradient: Vector3<S>,
}

/// A point of the curve with the distance and its slope along t.
#[derive(Clone, Copy)]
struct CurvePoint<S> {
    point: Vector3<S>,
    distance: S,
    gradient: Vector3<S>,
    slope: S,
}

impl<S: Scalar> Curve<S> {
    /// Returns the curve in the axes in which `seen` is its frame.
    pub(super) fn seen(&self, seen: &Frame<S>) -> Self {
        match *self {
            Self::Line { middle, half } => Self::Line { middle: seen.point(middle), half: seen.rotation * half },
            Self::Arc { centre, across, along, half_angle } => Self::Arc {
                centre: seen.point(centre),
                across: seen.rotation * across,
                along: seen.rotation * along,
                half_angle,
            },
        }
    }

    /// Returns the point at t and its derivative by t.
    pub fn at(&self, t: S) -> (Vector3<S>, Vector3<S>) {
        match *self {
            Self::Line { middle, half } => (middle + half * t, half),
            Self::Arc { centre, across, along, half_angle } => {
                let (sin, cos) = (t * half_angle).sin_cos();
                (centre + across * cos + along * sin, (along * cos - across * sin) * half_angle)
            }
        }
    }

    /// Returns the point with the smallest sum of the distance phi from the solid and `crown` t^2, by halving on its slope
    /// and then from the tangents at both ends of the interval: exact for a bend between two faces, and to the interval
    /// squared where phi is smooth.
    pub fn nearest(&self, solid: &ContactSolid<S>, crown: S) -> Approach<S> {
        let (mut low, mut high, half) = (-S::ONE, S::ONE, S::constant(0.5));
        for _ in 0..HALVINGS {
            let middle = (low + high) * half;
            let slope = self.sample(solid, crown, middle).slope;
            (low, high) = (slope.select_below(0.0, || middle, || low), slope.select_below(0.0, || high, || middle));
        }
        let [a, b] = [low, high].map(|t| self.sample(solid, crown, t));
        let bend = b.slope - a.slope;
        let inner = || (-a.slope / bend).clipped(S::ZERO, S::ONE);
        // At an end of the curve both slopes have one sign, and of a bend by rounding only the sign is known.
        let outer = || a.slope.select_below(0.0, || S::ONE, || S::ZERO);
        let of_b = bend.select_below(f64::MIN_POSITIVE, outer, inner);
        let of_a = S::ONE - of_b;
        Approach {
            point: a.point * of_a + b.point * of_b,
            distance: a.distance * of_a + b.distance * of_b - of_a * of_b * bend * (high - low),
            gradient: a.gradient * of_a + b.gradient * of_b,
        }
    }

    fn sample(&self, solid: &ContactSolid<S>, crown: S, t: S) -> CurvePoint<S> {
        let (point, along) = self.at(t);
        let (distance, gradient) = solid.distance(point);
        let slope = gradient.dot(along) + crown * t * S::constant(2.0);
        CurvePoint { point, distance: distance + crown * t * t, gradient, slope }
    }
}
