//! Hydraulic cylinders: their pins, and the check that they start within their stroke.

use crate::dynamics::LinkKinematics;
use crate::elements::drives::{Aim, Cylinder};
use crate::elements::of_kind_mut;
use crate::model::Model;
use crate::scenario::assembly::attachments::attachment;
use crate::scenario::assembly::{FieldError, known};
use crate::scenario::leaf::Quantity;
use crate::scenario::schema::{self, CylinderTarget, Scenario};
use crate::simulation::Setup;

/// Returns a cylinder, if it is enabled and its bodies exist.
pub fn build<S: Quantity>(
    scenario: &Scenario<S>,
    name: &str,
    model: &Model<S>,
) -> Result<Option<Cylinder<S>>, FieldError> {
    let schema::Drive::Cylinder(given) = &scenario.drives[name] else { return Ok(None) };
    check(scenario, name, given)?;
    let pins = [("first", &given.first), ("second", &given.second)];
    let there = |(_, pin): &(&str, &schema::Pin<S>)| pin.named_body().is_none_or(|body| model.body(body).is_some());
    if !given.enabled || !pins.iter().all(there) {
        return Ok(None);
    }
    let place = |(which, pin): (&str, &schema::Pin<S>)| {
        attachment(scenario, model, &format!("drives.{name}.cylinder.{which}.position_m"), pin)
    };
    let (first, second) = (place(pins[0])?, place(pins[1])?);
    let aim = match &given.target {
        CylinderTarget::Hold => Aim::Hold,
        CylinderTarget::Length(target) => Aim::Length(target.length_m.get()),
        CylinderTarget::Lever => Aim::Lever,
    };
    Ok(Some(Cylinder {
        name: name.to_owned(),
        first,
        second,
        stiffness: given.stiffness_n_per_m.get(),
        damping: given.damping_n_s_per_m.get(),
        push_limit: given.push_limit_n.get(),
        pull_limit: given.pull_limit_n.get(),
        stroke: [given.shortest_m.get(), given.longest_m.get()],
        stop_stiffness: given.stop_stiffness_n_per_m.get(),
        stop_dissipation: given.stop_dissipation_s_per_m.get(),
        speed_limit: given.speed_limit_m_s.get(),
        holds: aim == Aim::Lever && scenario.simulation.begin_at_equilibrium,
        aim,
        start: S::ZERO,
        hold: [S::ZERO],
        arrival_s: None,
    }))
}

/// Checks that the bodies exist, the stroke is positive, and the target lies within it.
fn check<S: Quantity>(scenario: &Scenario<S>, name: &str, given: &schema::Cylinder<S>) -> Result<(), FieldError> {
    let field = |rest: &str| format!("drives.{name}.cylinder.{rest}");
    for (pin, which) in [(&given.first, "first.body"), (&given.second, "second.body")] {
        let bodies = scenario.bodies.keys().map(|body| body.as_str());
        known(&field(which), &pin.body, bodies.chain([schema::WORLD]))?;
    }
    let (shortest, longest) = (given.shortest_m.get(), given.longest_m.get());
    if !(longest - shortest).all(|stroke| stroke > 0.0) {
        return Err(FieldError::new(field("longest_m"), longest, format!("more than shortest_m, {shortest}")));
    }
    let CylinderTarget::Length(target) = &given.target else { return Ok(()) };
    let target = target.length_m.get();
    if !within(target, [shortest, longest]) {
        let allowed = format!("a length within the stroke, {shortest} to {longest}");
        return Err(FieldError::new(field("target.length.length_m"), target, allowed));
    }
    Ok(())
}

fn within<S: Quantity>(length: S, [shortest, longest]: [S; 2]) -> bool {
    (length - shortest).all(|beyond| beyond >= 0.0) && (longest - length).all(|left| left >= 0.0)
}

/// Takes the lengths at the start of the run, with loops closed.
///
/// # Errors
/// A length outside the stroke; pins that coincide have the length 0. A target length that different lanes reach at
/// different times, because a step ends at that time.
pub fn begin<S: Quantity>(setup: &mut Setup<S>) -> Result<(), FieldError> {
    let Setup { model, elements, q, v, .. } = setup;
    let mut links = LinkKinematics::new(model);
    links.update(model, q, v);
    for cylinder in of_kind_mut::<S, Cylinder<S>>(elements) {
        cylinder.start_at(model, &links);
        let field = || format!("drives.{}.cylinder", cylinder.name);
        let (start, [shortest, longest]) = (cylinder.start, cylinder.stroke);
        if !within(start, cylinder.stroke) {
            let found = format!("pins {start:.4} m apart at the start");
            let allowed = format!("a length within the stroke, {shortest} to {longest} m");
            return Err(FieldError::new(field(), found, allowed));
        }
        if matches!(cylinder.aim, Aim::Length(_)) && cylinder.arrival_s.is_none() {
            return Err(FieldError::new(
                field(),
                "a target length that lanes reach at different times",
                "the same time in all lanes",
            ));
        }
    }
    Ok(())
}
