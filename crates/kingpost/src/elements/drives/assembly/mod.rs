//! Drives, inputs and prescribed motions.

pub(crate) mod cylinders;
pub(crate) mod histories;

use crate::dynamics::Clock;
use crate::elements::drives::{Brake, ControlledDrive, DriveLimits, Motor, Servo, SetPoint, TimeFunction};
use crate::elements::{AnyElement, CoulombFriction, Input};
use crate::model::AxisMotion::{self, Rotation, Translation};
use crate::model::{Model, MotionType};
use crate::scenario::assembly::axes::axes;
use crate::scenario::assembly::bodies::joint_name;
use crate::scenario::assembly::{FieldError, known, wave_motion, wires};
use crate::scenario::leaf::Quantity;
use crate::scenario::schema::{self, BrakeState, History, Scenario};
use crate::world::World;
use indexmap::IndexMap;

/// Builds the enabled drives for a model that starts at `q`, and sets the initial rates of prescribed joints in `v`.
pub fn build<S: Quantity>(
    scenario: &Scenario<S>,
    model: &Model<S>,
    world: &World<S>,
    (q, v): (&[S], &mut [S]),
) -> Result<Vec<AnyElement<S>>, FieldError> {
    let mut drives: Vec<AnyElement<S>> = Vec::new();
    let mut driven = IndexMap::new();
    for (name, drive) in &scenario.drives {
        let Some(parts) = JointDrive::of(name, drive) else {
            if let Some(cylinder) = cylinders::build(scenario, name, model)? {
                drives.push(Box::new(cylinder));
            }
            continue;
        };
        let allowed = coordinates(scenario, parts.motion);
        known(&format!("{}.joint", parts.field), parts.joint, allowed.iter().map(String::as_str))?;
        let profile = match parts.law {
            Law::Motor { history, pulse, list, .. } => histories::of_motor(&parts.field, history, pulse, list)?,
            Law::Servo { .. } | Law::Brake { .. } | Law::Controlled { .. } => TimeFunction::constant(),
        };
        let Some(coordinate) = model.coordinate(parts.joint).filter(|_| parts.enabled) else { continue };
        let Some((_, position)) = model.axis_coordinate(coordinate) else { continue };
        check_free(&parts, model.modes[coordinate])?;
        check_alone(&parts, name, driven.entry(coordinate).or_default())?;
        drives.push(match parts.law {
            Law::Motor { effort, history, .. } => {
                let lever = (history == History::Lever).then(|| name.to_string());
                Box::new(Motor { coordinate, effort, profile, lever })
            }
            Law::Servo { numbers: [target, stiffness, damping, limit] } => {
                let offset = offset(scenario, name, parts.motion);
                Box::new(Servo { position, coordinate, target, stiffness, damping, limit, offset })
            }
            Law::Controlled { set_point, value, limits, numbers: [stiffness, damping, response_time] } => {
                let (name, motion) = (name.to_string(), parts.motion);
                Box::new(ControlledDrive {
                    name,
                    position,
                    coordinate,
                    motion,
                    set_point,
                    value,
                    limits,
                    stiffness,
                    damping,
                    response_time,
                    start: q[position],
                    hold: [S::ZERO],
                })
            }
            Law::Brake { state: BrakeState::Released, .. } => continue,
            Law::Brake { numbers: [friction, smoothing], state } => {
                let lever = (state == BrakeState::Lever).then(|| name.to_string());
                Box::new(Brake { friction: CoulombFriction { coordinate, friction, smoothing }, lever })
            }
        });
    }
    let mut accelerations = vec![S::ZERO; v.len()];
    for motion in histories::given_motions(scenario, model)? {
        motion.prescribe(world, Clock { time_s: 0.0, middle_s: 0.0 }, v, &mut accelerations);
        drives.push(motion);
    }
    for motion in wave_motion::build(scenario, model, world)? {
        v[motion.coordinates()].copy_from_slice(&motion.at(world, 0.0).rates);
        drives.push(Box::new(motion));
    }
    Ok(drives)
}

