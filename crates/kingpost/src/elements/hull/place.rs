//! The position and motion of a hull, and the slow frame in which its wave loads are computed.

use crate::dynamics::LinkKinematics;
use crate::elements::Context;
use crate::model::Model;
use crate::scalar::Scalar;
use crate::spatial::{Frame, Matrix3, SpatialInertia, Symmetric3, Twist, Vector3, Wrench, hat};

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

    /// Returns the frame and the twist of the hull.
    pub fn motion(&self, at: &Context<'_, S>) -> HullMotion<S> {
        self.motion_of(at.model, at.links)
    }

    /// Returns the frame and the twist of the hull from kinematics alone.
    pub fn motion_of(&self, model: &Model<S>, links: &LinkKinematics<S>) -> HullMotion<S> {
        let twist = self.in_body().twist_to_child(&links.body_twist(model, self.body));
        HullMotion { frame: self.frame(model, links), twist }
    }

    /// Returns the twist relative to water that flows at `current` (world, m/s), in the body's axes about the origin,
    /// and the current in those axes.
    pub fn through_water(&self, at: &Context<'_, S>, current: Vector3<S>) -> (Twist<S>, Vector3<S>) {
        let twist = self.in_body().twist_to_child(&at.links.body_twist(at.model, self.body));
        let stream = at.links.to_body_axes(at.model, self.body, current);
        (Twist { linear: twist.linear - stream, ..twist }, stream)
    }

    /// Transforms a wrench about the data's origin to the centre of mass, both in body axes.
    pub fn about_centre(&self, wrench: &Wrench<S>) -> Wrench<S> {
        self.in_body().wrench_to_parent(wrench)
    }

    /// Returns the frame of the data in the body's frame.
    pub fn in_body(&self) -> Frame<S> {
        Frame::translation(self.origin)
    }
}

/// The frame of the first-order loads: level, at the average position and heading of the hull.
///
/// First-order loads at the hull's present position would have a mean through the phase of the waves, which is a
/// second-order effect.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LowFrequencyFrame<S = f64> {
    /// x and y in the world, m.
    pub position: [S; 2],
    /// Heading, rad, without jumps at a full turn.
    pub heading: S,
    /// Roll and pitch, rad.
    pub lean: [S; 2],
}

impl<S: Scalar> LowFrequencyFrame<S> {
    /// Returns the position, heading, roll and pitch of a hull.
    pub fn of(frame: &Frame<S>) -> Self {
        let [x, y, _] = frame.position.0;
        Self { position: [x, y], heading: heading(&frame.rotation), lean: RollAndPitch::of(&frame.rotation).angles() }
    }

    /// Returns the rotation about the vertical from the slow frame's level axes to the world's.
    pub fn rotation(&self) -> Matrix3<S> {
        let (sin, cos) = self.heading.sin_cos();
        let (o, i) = (S::ZERO, S::ONE);
        Matrix3([[cos, -sin, o], [sin, cos, o], [o, o, i]])
    }

    /// Rotation from the hull's average axes to the slow frame's.
    fn leaning(&self) -> Matrix3<S> {
        let [roll, pitch] = self.lean.map(|angle| angle.sin_cos().into());
        RollAndPitch { roll, pitch }.rotation()
    }
}

/// Returns the yaw of an orientation, rad.
fn heading<S: Scalar>(rotation: &Matrix3<S>) -> S {
    let forward = rotation.column(0);
    forward[1].atan2(forward[0])
}

/// The axes of a hull's coefficients on its body.
#[derive(Clone, Copy, Debug)]
pub struct CoefficientFrame<S = f64> {
    /// The body.
    pub body: usize,
    /// Frame of the coefficients in the axes of the body, about its centre of mass. For coefficients of the upright
    /// hull its axes are the hull's.
    pub in_body: Frame<S>,
}

impl<S: Scalar> CoefficientFrame<S> {
    /// Returns its frame in the world.
    pub fn frame(&self, model: &Model<S>, links: &LinkKinematics<S>) -> Frame<S> {
        links.body_frame(model, self.body).times(&self.in_body)
    }
}

