//! A satellite receiver that helps another sensor of the same body with its positions.

use crate::elements::ticks::{Due, due};
use crate::scalar::Scalar;
use crate::spatial::{Matrix3, Vector3};

/// A receiver on the same body, whose positions keep a unit from wandering.
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
    /// Whether it has a status: it can drop out.
    pub has_status: bool,
}

/// Sample that a unit gets of its receiver.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ReceiverSample {
    /// Whether it is the first.
    pub is_first: bool,
    /// Whether there is a position; the first sample always has one.
    pub delivers: bool,
}

impl<S: Scalar> PositionAid<S> {
    /// The columns that it needs.
    pub fn columns(&self) -> Vec<String> {
        let place = ["x", "y", "z"].map(|axis| format!("{}.measured_position.{axis}", self.receiver));
        let status = self.has_status.then(|| format!("{}.sensor_status", self.receiver));
        place.into_iter().chain(status).collect()
    }

    /// The sample of the receiver that is due at a time, if it has not been taken, by these columns; `next` is a mode of the
    /// unit, as for [`due`].
    pub fn sample(&self, time_s: f64, read: &[S], next: &mut i64) -> Option<ReceiverSample> {
        let Due { is_first, .. } = due(time_s, self.period_s, next)?;
        let works = !self.has_status || read.last().is_none_or(|status| status.all(|status| status > 0.5));
        Some(ReceiverSample { is_first, delivers: is_first || works })
    }

    /// g by these columns at a sample of the receiver, m: with the unit's rotation R, its angular velocity omega in its own
    /// axes and its velocity v in those of the world, a position p of the age a gives
    ///
    /// ```text
    /// g = p - R r + a R (omega x r) + a v
    /// ```
    ///
    /// Until the next sample g moves on with v.
    pub fn fix(&self, read: &[S], (rotation, angular): (Matrix3<S>, Vector3<S>), velocity: Vector3<S>) -> Vector3<S> {
        let age = S::constant(self.age_s);
        let arm = self.arm - angular.cross(self.arm) * age;
        Vector3::from_slice(&read[..3]) - rotation * arm + velocity * age
    }

    /// Time since the last sample, by the number of the next, s.
    pub fn since_fix_s(&self, time_s: f64, next: i64) -> f64 {
        if next == 0 { 0.0 } else { time_s - (next - 1) as f64 * self.period_s }
    }
}
