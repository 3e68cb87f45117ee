//! Mooring lines and hawsers: their ends, and what they are made of.

use super::super::schema::{self, Force as ForceSchema, Scenario};
use super::flexible::carrier_in_model;
use super::reading::{Gathered, Reading};
use super::{FieldError, known};
use crate::forces::{Force, SpringLine};
use crate::model::{Attachment, Model};
use crate::spatial::Frame;

/// A line without weight, where it is on and between bodies that are there.
pub fn spring<S: Gathered>(
    scenario: &Reading<Scenario>,
    name: &str,
    model: &Model<S>,
) -> Result<Option<Force<S>>, FieldError> {
    let line = scenario.part(|scenario| &scenario.forces[name]).kind(spring_line_of);
    let given = line.first();
    let field = |end: &str| format!("forces.{name}.spring_line.{end}.body");
    let first = end(scenario, model, &field("first"), &line.part(|line| &line.first))?;
    let second = end(scenario, model, &field("second"), &line.part(|line| &line.second))?;
    if given.first.body == given.second.body {
        return Err(FieldError::new(field("second"), &given.second.body, "another body than that of the first end"));
    }
    let (Some(first), Some(second), true) = (first, second, given.enabled) else { return Ok(None) };
    Ok(Some(Force::SpringLine(Box::new(SpringLine {
        name: name.to_owned(),
        first,
        second,
        unstretched_length: line.number(|line| line.unstretched_length_m.get()),
        axial_stiffness: line.number(|line| line.axial_stiffness_n.get()),
        dissipation: line.number(|line| line.dissipation_s_per_m.get()),
    }))))
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

fn spring_line_of(force: &ForceSchema) -> Option<&schema::SpringLine> {
    if let ForceSchema::SpringLine(line) = force { Some(line) } else { None }
}
