//! Drives, inputs and prescribed motions.

use super::super::schema::{self, History, PrismaticMode, RevoluteMode, Scenario};
use super::{FieldError, known};
use crate::drives::{Drive, Motor, PrescribedMotion, Profile, Pulse, Servo};
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
        let (field, wanted) = (&parts.field, parts.rotary);
        known(&format!("{field}.joint"), parts.joint, joints(scenario, wanted))?;
        let profile = match parts.history {
            Some((history, pulse)) => Some(profile(field, history, pulse)?),
            None => None,
        };
        let Some(joint) = model.joint(parts.joint).filter(|_| parts.enabled) else { continue };
        let (coordinate, position) = (model.tree.nodes[joint].velocities, model.tree.nodes[joint].positions);
        let input = matches!(parts.history, Some((History::Lever, _))).then(|| {
            inputs.push(Input { name: name.to_string(), unit: "1", lower: -1.0, upper: 1.0, value: 0.0 });
            inputs.len() - 1
        });
        drives.push(match (profile, parts.numbers) {
            (Some(profile), numbers) => Drive::Motor(Motor { coordinate, effort: numbers[0], profile, input }),
            (None, [target, stiffness, damping, limit]) => {
                Drive::Servo(Servo { position, coordinate, target, stiffness, damping, limit })
            }
        });
    }
    for motion in prescribed(scenario, model)? {
        v[motion.coordinate] = motion.initial_rate();
        drives.push(Drive::Prescribed(motion));
    }
    Ok(Drives { drives, inputs })
}

/// What the four kinds of drive have in common.
struct Parts<'a> {
    field: String,
    enabled: bool,
    joint: &'a str,
    rotary: bool,
    /// A motor's history; a servo has none.
    history: Option<(History, Option<&'a schema::Pulse>)>,
    /// Effort, or target, stiffness, damping, limit.
    numbers: [f64; 4],
}

impl<'a> Parts<'a> {
    fn of(name: &str, drive: &'a schema::Drive) -> Self {
        let field = |kind: &str| format!("drives.{name}.{kind}");
        match drive {
            schema::Drive::Motor(d) => Self {
                field: field("motor"),
                enabled: d.enabled,
                joint: &d.joint,
                rotary: true,
                history: Some((d.history, d.pulse.as_ref())),
                numbers: [d.torque_n_m, 0.0, 0.0, 0.0],
            },
            schema::Drive::LinearMotor(d) => Self {
                field: field("linear_motor"),
                enabled: d.enabled,
                joint: &d.joint,
                rotary: false,
                history: Some((d.history, d.pulse.as_ref())),
                numbers: [d.force_n, 0.0, 0.0, 0.0],
            },
            schema::Drive::Servo(d) => Self {
                field: field("servo"),
                enabled: d.enabled,
                joint: &d.joint,
                rotary: true,
                history: None,
                numbers: [
                    d.target_rad,
                    d.stiffness_n_m_per_rad.get(),
                    d.damping_n_m_s_per_rad.get(),
                    d.torque_limit_n_m.get(),
                ],
            },
            schema::Drive::LinearServo(d) => Self {
                field: field("linear_servo"),
                enabled: d.enabled,
                joint: &d.joint,
                rotary: false,
                history: None,
                numbers: [d.target_m, d.stiffness_n_per_m.get(), d.damping_n_s_per_m.get(), d.force_limit_n.get()],
            },
        }
    }
}

/// Names of the revolute or of the prismatic joints, those of disabled bodies too.
fn joints(scenario: &Scenario, rotary: bool) -> impl Iterator<Item = &str> {
    scenario.bodies.iter().filter_map(move |(body, description)| {
        let fits = match description.joint {
            schema::Joint::Revolute(_) => rotary,
            schema::Joint::Prismatic(_) => !rotary,
            schema::Joint::Floating(_) | schema::Joint::Fixed(_) => false,
        };
        fits.then(|| description.joint.name().unwrap_or(body).as_str())
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
        if !profile.is_continuous() || (history == History::Pulse && pulse.is_some_and(|p| p.rise_s.get() == 0.0)) {
            let allowed = "greater than 0: a rate cannot jump";
            return Err(FieldError::new(format!("{field}.pulse.rise_s"), 0, allowed));
        }
        motions.push(PrescribedMotion { coordinate: model.tree.nodes[i].velocities, rate, profile });
    }
    Ok(motions)
}
