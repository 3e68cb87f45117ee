//! Checks of the camera and the plots of a scenario.

use super::FieldError;
use super::columns;
use crate::scenario::leaf::Quantity;
use crate::scenario::schema::{Camera, Scenario};
use crate::simulation::Setup;

/// Largest numbers of plots, and of lines in a plot: more cannot be distinguished.
const MOST_PLOTS: usize = 6;
const MOST_LINES: usize = 8;

/// Checks that plots have existing columns of one unit each, and that the camera looks in a direction.
pub fn check<S: Quantity>(scenario: &Scenario<S>, setup: &Setup<S>) -> Result<(), FieldError> {
    let Some(view) = &scenario.view else { return Ok(()) };
    if let Some(Camera::Place(place)) = &view.camera
        && place.eye_m == place.target_m
    {
        return Err(FieldError::new("view.camera.place.target_m", "the position of the eye", "another position"));
    }
    if view.plots.len() > MOST_PLOTS {
        return Err(FieldError::new("view.plots", view.plots.len(), format!("at most {MOST_PLOTS} plots")));
    }
    let known = columns::of(setup);
    for (k, plot) in view.plots.iter().enumerate() {
        let field = format!("view.plots.{k}");
        if plot.is_empty() || plot.len() > MOST_LINES {
            return Err(FieldError::new(
                field,
                format!("{} columns", plot.len()),
                format!("1 to {MOST_LINES} columns"),
            ));
        }
        let mut first = None;
        for (line, name) in plot.iter().enumerate() {
            let of_line = format!("{field}.{line}");
            let column = columns::find(&known, &of_line, name)?;
            let unit = *first.get_or_insert(column.unit);
            if column.unit != unit {
                let allowed = format!("a column in {unit}, as the first of its plot");
                return Err(FieldError::new(of_line, format!("{name}, in {}", column.unit), allowed));
            }
        }
    }
    Ok(())
}
