//! The ground on which a line can lie.

use super::one_sided::{OneSided, is_open, mean_one_sided, one_sided, positive, share_at_end};
use crate::scalar::Scalar;
use crate::spatial::{Matrix3, Vector3};

/// A plane ground: a stiff and damped support along its normal, with dry friction across and along the line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LineGround<S = f64> {
    /// Depth below the still waterline at the origin of the world, m.
    pub depth: S,
    /// Unit normal, world, upwards.
    pub normal: Vector3<S>,
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
    /// Creates a level ground without damping and friction at a depth (m), with this stiffness per length of the line (N/m^2).
    pub fn level(depth: S, stiffness_per_length: S) -> Self {
        let (normal, none) = (Vector3::constant([0.0, 0.0, 1.0]), S::ZERO);
        Self {
            depth,
            normal,
            stiffness_per_length,
            damping_time: none,
            friction: none,
            sliding_speed: S::constant(0.01),
        }
    }

    /// Returns the ground with this share of its stiffness.
    pub fn softened(self, share: S) -> Self {
        Self { stiffness_per_length: self.stiffness_per_length * share, ..self }
    }

    /// Returns the distance of a point of the world under the ground, along its normal, m.
    pub fn under(&self, point: Vector3<S>) -> S {
        -(self.depth * self.normal[2]) - self.normal.dot(point)
    }

    /// Returns the height of the ground at the horizontal place of a point of the world, m.
    pub fn height_at(&self, point: Vector3<S>) -> S {
        -self.depth - (self.normal[0] * point[0] + self.normal[1] * point[1]) / self.normal[2]
    }

    /// Returns the gradient of the height, along x and y.
    pub fn gradient(&self) -> [S; 2] {
        [0, 1].map(|k| -self.normal[k] / self.normal[2])
    }

    /// Returns the part of the downward unit vector along the ground: zero if it is level.
    pub fn fall(&self) -> Vector3<S> {
        self.normal * self.normal[2] - Vector3::constant([0.0, 0.0, 1.0])
    }

    /// Returns force (N), heat (W) and stored energy (J) of a part of this length at a point of the world with a velocity.
    pub fn support(&self, length: S, point: Vector3<S>, velocity: Vector3<S>) -> (Vector3<S>, S, S) {
        let rising = self.normal.dot(velocity);
        let sliding = velocity - self.normal * rising;
        let stiffness = self.stiffness_per_length * length;
        let [elastic, whole] = one_sided(self.under(point), -rising, self.damping_time);
        let normal = stiffness * whole;
        let speed = (sliding.norm_squared() + self.sliding_speed * self.sliding_speed).sqrt();
        let drag = self.friction * normal / speed;
        let heat = drag * sliding.norm_squared() - stiffness * (whole - elastic) * rising;
        (self.normal * normal - sliding * drag, heat, stiffness * elastic * elastic * S::constant(0.5))
    }

    /// Returns the elastic force (N/m) and its energy (J/m) per length at a point of the world.
    pub fn held_per_length(&self, point: Vector3<S>) -> [S; 2] {
        let elastic = positive(self.under(point));
        let force = self.stiffness_per_length * elastic;
        [force, force * elastic * S::constant(0.5)]
    }

    /// Returns the mean support over an interval of a part of this length that moves from a point by `way` (m), with this
    /// velocity at first.
    #[inline(always)]
    pub fn mean_support(
        &self,
        length: S,
        (point, velocity): (Vector3<S>, Vector3<S>),
        (to, way): (Vector3<S>, Vector3<S>),
        interval_s: S,
    ) -> MeanSupport<S> {
        let (depths, sinking) = ([point, to].map(|point| self.under(point)), -self.normal.dot(velocity));
        let per_s = S::ONE / interval_s;
        let stiffness = self.stiffness_per_length * length;
        let (share, mean) = (share_at_end(interval_s, self.damping_time), (depths[1] - depths[0]) * per_s);
        // The rate at the end is twice the mean rate less that at the start.
        let rate = mean + share * (mean - sinking);
        if is_open(depths, rate, self.damping_time) {
            return MeanSupport { force: Vector3::zero(), heat: S::ZERO, slope: Matrix3::zero(), rise: S::ZERO };
        }
        let OneSided { elastic, whole, slopes: [by_depth, per_rate] } = mean_one_sided(depths, rate, self.damping_time);
        let slope = by_depth + per_rate * (S::ONE + share) * per_s;
        let (normal, rise) = (stiffness * whole, stiffness * slope);
        let up = self.normal;
        let slides = (way - up * up.dot(way)) * per_s;
        let per_speed = S::ONE / (slides.norm_squared() + self.sliding_speed * self.sliding_speed).sqrt();
        let along = slides * per_speed;
        let (limit, per_depth) = (self.friction * normal, self.friction * rise);
        let in_plane = Matrix3::identity() - Matrix3::outer(up, up) - Matrix3::outer(along, along);
        let slope = in_plane.scaled(limit * per_speed * per_s) + Matrix3::outer(up * rise - along * per_depth, up);
        let heat = limit * along.dot(way) + stiffness * (whole - elastic) * (depths[1] - depths[0]);
        let held = normal.select_below(f64::MIN_POSITIVE, || S::ZERO, || self.sliding_speed * per_speed);
        MeanSupport { force: up * normal - along * limit, heat, slope, rise: rise / stiffness + held }
    }
}
