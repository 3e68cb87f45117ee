//! The controller: the force and moment that it demands.

use crate::dynamics::LinkKinematics;
use crate::elements::hull::HullFrame;
use crate::model::Model;
use crate::scalar::Scalar;

/// Surge and sway in the axes of the heading, and yaw.
pub type Planar<S> = [S; 3];

/// A place in the world, m, and a heading, rad.
#[derive(Clone, Copy, Debug)]
pub struct Target<S = f64> {
    /// x and y, m.
    pub position: [S; 2],
    /// Heading from x counter-clockwise, rad.
    pub heading: S,
}

/// Gains of surge, sway and yaw: N or N m, m or rad, s.
#[derive(Clone, Copy, Debug)]
pub struct Gains<S = f64> {
    /// K_p.
    pub stiffness: Planar<S>,
    /// K_d.
    pub damping: Planar<S>,
    /// K_i.
    pub integral: Planar<S>,
    /// Whether each of the three has an integral.
    pub integrates: [bool; 3],
    /// T_t, s: tracking time constant with which an integral follows the force that the thrusters can give.
    pub tracking_time: Planar<S>,
}

/// The deviation of a ship from its target.
#[derive(Clone, Copy, Debug)]
pub struct Deviation<S = f64> {
    /// Position error from the ship to the target, along the heading and to port, m; heading error in (-pi, pi], rad.
    pub error: Planar<S>,
    /// Velocity along the same axes, m/s, and the rate about the vertical, rad/s.
    pub rate: Planar<S>,
    /// Cosine and sine of the heading.
    pub heading: [S; 2],
}

impl<S: Scalar> Target<S> {
    /// Returns the deviation of a point of a body from the target.
    pub fn deviation(&self, place: &HullFrame<S>, model: &Model<S>, links: &LinkKinematics<S>) -> Deviation<S> {
        let motion = place.motion_of(model, links);
        let (position, rotation) = (motion.frame.position, motion.frame.rotation);
        let forward = rotation.column(0);
        let angle = forward[1].atan2(forward[0]);
        let (sin, cos) = angle.sin_cos();
        let (missing_sin, missing_cos) = (self.heading - angle).sin_cos();
        let to_heading = |x: S, y: S| [cos * x + sin * y, cos * y - sin * x];
        let [ahead, aside] = to_heading(self.position[0] - position[0], self.position[1] - position[1]);
        let velocity = rotation * motion.twist.linear;
        let [surge, sway] = to_heading(velocity[0], velocity[1]);
        let yaw_rate = rotation.row(2).dot(motion.twist.angular);
        Deviation {
            error: [ahead, aside, missing_sin.atan2(missing_cos)],
            rate: [surge, sway, yaw_rate],
            heading: [cos, sin],
        }
    }
}

impl<S: Scalar> Deviation<S> {
    /// Transforms a force and moment from world axes to the axes of the heading.
    pub fn from_world(&self, [x, y, yaw]: [S; 3]) -> Planar<S> {
        let [cos, sin] = self.heading;
        [cos * x + sin * y, cos * y - sin * x, yaw]
    }

    /// Transforms a force and moment from the axes of the heading to world axes.
    pub fn to_world(&self, [surge, sway, yaw]: Planar<S>) -> [S; 3] {
        let [cos, sin] = self.heading;
        [cos * surge - sin * sway, sin * surge + cos * sway, yaw]
    }
}

impl<S: Scalar> Gains<S> {
    /// Returns K_p e - K_d nu.
    pub fn proportional(&self, at: &Deviation<S>) -> Planar<S> {
        core::array::from_fn(|k| self.stiffness[k] * at.error[k] - self.damping[k] * at.rate[k])
    }

    /// Returns the rate of the integrals, in the axes of the heading: K_i e - (demand - given) / T_t, so that they do
    /// not wind up at a limit.
    pub fn integral_rate(&self, at: &Deviation<S>, demand: Planar<S>, given: Planar<S>) -> Planar<S> {
        core::array::from_fn(|k| {
            let rate = || self.integral[k] * at.error[k] + (given[k] - demand[k]) / self.tracking_time[k];
            if self.integrates[k] { rate() } else { S::ZERO }
        })
    }
}
