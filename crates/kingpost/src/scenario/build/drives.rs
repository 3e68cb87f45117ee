//! Drives, inputs and prescribed motions.

use super::super::schema::{self, BrakeState, History, Scenario};
use super::axes::axes;
use super::bodies::joint_name;
use super::flexible::owner;
use super::reading::{Gathered, Reading};
use super::{FieldError, cylinders, known, wave_motion};
use crate::dynamics::Clock;
use crate::elements::drives::{Brake, Motor, PrescribedMotion, Profile, Pulse, Servo};
use crate::elements::{AnyElement, CoulombFriction};
use crate::model::AxisMotion::{self, Rotation, Translation};
use crate::model::{Mode, Model};

/// The drives that are on; gives prescribed joints their initial rate in `v`.
pub fn build<S: Gathered>(
    scenario: &Reading<Scenario>,
    model: &Model<S>,
    v: &mut [S],
) -> Result<Vec<AnyElement<S>>, FieldError> {
    let mut drives: Vec<AnyElement<S>> = Vec::new();
    for name in scenario.first().drives.keys() {
        let Some(parts) = Parts::of(name, &scenario.part(|scenario| &scenario.drives[name])) else {
            if let Some(cylinder) = cylinders::build(scenario, name, model)? {
                drives.push(Box::new(cylinder));
            }
            continue;
        };
        let allowed = coordinates(scenario.first(), parts.motion);
        known(&format!("{}.joint", parts.field), parts.joint, allowed.iter().map(String::as_str))?;
        let profile = match parts.law {
            Law::Motor { history, pulse, .. } => profile(&parts.field, history, pulse)?,
            Law::Servo { .. } | Law::Brake { .. } => Profile::constant(),
        };
        let Some(coordinate) = model.coordinate(parts.joint).filter(|_| parts.enabled) else { continue };
        let Some((_, position)) = model.axis_coordinate(coordinate) else { continue };
        check_free(&parts, model.modes[coordinate])?;
        drives.push(match parts.law {
            Law::Motor { effort, history, .. } => {
                let lever = (history == History::Lever).then(|| name.to_string());
                Box::new(Motor { coordinate, effort, profile, lever })
            }
            Law::Servo { numbers: [target, stiffness, damping, limit] } => {
                Box::new(Servo { position, coordinate, target, stiffness, damping, limit })
            }
            Law::Brake { state: BrakeState::Released, .. } => continue,
            Law::Brake { numbers: [friction, smoothing], state } => {
                let lever = (state == BrakeState::Lever).then(|| name.to_string());
                Box::new(Brake { friction: CoulombFriction { coordinate, friction, smoothing }, lever })
            }
        });
    }
    for motion in prescribed(scenario, model)? {
        v[motion.coordinate] = motion.rate_at(Clock { time_s: 0.0, middle_s: 0.0 });
        drives.push(Box::new(motion));
    }
    for motion in wave_motion::build(scenario, model)? {
        v[motion.coordinates()].copy_from_slice(&motion.at(0.0).rates);
        drives.push(Box::new(motion));
    }
    Ok(drives)
}

/// A drive that is on has nothing to say where the coordinate is held or prescribed.
fn check_free<S: Gathered>(parts: &Parts<S>, mode: Mode) -> Result<(), FieldError> {
    let mode = match mode {
        Mode::Free => return Ok(()),
        Mode::Held => "held",
        Mode::Prescribed => "prescribed",
    };
    let found = format!("{}, which is {mode}", parts.joint);
    Err(FieldError::new(format!("{}.joint", parts.field), found, "a joint whose mode is free, for a drive that is on"))
}

/// A drive of a joint, without the difference between turning and sliding.
struct Parts<'a, S> {
    field: String,
    enabled: bool,
    joint: &'a str,
    motion: AxisMotion,
    law: Law<'a, S>,
}

/// What a drive does, in N m and rad or in N and m.
enum Law<'a, S> {
    Motor {
        effort: S,
        history: History,
        pulse: Option<&'a schema::Pulse>,
    },
    /// Target, stiffness, damping, limit.
    Servo {
        numbers: [S; 4],
    },
    /// Capacity, smoothing speed.
    Brake {
        numbers: [S; 2],
        state: BrakeState,
    },
}

impl<'a, S: Gathered> Parts<'a, S> {
    /// `None` for a drive that is in no joint.
    fn of(name: &str, drive: &Reading<'a, schema::Drive>) -> Option<Self> {
        let motor = |history, pulse: &'a Option<schema::Pulse>| Law::Motor {
            effort: drive.number(effort),
            history,
            pulse: pulse.as_ref(),
        };
        let servo = || Law::Servo { numbers: drive.numbers(servo_numbers) };
        let brake = |state| Law::Brake { numbers: drive.numbers(brake_numbers), state };
        let (kind, enabled, joint, motion, law) = match drive.first() {
            schema::Drive::Motor(d) => ("motor", d.enabled, &d.joint, Rotation, motor(d.history, &d.pulse)),
            schema::Drive::LinearMotor(d) => {
                ("linear_motor", d.enabled, &d.joint, Translation, motor(d.history, &d.pulse))
            }
            schema::Drive::Servo(d) => ("servo", d.enabled, &d.joint, Rotation, servo()),
            schema::Drive::LinearServo(d) => ("linear_servo", d.enabled, &d.joint, Translation, servo()),
            schema::Drive::Brake(d) => ("brake", d.enabled, &d.joint, Rotation, brake(d.state)),
            schema::Drive::LinearBrake(d) => ("linear_brake", d.enabled, &d.joint, Translation, brake(d.state)),
            schema::Drive::Cylinder(_) => return None,
        };
        Some(Self { field: format!("drives.{name}.{kind}"), enabled, joint: joint.as_str(), motion, law })
    }
}

