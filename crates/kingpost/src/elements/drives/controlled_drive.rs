//! A drive that follows a set-point within its limits: a winch, a slewing gear, a luffing drive.

use crate::dynamics::Loads;
use crate::elements::{
    Context, Declaration, Element, ElementState, EvaluationMode, Input, Output, Settling, StateDeclaration, Support,
};
use crate::model::AxisMotion;
use crate::scalar::Scalar;

/// A reference that moves to the set-point within limits of speed, acceleration and jerk, and an effort that follows it:
///
/// ```text
/// x_r' = v_r - (tau_free - tau) / c,    v_r' = a_r
/// a_t  = (v_t - v_r) / T,               within +-a_max
/// a_r  = a_t,  or with a limit of jerk  a_r' = 4 (a_t - a_r) / T,  within +-j_max
/// tau_free = h + k (x_r - q) + c (v_r - v),   tau within +-tau_max, and where it drives within P_max / |v|
/// ```
///
/// For a speed set-point the target speed is the set-point within +-v_max. For a position set-point x it is `v_t = a T'
/// (sqrt(1 + 2 |e| / (a T'^2)) - 1)` towards it, with e = x - x_r, T' = 4 T and a = a_max / 2: half of the acceleration
/// then suffices to stop at x. With a jerk limit, T is at least the time in which the acceleration reaches its limit. h
/// is the effort that holds the joint at rest at the start. While the effort is at its limit the reference moves with
/// the load, so that the drive does not catch up afterwards (back-calculation: Astrom & Hagglund, *Advanced PID
/// Control*, 2006, sec. 3.5).
#[derive(Clone, Debug)]
pub struct ControlledDrive<S = f64> {
    /// Name in the results.
    pub name: String,
    /// Index in q.
    pub position: usize,
    /// Index in v.
    pub coordinate: usize,
    /// Whether it turns or slides.
    pub motion: AxisMotion,
    /// Its set-point.
    pub set_point: SetPoint,
    /// The set-point, to which the input is added: N m or N, rad/s or m/s, rad or m.
    pub value: S,
    /// Its limits.
    pub limits: DriveLimits<S>,
    /// k, N m/rad or N/m.
    pub stiffness: S,
    /// c, N m s/rad or N s/m; above 0.
    pub damping: S,
    /// T, s.
    pub response_time: S,
    /// The coordinate at the start; the drive holds the joint there while an equilibrium is sought.
    pub start: S,
    /// The effort that holds the joint there, with which the run begins.
    pub hold: [S; 1],
}

/// The set-point of a drive.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SetPoint {
    /// A torque or a force, at once.
    Effort,
    /// A speed.
    Speed,
    /// A position.
    Position,
}

/// Limits of a drive, in rad and N m or in m and N.
#[derive(Clone, Copy, Debug)]
pub struct DriveLimits<S = f64> {
    /// v_max.
    pub speed: S,
    /// a_max.
    pub acceleration: S,
    /// j_max.
    pub jerk: Option<S>,
    /// tau_max.
    pub effort: S,
    /// P_max, W.
    pub power: Option<S>,
}

/// States: the reference.
const POSITION: usize = 0;
const SPEED: usize = 1;
const ACCELERATION: usize = 2;

/// The effort of a drive, with and without limits.
struct Effort<S> {
    free: S,
    given: S,
    /// Active limit of the effort.
    limit: S,
}

impl<S: Scalar> Element<S> for ControlledDrive<S> {
    fn name(&self) -> &str {
        &self.name
    }

    fn declare(&self) -> Declaration {
        let [position, speed, acceleration, effort] = match self.motion {
            AxisMotion::Rotation => ["rad", "rad/s", "rad/s^2", "N m"],
            AxisMotion::Translation => ["m", "m/s", "m/s^2", "N"],
        };
        let reference = [("position", position), ("speed", speed), ("acceleration", acceleration)];
        let (unit, farthest) = match self.set_point {
            SetPoint::Effort => (effort, self.limits.effort.value()),
            SetPoint::Speed => (speed, self.limits.speed.value()),
            SetPoint::Position => (position, FARTHEST),
        };
        let input =
            Input { name: self.name.clone(), unit, lower: -farthest, upper: farthest, value: 0.0, signal: None };
        let states = reference[..self.state_count()].iter().map(|(name, unit)| StateDeclaration::new(*name, unit));
        Declaration { states: states.collect(), inputs: vec![input], outputs: self.shown(), ..Declaration::default() }
    }

