//! The ground on which a line can lie.

use crate::scalar::Scalar;
use crate::spatial::Vector3;

/// A level ground at the depth of the water: a stiff and damped support, with dry friction across and along the line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LineGround<S = f64> {
    /// Stiffness per length of the line, N/m^2.
    pub stiffness_per_length: S,
    /// Damping of the sinking line per length, N s/m^2.
    pub damping_per_length: S,
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
        let damped = spring + self.damping_per_length * length * sinking;
        let touches = |force: S| depth.select_below(f64::MIN_POSITIVE, || S::ZERO, || force);
        let normal = touches(damped.select_below(0.0, || S::ZERO, || damped));
        let speed = (vx * vx + vy * vy + self.sliding_speed * self.sliding_speed).sqrt();
        let drag = self.friction * normal / speed;
        let force = Vector3::new(-drag * vx, -drag * vy, normal);
        let heat = drag * (vx * vx + vy * vy) + (normal - spring) * sinking;
        (force, heat, spring * depth * S::constant(0.5))
    }
}
