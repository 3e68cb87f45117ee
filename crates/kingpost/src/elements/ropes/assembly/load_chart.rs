//! The load chart of a crane: its slewing axis, its radii and its rated loads.

use crate::elements::ropes::LoadChart;
use crate::model::Model;
use crate::scenario::assembly::FieldError;
use crate::scenario::assembly::hinges::hinge;
use crate::scenario::leaf::Quantity;
use crate::scenario::schema::{self, Scenario};
use crate::spatial::Frame;

/// Returns the chart of the rope with this name; `None` if the slewing joint does not exist.
pub fn build<S: Quantity>(
    scenario: &Scenario<S>,
    rope: &str,
    given: &schema::LoadChart<S>,
    model: &Model<S>,
) -> Result<Option<LoadChart<S>>, FieldError> {
    let field = |name: &str| format!("forces.{rope}.rope.load_chart.{name}");
    check_rows(given, field)?;
    let Some((node, hinge)) = hinge(scenario, &field("joint"), given.joint.as_str(), model)? else { return Ok(None) };
    Ok(Some(LoadChart {
        centre: model.attachment(node.parent, Frame::translation(hinge.placement().position)),
        axis: hinge.placement().rotation * hinge.axis(),
        radii: given.radii_m.clone(),
        rated_loads: given.rated_loads_kg.iter().map(|load| load.get()).collect(),
    }))
}

/// Checks that there are two or more increasing radii, with a rated load for each.
fn check_rows<S: Quantity>(given: &schema::LoadChart<S>, field: impl Fn(&str) -> String) -> Result<(), FieldError> {
    let (radii, count) = (&given.radii_m, given.radii_m.len());
    if count < 2 {
        return Err(FieldError::new(field("radii_m"), format!("{count} numbers"), "2 radii or more"));
    }
    if given.rated_loads_kg.len() != count {
        let found = format!("{} numbers", given.rated_loads_kg.len());
        return Err(FieldError::new(field("rated_loads_kg"), found, format!("{count}, one for each radius")));
    }
    if !(radii[0] >= 0.0 && radii[0].is_finite()) {
        return Err(FieldError::new(field("radii_m.0"), radii[0], "a number, at least 0"));
    }
    match (1..count).find(|&row| !(radii[row] > radii[row - 1] && radii[row].is_finite())) {
        Some(row) => {
            let allowed = format!("more than the radius before, {}", radii[row - 1]);
            Err(FieldError::new(field(&format!("radii_m.{row}")), radii[row], allowed))
        }
        None => Ok(()),
    }
}
