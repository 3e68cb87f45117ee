//! A satellite receiver whose positions correct another sensor of the same body.

use crate::elements::ticks::{Due, due};
use crate::scalar::Scalar;
use crate::spatial::{Matrix3, Vector3};

/// A satellite receiver on the same body, whose positions prevent the drift of a unit.
#[derive(Clone, Debug)]
pub struct PositionAid<S = f64> {
    /// The receiver's name.
    pub receiver: String,
    /// From the unit to the antenna, in the axes of their body, m.
    pub arm: Vector3<S>,
    /// The receiver's sampling period, s.
    pub period_s: f64,
    /// Age of its positions, s.
    pub age_s: f64,
    /// Whether it has a status output, because it can drop out.
    pub has_status: bool,
}

/// Sample that a unit gets from its receiver.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ReceiverSample {
    /// Whether it is the first.
    pub is_first: bool,
    /// Whether the sample has a position; the first sample always has one.
    pub delivers: bool,
}

impl<S: Scalar> PositionAid<S> {
    /// Returns the columns that it reads.
    pub fn columns(&self) -> Vec<String> {
        let place = ["x", "y", "z"].map(|axis| format!("{}.measured_position.{axis}", self.receiver));
        let status = self.has_status.then(|| format!("{}.sensor_status", self.receiver));
        place.into_iter().chain(status).collect()
    }

    /// Returns the receiver's sample that is due at a time and has not been taken, from these columns; `next` is a mode
    /// of the unit, as for [`due`].
    pub fn sample(&self, time_s: f64, read: &[S], next: &mut i64) -> Option<ReceiverSample> {
        let Due { is_first, .. } = due(time_s, self.period_s, next)?;
        let works = !self.has_status || read.last().is_none_or(|status| status.all(|status| status > 0.5));
        Some(ReceiverSample { is_first, delivers: is_first || works })
    }

    /// Returns g, the position of the unit from a sample of the receiver in these columns, m. With the unit's rotation
    /// R, its angular velocity omega in body axes, its velocity v in world axes, and a received position p of the age
    /// a,
    ///
    /// ```text
    /// g = p - R r + a R (omega x r) + a v
    /// ```
    ///
    /// Until the next sample g is extrapolated with v.
    pub fn fix(&self, read: &[S], (rotation, angular): (Matrix3<S>, Vector3<S>), velocity: Vector3<S>) -> Vector3<S> {
        let age = S::constant(self.age_s);
        let arm = self.arm - angular.cross(self.arm) * age;
        Vector3::from_slice(&read[..3]) - rotation * arm + velocity * age
    }

    /// Returns the time since the last sample, s, from the number of the next sample.
    pub fn since_fix_s(&self, time_s: f64, next: i64) -> f64 {
        if next == 0 { 0.0 } else { time_s - (next - 1) as f64 * self.period_s }
    }
}
