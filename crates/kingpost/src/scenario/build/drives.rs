//! Drives, inputs and prescribed motions.

use super::super::schema::{self, History, PrismaticMode, RevoluteMode, Scenario};
use super::bodies::joint_name;
use super::reading::{Gathered, Reading};
use super::{FieldError, known};
use crate::drives::{Clock, Drive, Motor, PrescribedMotion, Profile, Pulse, Servo};
use crate::model::{Joint, Mode, Model};
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
        let parts = Parts::of(name, &scenario.part(|scenario| &scenario.drives[name]));
        known(&format!("{}.joint", parts.field), parts.joint, joints(scenario.first(), parts.rotary))?;
        let profile = match parts.law {
            Law::Motor { history, pulse, .. } => Some(profile(&parts.field, history, pulse)?),
            Law::Servo { .. } => None,
        };
        let Some(joint) = model.joint(parts.joint).filter(|_| parts.enabled) else { continue };
        check_free(&parts, &model.joints[joint])?;
        let (coordinate, position) = (model.tree.nodes[joint].velocities, model.tree.nodes[joint].positions);
        drives.push(match (parts.law, profile) {
            (Law::Motor { effort, history, .. }, Some(profile)) => {
                let input = (history == History::Lever).then(|| {
                    inputs.push(Input { name: name.to_string(), unit: "1", lower: -1.0, upper: 1.0, value: 0.0 });
                    inputs.len() - 1
                });
                Drive::Motor(Motor { coordinate, effort, profile, input })
            }
            (Law::Servo { numbers: [target, stiffness, damping, limit] }, _) => {
                Drive::Servo(Servo { position, coordinate, target, stiffness, damping, limit })
            }
            (Law::Motor { .. }, None) => continue,
        });
    }
    for motion in prescribed(scenario, model)? {
        v[motion.coordinate] = motion.rate_at(Clock { time_s: 0.0, middle_s: 0.0 });
        drives.push(Drive::Prescribed(motion));
    }
    Ok(Drives { drives, inputs })
}

/// A drive that is on has nothing to say in a joint that is held or prescribed.
fn check_free<S: Gathered>(parts: &Parts<S>, joint: &Joint<S>) -> Result<(), FieldError> {
    let mode = match joint.mode {
        Mode::Free => return Ok(()),
        Mode::Held => "held",
        Mode::Prescribed => "prescribed",
    };
    let found = format!("{}, which is {mode}", parts.joint);
    Err(FieldError::new(format!("{}.joint", parts.field), found, "a joint whose mode is free, for a drive that is on"))
}

/// A drive without the difference between turning and sliding.
struct Parts<'a, S> {
    field: String,
    enabled: bool,
    joint: &'a str,
    rotary: bool,
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
}

impl<'a, S: Gathered> Parts<'a, S> {
    fn of(name: &str, drive: &Reading<'a, schema::Drive>) -> Self {
        let motor = |history, pulse: &'a Option<schema::Pulse>| Law::Motor {
            effort: drive.number(effort),
            history,
            pulse: pulse.as_ref(),
        };
        let servo = || Law::Servo { numbers: drive.numbers(servo_numbers) };
        let (kind, enabled, joint, rotary, law) = match drive.first() {
            schema::Drive::Motor(d) => ("motor", d.enabled, &d.joint, true, motor(d.history, &d.pulse)),
            schema::Drive::LinearMotor(d) => ("linear_motor", d.enabled, &d.joint, false, motor(d.history, &d.pulse)),
            schema::Drive::Servo(d) => ("servo", d.enabled, &d.joint, true, servo()),
            schema::Drive::LinearServo(d) => ("linear_servo", d.enabled, &d.joint, false, servo()),
        };
        Self { field: format!("drives.{name}.{kind}"), enabled, joint: joint.as_str(), rotary, law }
    }
}

/// A motor's full torque or force; 0 for other drives.
fn effort(drive: &schema::Drive) -> f64 {
    match drive {
        schema::Drive::Motor(d) => d.torque_n_m,
        schema::Drive::LinearMotor(d) => d.force_n,
        schema::Drive::Servo(_) | schema::Drive::LinearServo(_) => 0.0,
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
        schema::Drive::Motor(_) | schema::Drive::LinearMotor(_) => [0.0; 4],
    }
}

/// Names of the revolute or of the prismatic joints, those of bodies that are not enabled too.
fn joints(scenario: &Scenario, rotary: bool) -> impl Iterator<Item = &str> {
    scenario.bodies.iter().filter_map(move |(name, body)| {
        let fits = match body.joint {
            schema::Joint::Revolute(_) => rotary,
            schema::Joint::Prismatic(_) => !rotary,
            schema::Joint::Floating(_) | schema::Joint::Fixed(_) => false,
        };
        fits.then(|| joint_name(name, body))
    })
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

/// The motions of the prescribed joints that are there.
fn prescribed<S: Gathered>(
    scenario: &Reading<Scenario>,
    model: &Model<S>,
) -> Result<Vec<PrescribedMotion<S>>, FieldError> {
    let mut motions = Vec::new();
    for (i, body) in model.bodies.iter().enumerate() {
        let joint = scenario.part(|scenario| &scenario.bodies[body.name.as_str()].joint);
        let Some((kind, history, pulse)) = prescribed_law(joint.first()) else { continue };
        let field = format!("bodies.{}.joint.{kind}.mode.prescribed", body.name);
        if history == History::Lever {
            return Err(FieldError::new(
                format!("{field}.history"),
                "lever",
                "constant or pulse, for a prescribed motion",
            ));
        }
        let profile = profile(&field, history, pulse)?;
        if history == History::Pulse && pulse.is_some_and(|p| p.rise_s.get() == 0.0) {
            let allowed = "a number greater than 0: a rate cannot jump";
            return Err(FieldError::new(format!("{field}.pulse.rise_s"), 0, allowed));
        }
        let rate = joint.number(prescribed_rate);
        motions.push(PrescribedMotion { coordinate: model.tree.nodes[i].velocities, rate, profile });
    }
    Ok(motions)
}

/// The kind of a joint that is prescribed, and how its rate goes with time.
fn prescribed_law(joint: &schema::Joint) -> Option<(&'static str, History, Option<&schema::Pulse>)> {
    match joint {
        schema::Joint::Revolute(schema::RevoluteJoint { mode: RevoluteMode::Prescribed(given), .. }) => {
            Some(("revolute", given.history, given.pulse.as_ref()))
        }
        schema::Joint::Prismatic(schema::PrismaticJoint { mode: PrismaticMode::Prescribed(given), .. }) => {
            Some(("prismatic", given.history, given.pulse.as_ref()))
        }
        _ => None,
    }
}

/// The full rate of a joint that is prescribed; 0 for others.
fn prescribed_rate(joint: &schema::Joint) -> f64 {
    match joint {
        schema::Joint::Revolute(schema::RevoluteJoint { mode: RevoluteMode::Prescribed(given), .. }) => {
            given.rate_rad_s
        }
        schema::Joint::Prismatic(schema::PrismaticJoint { mode: PrismaticMode::Prescribed(given), .. }) => {
            given.speed_m_s
        }
        _ => 0.0,
    }
}