/// The coordinates of linear theory, along which the wave loads act: level, at the hull's average position. Roll, pitch
/// and yaw are rotations from the hull's average attitude: yaw about its vertical, pitch about the horizontal axis
/// across the present heading, roll about the hull's longitudinal axis. T maps the twist of the body about its centre
/// of mass, in its axes, to the rates w of these coordinates; its transpose maps a load along them to a load on the
/// body.
///
/// Radiation, excitation and added mass of a listing hull refer to level axes: waves much longer than the hull lift it
/// vertically at any list.
///
/// The neglected terms are of second order and excite no motion. Other axes would excite motion. Forces in axes that
/// yaw with the waves would have a mean, which belongs to the drift; so would a yaw moment about an axis, or with a
/// lever arm, that tilts with the waves. Pitch moments in axes that do not yaw with the hull, or yaw moments in axes
/// that do not pitch with the hull, would roll a slender ship at the difference frequencies.
///
/// The lever arm of yaw is measured from the centre of mass of the whole ship with crane and load, because the sum of
/// all forces accelerates that point. About the hull's centre of mass, relative to which a swinging load moves,
/// first-order forces would have a mean moment.
#[derive(Clone, Copy, Debug)]
pub struct SeaAxes<S = f64> {
    /// Rotation from the hull's average axes to the slow frame's.
    leaning: Matrix3<S>,
    turns: RollAndPitch<S>,
    /// Matrix from angular velocity in body axes to rates of roll, pitch and yaw, and the inverse.
    turning: Matrix3<S>,
    turning_back: Matrix3<S>,
    /// Rotation from the body's axes to level axes, at the hull's attitude relative to its average.
    level: Matrix3<S>,
    /// Matrix from angular rates to the velocity of the point where forces act, relative to the centre of mass.
    lever: Matrix3<S>,
    /// From the body's axes to those of the coefficients.
    to_data: Matrix3<S>,
}

impl<S: Scalar> SeaAxes<S> {
    /// Returns the axes for a hull with these coefficient axes in the world. `off` is the horizontal deviation, m, of
    /// the ship's centre of mass from its mean position relative to the hull's centre of mass.
    pub fn of(on: &CoefficientFrame<S>, in_world: &Frame<S>, slow: &LowFrequencyFrame<S>, off: [S; 2]) -> Self {
        let (leaning, heading) = (slow.leaning(), slow.rotation());
        let (to_data, mean) = (on.in_body.rotation.transpose(), heading * leaning);
        let from_mean = mean.transpose() * in_world.rotation;
        let turns = RollAndPitch::of(&from_mean);
        Self {
            turning: leaning * turns.inverse() * to_data,
            turning_back: on.in_body.rotation * turns.matrix() * leaning.transpose(),
            level: leaning * from_mean * to_data,
            lever: lever(leaning * (to_data * on.in_body.position), off),
            leaning,
            turns,
            to_data,
        }
    }

    /// Returns w = T nu.
    pub fn rates(&self, of_body: &Twist<S>) -> Twist<S> {
        let angular = self.turning * of_body.angular;
        Twist { angular, linear: self.level * of_body.linear + self.lever * angular }
    }

    /// Returns `T' nu`, the part of the rate of T nu that depends on velocities only. `off_rate` is the rate of `off`.
    pub fn drift(&self, of_body: &Twist<S>, off_rate: [S; 2]) -> Twist<S> {
        let turning = self.turning * of_body.angular;
        let rates = self.leaning.transpose_times(turning);
        let angular = -(self.leaning * (self.turns.inverse() * self.turns.drift(rates)));
        let turned = Vector3::new(-(turning[2] * off_rate[1]), turning[2] * off_rate[0], S::ZERO);
        let linear = self.level * of_body.angular.cross(of_body.linear) + self.lever * angular + turned;
        Twist { angular, linear }
    }

    /// Returns `T^T F`, about the body's centre of mass, in its axes.
    pub fn wrench_to_body(&self, wrench: &Wrench<S>) -> Wrench<S> {
        let moment = wrench.moment + self.lever.transpose_times(wrench.force);
        Wrench { moment: self.turning.transpose_times(moment), force: self.level.transpose_times(wrench.force) }
    }

    /// Returns F from `T^T F`.
    pub fn wrench_of_body(&self, wrench: &Wrench<S>) -> Wrench<S> {
        let force = self.level * wrench.force;
        let moment = self.turning_back.transpose_times(wrench.moment) - self.lever.transpose_times(force);
        Wrench { moment, force }
    }

    /// Returns `T^T A T`.
    pub fn inertia_in_body(&self, added: &SpatialInertia<S>) -> SpatialInertia<S> {
        let (turning, level) = (self.turning.transpose(), self.level.transpose());
        let of_linear = self.lever.transpose() * added.linear.to_matrix();
        let coupling = added.coupling + of_linear;
        let with_lever = added.coupling * self.lever;
        let angular = added.angular.to_matrix() + with_lever + with_lever.transpose() + of_linear * self.lever;
        SpatialInertia {
            angular: Symmetric3::from_upper(&angular).rotated(&turning),
            coupling: turning * coupling * self.level,
            linear: added.linear.rotated(&level),
        }
    }