    /// Sets the reference to the coordinate's position and rate.
    fn begin(&mut self, at: &Context<'_, S>, own: &mut ElementState<'_, S>) {
        if let [position, speed, ..] = own.states {
            (*position, *speed) = (at.q[self.position], at.v[self.coordinate]);
        }
    }

    fn loads(&mut self, at: &Context<'_, S>, loads: &mut Loads<S>) {
        let effort = self.effort(at).given;
        loads.force[self.coordinate] += effort;
        loads.power.drives += effort * at.v[self.coordinate];
    }

    fn rates(&mut self, at: &Context<'_, S>, rates: &mut [S]) {
        let effort = self.effort(at);
        let wanted = self.wanted_acceleration(at);
        match (rates, at.states) {
            ([of_position, of_speed], [_, speed]) => {
                *of_position = *speed - (effort.free - effort.given) / self.damping;
                *of_speed = wanted;
            }
            ([of_position, of_speed, of_acceleration], [_, speed, acceleration]) => {
                *of_position = *speed - (effort.free - effort.given) / self.damping;
                *of_speed = *acceleration;
                let jerk = (wanted - *acceleration) * (S::constant(4.0) / self.reaction());
                *of_acceleration = self.limits.jerk.map_or(jerk, |limit| jerk.clipped(-limit, limit));
            }
            _ => {}
        }
    }

    fn settling(&self) -> Option<&dyn Settling<S>> {
        (self.set_point != SetPoint::Effort).then_some(self)
    }

    fn settling_mut(&mut self) -> Option<&mut dyn Settling<S>> {
        if self.set_point == SetPoint::Effort { None } else { Some(self) }
    }

    fn outputs(&mut self, at: &Context<'_, S>, out: &mut Vec<S>) {
        let (effort, rate) = (self.effort(at), at.v[self.coordinate]);
        let power = effort.given * rate;
        let size = |x: S| x.select_below(0.0, || -x, || x);
        let reference = at.states.get(SPEED).copied().unwrap_or(rate);
        let [used, running] = [effort.given / effort.limit, reference / self.limits.speed].map(size);
        let driving = power.select_below(0.0, || S::ZERO, || power);
        let driving = self.limits.power.map_or(S::ZERO, |limit| driving / limit);
        out.extend([effort.given, reference, power, used, running, driving]);
    }

    fn supports(&self) -> Vec<Support> {
        vec![Support::Coordinate(self.coordinate)]
    }
}

impl<S: Scalar> Settling<S> for ControlledDrive<S> {
    fn trim(&self) -> &[S] {
        &self.hold
    }

    fn set_trim(&mut self, trim: &[S]) {
        self.hold.copy_from_slice(trim);
    }

    fn take_over(&mut self, at: &Context<'_, S>) -> S {
        let off = at.q[self.position] - self.start;
        self.hold[0] += -(self.stiffness * off);
        off.select_below(0.0, || -off, || off)
    }

    fn utilisation(&self, _at: &Context<'_, S>) -> S {
        let [hold] = self.hold;
        hold.select_below(0.0, || -hold, || hold) / self.limits.effort
    }
}

/// Largest offset of a position, rad or m.
const FARTHEST: f64 = 1e6;

impl<S: Scalar> ControlledDrive<S> {
    fn state_count(&self) -> usize {
        match (self.set_point, self.limits.jerk) {
            (SetPoint::Effort, _) => 0,
            (_, None) => ACCELERATION,
            (_, Some(_)) => ACCELERATION + 1,
        }
    }

