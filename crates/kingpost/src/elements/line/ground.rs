//! The ground on which a line can lie.

use super::section::{mean_of_positive, ramp};
use crate::scalar::Scalar;
use crate::spatial::{Matrix3, Vector3};

/// A level ground: a stiff and damped support, with dry friction across and along the line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LineGround<S = f64> {
    /// Depth below the still waterline, m.
    pub depth: S,
    /// Stiffness per length of the line, N/m^2.
    pub stiffness_per_length: S,
    /// Damping of the sinking line per length, N s/m^2, from the full depth on; it grows linearly down to this depth, so that
    /// the force does not jump.
    pub damping_per_length: S,
    /// Depth under the ground of the full damping, m.
    pub full_depth: S,
    /// Coefficient of friction.
    pub friction: S,
    /// Speed at which the friction is at half of sqrt(2) of its limit, m/s: below it friction grows with the speed.
    pub sliding_speed: S,
}

impl<S: Scalar> LineGround<S> {
    /// Returns force (N), heat (W) and stored energy (J) of a part of this length, whose lowest point is `depth` (m) under
    /// the ground, at a velocity.
    pub fn support(&self, length: S, depth: S, velocity: Vector3<S>) -> (Vector3<S>, S, S) {
        let [vx, vy, sinking] = [velocity[0], velocity[1], -velocity[2]];
        let depth = depth.select_below(0.0, || S::ZERO, || depth);
        let spring = self.stiffness_per_length * length * depth;
        let share = ramp(depth, self.full_depth).0;
        let damped = spring + self.damping_per_length * length * share * sinking;
        let touches = |force: S| depth.select_below(f64::MIN_POSITIVE, || S::ZERO, || force);
        let normal = touches(damped.select_below(0.0, || S::ZERO, || damped));
        let speed = (vx * vx + vy * vy + self.sliding_speed * self.sliding_speed).sqrt();
        let drag = self.friction * normal / speed;
        let force = Vector3::new(-drag * vx, -drag * vy, normal);
        let heat = drag * (vx * vx + vy * vy) + (normal - spring) * sinking;
        (force, heat, spring * depth * S::constant(0.5))
    }

    /// Returns the mean force (N) over an interval on a part of this length that moves by `way` (m) to a point with this
    /// depth under the ground, its heat (J), and the derivative of the force along the way, with the sign changed, N/m. The
    /// spring changes the stored energy by its work.
    pub fn mean_support(
        &self,
        length: S,
        [before, after]: [S; 2],
        way: Vector3<S>,
        interval_s: S,
    ) -> (Vector3<S>, S, Matrix3<S>) {
        let per_s = S::ONE / interval_s;
        let (mean, slope) = mean_of_positive(before, after);
        let (stiffness, damping) = (self.stiffness_per_length * length, self.damping_per_length * length * per_s);
        let spring = stiffness * mean;
        let (share, grows) = ramp(mean, self.full_depth);
        let damped = spring + damping * share * (after - before);
        let touches = |value: S| spring.select_below(f64::MIN_POSITIVE, || S::ZERO, || value);
        let pushes = |value: S| touches(damped.select_below(0.0, || S::ZERO, || value));
        let (normal, rise) =
            (pushes(damped), pushes(stiffness * slope + damping * (share + grows * slope * (after - before))));
        let [vx, vy] = [way[0] * per_s, way[1] * per_s];
        let per_speed = S::ONE / (vx * vx + vy * vy + self.sliding_speed * self.sliding_speed).sqrt();
        let [ex, ey] = [vx * per_speed, vy * per_speed];
        let limit = self.friction * normal;
        let k = limit * per_speed * per_s;
        let zero = S::ZERO;
        let (down, share) = (rise, self.friction * rise);
        let slope = Matrix3([
            [k * (S::ONE - ex * ex), -(k * ex * ey), -(share * ex)],
            [-(k * ex * ey), k * (S::ONE - ey * ey), -(share * ey)],
            [zero, zero, down],
        ]);
        let heat = limit * (ex * way[0] + ey * way[1]) + (normal - spring) * (after - before);
        (Vector3::new(-(limit * ex), -(limit * ey), normal), heat, slope)
    }
}
