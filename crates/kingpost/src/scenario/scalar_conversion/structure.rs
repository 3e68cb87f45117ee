//! The structure of a scenario: everything except its continuous numbers.

use super::super::over::{Numbers, OverScalar};
use super::super::schema::Scenario;
use super::super::writing::ToValue;

/// Replaces each number by 0, and collects the numbers in their order.
#[derive(Default)]
struct Blanks {
    numbers: Vec<f64>,
}

impl Numbers<f64> for Blanks {
    fn number(&mut self, value: f64) -> f64 {
        self.numbers.push(value);
        0.0
    }
}

impl Scenario {
    /// Returns the scenario without its continuous numbers, as text. Runs with the same structure can run in
    /// lanes, and one run can continue with the numbers of another.
    pub(crate) fn structure(&self) -> String {
        self.structure_and_numbers().0
    }

    /// Returns the [structure](Self::structure), and the continuous numbers in the order of their
    /// declarations.
    pub(super) fn structure_and_numbers(&self) -> (String, Vec<f64>) {
        let mut blanks = Blanks::default();
        let structure = self.over(&mut blanks).to_value().to_string();
        (structure, blanks.numbers)
    }
}