    fn shown(&self) -> Vec<Output> {
        let number = |variable, description, unit| Output::number(variable, description, "drive", &self.name, unit);
        let [effort, reference] = match self.motion {
            AxisMotion::Rotation => [
                number("drive_torque", "torque of a drive", &["N m"]),
                number("drive_reference_rate", "rate of the reference that a drive follows", &["rad/s"]),
            ],
            AxisMotion::Translation => [
                number("drive_force", "force of a drive", &["N"]),
                number("drive_reference_speed", "speed of the reference that a drive follows", &["m/s"]),
            ],
        };
        vec![
            effort,
            reference,
            number("drive_power", "power that a drive delivers; negative: absorbs", &["W"]),
            number("drive_effort_utilisation", "torque or force of a drive over its limit", &["1"]),
            number("drive_speed_utilisation", "speed of a drive's reference over its limit", &["1"]),
            number(
                "drive_power_utilisation",
                "power that a drive delivers over its power limit; 0 without a limit, and while the drive brakes",
                &["1"],
            ),
        ]
    }

    /// Returns the set-point plus the input of a user or a controller.
    fn target(&self, at: &Context<'_, S>) -> S {
        at.inputs.first().map_or(self.value, |offset| self.value + *offset)
    }

    fn effort(&self, at: &Context<'_, S>) -> Effort<S> {
        let (q, v) = (at.q[self.position], at.v[self.coordinate]);
        let free = match at.states {
            _ if self.set_point == SetPoint::Effort => self.target(at),
            [position, speed, ..] if at.evaluation != EvaluationMode::Settling => {
                self.hold[0] + self.stiffness * (*position - q) + self.damping * (*speed - v)
            }
            _ => return self.holding(q),
        };
        let limit = self.limits.effort;
        let drives = free * v;
        // Above the speed P / tau_max the power limits a driving effort; a braking effort is limited by tau_max only.
        let limit = self.limits.power.map_or(limit, |power| {
            let speed = v.select_below(0.0, || -v, || v);
            let knee = power / limit;
            drives.select_below(
                0.0,
                || limit,
                || speed.select_less(knee, || limit, || power / knee.select_less(speed, || speed, || knee)),
            )
        });
        Effort { free, given: free.clipped(-limit, limit), limit }
    }

    /// Returns the effort while an equilibrium is sought, without limits.
    fn holding(&self, q: S) -> Effort<S> {
        let effort = self.hold[0] + self.stiffness * (self.start - q);
        Effort { free: effort, given: effort, limit: self.limits.effort }
    }

    /// Returns T; with a jerk limit, at least the time that the reference needs to reach a new speed without overshoot.
    fn reaction(&self) -> S {
        let time = self.response_time;
        self.limits.jerk.map_or(time, |jerk| {
            let [to_acceleration, to_speed] = [self.limits.acceleration / jerk, (self.limits.speed / jerk).sqrt()];
            let least = to_acceleration.select_less(to_speed, || to_acceleration, || to_speed);
            time.select_less(least, || least, || time)
        })
    }

    /// Returns a_t.
    fn wanted_acceleration(&self, at: &Context<'_, S>) -> S {
        let [position, speed] = [POSITION, SPEED].map(|i| at.states.get(i).copied().unwrap_or(S::ZERO));
        let (limits, time) = (&self.limits, self.reaction());
        let wanted = match self.set_point {
            SetPoint::Position => self.approach(self.target(at) - position, time),
            _ => self.target(at),
        };
        let wanted = wanted.clipped(-limits.speed, limits.speed);
        ((wanted - speed) * (S::ONE / time)).clipped(-limits.acceleration, limits.acceleration)
    }

    /// Returns the speed towards a position at this distance: proportional to a short distance; at a long distance, the
    /// speed from which half of the acceleration limit stops in time.
    fn approach(&self, way: S, time: S) -> S {
        let slow = S::constant(4.0) * time;
        let braking = self.limits.acceleration * S::constant(0.5);
        let size = way.select_below(0.0, || -way, || way);
        let speed = braking * slow * ((S::ONE + (size + size) / (braking * slow * slow)).sqrt() - S::ONE);
        way.select_below(0.0, || -speed, || speed)
    }
}
