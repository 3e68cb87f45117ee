//! Drives, inputs and prescribed motions.

use super::super::schema::{self, History, PrismaticMode, RevoluteMode, Scenario};
use super::bodies::joint_name;
use super::{FieldError, known};
use crate::drives::{Clock, Drive, Motor, PrescribedMotion, Profile, Pulse, Servo};
use crate::model::{JointKind, Model};
use crate::simulation::Input;

/// The drives that are on, and the table of what can be set from outside.
pub struct Drives {
    pub drives: Vec<Drive>,
    pub inputs: Vec<Input>,
}

/// Builds them, and gives prescribed joints their initial rate in `v`.
pub fn build(scenario: &Scenario, model: &Model, v: &mut [f64]) -> Result<Drives, FieldError> {
    let (mut drives, mut inputs) = (Vec::new(), Vec::new());
    for (name, drive) in &scenario.drives {
        let parts = Parts::of(name, drive);
        known(&format!("{}.joint", parts.field), parts.joint, joints(scenario, parts.rotary))?;
        let profile = match parts.law {
            Law::Motor { history, pulse, .. } => Some(profile(&parts.field, history, pulse)?),
            Law::Servo { .. } => None,
        };
        let Some(joint) = model.joint(parts.joint).filter(|_| parts.enabled) else { continue };
        let (coordinate, position) = (model.tree.nodes[joint].velocities, model.tree.nodes[joint].positions);
        drives.push(match (parts.law, profile) {
            (Law::Motor { effort, history, .. }, Some(profile)) => {
                let input = (history == History::Lever).then(|| {
                    inputs.push(Input { name: name.to_string(), unit: "1", lower: -1.0, upper: 1.0, value: 0.0 });
                    inputs.len() - 1
                });
                Drive::Motor(Motor { coordinate, effort, profile, input })
            }
            (Law::Servo { target, stiffness, damping, limit }, _) => {
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

/// A drive without the difference between turning and sliding.
struct Parts<'a> {
    field: String,
    enabled: bool,
    joint: &'a str,
    rotary: bool,
    law: Law<'a>,
}

/// What a drive does, in N m and rad or in N and m.
enum Law<'a> {
    Motor { effort: f64, history: History, pulse: Option<&'a schema::Pulse> },
    Servo { target: f64, stiffness: f64, damping: f64, limit: f64 },
}

impl<'a> Parts<'a> {
    fn of(name: &str, drive: &'a schema::Drive) -> Self {
        let (kind, enabled, joint, rotary, law) = match drive {
            schema::Drive::Motor(d) => {
                let law = Law::Motor { effort: d.torque_n_m, history: d.history, pulse: d.pulse.as_ref() };
                ("motor", d.enabled, &d.joint, true, law)
            }
            schema::Drive::LinearMotor(d) => {
                let law = Law::Motor { effort: d.force_n, history: d.history, pulse: d.pulse.as_ref() };
                ("linear_motor", d.enabled, &d.joint, false, law)
            }
            schema::Drive::Servo(d) => {
                let (stiffness, damping) = (d.stiffness_n_m_per_rad.get(), d.damping_n_m_s_per_rad.get());
                let law = Law::Servo { target: d.target_rad, stiffness, damping, limit: d.torque_limit_n_m.get() };
                ("servo", d.enabled, &d.joint, true, law)
            }
            schema::Drive::LinearServo(d) => {
                let (stiffness, damping) = (d.stiffness_n_per_m.get(), d.damping_n_s_per_m.get());
                let law = Law::Servo { target: d.target_m, stiffness, damping, limit: d.force_limit_n.get() };
                ("linear_servo", d.enabled, &d.joint, false, law)
            }
        };
        Self { field: format!("drives.{name}.{kind}"), enabled, joint: joint.as_str(), rotary, law }
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
fn prescribed(scenario: &Scenario, model: &Model) -> Result<Vec<PrescribedMotion>, FieldError> {
    let mut motions = Vec::new();
    for (i, body) in model.bodies.iter().enumerate() {
        let (rate, history, pulse) = match &scenario.bodies[body.name.as_str()].joint {
            schema::Joint::Revolute(schema::RevoluteJoint { mode: RevoluteMode::Prescribed(given), .. }) => {
                (given.rate_rad_s, given.history, given.pulse.as_ref())
            }
            schema::Joint::Prismatic(schema::PrismaticJoint { mode: PrismaticMode::Prescribed(given), .. }) => {
                (given.speed_m_s, given.history, given.pulse.as_ref())
            }
            _ => continue,
        };
        let kind = if matches!(model.joints[i].kind, JointKind::Revolute(_)) { "revolute" } else { "prismatic" };
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
        motions.push(PrescribedMotion { coordinate: model.tree.nodes[i].velocities, rate, profile });
    }
    Ok(motions)
}