/// Returns the input for the offset of a servo's target, which a wire may set.
fn offset<S>(scenario: &Scenario<S>, name: &str, motion: AxisMotion) -> Option<Input> {
    let name = wires::offset_of(name);
    let unit = if motion == Rotation { "rad" } else { "m" };
    let (lower, upper) = (-FARTHEST_OFFSET, FARTHEST_OFFSET);
    wires::leads_to(scenario, &name).then_some(Input { name, unit, lower, upper, value: 0.0, signal: None })
}

/// Largest offset of a servo's target, rad or m.
const FARTHEST_OFFSET: f64 = 1e6;

/// Refuses an enabled drive on a coordinate that is held or prescribed: it would have no effect.
fn check_free<S: Quantity>(parts: &JointDrive<'_, S>, mode: MotionType) -> Result<(), FieldError> {
    let mode = match mode {
        MotionType::Free => return Ok(()),
        MotionType::Held => "held",
        MotionType::Prescribed => "prescribed",
    };
    let found = format!("{}, which is {mode}", parts.joint);
    Err(FieldError::new(format!("{}.joint", parts.field), found, "a joint whose mode is free, for an enabled drive"))
}

/// Refuses two drives with set-points on one joint: they would oppose each other. The efforts of motors and brakes are
/// added.
fn check_alone<'a, S: Quantity>(
    parts: &JointDrive<'_, S>,
    name: &'a str,
    drives_it: &mut Option<&'a str>,
) -> Result<(), FieldError> {
    if matches!(parts.law, Law::Motor { .. } | Law::Brake { .. }) {
        return Ok(());
    }
    let Some(first) = drives_it.replace(name) else { return Ok(()) };
    let found = format!("{}, which both {first} and {name} drive", parts.joint);
    Err(FieldError::new(
        format!("{}.joint", parts.field),
        found,
        "one enabled drive with a set-point for each joint; motors and brakes may be added",
    ))
}

/// A drive of a joint that turns or slides.
struct JointDrive<'a, S> {
    field: String,
    enabled: bool,
    joint: &'a str,
    motion: AxisMotion,
    law: Law<'a, S>,
}

/// The law of a drive, in N m and rad or in N and m.
enum Law<'a, S> {
    Motor {
        effort: S,
        history: History,
        pulse: Option<&'a schema::Pulse>,
        list: Option<&'a schema::HistoryList<S>>,
    },
    /// Target, stiffness, damping, limit.
    Servo {
        numbers: [S; 4],
    },
    /// Stiffness, damping, time of response.
    Controlled {
        set_point: SetPoint,
        value: S,
        limits: DriveLimits<S>,
        numbers: [S; 3],
    },
    /// Capacity, smoothing speed.
    Brake {
        numbers: [S; 2],
        state: BrakeState,
    },
}

