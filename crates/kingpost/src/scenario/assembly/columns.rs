//! Columns of the results that a scenario names, and the units of their bounds.

use super::FieldError;
use crate::elements::{AnyElement, Layout};
use crate::model::Model;
use crate::results::Channels;
use crate::scenario::leaf::Quantity;
use crate::scenario::units;
use crate::scenario::wording::{nearest, one_of};
use crate::simulation::Setup;

/// A column of the results.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// Name of the column in a table of results.
    pub name: String,
    /// SI unit.
    pub unit: &'static str,
}

/// Number of similar names that an error lists.
const MOST_LISTED: usize = 12;

/// Returns every column of a run.
pub fn of<S: Quantity>(setup: &Setup<S>) -> Vec<Column> {
    among(&setup.model, &setup.elements)
}

/// Returns every column of this model with these elements.
pub fn among<S: Quantity>(model: &Model<S>, elements: &[AnyElement<S>]) -> Vec<Column> {
    let channels = Channels::new(model, &Layout::new(elements, 0)).list;
    let of = |channel: crate::results::Channel| {
        channel.columns.into_iter().zip(channel.units).map(|(name, unit)| Column { name, unit })
    };
    channels.into_iter().flat_map(of).collect()
}

/// Returns the column with this name.
pub fn find<'a>(columns: &'a [Column], field: &str, name: &str) -> Result<&'a Column, FieldError> {
    if let Some(column) = columns.iter().find(|column| column.name == name) {
        return Ok(column);
    }
    let all: Vec<&str> = columns.iter().map(|column| column.name.as_str()).collect();
    // Candidates are sorted by the number of name parts in common, such as the same body, or the same
    // variable of another body.
    let shared = |column: &str| column.split('.').filter(|part| name.split('.').any(|other| other == *part)).count();
    let mut alike: Vec<&str> = all.iter().copied().filter(|column| shared(column) > 0).collect();
    alike.sort_by_key(|column| core::cmp::Reverse(shared(column)));
    alike.truncate(MOST_LISTED);
    let meant = nearest(&all, name).map_or_else(String::new, |name| format!("; did you mean {name}?"));
    let allowed = match alike.as_slice() {
        [] => format!("a column of the results, as in the header of a run's table{meant}"),
        alike => format!("{}, or another column of the results{meant}", one_of(alike)),
    };
    Err(FieldError::new(field, name, allowed))
}

/// Returns the factor from a unit to the SI unit.
pub fn factor(field: &str, unit: Option<&str>, si: &str) -> Result<f64, FieldError> {
    let Some(unit) = unit else { return Ok(1.0) };
    units::factor_of(unit, si).ok_or_else(|| {
        let allowed: Vec<String> = units::units_for(si).into_iter().map(|(unit, _)| unit).collect();
        FieldError::new(field, unit, one_of(&allowed.iter().map(String::as_str).collect::<Vec<_>>()))
    })
}
