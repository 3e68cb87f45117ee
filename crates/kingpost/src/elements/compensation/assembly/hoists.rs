//! The drives that compensations name, and the ropes that they let out.

use crate::elements::compensation::{Hoist, MovedSheaves};
use crate::elements::drives::{ControlledDrive, SetPoint};
use crate::elements::ropes::{Drum, RopePath};
use crate::elements::{AnyElement, DynamicLine, Element, Rope, of_kind};
use crate::model::{Attachment, Model};
use crate::scenario::assembly::{FieldError, wires};
use crate::scenario::leaf::Quantity;
use crate::scenario::schema::{Drive, Scenario};

/// Returns the enabled entry named `found`, or an error that lists the enabled entries.
pub fn named<T>(field: &str, found: &str, (all, names): (Vec<(&str, T)>, &str)) -> Result<T, FieldError> {
    let listed: Vec<&str> = all.iter().map(|(name, _)| *name).collect();
    let allowed = wires::allowed(&listed, found, &format!("{names} that is enabled"));
    let one = all.into_iter().find(|(name, _)| *name == found);
    one.map(|(_, one)| one).ok_or_else(|| FieldError::new(field, found, allowed))
}

/// Returns the controlled drive with this name; its set-point must be a speed.
pub fn drive<'a, S: Quantity>(
    field: &str,
    found: &str,
    elements: &'a [AnyElement<S>],
) -> Result<&'a ControlledDrive<S>, FieldError> {
    let built = of_kind::<S, ControlledDrive<S>>(elements).map(|drive| (drive.name.as_str(), drive)).collect();
    let drive = named(field, found, (built, "a controlled drive"))?;
    let mode = match drive.set_point {
        SetPoint::Speed => return Ok(drive),
        SetPoint::Effort => "torque",
        SetPoint::Position => "position",
    };
    let found = format!("{found}, whose set-point is a {mode}");
    Err(FieldError::new(field, found, "a drive with set_point: {speed: {}}"))
}

/// A rope over the crane's tip that a drive lets out.
pub struct Hung<'a, S> {
    /// The drive of the drum or of the sheaves.
    pub drive: &'a ControlledDrive<S>,
    /// Set-point of the drive, rad/s or m/s.
    pub speed: S,
    /// Part that the drive moves.
    pub hoist: Hoist<S>,
    /// The place before the rope's last end.
    pub tip: Attachment<S>,
    /// Falls of the last part.
    pub falls: S,
}

/// Returns the rope with the drive of its drum, or with the drive of a joint that moves its sheaves.
pub fn hung<'a, S: Quantity>(
    (scenario, model): (&Scenario<S>, &Model<S>),
    lead: &str,
    [rope, by]: [&str; 2],
    elements: &'a [AnyElement<S>],
) -> Result<Hung<'a, S>, FieldError> {
    let (path, drum) = named(&format!("{lead}.rope"), rope, (over_sheaves(elements), "a rope"))?;
    let driven = drive(&format!("{lead}.drive"), by, elements)?;
    let drum = drum.filter(|drum| drum.coordinate == driven.coordinate).map(Hoist::Drum);
    let Some(hoist) = drum.or_else(|| moved_sheaves(model, path, driven).map(Hoist::Sheaves)) else {
        let allowed =
            format!("the drive of the drum of {rope}, or of a joint between drum and tip that moves its sheaves");
        return Err(FieldError::new(format!("{lead}.drive"), driving(scenario, by), allowed));
    };
    let stations = path.stations();
    let (tip, falls) = (stations[stations.len() - 2].centre, stations[stations.len() - 1].falls);
    let speed = driven.value;
    Ok(Hung { drive: driven, speed, hoist, tip, falls })
}

/// Path and drum of a rope, with its name.
type OverSheaves<'a, S> = (&'a str, (&'a RopePath<S>, Option<Drum<S>>));

/// Returns the ropes and the lines with mass that run over a path.
fn over_sheaves<S: Quantity>(elements: &[AnyElement<S>]) -> Vec<OverSheaves<'_, S>> {
    let ropes = of_kind::<S, Rope<S>>(elements).map(|rope| (rope.name.as_str(), (&rope.path, rope.drum)));
    let lines = of_kind::<S, DynamicLine<S>>(elements);
    ropes.chain(lines.filter_map(|line| Some((line.name(), line.over_sheaves()?)))).collect()
}

/// Returns the text "drive, which drives joint" for an error.
pub fn driving<S: Quantity>(scenario: &Scenario<S>, drive: &str) -> String {
    let joint = match scenario.drives.get(drive) {
        Some(Drive::ControlledDrive(given)) => given.joint.to_string(),
        Some(Drive::LinearControlledDrive(given)) => given.joint.to_string(),
        _ => String::new(),
    };
    format!("{drive}, which drives {joint}")
}

/// Returns the sheaves before the tip that the joint of a drive moves.
fn moved_sheaves<S: Quantity>(
    model: &Model<S>,
    whole: &RopePath<S>,
    drive: &ControlledDrive<S>,
) -> Option<MovedSheaves<S>> {
    let driven = model.plan.iter().position(|place| place.velocities == drive.coordinate)?;
    let way = |link: Option<usize>| core::iter::successors(link, |link| model.links.nodes[*link].parent);
    let path = whole.up_to_tip()?;
    let moved = path.stations().iter().map(|station| way(station.centre.link).any(|link| link == driven)).collect();
    MovedSheaves::new(path, driven, moved)
}