impl<'a, S: Quantity> JointDrive<'a, S> {
    /// Returns the parts of a joint's drive; `None` for a drive outside a joint.
    fn of(name: &str, drive: &'a schema::Drive<S>) -> Option<Self> {
        let motor = |effort, history, pulse: &'a Option<schema::Pulse>, list: &'a Option<schema::HistoryList<S>>| {
            Law::Motor { effort, history, pulse: pulse.as_ref(), list: list.as_ref() }
        };
        let (kind, enabled, joint, motion, law) = match drive {
            schema::Drive::Motor(d) => {
                ("motor", d.enabled, &d.joint, Rotation, motor(d.torque_n_m, d.history, &d.pulse, &d.list))
            }
            schema::Drive::LinearMotor(d) => {
                ("linear_motor", d.enabled, &d.joint, Translation, motor(d.force_n, d.history, &d.pulse, &d.list))
            }
            schema::Drive::Servo(d) => {
                let (stiffness, damping) = (d.stiffness_n_m_per_rad.get(), d.damping_n_m_s_per_rad.get());
                let numbers = [d.target_rad, stiffness, damping, d.torque_limit_n_m.get()];
                ("servo", d.enabled, &d.joint, Rotation, Law::Servo { numbers })
            }
            schema::Drive::LinearServo(d) => {
                let (stiffness, damping) = (d.stiffness_n_per_m.get(), d.damping_n_s_per_m.get());
                let numbers = [d.target_m, stiffness, damping, d.force_limit_n.get()];
                ("linear_servo", d.enabled, &d.joint, Translation, Law::Servo { numbers })
            }
            schema::Drive::ControlledDrive(d) => {
                let (set_point, value) = match d.set_point {
                    schema::AngleSetPoints::Torque(given) => (SetPoint::Effort, given.torque_n_m),
                    schema::AngleSetPoints::Speed(given) => (SetPoint::Speed, given.rate_rad_s),
                    schema::AngleSetPoints::Position(given) => (SetPoint::Position, given.angle_rad),
                };
                let limits = DriveLimits {
                    speed: d.speed_limit_rad_s.get(),
                    acceleration: d.acceleration_limit_rad_s2.get(),
                    jerk: d.jerk_limit_rad_s3.map(|limit| limit.get()),
                    effort: d.torque_limit_n_m.get(),
                    power: d.power_limit_w.map(|limit| limit.get()),
                };
                let numbers = [d.stiffness_n_m_per_rad.get(), d.damping_n_m_s_per_rad.get(), d.response_time_s.get()];
                let law = Law::Controlled { set_point, value, limits, numbers };
                ("controlled_drive", d.enabled, &d.joint, Rotation, law)
            }
            schema::Drive::LinearControlledDrive(d) => {
                let (set_point, value) = match d.set_point {
                    schema::LengthSetPoints::Force(given) => (SetPoint::Effort, given.force_n),
                    schema::LengthSetPoints::Speed(given) => (SetPoint::Speed, given.speed_m_s),
                    schema::LengthSetPoints::Position(given) => (SetPoint::Position, given.extension_m),
                };
                let limits = DriveLimits {
                    speed: d.speed_limit_m_s.get(),
                    acceleration: d.acceleration_limit_m_s2.get(),
                    jerk: d.jerk_limit_m_s3.map(|limit| limit.get()),
                    effort: d.force_limit_n.get(),
                    power: d.power_limit_w.map(|limit| limit.get()),
                };
                let numbers = [d.stiffness_n_per_m.get(), d.damping_n_s_per_m.get(), d.response_time_s.get()];
                let law = Law::Controlled { set_point, value, limits, numbers };
                ("linear_controlled_drive", d.enabled, &d.joint, Translation, law)
            }
            schema::Drive::Brake(d) => {
                let numbers = [d.torque_n_m.get(), d.smoothing_rad_s.get()];
                ("brake", d.enabled, &d.joint, Rotation, Law::Brake { numbers, state: d.state })
            }
            schema::Drive::LinearBrake(d) => {
                let numbers = [d.force_n.get(), d.smoothing_m_s.get()];
                ("linear_brake", d.enabled, &d.joint, Translation, Law::Brake { numbers, state: d.state })
            }
            schema::Drive::Cylinder(_) => return None,
        };
        Some(Self { field: format!("drives.{name}.{kind}"), enabled, joint: joint.as_str(), motion, law })
    }
}

/// Returns the names of the coordinates with this motion (turning or sliding), including those of disabled bodies.
fn coordinates<S: Quantity>(scenario: &Scenario<S>, motion: AxisMotion) -> Vec<String> {
    let of_body = |(name, body): (&schema::Name, &schema::Body<S>)| {
        let axes = axes(&body.joint).into_iter().filter(|axis| axis.motion == motion);
        axes.map(|axis| axis.coordinate_name(joint_name(name, body))).collect::<Vec<_>>()
    };
    scenario.bodies.iter().flat_map(of_body).collect()
}