    /// Returns A of a listing hull at its average attitude, about the centre of mass in the body's axes.
    pub fn listing(&self, added: &SpatialInertia<S>, on: &CoefficientFrame<S>) -> SpatialInertia<S> {
        added.to_parent(&self.level_in_body(on))
    }

    /// Returns the level axes of the hull at its average attitude, about the coefficients' origin, in the frame of the body.
    pub fn level_in_body(&self, on: &CoefficientFrame<S>) -> Frame<S> {
        Frame { rotation: (self.leaning * self.to_data).transpose(), position: on.in_body.position }
    }
}

/// Returns the matrix from angular rates to the velocity of the point where forces act, relative to the centre of mass:
/// the point is at `to_origin`, for yaw shifted horizontally by `off`.
fn lever<S: Scalar>(to_origin: Vector3<S>, [x, y]: [S; 2]) -> Matrix3<S> {
    let to_left = hat(to_origin).0.map(|row| row.map(|entry| -entry));
    let [[a, b, c], [d, e, f], last] = to_left;
    Matrix3([[a, b, c - y], [d, e, f + x], last])
}

/// Roll and pitch of an orientation: `omega = E (roll', pitch', yaw')`, omega in body axes (Fossen, *Handbook of Marine Craft
/// Hydrodynamics and Motion Control*, 2011, eq. 2.28). E is singular where the bow points straight up or down.
#[derive(Clone, Copy, Debug)]
struct RollAndPitch<S> {
    roll: [S; 2],
    pitch: [S; 2],
}

impl<S: Scalar> RollAndPitch<S> {
    /// Returns the sines and cosines of roll and pitch, from the vertical in body axes.
    fn of(rotation: &Matrix3<S>) -> Self {
        let [x, y, z] = rotation.row(2).0;
        let level = (y * y + z * z).sqrt();
        Self { roll: [y / level, z / level], pitch: [-x, level] }
    }

    /// Returns the rotation by roll and then by pitch.
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

    /// Returns the inverse of E.
    fn inverse(&self) -> Matrix3<S> {
        let Self { roll: [sin, cos], pitch: [sin_pitch, cos_pitch] } = *self;
        let (o, i, tan_pitch) = (S::ZERO, S::ONE, sin_pitch / cos_pitch);
        Matrix3([[i, sin * tan_pitch, cos * tan_pitch], [o, cos, -sin], [o, sin / cos_pitch, cos / cos_pitch]])
    }

    /// Returns `E' (roll', pitch', yaw')`.
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

    fn somewhere() -> (Frame, LowFrequencyFrame, Twist) {
        let frame = Frame { rotation: exp(Vector3::new(0.3, -0.4, 0.9)), position: Vector3::new(3.0, -2.0, 0.5) };
        let twist = Twist { angular: Vector3::new(0.2, -0.15, 0.3), linear: Vector3::new(1.0, -0.4, 0.6) };
        (frame, LowFrequencyFrame { position: [1.0, 2.0], heading: 0.7, lean: [0.1, -0.05] }, twist)
    }

    /// Roll, pitch and yaw by their definition, `R = Rz(yaw) Ry(pitch) Rx(roll)`.
    fn angles(rotation: &Matrix3) -> Vector3 {
        let r = &rotation.0;
        Vector3::new(libm::atan2(r[2][1], r[2][2]), -libm::asin(r[2][0]), libm::atan2(r[1][0], r[0][0]))
    }

    /// A hull whose coefficients' origin and axes are not those of its body.
    fn on() -> CoefficientFrame {
        let rotation = exp(Vector3::new(-0.1, 0.02, 0.0));
        CoefficientFrame { body: 0, in_body: Frame { rotation, position: Vector3::new(1.5, -0.3, -0.8) } }
    }

    /// The frame of the coefficients after a time at a constant twist of the body.
    fn after(body: &Frame, twist: &Twist, time_s: f64) -> Frame {
        let moved = Frame {
            rotation: body.rotation * exp(twist.angular * time_s),
            position: body.position + body.rotation * (twist.linear * time_s),
        };
        moved.times(&on().in_body)
    }

