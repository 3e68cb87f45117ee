//! The ground on which a line can lie.

use super::one_sided::{OneSided, mean_one_sided, one_sided, share_at_end};
use crate::scalar::Scalar;
use crate::spatial::{Matrix3, Vector3};

/// A level ground: a stiff and damped support, with dry friction across and along the line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LineGround<S = f64> {
    /// Depth below the still waterline, m.
    pub depth: S,
    /// Stiffness per length of the line, N/m^2.
    pub stiffness_per_length: S,
    /// Damping over stiffness, s.
    pub damping_time: S,
    /// Coefficient of friction.
    pub friction: S,
    /// Speed at which the friction is at half of sqrt(2) of its limit, m/s: below it friction grows with the speed.
    pub sliding_speed: S,
}

/// The mean support of a part of a line by the ground over an interval.
pub struct MeanSupport<S> {
    /// N.
    pub force: Vector3<S>,
    /// J.
    pub heat: S,
    /// Derivative of the force along the way, with the sign changed, N/m.
    pub slope: Matrix3<S>,
    /// Derivative of the support along the depth over its stiffness, and share to which friction holds the part.
    pub rise: S,
}

impl<S: Scalar> LineGround<S> {
    /// Returns force (N), heat (W) and stored energy (J) of a part of this length, which is `depth` (m) under the ground, at a
    /// velocity.
    pub fn support(&self, length: S, depth: S, velocity: Vector3<S>) -> (Vector3<S>, S, S) {
        let [vx, vy, sinking] = [velocity[0], velocity[1], -velocity[2]];
        let stiffness = self.stiffness_per_length * length;
        let [elastic, whole] = one_sided(depth, sinking, self.damping_time);
        let normal = stiffness * whole;
        let speed = (vx * vx + vy * vy + self.sliding_speed * self.sliding_speed).sqrt();
        let drag = self.friction * normal / speed;
        let force = Vector3::new(-drag * vx, -drag * vy, normal);
        let heat = drag * (vx * vx + vy * vy) + stiffness * (whole - elastic) * sinking;
        (force, heat, stiffness * elastic * elastic * S::constant(0.5))
    }

    /// Returns the elastic force (N/m) and its energy (J/m) per length, `depth` (m) under the ground.
    pub fn held_per_length(&self, depth: S) -> [S; 2] {
        let [elastic, _] = one_sided(depth, S::ZERO, self.damping_time);
        let force = self.stiffness_per_length * elastic;
        [force, force * elastic * S::constant(0.5)]
    }

    /// Returns the mean support over an interval of a part of this length that moves by `way` (m) between two depths under the
    /// ground and sinks with `sinking` (m/s) at first.
    #[inline]
    pub fn mean_support(
        &self,
        length: S,
        (depths, sinking): ([S; 2], S),
        way: Vector3<S>,
        interval_s: S,
    ) -> MeanSupport<S> {
        let per_s = S::ONE / interval_s;
        let stiffness = self.stiffness_per_length * length;
        let (share, mean) = (share_at_end(interval_s, self.damping_time), (depths[1] - depths[0]) * per_s);
        // The rate at the end is twice the mean rate less that at the start.
        let rate = mean + share * (mean - sinking);
        let OneSided { elastic, whole, slopes: [along, per_rate] } = mean_one_sided(depths, rate, self.damping_time);
        let slope = along + per_rate * (S::ONE + share) * per_s;
        let (normal, rise) = (stiffness * whole, stiffness * slope);
        let [vx, vy] = [way[0] * per_s, way[1] * per_s];
        let per_speed = S::ONE / (vx * vx + vy * vy + self.sliding_speed * self.sliding_speed).sqrt();
        let [ex, ey] = [vx * per_speed, vy * per_speed];
        let (limit, per_depth) = (self.friction * normal, self.friction * rise);
        let k = limit * per_speed * per_s;
        let slope = Matrix3([
            [k * (S::ONE - ex * ex), -(k * ex * ey), -(per_depth * ex)],
            [-(k * ex * ey), k * (S::ONE - ey * ey), -(per_depth * ey)],
            [S::ZERO, S::ZERO, rise],
        ]);
        let heat = limit * (ex * way[0] + ey * way[1]) + stiffness * (whole - elastic) * (depths[1] - depths[0]);
        let held = normal.select_below(f64::MIN_POSITIVE, || S::ZERO, || self.sliding_speed * per_speed);
        MeanSupport {
            force: Vector3::new(-(limit * ex), -(limit * ey), normal),
            heat,
            slope,
            rise: rise / stiffness + held,
        }
    }
}
