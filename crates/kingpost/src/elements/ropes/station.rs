//! The stations of a rope: points, sheaves, a drum.

use crate::elements::Context;
use crate::elements::lines::{place, velocity};
use crate::model::Attachment;
use crate::scalar::Scalar;
use crate::spatial::{Vector3, Wrench};

/// Smoothing speed of the sign change of friction, for the rope's speed over a sheave or on a drum, m/s.
const SMOOTHING_M_S: f64 = 0.01;

/// A place on a rope's path.
#[derive(Clone, Debug)]
pub struct Station<S = f64> {
    /// A point, or the centre of a sheave or a drum: on a body or in the world.
    pub centre: Attachment<S>,
    /// The sheave or drum; `None` for a point where the rope ends or through which it runs.
    pub round: Option<Round<S>>,
    /// Parallel falls of the leg that ends here.
    pub falls: S,
}

/// A sheave or a drum.
#[derive(Clone, Copy, Debug)]
pub struct Round<S = f64> {
    /// Unit vector about which the rope turns from its first end to its last, body axes.
    pub axis: Vector3<S>,
    /// Radius to the middle of the rope, m.
    pub radius: S,
    /// Its efficiency, with bearing friction and bending of the rope.
    pub efficiency: Efficiency<S>,
}

/// Efficiency of a sheave: the smaller over the larger tension of the rope that runs over it.
#[derive(Clone, Copy, Debug)]
pub struct Efficiency<S = f64> {
    /// Efficiency while the rope runs towards its first end.
    pub hoisting: S,
    /// Efficiency while the rope runs towards its last end.
    pub lowering: S,
}

impl<S: Scalar> Efficiency<S> {
    /// Returns the [ratio](Self::ratio) of tensions for the speed of a rope, smoothed about rest.
    pub fn of_rope(&self, speed: S) -> S {
        self.ratio(speed, SMOOTHING_M_S)
    }

    /// Returns the tension before a sheave over the tension after it; `speed` is the speed of the rope towards its last
    /// end, m/s. The ratio is smooth, is 1 at rest, and never adds energy.
    pub fn ratio(&self, speed: S, smoothing_m_s: f64) -> S {
        let smoothing = S::constant(smoothing_m_s);
        let way = speed / (speed * speed + smoothing * smoothing).sqrt();
        let (lowering, hoisting) = (self.lowering, S::ONE / self.hoisting);
        let (odd, even) = ((lowering - hoisting) * S::constant(0.5), (lowering + hoisting) * S::constant(0.5) - S::ONE);
        S::ONE + way * (odd + way * even)
    }
}

/// The motion of a station, in world axes.
#[derive(Clone, Copy, Debug)]
pub(super) struct StationMotion<S> {
    /// m.
    pub centre: Vector3<S>,
    /// m/s.
    pub velocity: Vector3<S>,
    /// Angular velocity of its body, rad/s.
    pub angular_velocity: Vector3<S>,
}

impl<S: Scalar> Station<S> {
    /// Returns the position and motion of the station.
    pub(super) fn motion(&self, at: &Context<'_, S>) -> StationMotion<S> {
        let angular_velocity = self.centre.body.map_or(Vector3::zero(), |body| {
            at.links.body_frame(at.model, body).rotation * at.links.body_twist(at.model, body).angular
        });
        let centre = place(&self.centre, at.model, at.links);
        StationMotion { centre, velocity: velocity(&self.centre, at), angular_velocity }
    }

    /// Transforms a vector from the axes of the station's body to world axes.
    pub(super) fn to_world(&self, at: &Context<'_, S>, vector: Vector3<S>) -> Vector3<S> {
        self.centre.body.map_or(vector, |body| at.links.body_frame(at.model, body).rotation * vector)
    }

    /// Transforms a vector from world axes to the axes of the station's body.
    pub(super) fn to_body(&self, at: &Context<'_, S>, vector: Vector3<S>) -> Vector3<S> {
        self.centre.body.map_or(vector, |body| at.links.to_body_axes(at.model, body, vector))
    }

    /// Returns the body on which a wrench at the station acts, and the wrench in the body's axes about its centre of
    /// mass; `None` for a station in the world.
    pub(in crate::elements) fn on_body(&self, at: &Context<'_, S>, in_world: &Wrench<S>) -> Option<(usize, Wrench<S>)> {
        let body = self.centre.body?;
        let (force, moment) = (self.to_body(at, in_world.force), self.to_body(at, in_world.moment));
        Some((body, Wrench { moment: moment + self.centre.in_body.position.cross(force), force }))
    }
}
