//! Where a hull is, how it moves, and the slow frame that its loads by the sea are seen from.

use crate::dynamics::LinkKinematics;
use crate::elements::Moment;
use crate::model::Model;
use crate::scalar::Scalar;
use crate::spatial::{Frame, Matrix3, SpatialInertia, Twist, Vector3, Wrench};

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

    /// The frame of the data in the body's.
    pub fn in_body(&self) -> Frame<S> {
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
    /// Roll and pitch, rad.
    pub lean: [S; 2],
}

impl<S: Scalar> SlowFrame<S> {
    /// Where a hull is and heads.
    pub fn of(frame: &Frame<S>) -> Self {
        let [x, y, _] = frame.position.0;
        Self { position: [x, y], heading: heading(&frame.rotation), lean: Turns::of(&frame.rotation).angles() }
    }

    /// A turn about the vertical, from the slow frame's level axes to the world's.
    pub fn rotation(&self) -> Matrix3<S> {
        let (sin, cos) = self.heading.sin_cos();
        let (o, i) = (S::ZERO, S::ONE);
        Matrix3([[cos, -sin, o], [sin, cos, o], [o, o, i]])
    }

    /// From the hull's axes on average to the slow frame's.
    fn leaning(&self) -> Matrix3<S> {
        let [roll, pitch] = self.lean.map(|angle| angle.sin_cos().into());
        Turns { roll, pitch }.rotation()
    }
}

/// Yaw of an orientation, rad.
fn heading<S: Scalar>(rotation: &Matrix3<S>) -> S {
    let forward = rotation.column(0);
    forward[1].atan2(forward[0])
}

/// What the loads of the sea act along: the coordinates of linear theory, about the hull's attitude on average. Forces are
/// along axes that stand so; moments along turns from it, yaw about its vertical, pitch about the axis across the heading that
/// the hull has come to, roll about the hull's own axis. T takes a twist in the body's axes to the rates of these, and does not
/// move the point that it is of.
///
/// What is left out is of second order, and makes no motion of its own. Forces in axes that yawed with the waves would have a
/// mean, which belongs to the drift; so would a moment of yaw about an axis that tilted with them, or a lever that did. Moments
/// of pitch in axes that did not yaw with the hull, or of yaw in axes that did not pitch, would roll a slender ship at the
/// differences of the waves' frequencies.
#[derive(Clone, Copy, Debug)]
pub struct SeaAxes<S = f64> {
    /// From the axes of the hull on average to the slow frame's.
    leaning: Matrix3<S>,
    /// From these axes to the world's.
    pub(super) mean: Matrix3<S>,
    turns: Turns<S>,
    of_forces: Matrix3<S>,
}

impl<S: Scalar> SeaAxes<S> {
    /// Of a hull that stands and heads so.
    pub fn of(hull: &Frame<S>, slow: &SlowFrame<S>) -> Self {
        let leaning = slow.leaning();
        let mean = slow.rotation() * leaning;
        let of_forces = mean.transpose() * hull.rotation;
        Self { leaning, mean, turns: Turns::of(&of_forces), of_forces }
    }

    /// By mode, surge, sway, heave, roll, pitch and yaw along the slow frame's axes: of a force or velocity, and of a moment or
    /// angular velocity along these.
    pub fn modes(&self, linear: Vector3<S>, angular: Vector3<S>) -> [S; 6] {
        let [[x, y, z], [roll, pitch, yaw]] = [linear, angular].map(|along| (self.leaning * along).0);
        [x, y, z, roll, pitch, yaw]
    }

    /// Force and moment along these of a load by mode.
    pub fn of_modes(&self, [x, y, z, roll, pitch, yaw]: [S; 6]) -> Wrench<S> {
        let [force, moment] = [[x, y, z], [roll, pitch, yaw]].map(|load| self.leaning.transpose_times(Vector3(load)));
        Wrench { moment, force }
    }

    /// T nu.
    pub fn twist(&self, in_body: &Twist<S>) -> Twist<S> {
        Twist { angular: self.turns.inverse() * in_body.angular, linear: self.of_forces * in_body.linear }
    }

