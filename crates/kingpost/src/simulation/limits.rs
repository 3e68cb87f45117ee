//! Limits against which the results of a run are checked.

use crate::results::Channels;
use crate::scalar::Scalar;
use serde::Serialize;

/// Column of the present step of an operation.
pub(crate) const OPERATION_STEP: &str = "operation.operation_step";

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
    /// Percentage of the rows that must be within the bounds; 100 for all.
    pub percentile: f64,
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
    /// Percentage of the rows that must be within the bounds; 100 for all.
    pub percentile: f64,
    /// Whether enough rows are within the limit; absent if it applied to no row.
    pub held: Option<bool>,
    /// The value nearest to a bound, or farthest beyond one; with a percentile below 100 of the rows without the allowed share of
    /// the worst.
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
    /// Worst value, and its time, s; with a percentile below 100 the value of every row.
    seen: Vec<[f64; 2]>,
}

/// Share of an allowed number of rows by which it is rounded: 1 % of 100 rows is one row.
const ROUNDING: f64 = 1e-12;

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

    /// Whether the limit applies at a time, s, in a step of the operation.
    pub(crate) fn applies(&self, time_s: f64, step: Option<f64>) -> bool {
        let in_step = || step.is_some_and(|step| self.steps.contains(&step));
        (self.from_s..=self.until_s).contains(&time_s) && (self.steps.is_empty() || in_step())
    }

    /// Whether each row alone must be within the bounds.
    pub(crate) fn is_of_each_row(&self) -> bool {
        self.percentile >= 100.0
    }
}

impl Held {
    fn see(&mut self, value: f64, time_s: f64) {
        if self.limit.is_of_each_row() {
            if self.seen.first().is_some_and(|[worst, _]| self.limit.margin(value) >= self.limit.margin(*worst)) {
                return;
            }
            self.seen.clear();
        }
        self.seen.push([value, time_s]);
    }

    /// Returns the worst value after those that the percentile allows beyond a bound, with its time, s.
    fn worst(&self) -> Option<[f64; 2]> {
        let allowed = (1.0 - self.limit.percentile / 100.0) * self.seen.len() as f64;
        let beyond = libm::floor(allowed * (1.0 + ROUNDING)) as usize;
        let mut seen: Vec<&[f64; 2]> = self.seen.iter().collect();
        let place = beyond.min(seen.len().checked_sub(1)?);
        let by_margin = |a: &&[f64; 2], b: &&[f64; 2]| self.limit.margin(a[0]).total_cmp(&self.limit.margin(b[0]));
        Some(**seen.select_nth_unstable_by(place, by_margin).1)
    }
}

impl Limits {
    /// Creates the limits on existing columns: the scenario has checked the names.
    pub(super) fn new(limits: Vec<Limit>, channels: &Channels) -> Self {
        let step = channels.place(OPERATION_STEP);
        let placed = |limit: Limit| Some(Held { place: channels.place(&limit.column)?, limit, step, seen: Vec::new() });
        Self { held: limits.into_iter().filter_map(placed).collect() }
    }

    /// Checks the values of a row.
    pub(super) fn see<S: Scalar>(&mut self, row: &[S]) {
        let time_s = row[0].value();
        for held in &mut self.held {
            if held.limit.applies(time_s, held.step.map(|place| row[place].value())) {
                held.see(row[held.place].value() / held.limit.unit.1, time_s);
            }
        }
    }

    /// Removes the results of all rows.
    pub(super) fn begin_anew(&mut self) {
        self.held.iter_mut().for_each(|held| held.seen.clear());
    }

    /// Returns the results so far.
    pub(super) fn results(&self) -> Vec<LimitResult> {
        let result = |held: &Held| {
            let (limit, worst) = (&held.limit, held.worst());
            LimitResult {
                name: limit.name.clone(),
                column: limit.column.clone(),
                unit: limit.unit.0.clone(),
                at_least: limit.bounds[0],
                at_most: limit.bounds[1],
                percentile: limit.percentile,
                held: worst.map(|[value, _]| limit.margin(value) >= 0.0),
                worst: worst.map(|[value, _]| value),
                worst_time_s: worst.map(|[_, time_s]| time_s),
            }
        };
        self.held.iter().map(result).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn limit(bounds: [Option<f64>; 2], percentile: f64) -> Limits {
        let limit = Limit {
            name: "reach".to_owned(),
            column: "x".to_owned(),
            unit: ("m".to_owned(), 1.0),
            bounds,
            from_s: 0.0,
            until_s: f64::INFINITY,
            steps: Vec::new(),
            percentile,
        };
        Limits { held: vec![Held { limit, place: 1, step: None, seen: Vec::new() }] }
    }

    /// "At least" and "at most" include the bound itself, and no value beyond it.
    #[test]
    fn a_value_at_its_bound_is_within_the_limit() {
        let beyond = |value: f64| value * (1.0 + f64::EPSILON);
        for (bounds, value, holds) in [
            ([None, Some(2.0)], 2.0, true),
            ([None, Some(2.0)], beyond(2.0), false),
            ([Some(-2.0), None], -2.0, true),
            ([Some(-2.0), None], beyond(-2.0), false),
            ([Some(2.0), Some(2.0)], 2.0, true),
            ([None, Some(2.0)], f64::NAN, false),
        ] {
            let mut limits = limit(bounds, 100.0);
            limits.see(&[0.0, value]);
            assert_eq!(limits.results()[0].held, Some(holds), "{bounds:?}, {value}");
        }
    }

    /// The n largest of 100 values are allowed beyond a bound at a percentile of 100 - n.
    #[test]
    fn a_percentile_allows_its_share_of_rows_beyond_the_bound() {
        for allowed in [0_u8, 1, 5, 50, 99] {
            let worst = f64::from(100 - allowed);
            for (bound, holds) in [(worst, true), (worst - 0.5, false)] {
                let mut limits = limit([None, Some(bound)], f64::from(100 - allowed));
                (0..100).for_each(|k: i32| limits.see(&[f64::from(k), f64::from(1 + (37 * k) % 100)]));
                let found = &limits.results()[0];
                assert_eq!((found.worst, found.held), (Some(worst), Some(holds)), "{allowed} of 100 beyond {bound}");
                let time_s = found.worst_time_s.expect("rows were seen") as i32;
                assert_eq!(f64::from(1 + (37 * time_s) % 100), worst, "{time_s} s");
            }
        }
        assert_eq!(limit([None, Some(1.0)], 90.0).results()[0].held, None);
    }
}
