//! The spots of one side that may touch the solid of the other: points, balls, the ends of a cylinder, curves, rims.

use super::curve::Curve;
use super::length::{choose, length};
use super::solid::ContactSolid;
use crate::scalar::Scalar;
use crate::spatial::{Frame, Vector3};

/// A part of a shape that may touch a solid, in the shape's axes.
#[derive(Clone, Copy, Debug)]
pub enum Spot<S = f64> {
    /// A ball; of radius 0, a corner or a foot.
    Ball {
        /// m.
        centre: Vector3<S>,
        /// m.
        radius: S,
    },
    /// The end of a cylinder, as a flat spheroid, for contact with a plane only. A lying cylinder then rolls on a
    /// circle; a standing one has a single contact point, which moves to the rim as the cylinder leans. The transition
    /// between the two is continuous.
    End {
        /// m.
        centre: Vector3<S>,
        /// Unit vector along the cylinder.
        axis: Vector3<S>,
        /// Semi-axis across it, m.
        radius: S,
        /// Semi-axis along it, m.
        bulge: S,
    },
    /// A tube about a curve, with a single contact point where it is deepest. Its radius falls by `crown` from the middle
    /// of the curve to its ends, so that the point is unique and moves continuously.
    Tube {
        /// The line in its middle.
        curve: Curve<S>,
        /// m.
        radius: S,
        /// m.
        crown: S,
    },
    /// The rim of a round body, with a single contact point where it is deepest, whatever the roll angle: a lying body rolls
    /// evenly.
    Rim {
        /// m.
        centre: Vector3<S>,
        /// From the centre to a point of the circle, m.
        across: Vector3<S>,
        /// From the centre, a quarter turn after that point, m.
        along: Vector3<S>,
    },
}

/// Number of points of a rim of which the nearest is sought: more than the edges that a circle crosses on a box, eight.
const SAMPLES: u32 = 16;

/// The position of a spot relative to a solid, in the solid's axes.
#[derive(Clone, Copy, Debug)]
pub struct Nearness<S> {
    /// The spot's deepest point, m.
    pub point: Vector3<S>,
    /// Outward normal of the solid.
    pub normal: Vector3<S>,
    /// Growth of the depth per displacement against the normal: below 1 for a line that crosses an edge of the solid.
    pub gain: S,
    /// Depth of the spot in the solid, m; negative outside.
    pub depth: S,
    /// The middle of the spot, m.
    pub middle: Vector3<S>,
}

impl<S: Scalar> Spot<S> {
    /// Returns the spot's position relative to a solid; `seen` is the shape's frame in the solid's axes.
    pub fn nearness(&self, solid: &ContactSolid<S>, seen: &Frame<S>) -> Nearness<S> {
        match *self {
            Self::Ball { centre, radius } => {
                let middle = seen.point(centre);
                let (distance, normal) = solid.distance(middle);
                Nearness { point: middle - normal * radius, normal, gain: S::ONE, depth: radius - distance, middle }
            }
            Self::End { centre, axis, radius, bulge } => {
                let middle = seen.point(centre);
                let (distance, normal) = solid.distance(middle);
                let up = seen.rotation.transpose_times(normal);
                let along = up.dot(axis);
                let across = up - axis * along;
                // The support function of a spheroid and its gradient.
                let to_rim = (across * radius).norm_squared() + (along * bulge) * (along * bulge);
                let reach = to_rim.sqrt();
                let deepest = (across * (radius * radius) + axis * (along * bulge * bulge)) * (-S::ONE / reach);
                Nearness {
                    point: middle + seen.rotation * deepest,
                    normal,
                    gain: S::ONE,
                    depth: reach - distance,
                    middle,
                }
            }
            Self::Tube { curve, radius, crown } => {
                let curve = curve.seen(seen);
                let nearest = curve.nearest(solid, crown);
                let gain = length(nearest.gradient);
                let normal = nearest.gradient * (S::ONE / gain);
                let point = nearest.point - normal * radius;
                Nearness { point, normal, gain, depth: radius - nearest.distance, middle: curve.at(S::ZERO).0 }
            }
            Self::Rim { centre, across, along } => {
                let curve = deepest_arc(solid, seen, [centre, across, along]);
                let tube = Self::Tube { curve, radius: S::ZERO, crown: S::ZERO };
                Nearness { middle: seen.point(centre), ..tube.nearness(solid, seen) }
            }
        }
    }
}

/// Returns the arc of a circle between the neighbours of the nearest of [`SAMPLES`] points to a solid. A circle can have a
/// nearest point at each of several edges: the depth is continuous only for the nearest of all.
fn deepest_arc<S: Scalar>(
    solid: &ContactSolid<S>,
    seen: &Frame<S>,
    [centre, across, along]: [Vector3<S>; 3],
) -> Curve<S> {
    let mut least = S::constant(f64::MAX);
    let mut best = [across, along];
    for k in 0..SAMPLES {
        let (sin, cos) = S::constant(f64::from(k) / f64::from(SAMPLES)).sin_cos_of_turns();
        let turned = [across * cos + along * sin, along * cos - across * sin];
        let (distance, _) = solid.distance(seen.point(centre + turned[0]));
        best = core::array::from_fn(|i| Vector3(choose(distance, least, turned[i].0, best[i].0)));
        least = distance.select_less(least, || distance, || least);
    }
    let half_angle = S::constant(core::f64::consts::TAU / f64::from(SAMPLES));
    Curve::Arc { centre, across: best[0], along: best[1], half_angle }
}