    /// Central differences of a motion at a constant twist; their error is of second order in 1e-5 s.
    #[test]
    fn rates_are_the_derivatives_of_the_coordinates_and_drifts_those_of_the_rates() {
        let (body, slow, twist) = somewhere();
        let (h, mean) = (1e-5, slow.rotation() * slow.leaning());
        let from_mean = |s: f64| angles(&(mean.transpose() * after(&body, &twist, s).rotation));
        let off = |s: f64| [0.4 + 0.2 * s, -0.3 + 0.5 * s];
        let axes = |s: f64| SeaAxes::of(&on(), &after(&body, &twist, s), &slow, off(s));
        let rates = slow.leaning() * ((from_mean(h) - from_mean(-h)) * (0.5 / h));
        assert!((rates - axes(0.0).rates(&twist).angular).norm() < 1e-9);
        let (ahead, astern) = (axes(h).rates(&twist), axes(-h).rates(&twist));
        let drift = axes(0.0).drift(&twist, [0.2, 0.5]);
        let angular = (ahead.angular - astern.angular) * (0.5 / h) - drift.angular;
        let linear = (ahead.linear - astern.linear) * (0.5 / h) - drift.linear;
        assert!(angular.norm() < 1e-8 && linear.norm() < 1e-8, "{angular:?} {linear:?}");
    }

    /// A push turns the hull about the whole ship's centre of mass, also after that centre has moved.
    #[test]
    fn a_force_turns_the_hull_about_the_moved_centre_of_mass_of_the_whole_ship() {
        let (body, _, _) = somewhere();
        let in_world = body.times(&on().in_body);
        let (slow, off) = (LowFrequencyFrame::of(&in_world), [0.7, -0.4]);
        let [swung, at_mean] = [off, [0.0; 2]].map(|off| SeaAxes::of(&on(), &in_world, &slow, off));
        let push = Wrench { moment: Vector3::zero(), force: Vector3::new(3.0, -2.0, 0.0) };
        let more = at_mean.wrench_of_body(&(swung.wrench_to_body(&push) - at_mean.wrench_to_body(&push)));
        let expected = Vector3::new(off[0], off[1], 0.0).cross(push.force);
        assert!((more.moment - expected).norm() < 1e-13 && more.force.norm() < 1e-14, "{more:?}");
    }

    /// At its average attitude and position a hull's rates are its twist at the origin, in the slow frame.
    #[test]
    fn at_the_average_attitude_and_position_the_rates_are_the_twist_at_the_origin() {
        let (body, _, twist) = somewhere();
        let in_world = body.times(&on().in_body);
        let (slow, at_origin) = (LowFrequencyFrame::of(&in_world), on().in_body.twist_to_child(&twist));
        let found = SeaAxes::of(&on(), &in_world, &slow, [0.0; 2]).rates(&twist);
        let seen = |v: Vector3| slow.rotation().transpose_times(in_world.rotation * v);
        assert!((found.linear - seen(at_origin.linear)).norm() < 1e-14);
        assert!((found.angular - seen(at_origin.angular)).norm() < 1e-14);
    }

    #[test]
    fn a_low_frequency_frame_of_a_hull_has_its_attitude() {
        let (frame, ..) = somewhere();
        let slow = LowFrequencyFrame::of(&frame);
        let found = slow.rotation() * slow.leaning();
        for k in 0..3 {
            assert!((found.row(k) - frame.rotation.row(k)).norm() < 1e-15, "{found:?}");
        }
    }

    fn added() -> SpatialInertia {
        SpatialInertia::rigid(2.0, Symmetric3::diagonal([3.0, 5.0, 7.0]))
            .to_parent(&Frame::translation(Vector3::new(0.3, 0.1, -0.2)))
    }

    #[test]
    fn wrenches_do_the_work_of_their_rates_and_inertias_keep_their_energy() {
        let (body, slow, twist) = somewhere();
        let axes = SeaAxes::of(&on(), &body.times(&on().in_body), &slow, [0.4, -0.3]);
        let load = Wrench { moment: Vector3::new(3.0, -2.0, 1.0), force: Vector3::new(-1.0, 4.0, 2.0) };
        let in_body = axes.wrench_to_body(&load);
        assert!((in_body.dot(&twist) - load.dot(&axes.rates(&twist))).abs() < 1e-13);
        let back = axes.wrench_of_body(&in_body) - load;
        assert!(back.moment.norm() < 1e-13 && back.force.norm() < 1e-13);
        let [seen, given] = [axes.inertia_in_body(&added()).quadratic(&twist), added().quadratic(&axes.rates(&twist))];
        assert!((seen - given).abs() < 1e-13 * given);
    }

    /// At rest in its mean position the added mass of a listing hull is level.
    #[test]
    fn the_added_mass_of_a_listing_hull_at_its_mean_position_is_level() {
        let (body, _, twist) = somewhere();
        let in_world = body.times(&on().in_body);
        let axes = SeaAxes::of(&on(), &in_world, &LowFrequencyFrame::of(&in_world), [0.0; 2]);
        let [listing, along] = [axes.listing(&added(), &on()), axes.inertia_in_body(&added())];
        assert!((listing.quadratic(&twist) - along.quadratic(&twist)).abs() < 1e-13 * along.quadratic(&twist));
    }
}