    /// `T' nu`: what of the rates of T nu is of velocities alone.
    pub fn drift(&self, in_body: &Twist<S>) -> Twist<S> {
        let rates = self.turns.inverse();
        let turned = self.turns.drift(rates * in_body.angular);
        Twist { angular: -(rates * turned), linear: self.of_forces * in_body.angular.cross(in_body.linear) }
    }

    /// `T^T F`.
    pub fn wrench_to_body(&self, wrench: &Wrench<S>) -> Wrench<S> {
        let moment = self.turns.inverse().transpose_times(wrench.moment);
        Wrench { moment, force: self.of_forces.transpose_times(wrench.force) }
    }

    /// F, of `T^T F`.
    pub fn wrench_of_body(&self, wrench: &Wrench<S>) -> Wrench<S> {
        Wrench { moment: self.turns.matrix().transpose_times(wrench.moment), force: self.of_forces * wrench.force }
    }

    /// `T^T A T`.
    pub fn inertia_in_body(&self, added: &SpatialInertia<S>) -> SpatialInertia<S> {
        let (turns, forces) = (self.turns.inverse().transpose(), self.of_forces.transpose());
        SpatialInertia {
            angular: added.angular.rotated(&turns),
            coupling: turns * added.coupling * self.of_forces,
            linear: added.linear.rotated(&forces),
        }
    }
}

/// Roll and pitch of an orientation: `omega = E (roll', pitch', yaw')`, omega in body axes (Fossen, *Handbook of Marine Craft
/// Hydrodynamics and Motion Control*, 2011, eq. 2.28). E is singular where the bow points straight up or down.
#[derive(Clone, Copy, Debug)]
struct Turns<S> {
    roll: [S; 2],
    pitch: [S; 2],
}

impl<S: Scalar> Turns<S> {
    /// Sines and cosines, by the vertical in body axes.
    fn of(rotation: &Matrix3<S>) -> Self {
        let [x, y, z] = rotation.row(2).0;
        let level = (y * y + z * z).sqrt();
        Self { roll: [y / level, z / level], pitch: [-x, level] }
    }

    /// The turn by pitch after that by roll.
    fn rotation(&self) -> Matrix3<S> {
        let Self { roll: [sin, cos], pitch: [sin_pitch, cos_pitch] } = *self;
        let (o, z) = (S::ZERO, -sin_pitch);
        Matrix3([[cos_pitch, sin_pitch * sin, sin_pitch * cos], [o, cos, -sin], [z, cos_pitch * sin, cos_pitch * cos]])
    }

    /// Roll and pitch.
    fn angles(&self) -> [S; 2] {
        [self.roll, self.pitch].map(|[sin, cos]| sin.atan2(cos))
    }

    /// E.
    fn matrix(&self) -> Matrix3<S> {
        let Self { roll: [sin, cos], pitch: [sin_pitch, cos_pitch] } = *self;
        let (o, i) = (S::ZERO, S::ONE);
        Matrix3([[i, o, -sin_pitch], [o, cos, sin * cos_pitch], [o, -sin, cos * cos_pitch]])
    }

    /// Its inverse.
    fn inverse(&self) -> Matrix3<S> {
        let Self { roll: [sin, cos], pitch: [sin_pitch, cos_pitch] } = *self;
        let (o, i, tan_pitch) = (S::ZERO, S::ONE, sin_pitch / cos_pitch);
        Matrix3([[i, sin * tan_pitch, cos * tan_pitch], [o, cos, -sin], [o, sin / cos_pitch, cos / cos_pitch]])
    }

