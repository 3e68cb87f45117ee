//! The motion of the crane's tip as heave compensation knows it.

use crate::elements::Context;
use crate::elements::hull::HullFrame;
use crate::elements::lines::{place, velocity};
use crate::model::Attachment;
use crate::scalar::Scalar;
use crate::spatial::Vector3;

/// The source of the tip's height and vertical velocity.
#[derive(Clone, Debug)]
pub enum Measurement<S = f64> {
    /// The motion itself, at once.
    Ideal,
    /// A motion reference unit, by its lever arm r to the tip in the axes of its body, which the crane's angles give. With
    /// the third row m of the rotation of roll phi and pitch theta, `m = (-sin theta, cos theta sin phi, cos theta cos phi)`,
    /// heave h and angular velocity omega,
    ///
    /// ```text
    /// z = h + m . r,    v = h' + m . (omega x r) + m . r'
    /// ```
    ///
    /// (Fossen, *Handbook of Marine Craft Hydrodynamics and Motion Control*, 2nd ed., 2021, eqs. 2.39 and 14.5). The last
    /// term is the crane's own motion. The sensors of the crane's angles are ideal here.
    Unit {
        /// The unit's name.
        name: String,
        /// Its body and place.
        place: HullFrame<S>,
        /// Whether it has a status: it can drop out.
        has_status: bool,
    },
}

/// The tip at a tick.
#[derive(Clone, Copy, Debug)]
pub struct Measured<S> {
    /// Its height by the position of the unit's place and by the rotation of its body, m: z is the sum.
    pub heights: [S; 2],
    /// The vertical velocity by the motion of the unit's place and by the rotation of its body, m/s.
    pub velocities: [S; 2],
    /// The vertical velocity by the crane's own motion, m/s.
    pub by_crane: S,
    /// Whether the sensor delivers.
    pub delivers: bool,
}

impl<S: Scalar> Measurement<S> {
    /// The columns that it needs.
    pub fn columns(&self) -> Vec<String> {
        let Self::Unit { name, has_status, .. } = self else { return Vec::new() };
        let signals = ["roll", "pitch", "heave", "heave_rate"].map(|signal| format!("{name}.measured_{signal}"));
        let rates = ["x", "y", "z"].map(|axis| format!("{name}.measured_angular_velocity.{axis}"));
        let status = has_status.then(|| format!("{name}.sensor_status"));
        signals.into_iter().chain(rates).chain(status).collect()
    }

    /// The tip by these columns.
    pub fn measure(&self, at: &Context<'_, S>, tip: &Attachment<S>, read: &[S]) -> Measured<S> {
        let (position, moving) = (place(tip, at.model, at.links), velocity(tip, at));
        let (Self::Unit { place, .. }, [roll, pitch, heave, heave_rate, x, y, z, status @ ..]) = (self, read) else {
            let velocities = [S::ZERO, moving[2]];
            return Measured { heights: [S::ZERO, position[2]], velocities, by_crane: S::ZERO, delivers: true };
        };
        let unit = place.motion(at);
        let to_body = |vector: Vector3<S>| unit.frame.rotation.transpose_times(vector);
        let arm = to_body(position - unit.frame.position);
        let arm_rate = to_body(moving) - unit.twist.linear - unit.twist.angular.cross(arm);
        let ([sin_roll, cos_roll], [sin_pitch, cos_pitch]) = (of_angle(*roll), of_angle(*pitch));
        let upward = Vector3([-sin_pitch, cos_pitch * sin_roll, cos_pitch * cos_roll]);
        let turning = Vector3([*x, *y, *z]).cross(arm);
        Measured {
            heights: [*heave, upward.dot(arm)],
            velocities: [*heave_rate, upward.dot(turning)],
            by_crane: upward.dot(arm_rate),
            delivers: status.first().is_none_or(|status| status.all(|status| status > 0.5)),
        }
    }
}

fn of_angle<S: Scalar>(angle: S) -> [S; 2] {
    let (sine, cosine) = angle.sin_cos();
    [sine, cosine]
}
