//! Where a hull is, how it moves, and the slow frame that its loads by the sea are seen from.

use crate::dynamics::{LinkKinematics, Moment};
use crate::model::Model;
use crate::scalar::Scalar;
use crate::spatial::{Frame, Matrix3, Twist, Vector3, Wrench};

/// A body and the origin of its hull's hydrodynamic data.
#[derive(Clone, Copy, Debug)]
pub struct HullFrame<S = f64> {
    /// The body.
    pub body: usize,
    /// The origin from the body's centre of mass, body axes, m. The data's axes are the body's.
    pub origin: Vector3<S>,
}

/// A hull at one moment.
#[derive(Clone, Copy, Debug)]
pub struct HullMotion<S = f64> {
    /// The frame of the hull's data in the world.
    pub frame: Frame<S>,
    /// Its twist, in its own axes about its origin.
    pub twist: Twist<S>,
}

impl<S: Scalar> HullFrame<S> {
    /// The frame of the data in the world.
    pub fn frame(&self, model: &Model<S>, links: &LinkKinematics<S>) -> Frame<S> {
        links.body_frame(model, self.body).times(&self.in_body())
    }

    /// Where the hull is and how it moves.
    pub fn motion(&self, at: &Moment<'_, S>) -> HullMotion<S> {
        self.motion_of(at.model, at.links)
    }

    /// The same, by kinematics alone.
    pub fn motion_of(&self, model: &Model<S>, links: &LinkKinematics<S>) -> HullMotion<S> {
        let twist = self.in_body().twist_to_child(&links.body_twist(model, self.body));
        HullMotion { frame: self.frame(model, links), twist }
    }

    /// Twist relative to water that flows at `current` (world, m/s), in the body's axes about the origin, and the current
    /// in those axes.
    pub fn through_water(&self, at: &Moment<'_, S>, current: Vector3<S>) -> (Twist<S>, Vector3<S>) {
        let twist = self.in_body().twist_to_child(&at.links.body_twist(at.model, self.body));
        let stream = at.links.to_body_axes(at.model, self.body, current);
        (Twist { linear: twist.linear - stream, ..twist }, stream)
    }

    /// A wrench about the data's origin, in body axes, about the centre of mass.
    pub fn about_centre(&self, wrench: &Wrench<S>) -> Wrench<S> {
        self.in_body().wrench_to_parent(wrench)
    }

    fn in_body(&self) -> Frame<S> {
        Frame::translation(self.origin)
    }
}

/// The frame that first-order loads are seen from: level, where the hull is and heads on average.
///
/// Waves at the hull's own place would drag it along by their phase, which is an effect of second
/// order.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SlowFrame<S = f64> {
    /// x and y in the world, m.
    pub position: [S; 2],
    /// Heading, rad, without jumps at a full turn.
    pub heading: S,
}

impl<S: Scalar> SlowFrame<S> {
    /// Where a hull is and heads.
    pub fn of(frame: &Frame<S>) -> Self {
        Self { position: [frame.position[0], frame.position[1]], heading: heading(&frame.rotation) }
    }

    /// A turn about the vertical, from the slow frame's axes to the world's.
    pub fn rotation(&self) -> Matrix3<S> {
        let (sin, cos) = self.heading.sin_cos();
        let (o, i) = (S::ZERO, S::ONE);
        Matrix3([[cos, -sin, o], [sin, cos, o], [o, o, i]])
    }
}

/// Yaw of an orientation, rad.
fn heading<S: Scalar>(rotation: &Matrix3<S>) -> S {
    let forward = rotation.column(0);
    forward[1].atan2(forward[0])
}
