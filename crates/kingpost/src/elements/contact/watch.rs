//! Warns of a contact whose penetration is too deep.

use crate::elements::{Exceeded, Extreme, Warning, Watcher, significant};

/// The largest penetration of a run.
#[derive(Clone, Debug)]
pub(super) struct Depth {
    name: String,
    tolerance_m: f64,
    largest: Extreme,
}

impl Depth {
    pub(super) fn new(name: &str, tolerance_m: f64) -> Self {
        Self { name: name.to_owned(), tolerance_m, largest: Extreme::default() }
    }
}

impl Watcher for Depth {
    fn columns(&self) -> Vec<String> {
        vec![format!("{}.contact_penetration", self.name)]
    }

    fn see(&mut self, time_s: f64, values: &[f64]) {
        self.largest.see(time_s, values.first().copied().unwrap_or_default());
    }

    fn warnings(&self) -> Vec<Warning> {
        let Extreme { value, time_s } = self.largest;
        if value <= self.tolerance_m {
            return Vec::new();
        }
        let text = format!(
            "penetrates by {} m, more than its penetration_tolerance_m of {} m: make the contact stiffer",
            significant(value, 3),
            significant(self.tolerance_m, 3)
        );
        let numbers = Exceeded { value, bound: self.tolerance_m, unit: "m" };
        vec![Warning::exceeded("deep_penetration", time_s, &self.name, numbers, text)]
    }
}
