//! Mooring lines and hawsers: their ends, and what they are made of.

use super::super::schema::{self, Force as ForceSchema, Scenario};
use super::flexible::carrier_in_model;
use super::reading::{Gathered, Reading};
use super::{FieldError, known};
use crate::dynamics::LinkKinematics;
use crate::elements::lines::Catenary;
use crate::elements::{AnyElement, CatenaryLine, SpringLine, of_kind};
use crate::model::{Attachment, Model};
use crate::scalar::Scalar;
use crate::simulation::Setup;
use crate::spatial::Frame;

/// A line without weight, where it is on and between bodies that are there.
pub fn spring<S: Gathered>(
    scenario: &Reading<Scenario>,
    name: &str,
    model: &Model<S>,
) -> Result<Option<AnyElement<S>>, FieldError> {
    let line = scenario.part(|scenario| &scenario.forces[name]).kind(spring_line_of);
    let given = line.first();
    let field = |end: &str| format!("forces.{name}.spring_line.{end}.body");
    let first = end(scenario, model, &field("first"), &line.part(|line| &line.first))?;
    let second = end(scenario, model, &field("second"), &line.part(|line| &line.second))?;
    if given.first.body == given.second.body {
        return Err(FieldError::new(field("second"), &given.second.body, "another body than that of the first end"));
    }
    let (Some(first), Some(second), true) = (first, second, given.enabled) else { return Ok(None) };
    Ok(Some(Box::new(SpringLine {
        name: name.to_owned(),
        first,
        second,
        unstretched_length: line.number(|line| line.unstretched_length_m.get()),
        axial_stiffness: line.number(|line| line.axial_stiffness_n.get()),
        dissipation: line.number(|line| line.dissipation_s_per_m.get()),
    })))
}

/// A mooring line, where it is on and its body there.
pub fn catenary<S: Gathered>(
    scenario: &Reading<Scenario>,
    name: &str,
    model: &Model<S>,
) -> Result<Option<AnyElement<S>>, FieldError> {
    let line = scenario.part(|scenario| &scenario.forces[name]).kind(catenary_line_of);
    let given = line.first();
    let field = |field: &str| format!("forces.{name}.catenary_line.{field}");
    if given.fairlead.named_body().is_none() {
        return Err(FieldError::new(
            field("fairlead.body"),
            &given.fairlead.body,
            "a body: the anchor is in the world",
        ));
    }
    let fairlead = end(scenario, model, &field("fairlead.body"), &line.part(|line| &line.fairlead))?;
    let depth = scenario.first().sea.as_ref().and_then(|sea| sea.depth_m).filter(|_| given.seabed);
    if let Some(depth) = depth.map(|depth| depth.get()).filter(|depth| !same(given.anchor_m[2], -depth, *depth)) {
        let allowed = format!("{}, the seabed by sea.depth_m, or seabed: false", -depth);
        return Err(FieldError::new(field("anchor_m.2"), given.anchor_m[2], allowed));
    }
    let (Some(fairlead), true) = (fairlead, given.enabled) else { return Ok(None) };
    Ok(Some(Box::new(CatenaryLine {
        name: name.to_owned(),
        fairlead,
        anchor: line.vector(|line| line.anchor_m),
        line: Catenary {
            unstretched_length: line.number(|line| line.unstretched_length_m.get()),
            weight: line.number(|line| line.weight_in_water_n_per_m.get()),
            axial_stiffness: line.number(|line| line.axial_stiffness_n.get()),
            on_seabed: given.seabed,
        },
    })))
}

fn same(a: f64, b: f64, size: f64) -> bool {
    (a - b).abs() <= 1e-9 * size
}

/// Where a run begins, fairleads are above the seabed.
pub fn check_start<S: Scalar>(setup: &Setup<S>) -> Result<(), FieldError> {
    let Setup { model, elements, q, v, .. } = setup;
    let mut links = LinkKinematics::new(model);
    links.update(model, q, v);
    for line in of_kind::<S, CatenaryLine<S>>(elements).filter(|line| line.line.on_seabed) {
        let up = line.span(model, &links).up;
        if !up.all(|up| up > 0.0) {
            let found = format!("a fairlead that starts {} m below the seabed", -up.value());
            let allowed = "one above it (it is flat, at the anchor's depth), or seabed: false";
            return Err(FieldError::new(format!("forces.{}.catenary_line.fairlead", line.name), found, allowed));
        }
    }
    Ok(())
}

/// An end seen from the centre of mass of its body; `None` on a body that is not there.
fn end<S: Gathered>(
    scenario: &Reading<Scenario>,
    model: &Model<S>,
    field: &str,
    pin: &Reading<schema::Pin>,
) -> Result<Option<Attachment<S>>, FieldError> {
    let first = pin.first();
    let bodies = scenario.first().bodies.keys().map(|body| body.as_str());
    known(field, &first.body, bodies.chain([schema::WORLD]))?;
    if first.named_body().is_some_and(|body| model.body(body).is_none()) {
        return Ok(None);
    }
    let (body, centre) = carrier_in_model(scenario, model, first.named_body(), first.position_m);
    Ok(Some(model.attachment(body, Frame::translation(pin.vector(|pin| pin.position_m) - centre))))
}

fn catenary_line_of(force: &ForceSchema) -> Option<&schema::CatenaryLine> {
    if let ForceSchema::CatenaryLine(line) = force { Some(line) } else { None }
}

fn spring_line_of(force: &ForceSchema) -> Option<&schema::SpringLine> {
    if let ForceSchema::SpringLine(line) = force { Some(line) } else { None }
}
