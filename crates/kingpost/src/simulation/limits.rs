//! Limits against which the results of a run are checked.

use crate::results::Channels;
use crate::scalar::Scalar;
use serde::Serialize;

/// Column of the present step of an operation.
const STEP: &str = "operation.operation_step";

/// A limit on a column of the results.
#[derive(Clone, Debug, PartialEq)]
pub struct Limit {
    /// Its name in the scenario.
    pub name: String,
    /// The column.
    pub column: String,
    /// Unit of the bounds, and its value in the column's SI unit.
    pub unit: (String, f64),
    /// Lower and upper bound; `None` if there is none.
    pub bounds: [Option<f64>; 2],
    /// Time from which it applies, s.
    pub from_s: f64,
    /// Time until which it applies, s.
    pub until_s: f64,
    /// Numbers of the steps of the operation in which it applies, from 1; none if it applies in all.
    pub steps: Vec<f64>,
}

/// Result of a limit: whether the rows of a run so far are within it.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct LimitResult {
    /// Its name in the scenario.
    pub name: String,
    /// The column.
    pub column: String,
    /// Unit of all numbers of this result.
    pub unit: String,
    /// Lower bound.
    pub at_least: Option<f64>,
    /// Upper bound.
    pub at_most: Option<f64>,
    /// Whether all rows are within the limit; absent if it applied to no row.
    pub held: Option<bool>,
    /// The value nearest to a bound, or farthest beyond one.
    pub worst: Option<f64>,
    /// Time of the worst value, s.
    pub worst_time_s: Option<f64>,
}

/// Limits, each with the index of its column in a row and its worst value so far.
#[derive(Clone, Debug, Default)]
pub(super) struct Limits {
    held: Vec<Held>,
}

#[derive(Clone, Debug)]
struct Held {
    limit: Limit,
    place: usize,
    /// Place of the number of the present step of the operation.
    step: Option<usize>,
    /// Worst value, and its time, s.
    worst: Option<[f64; 2]>,
}

impl Limit {
    /// Distance of a value from the bounds; negative beyond a bound, and for NaN.
    pub(crate) fn margin(&self, value: f64) -> f64 {
        if value.is_nan() {
            return f64::NEG_INFINITY;
        }
        let [least, most] = self.bounds;
        let below = most.map_or(f64::INFINITY, |most| most - value);
        below.min(least.map_or(f64::INFINITY, |least| value - least))
    }
}

impl Held {
    /// Whether the limit applies to a row.
    fn applies<S: Scalar>(&self, row: &[S]) -> bool {
        let Limit { from_s, until_s, steps, .. } = &self.limit;
        let in_step = || self.step.is_some_and(|place| steps.contains(&row[place].value()));
        (*from_s..=*until_s).contains(&row[0].value()) && (steps.is_empty() || in_step())
    }
}

impl Limits {
    /// Creates the limits on existing columns: the scenario has checked the names.
    pub(super) fn new(limits: Vec<Limit>, channels: &Channels) -> Self {
        let step = channels.place(STEP);
        let placed = |limit: Limit| Some(Held { place: channels.place(&limit.column)?, limit, step, worst: None });
        Self { held: limits.into_iter().filter_map(placed).collect() }
    }

    /// Checks the values of a row.
    pub(super) fn see<S: Scalar>(&mut self, row: &[S]) {
        let time_s = row[0].value();
        for Held { limit, place, worst, .. } in self.held.iter_mut().filter(|held| held.applies(row)) {
            let value = row[*place].value() / limit.unit.1;
            if worst.is_none_or(|[worst, _]| limit.margin(value) < limit.margin(worst)) {
                *worst = Some([value, time_s]);
            }
        }
    }

    /// Removes the results of all rows.
    pub(super) fn begin_anew(&mut self) {
        self.held.iter_mut().for_each(|held| held.worst = None);
    }

    /// Returns the results so far.
    pub(super) fn results(&self) -> Vec<LimitResult> {
        let result = |Held { limit, worst, .. }: &Held| LimitResult {
            name: limit.name.clone(),
            column: limit.column.clone(),
            unit: limit.unit.0.clone(),
            at_least: limit.bounds[0],
            at_most: limit.bounds[1],
            held: worst.map(|[value, _]| limit.margin(value) >= 0.0),
            worst: worst.map(|[value, _]| value),
            worst_time_s: worst.map(|[_, time_s]| time_s),
        };
        self.held.iter().map(result).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// "At least" and "at most" include the bound itself, and no value beyond it.
    #[test]
    fn a_value_at_its_bound_is_within_the_limit() {
        let limit = |bounds| Limit {
            name: "reach".to_owned(),
            column: "x".to_owned(),
            unit: ("m".to_owned(), 1.0),
            bounds,
            from_s: 0.0,
            until_s: f64::INFINITY,
            steps: Vec::new(),
        };
        let beyond = |value: f64| value * (1.0 + f64::EPSILON);
        for (bounds, value, holds) in [
            ([None, Some(2.0)], 2.0, true),
            ([None, Some(2.0)], beyond(2.0), false),
            ([Some(-2.0), None], -2.0, true),
            ([Some(-2.0), None], beyond(-2.0), false),
            ([Some(2.0), Some(2.0)], 2.0, true),
            ([None, Some(2.0)], f64::NAN, false),
        ] {
            let mut limits = Limits { held: vec![Held { limit: limit(bounds), place: 1, step: None, worst: None }] };
            limits.see(&[0.0, value]);
            assert_eq!(limits.results()[0].held, Some(holds), "{bounds:?}, {value}");
        }
    }
}
