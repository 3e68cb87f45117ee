//! Drives, inputs and prescribed motions.

use super::super::schema::{self, BrakeState, History, Scenario};
use super::axes::axes;
use super::bodies::joint_name;
use super::reading::{Gathered, Reading};
use super::{FieldError, cylinders, histories, known, wave_motion};
use crate::dynamics::Clock;
use crate::elements::CoulombFriction;
use crate::elements::drives::{Brake, Drive, Motor, Profile, Servo};
use crate::model::AxisMotion::{self, Rotation, Translation};
use crate::model::{Mode, Model};
use crate::simulation::Input;

/// The drives that are on, and the table of what can be set from outside.
pub struct Drives<S> {
    pub drives: Vec<Drive<S>>,
    pub inputs: Vec<Input>,
}

/// Builds them, and gives prescribed joints their initial rate in `v`.
pub fn build<S: Gathered>(
    scenario: &Reading<Scenario>,
    model: &Model<S>,
    v: &mut [S],
) -> Result<Drives<S>, FieldError> {
    let (mut drives, mut inputs) = (Vec::new(), Vec::new());
    for name in scenario.first().drives.keys() {
        let Some(parts) = Parts::of(name, &scenario.part(|scenario| &scenario.drives[name])) else {
            let states = drives.iter().filter(|drive: &&Drive<S>| drive.has_state()).count();
            drives.extend(cylinders::build(scenario, name, model, &mut inputs, states)?.map(Drive::Cylinder));
            continue;
        };
        let allowed = coordinates(scenario.first(), parts.motion);
        known(&format!("{}.joint", parts.field), parts.joint, allowed.iter().map(String::as_str))?;
        let profile = match parts.law {
            Law::Motor { history, .. } => histories::of_motor(name, &parts.field, history, scenario)?,
            Law::Servo { .. } | Law::Brake { .. } => Profile::constant(),
        };
        let Some(coordinate) = model.coordinate(parts.joint).filter(|_| parts.enabled) else { continue };
        let Some((_, position)) = model.axis_coordinate(coordinate) else { continue };
        check_free(&parts, model.modes[coordinate])?;
        let mut lever = |lower, value| {
            inputs.push(Input { name: name.to_string(), unit: "1", lower, upper: 1.0, value });
            inputs.len() - 1
        };
        drives.push(match parts.law {
            Law::Motor { effort, history, .. } => {
                let input = (history == History::Lever).then(|| lever(-1.0, 0.0));
                Drive::Motor(Motor { coordinate, effort, profile, input })
            }
            Law::Servo { numbers: [target, stiffness, damping, limit] } => {
                Drive::Servo(Servo { position, coordinate, target, stiffness, damping, limit })
            }
            Law::Brake { state: BrakeState::Released, .. } => continue,
            Law::Brake { numbers: [friction, smoothing], state } => {
                let input = (state == BrakeState::Lever).then(|| lever(0.0, 1.0));
                Drive::Brake(Brake { friction: CoulombFriction { coordinate, friction, smoothing }, input })
            }
        });
    }
    for motion in histories::given_motions(scenario, model)? {
        v[motion.coordinate] = motion.rate_at(Clock { time_s: 0.0, middle_s: 0.0 });
        drives.push(Drive::Prescribed(motion));
    }
    for motion in wave_motion::build(scenario, model)? {
        v[motion.coordinates()].copy_from_slice(&motion.at(0.0).rates);
        drives.push(Drive::WaveMotion(motion));
    }
    Ok(Drives { drives, inputs })
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
    law: Law<S>,
}

/// What a drive does, in N m and rad or in N and m.
enum Law<S> {
    Motor {
        effort: S,
        history: History,
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
        let motor = |history| Law::Motor { effort: drive.number(effort), history };
        let servo = || Law::Servo { numbers: drive.numbers(servo_numbers) };
        let brake = |state| Law::Brake { numbers: drive.numbers(brake_numbers), state };
        let (kind, enabled, joint, motion, law) = match drive.first() {
            schema::Drive::Motor(d) => ("motor", d.enabled, &d.joint, Rotation, motor(d.history)),
            schema::Drive::LinearMotor(d) => ("linear_motor", d.enabled, &d.joint, Translation, motor(d.history)),
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
