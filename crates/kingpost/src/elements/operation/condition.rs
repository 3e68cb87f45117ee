//! The condition that ends a step of an operation.

use crate::elements::significant;

/// A condition that ends a step.
#[derive(Clone, Debug, PartialEq)]
pub enum Condition {
    /// The step has lasted this long, s.
    After(f64),
    /// A column of the results is in a range.
    Column(ColumnRange),
    /// All of these hold at once.
    All(Vec<Condition>),
    /// One of these holds.
    Any(Vec<Condition>),
}

/// Range of a column, in the unit of its bounds.
#[derive(Clone, Debug, PartialEq)]
pub struct ColumnRange {
    /// Its name.
    pub column: String,
    /// Its index among the columns that the operation reads.
    pub place: usize,
    /// The value is above this.
    pub above: Option<f64>,
    /// The value is below this.
    pub below: Option<f64>,
    /// Unit of both bounds, and its factor to the column's SI unit.
    pub unit: (String, f64),
}

impl Condition {
    /// Whether the condition holds at this time after the start of the step, s, with these values of the columns.
    pub fn holds(&self, elapsed_s: f64, columns: &[f64]) -> bool {
        match self {
            Self::After(time_s) => elapsed_s >= *time_s,
            Self::Column(range) => range.holds(columns),
            Self::All(all) => all.iter().all(|one| one.holds(elapsed_s, columns)),
            Self::Any(any) => any.iter().any(|one| one.holds(elapsed_s, columns)),
        }
    }

    /// Returns the part of the condition that does not hold, as text for an error.
    pub fn missing(&self, elapsed_s: f64, columns: &[f64]) -> String {
        let of = |conditions: &[Self], link: &str| {
            let open = conditions.iter().filter(|one| !one.holds(elapsed_s, columns));
            open.map(|one| one.missing(elapsed_s, columns)).collect::<Vec<_>>().join(link)
        };
        match self {
            Self::After(time_s) => {
                format!("found {} s since it began, allowed: at least {} s", significant(elapsed_s, 4), time_s)
            }
            Self::Column(range) => range.missing(columns),
            Self::All(all) => of(all, ", and "),
            Self::Any(any) => of(any, ", or "),
        }
    }
}

impl ColumnRange {
    fn value(&self, columns: &[f64]) -> f64 {
        columns.get(self.place).map_or(f64::NAN, |value| value / self.unit.1)
    }

    fn holds(&self, columns: &[f64]) -> bool {
        let value = self.value(columns);
        self.above.is_none_or(|above| value > above) && self.below.is_none_or(|below| value < below)
    }

    fn missing(&self, columns: &[f64]) -> String {
        let unit = if self.unit.0 == "1" { String::new() } else { format!(" {}", self.unit.0) };
        let found = significant(self.value(columns), 4);
        let bounds = [("above", self.above), ("below", self.below)];
        let bounds = bounds.into_iter().filter_map(|(side, bound)| Some(format!("{side} {}{unit}", bound?)));
        format!("found {} {found}{unit}, allowed: {}", self.column, bounds.collect::<Vec<_>>().join(" and "))
    }
}