/// A motor's full torque or force; 0 for other drives.
fn effort(drive: &schema::Drive) -> f64 {
    match drive {
        schema::Drive::Motor(d) => d.torque_n_m,
        schema::Drive::LinearMotor(d) => d.force_n,
        _ => 0.0,
    }
}

/// A servo's target, stiffness, damping and limit; 0 for other drives.
fn servo_numbers(drive: &schema::Drive) -> [f64; 4] {
    match drive {
        schema::Drive::Servo(d) => {
            let (stiffness, damping) = (d.stiffness_n_m_per_rad.get(), d.damping_n_m_s_per_rad.get());
            [d.target_rad, stiffness, damping, d.torque_limit_n_m.get()]
        }
        schema::Drive::LinearServo(d) => {
            let (stiffness, damping) = (d.stiffness_n_per_m.get(), d.damping_n_s_per_m.get());
            [d.target_m, stiffness, damping, d.force_limit_n.get()]
        }
        _ => [0.0; 4],
    }
}

/// A brake's capacity and smoothing speed; 0 for other drives.
fn brake_numbers(drive: &schema::Drive) -> [f64; 2] {
    match drive {
        schema::Drive::Brake(d) => [d.torque_n_m.get(), d.smoothing_rad_s.get()],
        schema::Drive::LinearBrake(d) => [d.force_n.get(), d.smoothing_m_s.get()],
        _ => [0.0; 2],
    }
}

/// Names of the coordinates that turn or that slide, those of bodies that are not enabled too.
fn coordinates(scenario: &Scenario, motion: AxisMotion) -> Vec<String> {
    let of_body = |(name, body): (&schema::Name, &schema::Body)| {
        let axes = axes(&body.joint).into_iter().filter(|axis| axis.motion == motion);
        axes.map(|axis| axis.coordinate_name(joint_name(name, body))).collect::<Vec<_>>()
    };
    scenario.bodies.iter().flat_map(of_body).collect()
}

fn profile(field: &str, history: History, pulse: Option<&schema::Pulse>) -> Result<Profile, FieldError> {
    match (history, pulse) {
        (History::Constant | History::Lever, _) => Ok(Profile::constant()),
        (History::Pulse, Some(pulse)) => Ok(Profile::pulse(Pulse {
            rise_s: pulse.rise_s.get(),
            hold_s: pulse.hold_s.get(),
            reverse_s: pulse.reverse_s.get(),
        })),
        (History::Pulse, None) => {
            let allowed = "rise_s, hold_s and reverse_s, for a history that is a pulse";
            Err(FieldError::new(format!("{field}.pulse"), "nothing", allowed))
        }
    }
}

/// The motions of the prescribed coordinates that are there.
fn prescribed<S: Gathered>(
    scenario: &Reading<Scenario>,
    model: &Model<S>,
) -> Result<Vec<PrescribedMotion<S>>, FieldError> {
    let mut motions = Vec::new();
    for (i, body) in model.bodies.iter().enumerate() {
        let (name, 0) = owner(&body.name) else { continue };
        let joint = scenario.part(|scenario| &scenario.bodies[name].joint);
        for (k, axis) in axes(joint.first()).iter().enumerate() {
            let Some((_, history, pulse)) = &axis.prescribed else { continue };
            let path = format!("bodies.{}.joint.{}", body.name, joint.first().kind());
            let profile = prescribed_profile(&format!("{path}.{}", axis.field("mode.prescribed")), *history, pulse)?;
            let rate = joint.number(|joint| axes(joint)[k].prescribed.as_ref().map_or(0.0, |(rate, ..)| *rate));
            motions.push(PrescribedMotion { coordinate: model.tree.nodes[i].velocities + k, rate, profile });
        }
    }
    Ok(motions)
}

/// How a prescribed rate goes with time; it has no lever, and does not jump.
fn prescribed_profile(field: &str, history: History, pulse: &Option<schema::Pulse>) -> Result<Profile, FieldError> {
    if history == History::Lever {
        let allowed = "constant or pulse, for a prescribed motion";
        return Err(FieldError::new(format!("{field}.history"), "lever", allowed));
    }
    let profile = profile(field, history, pulse.as_ref())?;
    if history == History::Pulse && pulse.as_ref().is_some_and(|p| p.rise_s.get() == 0.0) {
        let allowed = "a number greater than 0: a rate cannot jump";
        return Err(FieldError::new(format!("{field}.pulse.rise_s"), 0, allowed));
    }
    Ok(profile)
}
