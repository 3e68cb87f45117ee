//! Checks of the camera and the plots of a scenario.

use super::FieldError;
use super::columns;
use crate::scenario::leaf::Quantity;
use crate::scenario::schema::{Camera, ColumnName, Scenario, View};
use crate::simulation::Setup;

/// Largest numbers of plots, and of lines in a plot: more cannot be distinguished.
const MOST_PLOTS: usize = 6;
const MOST_LINES: usize = 8;

/// Checks that plots have columns of one unit each, and that the camera looks in a direction. A column that does not
/// exist is left out with a warning ([`plots`]): a value that is set can remove it, and a view affects no number.
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
            let Ok(column) = columns::find(&known, &of_line, name) else { continue };
            let unit = *first.get_or_insert(column.unit);
            if column.unit != unit {
                let allowed = format!("a column in {unit}, as the first of its plot");
                return Err(FieldError::new(of_line, format!("{name}, in {}", column.unit), allowed));
            }
        }
    }
    Ok(())
}

/// Returns the columns of each plot that exist, and a warning of each other one.
pub(crate) fn plots(view: &View, setup: &Setup) -> (Vec<Vec<String>>, Vec<String>) {
    let known = columns::of(setup);
    let mut warnings = Vec::new();
    let mut shown = |(k, plot): (usize, &Vec<ColumnName>)| {
        let exists =
            |(line, name): (usize, &ColumnName)| match columns::find(&known, &format!("view.plots.{k}.{line}"), name) {
                Ok(_) => Some(name.to_string()),
                Err(error) => {
                    warnings.push(format!("{error}; the plot leaves it out"));
                    None
                }
            };
        plot.iter().enumerate().filter_map(exists).collect::<Vec<_>>()
    };
    let plots = view.plots.iter().enumerate().map(&mut shown).filter(|plot| !plot.is_empty()).collect();
    (plots, warnings)
}
