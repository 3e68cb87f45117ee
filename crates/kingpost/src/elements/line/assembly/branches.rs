//! Lines whose second end is fastened to another line: what they name, and the tree that they make.

use crate::scenario::assembly::FieldError;
use crate::scenario::leaf::Quantity;
use crate::scenario::schema::{DynamicLine, Force, Name, Scenario, SectionEnd};

/// Returns the line with mass of this name in a scenario.
fn line<'a, S: Quantity>(scenario: &'a Scenario<S>, name: &str) -> Option<&'a DynamicLine<S>> {
    match scenario.forces.get(name) {
        Some(Force::Line(line)) => Some(line),
        _ => None,
    }
}

/// Returns the enabled lines whose second end is fastened to a line of this name, with the sections at whose ends it is.
pub fn branches_of<'a, S: Quantity>(
    scenario: &'a Scenario<S>,
    name: &str,
) -> impl Iterator<Item = (&'a Name, usize, &'a DynamicLine<S>)> {
    scenario.forces.iter().filter_map(move |(branch, force)| match force {
        Force::Line(line) if line.enabled => {
            let on = line.second_on.as_ref().filter(|on| on.line == name)?;
            Some((branch, on.section, &**line))
        }
        _ => None,
    })
}

/// Checks the place on another line where the second end of a line of this name is fastened.
pub fn check<S: Quantity>(
    scenario: &Scenario<S>,
    name: &str,
    branch: &DynamicLine<S>,
    on: &SectionEnd,
) -> Result<(), FieldError> {
    let field = |field: &str| format!("forces.{name}.line.second_on.{field}");
    let lines = || scenario.forces.iter().filter(|(_, force)| matches!(force, Force::Line(_))).map(|(line, _)| line);
    let others: Vec<&str> = lines().map(|line| line.as_str()).filter(|line| *line != name).collect();
    let Some(carrier) = line(scenario, &on.line).filter(|_| on.line != name) else {
        let allowed = if others.is_empty() {
            "another line with mass".to_owned()
        } else {
            format!("one of {}", others.join(", "))
        };
        return Err(FieldError::new(field("line"), &on.line, allowed));
    };
    if branch.enabled && !carrier.enabled {
        let found = format!("{}, which is disabled", on.line);
        return Err(FieldError::new(field("line"), found, "a line that is enabled"));
    }
    check_section(on, carrier, &field("section"))?;
    check_circle(scenario, name, &field("line"))
}

/// Checks the section at whose end a line is fastened.
fn check_section<S: Quantity>(on: &SectionEnd, carrier: &DynamicLine<S>, field: &str) -> Result<(), FieldError> {
    let last = carrier.sections.len().saturating_sub(1);
    if on.section < last || (on.section == last && carrier.second_free) {
        return Ok(());
    }
    let held = "its last section ends at a body or another line";
    let allowed = match (carrier.second_free, last) {
        (true, 0) => format!("0, the section of {}", on.line),
        (true, _) => format!("0 to {last}, the sections of {}", on.line),
        (false, 0) => format!("a line of two sections: {held}"),
        (false, 1) => format!("0 of {}: {held}", on.line),
        (false, _) => format!("0 to {} of {}: {held}", last - 1, on.line),
    };
    Err(FieldError::new(field, on.section, allowed))
}

/// Checks that lines are not fastened to each other in a circle.
fn check_circle<S: Quantity>(scenario: &Scenario<S>, name: &str, field: &str) -> Result<(), FieldError> {
    let mut chain = vec![name];
    while let Some(on) = line(scenario, chain[chain.len() - 1]).and_then(|line| line.second_on.as_ref()) {
        chain.push(&on.line);
        if chain[..chain.len() - 1].contains(&on.line.as_str()) {
            let found = format!("a circle of lines: {}", chain.join(", "));
            return Err(FieldError::new(field, found, "lines that end at last on a body, in the world, or free"));
        }
    }
    Ok(())
}
