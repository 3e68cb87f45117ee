//! A drum: the length that it pays out as a function of its angle.
//!
//! With the angle theta from the start, positive as it pays out, and the radius R0 to the middle of the rope there, one
//! layer of rope pays out R0 theta. With layers of height h and N turns each, the radius falls like a spiral, by c =
//! h / (2 pi N) per angle:
//!
//! ```text
//! R = R0 - c theta,   L = L0 + R0 theta - c theta^2 / 2
//! ```
//!
//! which gives the mean radius of every layer. The point where the rope leaves the drum stays at R0: its shift would be
//! less than the height of the layers.

use crate::elements::Context;
use crate::scalar::Scalar;

/// A drum: the coordinate that turns it, its radius and the layers of rope.
#[derive(Clone, Copy, Debug)]
pub struct Drum<S = f64> {
    /// Index in q.
    pub position: usize,
    /// Index in v.
    pub coordinate: usize,
    /// 1 if positive rates of the coordinate pay out, otherwise -1.
    pub sense: S,
    /// R0, m.
    pub radius: S,
    /// Its angle at the start, rad.
    pub start: S,
    /// The layers; without them the radius stays R0.
    pub layers: Option<Layers<S>>,
}

/// Rope in layers.
#[derive(Clone, Copy, Debug)]
pub struct Layers<S = f64> {
    /// c, m/rad.
    pub thinning: S,
    /// Angle at which the innermost layer is reached, rad; beyond it the radius is constant.
    pub innermost_from: S,
}

/// The rope that a drum has paid out since the start.
#[derive(Clone, Copy, Debug)]
pub(in crate::elements) struct PaidOut<S> {
    /// L - L0, m.
    pub length: S,
    /// dL/dq, m.
    pub per_angle: S,
    /// L', m/s.
    pub rate: S,
    /// L'' without acceleration of the drum, m/s^2.
    pub bias_acceleration: S,
    /// theta left until the innermost layer, rad.
    pub left: S,
}

impl<S: Scalar> Drum<S> {
    pub(in crate::elements) fn paid_out(&self, at: &Context<'_, S>) -> PaidOut<S> {
        let angle = self.sense * (at.q[self.position] - self.start);
        let speed = self.sense * at.v[self.coordinate];
        let radius = self.radius;
        let one_layer = PaidOut {
            length: radius * angle,
            per_angle: self.sense * radius,
            rate: radius * speed,
            bias_acceleration: S::ZERO,
            left: S::ONE,
        };
        let Some(Layers { thinning, innermost_from }) = self.layers else { return one_layer };
        let left = innermost_from - angle;
        let spiral = angle.select_less(innermost_from, || angle, || innermost_from);
        let radius = radius - thinning * spiral;
        let growth = left.select_below(0.0, || S::ZERO, || thinning);
        PaidOut {
            length: radius * angle + thinning * spiral * spiral * S::constant(0.5),
            per_angle: self.sense * radius,
            rate: radius * speed,
            bias_acceleration: -growth * speed * speed,
            left,
        }
    }
}