    /// `E' (roll', pitch', yaw')`.
    fn drift(&self, rates: Vector3<S>) -> Vector3<S> {
        let Self { roll: [sin, cos], pitch: [sin_pitch, cos_pitch] } = *self;
        let [roll, pitch, yaw] = rates.0;
        let (of_yaw, of_pitch) = (roll * yaw * cos_pitch, roll * pitch);
        let both = pitch * yaw * sin_pitch + of_pitch;
        Vector3([-(pitch * yaw * cos_pitch), of_yaw * cos - both * sin, -(of_yaw * sin) - both * cos])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spatial::{Symmetric3, exp};

    fn somewhere() -> (Frame, SlowFrame, Twist) {
        let frame = Frame { rotation: exp(Vector3::new(0.3, -0.4, 0.9)), position: Vector3::new(3.0, -2.0, 0.5) };
        let twist = Twist { angular: Vector3::new(0.2, -0.15, 0.3), linear: Vector3::new(1.0, -0.4, 0.6) };
        (frame, SlowFrame { position: [1.0, 2.0], heading: 0.7, lean: [0.1, -0.05] }, twist)
    }

    /// Roll, pitch and yaw by their definition, `R = Rz(yaw) Ry(pitch) Rx(roll)`.
    fn angles(rotation: &Matrix3) -> Vector3 {
        let r = &rotation.0;
        Vector3::new(libm::atan2(r[2][1], r[2][2]), -libm::asin(r[2][0]), libm::atan2(r[1][0], r[0][0]))
    }

    /// Central differences of a motion at a constant twist; their error is of second order in 1e-5 s.
    #[test]
    fn twists_become_rates_of_place_and_angles_and_drifts_their_rates() {
        let (frame, slow, twist) = somewhere();
        let after = |s: f64| Frame { rotation: frame.rotation * exp(twist.angular * s), position: frame.position };
        let (h, axes) = (1e-5, SeaAxes::of(&frame, &slow));
        let from_mean = |s: f64| angles(&(axes.mean.transpose() * after(s).rotation));
        let rates = (from_mean(h) - from_mean(-h)) * (0.5 / h);
        assert!((rates - axes.twist(&twist).angular).norm() < 1e-9);
        let at = |s: f64| SeaAxes::of(&after(s), &slow).twist(&twist);
        let (change, drift) = ((at(h) - at(-h)) * (0.5 / h), axes.drift(&twist));
        assert!(
            (change - drift).angular.norm() < 1e-9 && (change - drift).linear.norm() < 1e-9,
            "{change:?} {drift:?}"
        );
    }

    /// About its attitude on average a hull's twist is what it is, seen from the slow frame.
    #[test]
    fn on_average_the_modes_are_those_of_the_twist() {
        let (frame, _, twist) = somewhere();
        let (slow, to_world) = (SlowFrame::of(&frame), |v: Vector3| frame.rotation * v);
        let axes = SeaAxes::of(&frame, &slow);
        let Twist { angular, linear } = axes.twist(&twist);
        let seen = |v: Vector3| slow.rotation().transpose_times(to_world(v)).0;
        let expected = [seen(twist.linear), seen(twist.angular)].concat();
        for (found, expected) in axes.modes(linear, angular).iter().zip(expected) {
            assert!((found - expected).abs() < 1e-15, "{found} {expected}");
        }
    }

    #[test]
    fn a_slow_frame_of_a_hull_has_its_attitude() {
        let (frame, ..) = somewhere();
        let found = SeaAxes::of(&frame, &SlowFrame::of(&frame)).mean;
        for k in 0..3 {
            assert!((found.row(k) - frame.rotation.row(k)).norm() < 1e-15, "{found:?}");
        }
    }

    #[test]
    fn wrenches_do_the_work_of_their_twists_and_inertias_keep_their_energy() {
        let (frame, slow, twist) = somewhere();
        let axes = SeaAxes::of(&frame, &slow);
        let load = Wrench { moment: Vector3::new(3.0, -2.0, 1.0), force: Vector3::new(-1.0, 4.0, 2.0) };
        let in_body = axes.wrench_to_body(&load);
        assert!((in_body.dot(&twist) - load.dot(&axes.twist(&twist))).abs() < 1e-14);
        let back = axes.wrench_of_body(&in_body) - load;
        assert!(back.moment.norm() < 1e-14 && back.force.norm() < 1e-14);
        let added = SpatialInertia::rigid(2.0, Symmetric3::diagonal([3.0, 5.0, 7.0]))
            .to_parent(&Frame::translation(Vector3::new(0.3, 0.1, -0.2)));
        let [seen, given] = [axes.inertia_in_body(&added).quadratic(&twist), added.quadratic(&axes.twist(&twist))];
        assert!((seen - given).abs() < 1e-14 * given);
    }
}
