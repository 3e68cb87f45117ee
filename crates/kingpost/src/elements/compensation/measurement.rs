//! The measured motion of a point of the crane, for compensation.

use crate::elements::Context;
use crate::elements::hull::HullFrame;
use crate::elements::lines::{place, velocity};
use crate::model::Attachment;
use crate::scalar::Scalar;
use crate::spatial::{Matrix3, Vector3, rotation_from_roll_pitch_yaw};

/// The source of the position and velocity of a point, such as the crane's tip.
#[derive(Clone, Debug)]
pub enum Measurement<S = f64> {
    /// The exact motion, without delay.
    Ideal,
    /// A motion reference unit, with the lever arm r from the unit to the point in the axes of its body, from the
    /// crane's angles. With the rotation R of roll, pitch and yaw, the displacement s of the unit and its angular
    /// velocity omega,
    ///
    /// ```text
    /// p = s + R r,    v = s' + R (omega x r) + R r'
    /// ```
    ///
    /// (Fossen, *Handbook of Marine Craft Hydrodynamics and Motion Control*, 2nd ed., 2021, eqs. 2.39 and 14.5). The
    /// last term is the crane's own motion. The sensors of the crane's angles are ideal here. Without horizontal
    /// motion, yaw is taken as 0 and only z is valid.
    Unit {
        /// The unit's name.
        name: String,
        /// Its body and place.
        place: HullFrame<S>,
        /// Whether it measures its horizontal motion and yaw.
        horizontal: bool,
        /// Whether it has a status output, because it can drop out.
        has_status: bool,
    },
}

/// A point at a tick, world axes.
#[derive(Clone, Copy, Debug)]
pub struct Measured<S> {
    /// The two parts of its position, m: from the position of the unit, and from the rotation of the unit's body.
    pub positions: [Vector3<S>; 2],
    /// The two parts of its velocity, m/s: from the velocity of the unit, and from the rotation of the unit's body.
    pub velocities: [Vector3<S>; 2],
    /// Velocity from the crane's own motion, m/s.
    pub by_crane: Vector3<S>,
    /// Whether the sensor works.
    pub delivers: bool,
}

/// The attitude of the unit's body at a tick.
#[derive(Clone, Copy, Debug)]
pub struct MeasuredAttitude<S> {
    /// Rotation from the body's axes to the world's, or, without a measured yaw, to level axes that yaw with the body.
    pub rotation: Matrix3<S>,
    /// Its angular velocity in its own axes, rad/s.
    pub angular: Vector3<S>,
}

impl<S: Scalar> Measurement<S> {
    /// Returns the columns that the measurement reads.
    pub fn columns(&self) -> Vec<String> {
        let Self::Unit { name, has_status, horizontal, .. } = self else { return Vec::new() };
        let of = |signal: &str| format!("{name}.measured_{signal}");
        let signals = ["roll", "pitch", "heave", "heave_rate"].map(of);
        let rates = ["x", "y", "z"].map(|axis| format!("{name}.measured_angular_velocity.{axis}"));
        let level = ["x", "x_velocity", "y", "y_velocity", "yaw"].into_iter().filter(|_| *horizontal).map(of);
        let status = has_status.then(|| format!("{name}.sensor_status"));
        signals.into_iter().chain(rates).chain(level).chain(status).collect()
    }

    /// Whether the yaw of the ship is known.
    pub fn has_yaw(&self) -> bool {
        matches!(self, Self::Ideal | Self::Unit { horizontal: true, .. })
    }

    /// Returns the attitude of the unit's body from these columns; `None` if the measurement is ideal.
    pub fn attitude(&self, read: &[S]) -> Option<MeasuredAttitude<S>> {
        let (Self::Unit { horizontal, .. }, [roll, pitch, _, _, x, y, z, rest @ ..]) = (self, read) else {
            return None;
        };
        let yaw = rest.get(4).copied().filter(|_| *horizontal).unwrap_or(S::ZERO);
        let rotation = rotation_from_roll_pitch_yaw(Vector3([*roll, *pitch, yaw]));
        Some(MeasuredAttitude { rotation, angular: Vector3([*x, *y, *z]) })
    }

    /// Returns the motion of the point from these columns. `driven` is its velocity from driven joints, m/s, which an
    /// ideal measurement subtracts to get the velocity from the ship.
    pub fn measure(&self, at: &Context<'_, S>, point: &Attachment<S>, driven: Vector3<S>, read: &[S]) -> Measured<S> {
        let (position, moving) = (place(point, at.model, at.links), velocity(point, at));
        let (Self::Unit { place, horizontal, has_status, .. }, Some(MeasuredAttitude { rotation, angular })) =
            (self, self.attitude(read))
        else {
            return Measured {
                positions: [Vector3::zero(), position],
                velocities: [Vector3::zero(), moving - driven],
                by_crane: driven,
                delivers: true,
            };
        };
        let unit = place.motion(at);
        let to_body = |vector: Vector3<S>| unit.frame.rotation.transpose_times(vector);
        let arm = to_body(position - unit.frame.position);
        let arm_rate = to_body(moving) - unit.twist.linear - unit.twist.angular.cross(arm);
        let level = |signal: usize| if *horizontal { read[7 + signal] } else { S::ZERO };
        let status = read.last().filter(|_| *has_status);
        Measured {
            positions: [Vector3([level(0), level(2), read[2]]), rotation * arm],
            velocities: [Vector3([level(1), level(3), read[3]]), rotation * angular.cross(arm)],
            by_crane: rotation * arm_rate,
            delivers: status.is_none_or(|status| status.all(|status| status > 0.5)),
        }
    }
}
