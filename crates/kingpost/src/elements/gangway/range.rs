//! Warns of a gangway outside its operating range.

use crate::elements::watcher::{Exceeded, Warning, Watcher, significant};

/// Watches stroke, luff and slew of a gangway.
///
/// ```
/// use kingpost::elements::Watcher;
/// use kingpost::elements::gangway::OperatingRange;
/// let mut range = OperatingRange::new("bridge", [[-2.0, 3.0], [-0.3, 0.3], [-1.0, 1.0]]);
/// range.see(7.5, &[3.4, 0.1, 0.0]);
/// assert!(range.warnings()[0].text.starts_with("its stroke was 3.4 m at 7.5 s"));
/// ```
#[derive(Clone, Debug)]
pub struct OperatingRange {
    gangway: String,
    /// Smallest and largest stroke (m), luff and slew (rad).
    limits: [[f64; 2]; 3],
    /// Value farthest beyond its limits, that limit, and the time, by quantity.
    worst: [Option<[f64; 3]>; 3],
}

/// A quantity: its column, its code, its name in words, its unit and the factor to it.
struct RangeColumn {
    column: &'static str,
    code: &'static str,
    what: &'static str,
    unit: &'static str,
    factor: f64,
}

const DEG: f64 = 180.0 / core::f64::consts::PI;
const WATCHED: [RangeColumn; 3] = [
    RangeColumn { column: "gangway_stroke", code: "gangway_stroke", what: "stroke", unit: "m", factor: 1.0 },
    RangeColumn { column: "gangway_luff", code: "gangway_luff", what: "luff angle", unit: "deg", factor: DEG },
    RangeColumn { column: "gangway_slew", code: "gangway_slew", what: "slew angle", unit: "deg", factor: DEG },
];

impl OperatingRange {
    /// Returns the watcher of a gangway with limits of stroke (m), luff and slew (rad).
    pub fn new(gangway: &str, limits: [[f64; 2]; 3]) -> Self {
        Self { gangway: gangway.to_owned(), limits, worst: [None; 3] }
    }
}

impl Watcher for OperatingRange {
    fn columns(&self) -> Vec<String> {
        WATCHED.iter().map(|watched| format!("{}.{}", self.gangway, watched.column)).collect()
    }

    fn see(&mut self, time_s: f64, values: &[f64]) {
        for ((value, [least, most]), worst) in values.iter().zip(self.limits).zip(&mut self.worst) {
            let bound = if *value > most { most } else { least };
            let beyond = (value - most).max(least - value);
            if beyond > 0.0 && worst.is_none_or(|[value, bound, _]| beyond > (value - bound).abs()) {
                *worst = Some([*value, bound, time_s]);
            }
        }
    }

    fn warnings(&self) -> Vec<Warning> {
        let of = |(watched, worst): (&RangeColumn, &Option<[f64; 3]>)| {
            let RangeColumn { code, what, unit, factor, .. } = *watched;
            let [value, bound, time_s] = (*worst)?;
            let [value, bound] = [value, bound].map(|number| number * factor);
            let text = format!(
                "its {what} was {} {unit} at {} s: its operating range ends at {} {unit}",
                significant(value, 3),
                significant(time_s, 6),
                significant(bound, 3)
            );
            Some(Warning::exceeded(code, time_s, &self.gangway, Exceeded { value, bound, unit }, text))
        };
        WATCHED.iter().zip(&self.worst).filter_map(of).collect()
    }
}
